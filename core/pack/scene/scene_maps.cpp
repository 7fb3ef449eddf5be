// SPDX-License-Identifier: Apache-2.0
#include "core/pack/scene/scene_maps.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <set>
#include <string>
#include <utility>

#include "core/atlas/texels/compose.h"
#include "core/image/load.h"
#include "core/image/texture_bytes.h"
#include "core/pack/scene/scene_pictures.h"

namespace etak {
namespace {

using Users = std::vector<const GltfMaterial*>;
using ImageOf = std::optional<int> MaterialMaps::*;
using TextureOf = std::optional<GltfTexture> GltfMaterial::*;

bool lies_on(const GltfTexture& map, const GltfTexture& lead) {
  return map.uv_set == lead.uv_set && map.transform == lead.transform && map.sampler == lead.sampler;
}

// The image that all users of some texels read as this texture. None where they do not agree, or where the
// texture does not lie as the pair does.
template <class Fits>
std::optional<int> shared_image(const Users& users, TextureOf which, const Fits& fits) {
  std::optional<int> out;
  for (const GltfMaterial* m : users) {
    const std::optional<GltfTexture>& texture = m->*which;
    if (!texture) continue;
    const GltfTexture* const lead = leading_texture(*m);
    if (lead == nullptr || !lies_on(*texture, *lead) || !fits(texture->image)) return std::nullopt;
    if (out && *out != texture->image) return std::nullopt;
    out = texture->image;
  }
  return out;
}

// Where the regions of an owner lie, and how.
struct Placing {
  bool any = false, whole_size = true, turned = false;
};
Placing placing_of(std::size_t owner, const PackDecision& decision) {
  Placing out;
  for (std::size_t r = 0; r < decision.regions.size(); ++r) {
    if (decision.regions[r].material != owner) continue;
    out.any = true;
    out.whole_size = out.whole_size && decision.regions[r].shrink == 0;
    out.turned = out.turned || decision.plan.places[r].rotated;
  }
  return out;
}

// An image of the document as RGBA of the input's size; 255 where there is none.
Image8 four(const std::optional<int>& image, const PackInput& in, const SceneRead& read) {
  Image8 out(in.width, in.height, 4, 255);
  if (!image) return out;
  const Image8 from = codes_of(read.decoded(*image), false);
  const auto channels = static_cast<std::size_t>(from.channels);
  for (std::size_t i = 0; i < out.pixel_count(); ++i) {
    const auto texel = four_channels(from.values.data() + channels * i, channels, std::uint8_t{255});
    std::copy(texel.begin(), texel.end(), out.values.begin() + static_cast<std::ptrdiff_t>(4 * i));
  }
  return out;
}

void fill_channel(Image8& to, std::size_t channel) {
  for (std::size_t i = channel; i < to.values.size(); i += 4) to.values[i] = 255;
}

void copy_channel(const Image8& from, Image8& to, std::size_t channel) {
  for (std::size_t i = channel; i < to.values.size(); i += 4) to.values[i] = from.values[i];
}

MaterialPair color_of(const MaterialMaps& maps, const PackInput& in, const SceneRead& read) {
  const std::optional<int> base = maps.exact ? maps.base_color : std::nullopt;
  const std::optional<int> metal = maps.exact ? maps.metal_rough : std::nullopt;
  MaterialPair out{four(base, in, read), four(metal, in, read)};
  if (in.facts.opaque) fill_channel(out.diffuse_alpha, 3);
  fill_channel(out.specular_gloss, 3);
  if (!maps.occlusion)
    fill_channel(out.specular_gloss, 0);
  else if (maps.occlusion != metal)
    copy_channel(four(maps.occlusion, in, read), out.specular_gloss, 0);
  return out;
}

MaterialPair geometry_of(const MaterialMaps& maps, const PackInput& in, const SceneRead& read) {
  return {four(maps.normal, in, read), four(maps.emissive, in, read)};
}

// The regions of a page whose owners have maps, on a page that has both textures.
struct MappedPage {
  int number = 0;
  std::vector<Region> regions;
  PackingPlan plan;
};

using PairOfOwner = MaterialPair (*)(const MaterialMaps&, const PackInput&, const SceneRead&);

PagePixels composed(const MappedPage& page, const SceneMaps& maps, const SceneRead& read, unsigned threads,
                    PairOfOwner pair_of) {
  std::vector<PackInput> materials(read.inputs.materials.size());
  for (const auto& [owner, of] : maps) {
    const PackInput& from = read.inputs.materials[owner];
    PackInput& in = materials[owner] = from;
    in.facts.learned = true;
    in.convert = [pair_of, &of = of, &from, &read](std::vector<std::string>&) {
      return pair_of(of, from, read);
    };
  }
  std::vector<Learned> learned(materials.size());
  PagePixels out;
  out.start(page.plan.pages[static_cast<std::size_t>(page.number)], 1);
  Composer composer(materials, page.regions, page.plan, {threads});
  composer.texels(page.number, out, learned);
  composer.mips(page.number, out);
  return out;
}

std::set<std::size_t> owners_on(int page, const PackDecision& decision) {
  std::set<std::size_t> out;
  for (std::size_t r = 0; r < decision.regions.size(); ++r)
    if (decision.plan.places[r].page == page) out.insert(decision.regions[r].material);
  return out;
}

// The textures that may be placed on a page, and what they weigh there and as they are.
struct PageOfMaps {
  int number;
  const PackDecision& decision;
  const MapWeights& weights;
  SceneMaps& maps;
  std::set<std::size_t> owners;

