// SPDX-License-Identifier: Apache-2.0
#include "core/project/project_export.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/paths.h"
#include "core/base/system.h"
#include "core/base/text/ascii.h"
#include "core/base/text/free_names.h"
#include "core/color/srgb.h"
#include "core/exchange/engine_values.h"
#include "core/exchange/gltf_material.h"
#include "core/exchange/material_x.h"
#include "core/image/files/png.h"
#include "core/image/linear_tables.h"
#include "core/math/mat3.h"
#include "core/project/project_pictures.h"
#include "core/scene/material_texels.h"

namespace etak {
namespace {

bool has(const ProjectMaterial& m, Channel channel) {
  return gives(m, channel);
}

// Whether a texture gives one of the two colours. The surface then has both.
bool has_colors(const ProjectMaterial& m) {
  return has(m, Channel::diffuse) || has(m, Channel::specular);
}

bool has_opacity(const ProjectMaterial& m) {
  return has(m, Channel::alpha) && m.alpha_mode != AlphaMode::opaque;
}

// The numbers of a material. Those that a texture replaces are such that no form has to change them.
ExportSurface numbers_of(ProjectMaterial m, const MaterialLibrary& library) {
  const bool colors = has_colors(m);
  if (has(m, Channel::specular)) {
    m.measured.reset();
    m.specular = ProjectMaterial{}.specular;
  }
  // A body that is not black is not clear.
  if (colors) m.diffuse = {0.5, 0.5, 0.5};
  ExportSurface out = export_surface(m, library);
  if (!colors) return out;
  out.kind = SurfaceKind::dielectric;
  out.diffuse = {0, 0, 0};
  out.total.reset();
  out.clear.reset();
  out.film.reset();
  if (has(m, Channel::specular)) out.source = "F0 of a picture";
  return out;
}

// The colours of the texels of a material in linear light.
class Texels {
 public:
  Texels(const ProjectMaterial& material, const ExportSurface& surface, const MaterialPair& pair, Fit fit)
      : pair_(pair), linear_(linear_tables().srgb) {
    Changes changes;
    if (!has(material, Channel::specular))
      f0_ = vec(fitted(surface.f0, {fit, largest_dielectric_f0, surface.space}, "F0", "", changes));
  }
  int width() const { return pair_.diffuse_alpha.width; }
  int height() const { return pair_.diffuse_alpha.height; }
  DiffuseSpecular at(int x, int y) const {
    return {color(pair_.diffuse_alpha, x, y), f0_ ? *f0_ : color(pair_.specular_gloss, x, y)};
  }

 private:
  Vec3 color(const Image8& from, int x, int y) const {
    const auto code = from.at(x, y);
    return {double{linear_[code[0]]}, double{linear_[code[1]]}, double{linear_[code[2]]}};
  }
  const MaterialPair& pair_;
  const std::array<float, 256>& linear_;
  std::optional<Vec3> f0_;  // the number, where no texture gives it
};

// The texel that differs most from what was wanted.
struct Worst {
  Vec3 wanted{0, 0, 0}, used{0, 0, 0};
  double error = 0;
  void look_at(const Vec3& is_wanted, const Vec3& is_used) {
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(is_wanted[c] - is_used[c]));
    if (most <= error) return;
    *this = {is_wanted, is_used, most};
  }
  void tell(Changes& changes, std::string_view field, std::string_view action,
            std::string_view reason) const {
    // Half a code of the brightest colours is no change.
    if (error > 0.005)
      note_change(changes, field, {wanted.begin(), wanted.end()}, {used.begin(), used.end()}, action, reason);
  }
};

void put_color(const Vec3& color, Image8& to, int x, int y) {
  for (std::size_t c = 0; c < 3; ++c)
    to.at(x, y)[c] = linear_tables().srgb_code(static_cast<float>(color[c]));
}

// One channel of a picture, each code by `code_of`.
template <class CodeOf>
Image8 channel_of(const Image8& from, std::size_t channel, int channels, const CodeOf& code_of) {
  Image8 out(from.width, from.height, channels);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const auto texel = out.at(x, y);
      std::fill(texel.begin(), texel.end(), std::uint8_t{255});
      texel[channels == 1 ? 0 : 1] = code_of(from.at(x, y)[channel]);
    }
  return out;
}

