// SPDX-License-Identifier: Apache-2.0
#include "tests/core/atlas/altered_models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "core/color/srgb.h"
#include "core/scene/gltf.h"
#include "tests/core/atlas/scene_support.h"
#include "tests/support.h"

namespace etak::test {
namespace altering {
namespace {

// What materials read the pictures of a scene as.
struct Kinds {
  std::set<int> color, metal_rough, normal;

  explicit Kinds(const GltfScene& scene) {
    const auto add = [](std::set<int>& to, const std::optional<GltfTexture>& texture) {
      if (texture) to.insert(texture->image);
    };
    for (const GltfMaterial& m : scene.materials) {
      add(color, m.base_color_texture);
      add(metal_rough, m.metallic_roughness_texture);
      add(normal, m.normal_texture);
    }
  }
};

Image8 resized(const Image8& from, double side) {
  const auto length = [side](int of) { return std::max(1, static_cast<int>(std::lround(of * side))); };
  Image8 out(length(from.width), length(from.height), from.channels);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const auto texel = from.at(x * from.width / out.width, y * from.height / out.height);
      std::copy(texel.begin(), texel.end(), out.at(x, y).begin());
    }
  return out;
}

using CodeTable = std::array<std::uint8_t, 256>;

template <class Change>
CodeTable table_of(const Change& change) {
  CodeTable out;
  for (std::size_t code = 0; code < out.size(); ++code) out[code] = change(static_cast<double>(code) / 255);
  return out;
}

Image8 altered(const Image8& from, int image, const Kinds& kinds, const Alteration& how) {
  const bool color = kinds.color.contains(image), normal = kinds.normal.contains(image),
             metal_rough = kinds.metal_rough.contains(image);
  Image8 out = resized(from, color ? how.color_side : how.other_side);
  const auto channels = static_cast<std::size_t>(out.channels);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; how.mirrored && x < out.width / 2; ++x) {
      const auto left = out.at(x, y), right = out.at(out.width - 1 - x, y);
      std::swap_ranges(left.begin(), left.end(), right.begin());
    }
  std::array<CodeTable, 3> gained;
  for (std::size_t c = 0; c < 3; ++c)
    gained[c] = table_of([&](double code) { return srgb_u8(srgb_decode(code) * how.color_gains[c]); });
  const CodeTable rougher = table_of([&](double code) { return plain_u8(code * how.roughness_gain); });
  for (std::size_t i = 0; i < out.values.size(); i += channels) {
    std::uint8_t* const texel = out.values.data() + i;
    if (normal && how.mirrored) texel[0] = static_cast<std::uint8_t>(255 - texel[0]);
    for (std::size_t c = 0; color && c < std::min<std::size_t>(3, channels); ++c)
      texel[c] = gained[c][texel[c]];
    if (metal_rough && channels >= 3) texel[1] = rougher[texel[1]];
  }
  return out;
}

// Turns the UVs of every primitive over: u becomes 1 - u.
void mirror_uvs(nlohmann::json& document, std::string& buffer) {
  std::set<std::size_t> done;
  for (auto& mesh : document["meshes"])
    for (auto& primitive : mesh["primitives"])
      for (const auto& [name, accessor_index] : primitive["attributes"].items()) {
        if (!name.starts_with("TEXCOORD_")) continue;
        const auto index = accessor_index.get<std::size_t>();
        if (!done.insert(index).second) continue;
        auto& accessor = document["accessors"][index];
        REQUIRE(accessor["componentType"] == 5126);
        const auto& view = document["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        const std::size_t stride = view.value("byteStride", std::size_t{8});
        std::size_t at =
            view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
        for (std::size_t i = 0; i < accessor["count"].get<std::size_t>(); ++i, at += stride) {
          float u = 0;
          REQUIRE(at + sizeof u <= buffer.size());
          std::memcpy(&u, buffer.data() + at, sizeof u);
          u = 1 - u;
          std::memcpy(buffer.data() + at, &u, sizeof u);
        }
        accessor.erase("min");
        accessor.erase("max");
      }
}

}  // namespace
}  // namespace altering

std::string altered_copy(const std::string& path, const Alteration& how, PngLevel level,
                         const std::string& folder) {
  using namespace altering;
  const GltfScene scene = read_gltf(path, {});
  const Kinds kinds(scene);
  auto document = nlohmann::json::parse(slurp(path));
  REQUIRE(document["buffers"].size() == 1);
  std::string buffer = slurp(std::filesystem::path(path)
                                 .replace_filename(document["buffers"][0]["uri"].get<std::string>())
                                 .string());
  if (how.mirrored) mirror_uvs(document, buffer);
  PngOptions png;
  png.level = level;
  png.threads = 2;
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    const auto index = static_cast<int>(i);
    const Image8 picture = altered(picture_of(scene.images[i]), index, kinds, how);
    const std::string name = "picture" + std::to_string(i) + ".png";
    spit(folder + "/" + name, png_bytes(picture, png));
    document["images"][i] = {{"uri", name}};
  }
  spit(folder + "/scene.bin", buffer);
  document["buffers"][0]["uri"] = "scene.bin";
  document["buffers"][0]["byteLength"] = buffer.size();
  spit(folder + "/scene.gltf", document.dump());
  return folder + "/scene.gltf";
}

}  // namespace etak::test