  // Takes kinds of textures off the page where they weigh no less in its picture `what` than as they are.
  void weigh(const std::string& what, std::initializer_list<ImageOf> kinds, int channels) {
    const PlannedPage& page = decision.plan.pages[static_cast<std::size_t>(number)];
    const TextureTotals* const file = weighed(what, &PictureSizes::files);
    keep_lighter(kinds, file != nullptr
                            ? *file
                            : TextureTotals{1, 0, texture_bytes({page.width, page.height, channels}, true)});
  }

  // Takes occlusion off the page where it weighs no less in the red channel of a picture that is there anyhow.
  void weigh_occlusion_in(const std::string& what) {
    const TextureTotals* const with = weighed(what, &PictureSizes::files);
    const TextureTotals* const bare = weighed(what, &PictureSizes::bare);
    const std::uint64_t more =
        with != nullptr && bare != nullptr ? with->disk - std::min(with->disk, bare->disk) : 0;
    keep_lighter({&MaterialMaps::occlusion}, {0, more, 0});
  }

 private:
  // Null where files are not weighed.
  const TextureTotals* weighed(const std::string& what,
                               std::map<std::string, TextureTotals> PictureSizes::*which) const {
    if (!decision.sizes) return nullptr;
    const auto& sizes = (*decision.sizes)[static_cast<std::size_t>(weights.others)].*which;
    const auto found = sizes.find(scene_picture(number, what));
    return found == sizes.end() ? nullptr : &found->second;
  }

  void keep_lighter(std::initializer_list<ImageOf> kinds, const TextureTotals& placed) {
    std::set<int> images;
    each(kinds, [&](std::optional<int>& image) {
      if (image) images.insert(*image);
    });
    TextureTotals kept;
    for (const int image : images) kept.add(weights.kept(image));
    if (weights.weight(placed) >= weights.weight(kept))
      each(kinds, [](std::optional<int>& image) { image.reset(); });
  }

