// SPDX-License-Identifier: Apache-2.0
#include "core/pack/scene/scene_pictures.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>

#include "core/color/srgb.h"
#include "core/image/files/png_choice.h"
#include "core/image/texture_bytes.h"
#include "core/scene/gltf_convert.h"
#include "core/scene/material_texels.h"

namespace etak {
namespace {

using Texel = std::array<std::uint8_t, 4>;
// A texel of a picture, of the texels of a page's two textures.
using PairMap = std::function<Texel(const std::uint8_t* diffuse_alpha, const std::uint8_t* specular_gloss)>;
// Changes the texel of a picture by the texels `a` and `b` of the textures that are placed there.
using MapsMap =
    std::function<void(const MaterialMaps& of, const std::uint8_t* a, const std::uint8_t* b, Texel&)>;

constexpr std::uint8_t none[4] = {0, 0, 0, 255};

const std::uint8_t* texel_or_none(const PixelsView8& view, int x, int y) {
  return view.data != nullptr ? view.at(x, y) : none;
}

// A texture that the page does not have reads as 0, 0, 0, 255.
//   waste   only texels that lie in no region are wanted: those of the pair are 0 there
Image8 mapped(const ScenePictureInput& in, const PairMap& map, bool waste = false) {
  const PlannedPage& page = in.decision.plan.pages[static_cast<std::size_t>(in.page)];
  const PixelsView8 a = in.pixels.view(Texture::diffuse_alpha), b = in.pixels.view(Texture::specular_gloss);
  Image8 out(page.width, page.height, 4);
  if (waste) {
    constexpr std::uint8_t zero[4] = {};
    const Texel texel = map(a.data != nullptr ? zero : none, b.data != nullptr ? zero : none);
    for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] = texel[i % 4];
    return out;
  }
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const Texel texel = map(texel_or_none(a, x, y), texel_or_none(b, x, y));
      std::copy(texel.begin(), texel.end(), out.at(x, y).begin());
    }
  return out;
}

void put_maps(const ScenePictureInput& in, const std::optional<PagePixels>& pixels, const MapsMap& map,
              Image8& out) {
  if (!pixels) return;
  const PixelsView8 a = pixels->view(Texture::diffuse_alpha), b = pixels->view(Texture::specular_gloss);
  for (const std::size_t r : in.maps.regions) {
    const MaterialMaps& of = in.by_owner.at(in.decision.regions[r].material);
    const PixelBox& cell = in.decision.plan.places[r].cell;
    for (int y = cell.y; y < std::min(cell.y + cell.height, out.height); ++y)
      for (int x = cell.x; x < std::min(cell.x + cell.width, out.width); ++x) {
        Texel texel;
        std::copy_n(out.at(x, y).begin(), 4, texel.begin());
        map(of, a.at(x, y), b.at(x, y), texel);
        std::copy(texel.begin(), texel.end(), out.at(x, y).begin());
      }
  }
}

// Grey where red, green and blue are one, and without an alpha that is full everywhere.
Image8 with_fewest_channels(const Image8& rgba) {
  bool grey = true, full = true;
  for (std::size_t i = 0; i < rgba.values.size(); i += 4) {
    const std::uint8_t* t = rgba.values.data() + i;
    grey = grey && t[0] == t[1] && t[1] == t[2];
    full = full && t[3] == 255;
  }
  if (!full && !grey) return rgba;
  const std::size_t colours = grey ? 1 : 3, channels = colours + (full ? 0 : 1);
  Image8 out(rgba.width, rgba.height, static_cast<int>(channels));
  for (std::size_t i = 0; i < rgba.pixel_count(); ++i) {
    const std::uint8_t* from = rgba.values.data() + 4 * i;
    std::uint8_t* to = out.values.data() + channels * i;
    std::copy_n(from, colours, to);
    if (!full) to[colours] = from[3];
  }
  return out;
}

PngOptions png_options(const PngRows& image, const WriteOptions& options) {
  PngOptions out;
  out.level = options.png_level ? *options.png_level : png_level_for(image);
  out.threads = options.threads;
  return out;
}

// The file of a picture that only the scene reads, and what it takes.
struct SceneFile {
  std::string bytes;
  TextureTotals totals;
};
SceneFile file_of(const Image8& picture, const WriteOptions& options) {
  const Image8 out = with_fewest_channels(picture);
  const PngOptions png = png_options(out, options);
  SceneFile file{options.png_level ? png_bytes(out, png) : least_png(out, png), {}};
  file.totals = {1, file.bytes.size(), texture_bytes({out.width, out.height, out.channels}, true)};
  return file;
}

// The pictures of one page.
struct ScenePictures {
  const ScenePictureInput& in;
  bool occluded = true;  // with occlusion in the red channel of others
  std::array<std::uint8_t, 256> roughness = roughness_codes(in.gloss);

  // Calls see(name, picture) for those that the scene reads; where they are not occluded, for those alone
  // that occlusion is a part of.
  template <class See>
  void each_read(const See& see) const {
    const auto where_read = [&](const char* what, const auto& picture) {
      if (const std::string name = scene_picture(in.page, what); in.reads(name)) see(name, picture());
    };
    where_read("metal_rough", [&] { return metal_rough(); });
    if (!occluded) return;
    where_read("roughness", [&] { return roughness_picture(); });
    where_read("occlusion", [&] { return occlusion_alone(); });
    where_read("base_color", [&] { return base_color(); });
    where_read("normal", [&] { return other(&MaterialMaps::normal, true, {128, 128, 255, 255}); });
    where_read("emissive", [&] { return other(&MaterialMaps::emissive, false, {0, 0, 0, 255}); });
  }