std::string png_of(const Image8& image, bool srgb) {
  PngOptions options;
  options.srgb = srgb;
  return png_bytes(image, options);
}

// Colour, and opacity as the fourth channel where the material has one.
Image8 gltf_base(const ProjectMaterial& m, const Texels& texels, const MaterialPair& pair, bool colored,
                 Changes& changes) {
  const bool opacity = has_opacity(m);
  Image8 out(texels.width(), texels.height(), opacity ? 4 : 3, 255);
  Worst clamped;
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      if (opacity) out.at(x, y)[3] = pair.diffuse_alpha.at(x, y)[3];
      if (!colored) continue;
      const Vec3 wanted =
          converted(texels.at(x, y), DiffuseConvention::as_it_is, DiffuseConvention::reduced_when_shading)
              .diffuse;
      Vec3 used = wanted;
      for (double& channel : used) channel = std::min(channel, 1.0);
      clamped.look_at(wanted, used);
      put_color(used, out, x, y);
    }
  clamped.tell(changes, "baseColorTexture", "clamp", "a texture ends at 1; the largest F0 is taken off it");
  return out;
}

// The emission of the texels, which ends at 1 in a file; what is above goes into that of the surface. Empty where there
// is no texture, or nothing is sent out.
//   times   a colour of at most 1 that the texels take
std::string emission_picture(const ProjectMaterial& m, const PictureDoor& door, const LinearRgb& times,
                             ExportSurface& surface) {
  const std::optional<Image> picture = light_picture(m, Channel::emission, door);
  if (!picture || surface.emission == LinearRgb{}) return {};
  const double largest =
      std::max(1.0, double{*std::max_element(picture->values.begin(), picture->values.end())});
  Image8 out(picture->width, picture->height, 3);
  for (std::size_t i = 0; i < out.values.size(); ++i)
    out.values[i] = srgb_u8(double{picture->values[i]} / largest * vec(times)[i % 3]);
  surface.emission = to_rgb(scaled(vec(surface.emission), largest));
  return png_of(out, true);
}

std::string occlusion_picture(const ProjectMaterial& m, const PictureDoor& door) {
  const std::optional<Image> picture = light_picture(m, Channel::occlusion, door);
  if (!picture) return {};
  Image8 out(picture->width, picture->height, 1);
  for (std::size_t i = 0; i < out.values.size(); ++i)
    out.values[i] = to_code(static_cast<float>(m.occlusion) * picture->values[i]);
  return png_of(out, false);
}

// Green points up.
std::string normal_map(const ProjectMaterial& m, const PictureDoor& door) {
  const Image normals = normal_picture(m, door, max_image_side);
  if (normals.width == 0) return {};
  Image8 codes(normals.width, normals.height, 3);
  for (int y = 0; y < codes.height; ++y)
    for (int x = 0; x < codes.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) codes.at(x, y)[c] = to_code(0.5F * normals.at(x, y)[c] + 0.5F);
  return png_of(codes, false);
}