  template <class Act>
  void each(std::initializer_list<ImageOf> kinds, const Act& act) {
    for (const std::size_t owner : owners)
      if (const auto found = maps.find(owner); found != maps.end())
        for (const ImageOf kind : kinds) act(found->second.*kind);
  }
};

}  // namespace

bool is_plain_metal_rough(const GltfMaterial& m) {
  return !m.specular_glossiness && m.ior == 1.5 && m.specular == 1 && !m.specular_texture &&
         m.specular_color == std::array<double, 3>{1, 1, 1} && !m.specular_color_texture;
}

SceneMaps scene_maps(const SceneRead& read, const PackDecision& decision, Others others) {
  std::map<std::size_t, Users> users;
  for (std::size_t i = 0; i < read.entries.size(); ++i) {
    const MaterialFate& fate = decision.left_out.fates[i];
    if (!fate.texels || !read.is_used(read.entries[i])) continue;
    Users& of_owner = users[fate.owner];
    const GltfMaterial& m = read.material(read.entries[i]);
    if (others == Others::written || is_plain_metal_rough(m)) of_owner.push_back(&m);
  }
  SceneMaps out;
  for (const auto& [owner, of] : users) {
    if (of.empty()) {  // none of them is written
      out[owner].exact = true;
      continue;
    }
    const Placing placing = placing_of(owner, decision);
    if (!placing.any || !placing.whole_size) continue;
    const PackInput& in = read.inputs.materials[owner];
    const auto fits = [&](int image) {
      const PictureHeader& h = read.header(image);
      return h.width == in.width && h.height == in.height && h.bits == 8 && !h.floating;
    };
    MaterialMaps maps;
    maps.base_color = shared_image(of, &GltfMaterial::base_color_texture, fits);
    maps.metal_rough = shared_image(of, &GltfMaterial::metallic_roughness_texture, fits);
    maps.occlusion = shared_image(of, &GltfMaterial::occlusion_texture, fits);
    maps.emissive = shared_image(of, &GltfMaterial::emissive_texture, fits);
    // Some viewers take the directions of a normal map from its UVs, which would turn with the region.
    if (!placing.turned) maps.normal = shared_image(of, &GltfMaterial::normal_texture, fits);
    maps.exact =
        std::all_of(of.begin(), of.end(), [](const GltfMaterial* m) { return is_plain_metal_rough(*m); });
    for (std::optional<int>* image :
         {&maps.base_color, &maps.metal_rough, &maps.occlusion, &maps.normal, &maps.emissive})
      if (*image) *image = read.stands_for[static_cast<std::size_t>(**image)];
    out.emplace(owner, maps);
  }
  return out;
}

SceneMaps none_placed(SceneMaps maps) {
  for (auto& [owner, of] : maps) {
    const bool exact = of.exact;
    of = {};
    of.exact = exact;
  }
  return maps;
}

SceneMaps worthwhile(const SceneMaps& maps, const std::vector<GltfForm>& forms, const PackDecision& decision,
                     const MapWeights& weights) {
  SceneMaps out = maps;
  // Beside another form the factors of a material are those of its constants.
  if (forms.size() > 1)
    for (auto& [owner, of] : out) of.exact = false;
  for (int p = 0; p < static_cast<int>(decision.plan.pages.size()); ++p) {
    PageOfMaps page{p, decision, weights, out, owners_on(p, decision)};
    page.weigh("normal", {&MaterialMaps::normal}, 3);
    page.weigh("emissive", {&MaterialMaps::emissive}, 3);
    const auto is_exact = [&](std::size_t owner) {
      const auto found = out.find(owner);
      return found != out.end() && found->second.exact;
    };
    // Materials that are solved from the pair need both of the pages anyhow.
    const bool needed = !std::all_of(page.owners.begin(), page.owners.end(), is_exact);
    const std::string holder = occlusion_picture(forms);
    if (holder == "occlusion") {
      page.weigh(holder, {&MaterialMaps::occlusion}, 1);
    } else if (needed) {
      page.weigh_occlusion_in(holder);
    } else {
      page.weigh("base_color", {&MaterialMaps::base_color}, 4);
      page.weigh(holder, {&MaterialMaps::metal_rough, &MaterialMaps::occlusion}, 3);
    }
  }
  return out;
}

MapPixels map_pixels(int page, const SceneMaps& maps, const SceneRead& read, const PackDecision& decision,
                     unsigned threads) {
  MapPixels out;
  MappedPage on{page, {}, decision.plan};
  on.plan.places.clear();
  on.plan.pages[static_cast<std::size_t>(page)].has = {true, true};
  bool color = false, geometry = false;
  for (std::size_t r = 0; r < decision.regions.size(); ++r) {
    const auto found = maps.find(decision.regions[r].material);
    if (decision.plan.places[r].page != page || found == maps.end()) continue;
    const MaterialMaps& of = found->second;
    out.regions.push_back(r);
    on.regions.push_back(decision.regions[r]);
    on.plan.places.push_back(decision.plan.places[r]);
    color = color || of.occlusion || (of.exact && (of.base_color || of.metal_rough));
    geometry = geometry || of.normal || of.emissive;
  }
  if (color) out.color = composed(on, maps, read, threads, color_of);
  if (geometry) out.geometry = composed(on, maps, read, threads, geometry_of);
  return out;
}

}  // namespace etak