 private:
  // Grey: beside it the factor of metal is 0, and occlusion lies elsewhere.
  Image8 roughness_picture() const {
    return mapped(in, [&](const std::uint8_t*, const std::uint8_t* sg) {
      const std::uint8_t code = roughness[sg[3]];
      return Texel{code, code, code, 255};
    });
  }
  Image8 occlusion_alone() const {
    Image8 out = mapped(in, [](const std::uint8_t*, const std::uint8_t*) {
      return Texel{255, 255, 255, 255};
    });
    put_maps(
        in, in.maps.color,
        [](const MaterialMaps& of, const std::uint8_t*, const std::uint8_t* b, Texel& to) {
          if (of.occlusion) to = {b[0], b[0], b[0], 255};
        },
        out);
    return out;
  }
  Image8 base_color() const {
    Image8 out = mapped(
        in,
        [&](const std::uint8_t* da, const std::uint8_t* sg) {
          const MetalRough m = solved(da, sg);
          return Texel{srgb_u8(m.base[0]), srgb_u8(m.base[1]), srgb_u8(m.base[2]), da[3]};
        },
        all_exact());
    put_maps(
        in, in.maps.color,
        [](const MaterialMaps& of, const std::uint8_t* a, const std::uint8_t*, Texel& to) {
          if (of.exact && of.base_color) to = {a[0], a[1], a[2], a[3]};
        },
        out);
    return out;
  }
  Image8 metal_rough() const {
    Image8 out = mapped(
        in,
        [&](const std::uint8_t* da, const std::uint8_t* sg) {
          const double metallic = std::clamp(solved(da, sg).metallic, 0.0, 1.0);
          return Texel{255, roughness[sg[3]], static_cast<std::uint8_t>(255 * metallic + 0.5), 255};
        },
        all_exact());
    put_maps(
        in, in.maps.color,
        [&](const MaterialMaps& of, const std::uint8_t* a, const std::uint8_t* b, Texel& to) {
          if (of.exact && of.metal_rough) to = {255, b[1], b[2], 255};
          if (occluded) occlusion(of, a, b, to);
        },
        out);
    return out;
  }
  // The `first` or second texture of geometry, over a texel that says nothing.
  Image8 other(std::optional<int> MaterialMaps::*which, bool first, const Texel& nothing) const {
    Image8 out = mapped(in, [&](const std::uint8_t*, const std::uint8_t*) { return nothing; });
    put_maps(
        in, in.maps.geometry,
        [&](const MaterialMaps& of, const std::uint8_t* a, const std::uint8_t* b, Texel& to) {
          const std::uint8_t* from = first ? a : b;
          if (of.*which) to = {from[0], from[1], from[2], 255};
        },
        out);
    return out;
  }

  // Whether no texel of the page that is read has to be solved from the pair.
  bool all_exact() const {
    const PackDecision& decision = in.decision;
    for (std::size_t r = 0; r < decision.regions.size(); ++r) {
      const auto of = in.by_owner.find(decision.regions[r].material);
      const bool exact = of != in.by_owner.end() && of->second.exact;
      if (decision.plan.places[r].page == in.page && !exact) return false;
    }
    return true;
  }
  static void occlusion(const MaterialMaps& of, const std::uint8_t*, const std::uint8_t* b, Texel& out) {
    if (of.occlusion) out[0] = b[0];
  }
  static MetalRough solved(const std::uint8_t* da, const std::uint8_t* sg) {
    DiffuseSpecular texel;
    for (std::size_t c = 0; c < 3; ++c)
      texel.diffuse[c] = srgb_decode(da[c] / 255.0), texel.f0[c] = srgb_decode(sg[c] / 255.0);
    return metal_rough_of(texel);
  }
};

}  // namespace

std::string scene_picture(int page, const std::string& what) {
  return "page" + std::to_string(page) + "_" + what + ".png";
}

std::string occlusion_picture(const std::vector<GltfForm>& forms) {
  return has_form(forms, GltfForm::metal_rough) ? "metal_rough" : "occlusion";
}

void add_scene_picture_sizes(const ScenePictureInput& in, const WriteOptions& options, PictureSizes& sizes) {
  ScenePictures{in}.each_read([&](const std::string& name, const Image8& picture) {
    sizes.files[name] = file_of(picture, options).totals;
  });
  ScenePictures{in, false}.each_read([&](const std::string& name, const Image8& picture) {
    sizes.bare[name] = file_of(picture, options).totals;
  });
  for (const Texture texture : both_textures)
    if (const std::string name = page_file(in.page, texture, "png"); in.reads(name)) {
      const PixelsView8 view = in.pixels.view(texture);
      const PngRows image{{view.width, view.height, 4}, view.data, view.stride};
      TextureTotals& file = sizes.files[name] = {1, 0, texture_bytes({view.width, view.height, 4}, true)};
      write_png(image, png_options(image, options),
                [&](std::string_view piece) { file.disk += piece.size(); });
    }
}

std::set<std::string> write_scene_pictures(OutputFolder& folder, const ScenePictureInput& in,
                                           const WriteOptions& options) {
  std::set<std::string> names;
  ScenePictures{in}.each_read([&](const std::string& name, const Image8& picture) {
    folder.write(*names.insert(name).first, file_of(picture, options).bytes);
  });
  return names;
}

}  // namespace etak