GltfPictures gltf_pictures(const ProjectMaterial& m, const Texels& texels, const MaterialPair& pair,
                           const PictureDoor& door, ExportSurface& surface, Changes& changes) {
  GltfPictures out;
  out.emissive = emission_picture(m, door, {1, 1, 1}, surface);
  out.occlusion = occlusion_picture(m, door);
  out.normal = normal_map(m, door);
  out.scale = m.uv_scale;
  const bool colored = has(m, Channel::diffuse) || (has(m, Channel::specular) && m.diffuse != LinearRgb{});
  if (colored || has_opacity(m)) {
    out.base_color = png_of(gltf_base(m, texels, pair, colored, changes), true);
    out.opacity_alone = !colored;
  }
  if (has_opacity(m)) {
    out.alpha_mode = m.alpha_mode == AlphaMode::mask ? "MASK" : "BLEND";
    out.alpha_cutoff = m.alpha_cutoff;
  }
  if (has(m, Channel::gloss)) {
    const auto roughness = roughness_codes(GlossForm::schueler);
    out.metallic_roughness = png_of(
        channel_of(pair.specular_gloss, 3, 3, [&](std::uint8_t gloss) { return roughness[gloss]; }), false);
  }
  if (has(m, Channel::specular)) {
    Image8 f0(texels.width(), texels.height(), 3);
    for (int y = 0; y < f0.height; ++y)
      for (int x = 0; x < f0.width; ++x)
        std::copy_n(pair.specular_gloss.at(x, y).begin(), 3, f0.at(x, y).begin());
    out.specular_color = png_of(f0, true);
  }
  return out;
}

// The bytes of the pictures of MaterialX, in place of their names.
using MaterialXBytes = MaterialXPictures;

// Colour and metalness of texels whose F0 is a texture's.
void take_metal_rough(const Texels& texels, MaterialXBytes& out, Changes& changes) {
  Image8 base(texels.width(), texels.height(), 3), metalness(texels.width(), texels.height(), 1);
  Worst off;
  for (int y = 0; y < base.height; ++y)
    for (int x = 0; x < base.width; ++x) {
      const DiffuseSpecular wanted = texels.at(x, y);
      const MetalRough solved = metal_rough_of(wanted);
      Vec3 color = solved.base;
      for (double& channel : color) channel = std::clamp(channel, 0.0, 1.0);
      off.look_at(wanted.f0, diffuse_specular(color, solved.metallic, dielectric_f0(1.5, 1, {1, 1, 1})).f0);
      put_color(color, base, x, y);
      metalness.at(x, y)[0] = to_code(static_cast<float>(solved.metallic));
    }
  out.base_color = png_of(base, true);
  out.base_metalness = png_of(metalness, false);
  off.tell(changes, "F0", "nearest", "a metal has its base colour as F0, and all else one index");
}

MaterialXBytes material_x_pictures(const ProjectMaterial& m, const Texels& texels, const MaterialPair& pair,
                                   const PictureDoor& door, ExportSurface& surface, Changes& changes) {
  MaterialXBytes out;
  if (m.texture(Channel::emission) && surface.emission != LinearRgb{}) {
    // The one number beside the picture is the luminance, so the picture takes the colour.
    const auto [color, strength] = emission_parts(surface.emission);
    surface.emission = {strength, strength, strength};
    out.emission_color = emission_picture(m, door, color, surface);
  }
  out.geometry_normal = normal_map(m, door);
  out.scale = m.uv_scale;
  if (m.texture(Channel::occlusion)) surface.notes.emplace_back("OpenPBR has no input for its occlusion");
  if (has(m, Channel::specular)) {
    take_metal_rough(texels, out, changes);
  } else if (has(m, Channel::diffuse)) {
    Image8 base(texels.width(), texels.height(), 3);
    for (int y = 0; y < base.height; ++y)
      for (int x = 0; x < base.width; ++x)
        std::copy_n(pair.diffuse_alpha.at(x, y).begin(), 3, base.at(x, y).begin());
    out.base_color = png_of(base, true);
  }
  if (has(m, Channel::gloss)) {
    const auto roughness = roughness_codes(GlossForm::schueler);
    out.specular_roughness = png_of(
        channel_of(pair.specular_gloss, 3, 1, [&](std::uint8_t gloss) { return roughness[gloss]; }), false);
  }
  if (has_opacity(m)) {
    const bool mask = m.alpha_mode == AlphaMode::mask;
    const auto opacity = [&](std::uint8_t code) {
      return !mask ? code : code >= m.alpha_cutoff * 255 ? std::uint8_t{255} : std::uint8_t{0};
    };
    out.geometry_opacity = png_of(channel_of(pair.diffuse_alpha, 3, 1, opacity), false);
  }
  return out;
}

