// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <filesystem>
#include <map>
#include <tuple>

#include "core/base/files/file.h"
#include "core/base/files/links.h"
#include "core/base/node_json.h"
#include "core/image/channels.h"
#include "core/image/image.h"
#include "core/validate/files/files.h"
#include "core/validate/pixels/flat_rows.h"

namespace etak {

namespace {

std::string beside(const std::string& path, const std::string& name) {
  const std::filesystem::path whole = path_beside(std::filesystem::path(path).parent_path().string(), name);
  return whole.lexically_normal().generic_string();
}

// Only what the rules ask for is read: layouts of other programs may hold less and more than etak's.
CheckTile read_tile(const JsonNode& node, std::size_t pages, int levels) {
  node.expect_object();
  CheckTile tile;
  tile.name = node.at("name").text();
  if (node.has("island")) tile.name += '#' + std::to_string(node.at("island").integer());
  tile.page = pages > 1 || node.has("page") ? node.at("page").integer(0, static_cast<int>(pages) - 1) : 0;
  tile.box = {node.at("x").integer(), node.at("y").integer(), node.at("w").integer(0),
              node.at("h").integer(0)};
  if (node.has("material")) tile.material = node.at("material").text();
  if (node.has("surface_class")) tile.surface_class = node.at("surface_class").text();
  if (node.has("gloss")) tile.typical_gloss = node.at("gloss").number();
  if (node.has("gutter")) tile.gutter = node.at("gutter").integer(0, max_image_side);
  // What is no copy of the edge cannot be held against it.
  if (node.has("source_gutter") && node.at("source_gutter").boolean()) tile.gutter = 0;
  // "mips" counts level 0, which nothing can bleed into.
  if (node.has("mips")) tile.mips = std::min(node.at("mips").integer(1, 16), levels) - 1;
  return tile;
}

// What the layout says of a material beside its places.
struct MaterialNode {
  std::string name;
  bool texels = true;
  std::array<std::optional<std::array<std::uint8_t, 4>>, 2> flat;  // by texture
};

MaterialNode read_material(const JsonNode& node) {
  node.expect_object();
  MaterialNode out;
  out.name = node.at("name").text();
  if (node.has("texels")) out.texels = node.at("texels").boolean();
  if (!node.has("constant")) return out;
  const JsonNode constant = node.at("constant");
  constant.expect_object();
  for (std::size_t texture = 0; texture < 2; ++texture) {
    std::array<std::uint8_t, 4> codes{};
    bool all = true;
    for (std::size_t c = 0; c < 4; ++c) {
      const std::string_view channel = channel_names[4 * texture + c];
      if (constant.has(channel))
        codes[c] = static_cast<std::uint8_t>(constant.at(channel).integer(0, 255));
      else
        all = false;
    }
    if (all) out.flat[texture] = codes;
  }
  return out;
}

std::vector<MaterialNode> read_materials(const JsonNode& root) {
  std::vector<MaterialNode> out;
  if (!root.has("materials")) return out;
  const JsonNode materials = root.at("materials");
  materials.expect_array();
  for (std::size_t i = 0; i < materials.size(); ++i) out.push_back(read_material(materials.at(i)));
  return out;
}

}  // namespace

std::vector<CheckTarget> targets_of_layout(const std::string& path, const std::string& label) {
  return targets_of_layout_text(read_file(path), path, label);
}

std::vector<CheckTarget> targets_of_layout_text(const std::string& text, const std::string& path,
                                                const std::string& label) {
  const JsonDocument document = parse_json_strictly(text, label, 16, "an atlas layout");
  const JsonNode root{document, label, {}};
  root.expect_object();
  const JsonNode pages = root.at("pages"), rects = root.at("rects");
  pages.expect_array();
  rects.expect_array();
  // Chains that end early ask for less.
  const int levels = root.has("levels") ? root.at("levels").integer(1, 16) : 16;

  std::vector<CheckTarget> targets(pages.size());
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const JsonNode page = pages.at(i);
    page.expect_object();
    CheckTarget& target = targets[i];
    for (const auto& [key, role] : {std::pair("diffuse_alpha", FileRole::diffuse_alpha),
                                    std::pair("specular_gloss", FileRole::specular_gloss)}) {
      if (!page.has(key)) continue;
      if (page.at(key).value.is_null()) {
        target.manifest.one_texture = true;
        continue;
      }
      const std::string name = page.at(key).text();
      target.files.push_back({role, beside(path, name), beside(label, name), false});
    }
    target.label = target.files.empty() ? label + "#" + page.pointer : target.files.back().label;
    if (root.has("gutter")) target.manifest.gutter = root.at("gutter").integer(0, max_image_side);
    if (root.has("mips")) target.manifest.mips = root.at("mips").integer(0, 16);
    if (root.has("transfer")) {
      target.manifest.transfer = texture_transfer_named(root.at("transfer").text());
      if (!target.manifest.transfer) root.at("transfer").fail_type("srgb, gamma22 or linear");
    }
  }
  if (root.has("diffuse") && root.at("diffuse").text() == "reduced_when_shading")
    for (CheckTarget& target : targets) target.manifest.specular_weighs_diffuse = true;
  const std::vector<MaterialNode> materials = read_materials(root);
  std::map<std::string_view, const MaterialNode*> by_name;
  for (const MaterialNode& material : materials) by_name.try_emplace(material.name, &material);
  // Materials that share texels have a row each: the tile is one.
  std::map<std::tuple<int, int, int, int, int>, std::size_t> seen;
  for (std::size_t i = 0; i < rects.size(); ++i) {
    CheckTile tile = read_tile(rects.at(i), pages.size(), levels);
    if (const auto material = by_name.find(rects.at(i).at("name").text()); material != by_name.end())
      tile.flat = material->second->flat;
    const PixelBox& box = tile.box;
    if (!seen.try_emplace({tile.page, box.x, box.y, box.width, box.height}, i).second) continue;
    targets[static_cast<std::size_t>(tile.page)].manifest.tiles.push_back(std::move(tile));
  }
  CheckTarget numbers;
  numbers.label = label;
  for (const MaterialNode& material : materials) {
    if (material.texels || !material.flat[0] || !material.flat[1]) continue;
    CheckTile& tile = numbers.manifest.tiles.emplace_back();
    tile.name = material.name;
    tile.flat = material.flat;
  }
  place_flat_tiles(numbers.manifest);
  if (!numbers.manifest.tiles.empty()) {
    if (!targets.empty()) {
      numbers.manifest.transfer = targets.front().manifest.transfer;
      numbers.manifest.specular_weighs_diffuse = targets.front().manifest.specular_weighs_diffuse;
    }
    targets.push_back(std::move(numbers));
  }
  return targets;
}

}  // namespace etak