// Writes pictures beside a document, under names that no other file has.
class PictureFolder {
 public:
  explicit PictureFolder(const std::string& document)
      : folder_(std::filesystem::path(document).parent_path()),
        stem_(sys::path_text(std::filesystem::path(document).stem())) {}

  /// Makes names of the bytes.
  void take(const std::string& material, MaterialXPictures& pictures) {
    const std::string before = stem_ + "_" + (material.empty() ? "" : plain(material) + "_");
    const auto one = [&](std::string& bytes, const char* input) {
      if (bytes.empty()) return;
      const auto numbered = [&](int i) {
        return before + input + (i == 1 ? "" : "_" + std::to_string(i)) + ".png";
      };
      std::string name = names_.free(numbered(1), numbered);
      while (!write(name, bytes)) name = names_.free(numbered(1), numbered);
      bytes = name;
    };
    one(pictures.base_color, "base_color");
    one(pictures.base_metalness, "base_metalness");
    one(pictures.specular_roughness, "specular_roughness");
    one(pictures.geometry_opacity, "geometry_opacity");
    one(pictures.emission_color, "emission_color");
    one(pictures.geometry_normal, "geometry_normal");
  }

 private:
  // A name as a part of a file's name.
  static std::string plain(const std::string& name) {
    std::string out = name.substr(0, 64);
    for (char& c : out)
      if (!is_letter(c) && !is_digit(c)) c = '_';
    return out;
  }

  // False where another file has the name.
  bool write(const std::string& name, const std::string& bytes) const {
    const std::string path = sys::path_text(folder_ / name);
    if (kind_at(path, false)) {
      sys::FileInfo info;
      return sys::file_info(path, info) && info.kind == sys::FileInfo::Kind::file &&
             info.size == bytes.size() && read_file(path) == bytes;
    }
    write_file(path, bytes, false);
    return true;
  }

  std::filesystem::path folder_;
  std::string stem_;
  FreeNames names_;
};

}  // namespace

std::vector<Changes> export_materials(std::span<const ProjectMaterial> materials,
                                      const MaterialLibrary& library, ExportForm form, Fit fit,
                                      const PictureDoor& door, const std::string& path) {
  std::vector<ExportSurface> surfaces;
  std::vector<GltfPictures> inside;
  std::vector<MaterialXPictures> beside;
  std::vector<Changes> of_pictures(materials.size()), changes;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const ProjectMaterial& m = materials[i];
    surfaces.push_back(numbers_of(m, library));
    validate(surfaces.back());  // before any picture is written
    inside.emplace_back();
    beside.emplace_back();
    if (!has_textures(m)) continue;
    const MaterialPair pair = pictures_of(m, library, door);
    const Texels texels(m, surfaces.back(), pair, fit);
    if (form == ExportForm::material_x)
      beside.back() = material_x_pictures(m, texels, pair, door, surfaces.back(), of_pictures[i]);
    else
      inside.back() = gltf_pictures(m, texels, pair, door, surfaces.back(), of_pictures[i]);
    for (const Change& change : of_pictures[i]) surfaces.back().notes.push_back(one_line(change));
  }
  std::string document;
  if (form == ExportForm::material_x) {
    PictureFolder folder(path);
    for (std::size_t i = 0; i < materials.size(); ++i)
      folder.take(materials.size() == 1 ? "" : materials[i].name, beside[i]);
    document = material_x(surfaces, fit, changes, beside);
  } else {
    document = gltf_document(surfaces, GltfMaterialForm::metal_rough,
                             form == ExportForm::glb ? GltfContainer::glb : GltfContainer::gltf, fit, changes,
                             inside);
  }
  write_file(path, document, true);
  for (std::size_t i = 0; i < changes.size(); ++i)
    changes[i].insert(changes[i].end(), of_pictures[i].begin(), of_pictures[i].end());
  return changes;
}

}  // namespace etak
