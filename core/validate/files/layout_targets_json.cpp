// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <tuple>

#include "core/atlas/layout.h"
#include "core/base/files/file.h"
#include "core/base/files/links.h"
#include "core/base/json/node_json.h"
#include "core/base/system.h"
#include "core/image/channels.h"
#include "core/image/image.h"
#include "core/judge/pixels/flat_rows.h"
#include "core/validate/files/layout_targets.h"

namespace etak {

namespace {

std::string beside(const std::string& path, const std::string& name) {
  const std::filesystem::path whole =
      path_beside(sys::path_text(std::filesystem::path(path).parent_path()), name);
  return whole.lexically_normal().generic_string();
}

// The parts of a layout that the check needs, of layouts of etak and of other programs.
struct LayoutFacts {
  struct Page {
    struct File {
      FileRole role;
      std::string name, channels;  // TargetFile::channels
    };
    std::vector<File> files;
    bool one_texture = false, spread = false;  // F0 and gloss have fewer channels
  };
  struct Place {
    std::string material;
    CheckTile tile;
    AtlasRect rect;
  };
  Manifest common;  // of every page
  std::vector<Page> pages;
  std::vector<AtlasMaterialRow> materials;  // name, texels and constant of each
  std::vector<Place> places;
};

// Levels below level 0 that must stay clean. `mips` counts level 0 too, and the chain of the page may end
// earlier.
int mips_of_tile(int mips, int levels) {
  return std::min(mips, levels) - 1;
}

std::string tile_name(const std::string& material, int island) {
  return material + '#' + std::to_string(island);
}

// A scene among the files beside the pages.
void add_other_file(const std::string& name, const std::string& path, Manifest& to) {
  if (name.ends_with(".gltf")) to.scene = beside(path, name);
}

// Reads only what the rules need, because layouts of other programs may hold less and more than those of
// etak.
LayoutFacts::Place read_place(const JsonNode& node, std::size_t pages, int levels, int common_gutter) {
  node.expect_object();
  LayoutFacts::Place out{node.at("name").text(), {}, {}};
  CheckTile& tile = out.tile;
  tile.name = node.has("island") ? tile_name(out.material, node.at("island").integer()) : out.material;
  // In layouts of etak the first island has no number, so that any tile may be one.
  tile.island_of = out.material;
  tile.page = pages > 1 || node.has("page") ? node.at("page").integer(0, static_cast<int>(pages) - 1) : 0;
  tile.box = {node.at("x").integer(), node.at("y").integer(), node.at("w").integer(0),
              node.at("h").integer(0)};
  if (node.has("material")) tile.material = node.at("material").text();
  if (node.has("surface_class")) tile.surface_class = node.at("surface_class").text();
  if (node.has("gloss")) tile.typical_gloss = node.at("gloss").number();
  if (node.has("gutter")) tile.gutter = node.at("gutter").integer(0, max_image_side);
  // A gutter from the picture itself is no copy of the edge and cannot be compared with it.
  if (node.has("source_gutter") && node.at("source_gutter").boolean()) {
    tile.own_around = tile.gutter.value_or(common_gutter);
    tile.gutter = 0;
  }
  if (node.has("mips")) tile.mips = mips_of_tile(node.at("mips").integer(1, 16), levels);
  if (node.has("parts")) out.rect = read_layout_rect(node, pages);
  return out;
}

AtlasMaterialRow read_row(const JsonNode& node) {
  node.expect_object();
  AtlasMaterialRow out;
  out.name = node.at("name").text();
  if (node.has("texels")) out.texels = node.at("texels").boolean();
  out.layers = node.text_or_empty("layers");
  if (!node.has("constant")) return out;
  const JsonNode constant = node.at("constant");
  constant.expect_object();
  for (std::size_t c = 0; c < channel_count; ++c)
    if (constant.has(channel_names[c]))
      out.constant[c] = static_cast<std::uint8_t>(constant.at(channel_names[c]).integer(0, 255));
  return out;
}

// The codes of a constant texture; nullopt where some channel varies.
std::optional<std::array<std::uint8_t, 4>> flat_codes(const AtlasMaterialRow& row, Texture texture) {
  std::array<std::uint8_t, 4> out{};
  for (std::size_t c = 0; c < 4; ++c) {
    const auto& code = row.constant[first_channel(texture) + c];
    if (!code) return std::nullopt;
    out[c] = *code;
  }
  return out;
}

std::string channels_of(const AtlasPage& page) {
  if (!page.first_in_blocks()) return {};
  return page.in_blocks.size() == 1 ? "g" : "fg";
}

// The codes of a constant F0.
std::optional<std::array<std::uint8_t, 3>> flat_f0(const AtlasMaterialRow& row) {
  const auto& code = row.constant;
  if (!code[specular_channel] || !code[specular_channel + 1] || !code[specular_channel + 2])
    return std::nullopt;
  return std::array{*code[specular_channel], *code[specular_channel + 1], *code[specular_channel + 2]};
}

constexpr std::array page_roles{FileRole::diffuse_alpha, FileRole::specular_gloss};  // by Texture

// A file with a fourth channel alone follows the one whose channel that is, small levels apart follow both; these are only
// known to be the layout's.
LayoutFacts::Page facts_of(const AtlasPage& page) {
  LayoutFacts::Page out;
  const std::string spread = channels_of(page);
  out.spread = !spread.empty();
  for (const Texture texture : both_textures) {
    const auto t = static_cast<std::size_t>(texture);
    if (page.files[t].empty()) continue;
    const std::string fourth = page.fourth_beside_first(texture);
    out.files.push_back({page_roles[t], page.files[t].front(),
                         !fourth.empty()                      ? "+"
                         : texture == Texture::specular_gloss ? spread
                                                              : ""});
    if (!fourth.empty()) out.files.push_back({FileRole::other, fourth, ""});
    if (const std::string tail = page.tail_beside_first(texture); !tail.empty())
      out.files.push_back({FileRole::other, tail, ""});
  }
  return out;
}

LayoutFacts::Page read_page(const JsonNode& node) {
  node.expect_object();
  AtlasPage page;
  page.in_blocks = read_channels_in_blocks(node);
  page.fourth_apart = read_fourth_apart(node);
  page.tail_apart = read_tail_apart(node);
  bool one_texture = false;
  for (const Texture texture : both_textures) {
    const std::string_view key = name(texture);
    if (!node.has(key)) continue;
    if (node.at(key).value.is_null())
      one_texture = true;
    else
      page.files[static_cast<std::size_t>(texture)] = {node.at(key).text()};
  }
  LayoutFacts::Page out = facts_of(page);
  out.one_texture = one_texture;
  return out;
}

LayoutFacts read_facts(const JsonNode& root, const std::string& path) {
  root.expect_object();
  const JsonNode pages = root.at("pages"), rects = root.at("rects");
  pages.expect_array();
  rects.expect_array();
  const int levels = root.has("levels") ? root.at("levels").integer(1, 16) : 16;
  LayoutFacts out;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    out.pages.push_back(read_page(pages.at(i)));
    if (root.has("gutter")) out.common.gutter = root.at("gutter").integer(0, max_image_side);
    if (root.has("mips")) out.common.mips = root.at("mips").integer(0, 16);
    if (root.has("transfer")) {
      out.common.transfer = root.at("transfer").word(texture_transfer_named, "srgb, power-2.2 or linear");
    }
  }
  out.common.specular_weighs_diffuse =
      root.has("diffuse") && root.at("diffuse").text() == "reduced_when_shading" && !out.pages.empty();
  if (root.has("other_files"))
    for (const Json& name : root.at("other_files").value)
      if (name.is_string()) add_other_file(name.get<std::string>(), path, out.common);
  if (root.has("materials")) out.materials = root.at("materials").each(read_row);
  out.places = rects.each(
      [&](const JsonNode& rect) { return read_place(rect, pages.size(), levels, out.common.gutter); });
  return out;
}

// The facts of a layout in memory, equal to those that read_facts() finds in its JSON.
LayoutFacts facts_of(const AtlasLayout& layout, const std::string& path) {
  LayoutFacts out;
  for (const std::string& name : layout.other_files) add_other_file(name, path, out.common);
  for (const AtlasPage& page : layout.pages) {
    out.pages.push_back(facts_of(page));
    out.pages.back().one_texture = page.files[0].empty() || page.files[1].empty();
  }
  out.common.specular_weighs_diffuse = layout.diffuse_reduced && !layout.pages.empty();
  out.materials = layout.materials;
  for (const AtlasRect& rect : layout.rects) {
    CheckTile& tile = out.places.emplace_back(LayoutFacts::Place{rect.name, {}, rect}).tile;
    tile.name = rect.island > 0 ? tile_name(rect.name, rect.island) : rect.name;
    tile.island_of = rect.name;
    tile.page = rect.page;
    tile.box = {rect.x, rect.y, rect.width, rect.height};
    tile.gutter = rect.source_gutter ? 0 : rect.gutter;
    tile.own_around = rect.source_gutter ? rect.gutter : 0;
    tile.mips = mips_of_tile(rect.mips, layout.levels);
  }
  return out;
}

// The target of the materials that are on no page; it has no tiles where every material is on one.
CheckTarget target_of_numbers(const LayoutFacts& facts, const std::string& label) {
  CheckTarget out;
  out.label = label;
  for (const AtlasMaterialRow& row : facts.materials) {
    CheckTile tile;
    tile.name = row.name;
    tile.layers = row.layers;
    for (const Texture texture : both_textures)
      tile.flat[static_cast<std::size_t>(texture)] = flat_codes(row, texture);
    if (!row.texels && tile.flat[0] && tile.flat[1]) out.manifest.tiles.push_back(std::move(tile));
  }
  place_flat_tiles(out.manifest);
  out.manifest.transfer = facts.common.transfer;
  out.manifest.specular_weighs_diffuse = facts.common.specular_weighs_diffuse;
  out.manifest.scene = facts.common.scene;
  return out;
}

using RowsByName = std::map<std::string_view, const AtlasMaterialRow*>;

// The materials whose parts lie apart, each a target of the page's files. Those that read the same are one.
void add_materials_apart(const LayoutFacts& facts, const RowsByName& rows, const std::string& label,
                         std::vector<CheckTarget>& to) {
  std::map<std::string, std::vector<AtlasRect>> by_name;
  for (const LayoutFacts::Place& place : facts.places)
    if (!place.rect.holds_all()) by_name[place.material].push_back(place.rect);
  std::vector<std::vector<AtlasRect>> known;
  const std::size_t first = to.size();
  for (const auto& [name, rects] : by_name) {
    const auto row = rows.find(name);
    const std::string layers = row != rows.end() ? row->second->layers : "";
    std::vector<AtlasRect> nameless = rects;
    for (AtlasRect& rect : nameless) rect.name.clear();
    if (const auto same = std::ranges::find(known, nameless); same != known.end()) {
      // Layers explain a tile only if those of all its materials do.
      CheckTarget& shared = to[first + static_cast<std::size_t>(same - known.begin())];
      if (layers.empty()) shared.manifest.tiles[0].layers.clear();
      continue;
    }
    known.push_back(std::move(nameless));
    CheckTarget target = to[static_cast<std::size_t>(rects[0].page)];
    target.label = label + "#/materials/" + name;
    target.manifest.layout_alone = false;
    target.manifest.scene.clear();
    target.manifest.parts = rects;
    CheckTile tile;
    tile.name = tile.island_of = name;
    tile.layers = layers;
    tile.page = rects[0].page;
    tile.box = {0, 0, rects[0].source_width, rects[0].source_height};
    tile.gutter = tile.mips = 0;
    target.manifest.tiles = {tile};
    to.push_back(std::move(target));
  }
}

std::vector<CheckTarget> targets_of(LayoutFacts facts, const std::string& path, const std::string& label) {
  std::vector<CheckTarget> targets;
  for (const LayoutFacts::Page& page : facts.pages) {
    CheckTarget& target = targets.emplace_back();
    target.manifest = facts.common;
    target.manifest.one_texture = page.one_texture;
    target.label = label + "#/pages/" + std::to_string(targets.size() - 1);
    for (const auto& [role, name, channels] : page.files) {
      target.files.push_back({role, beside(path, name), beside(label, name), false, channels});
      if (role != FileRole::other) target.label = target.files.back().label;
    }
  }
  RowsByName by_name;
  for (const AtlasMaterialRow& row : facts.materials) by_name.try_emplace(row.name, &row);
  // Materials that share texels have a rectangle each, all of the same place, which is one tile: by place its number on
  // the page.
  std::map<std::tuple<int, int, int, int, int>, std::size_t> seen;
  for (auto& [name, tile, rect] : facts.places) {
    const PixelBox& box = tile.box;
    CheckTarget& target = targets[static_cast<std::size_t>(tile.page)];
    target.manifest.layout_alone = target.manifest.layout_alone || !rect.holds_all();
    if (!rect.holds_all() && box.width == 1 && box.height == 1) continue;  // a number is no picture
    const auto row = by_name.find(name);
    tile.layers = row != by_name.end() ? row->second->layers : "";
    std::vector<CheckTile>& tiles = target.manifest.tiles;
    const auto [known, fresh] =
        seen.try_emplace({tile.page, box.x, box.y, box.width, box.height}, tiles.size());
    if (!fresh) {
      if (tile.layers.empty()) tiles[known->second].layers.clear();
      continue;
    }
    if (row != by_name.end())
      for (const Texture texture : both_textures)
        tile.flat[static_cast<std::size_t>(texture)] = flat_codes(*row->second, texture);
    if (row != by_name.end() && facts.pages[static_cast<std::size_t>(tile.page)].spread)
      tile.flat_f0 = flat_f0(*row->second);
    tiles.push_back(std::move(tile));
  }
  CheckTarget numbers = target_of_numbers(facts, label);
  if (!numbers.manifest.tiles.empty()) targets.push_back(std::move(numbers));
  add_materials_apart(facts, by_name, label, targets);
  return targets;
}

}  // namespace

std::vector<CheckTarget> targets_of_layout(const std::string& path, const std::string& label) {
  return targets_of_layout_text(read_file(path), path, label);
}

std::vector<CheckTarget> targets_of_layout_text(const std::string& text, const std::string& path,
                                                const std::string& label) {
  const JsonDocument document = parse_json_strictly(text, label, 16, "an atlas layout");
  return targets_of(read_facts(JsonNode{document, label, {}}, path), path, label);
}

std::vector<CheckTarget> targets_of_layout(const AtlasLayout& layout, const std::string& path,
                                           const std::string& label) {
  return targets_of(facts_of(layout, path), path, label);
}

}  // namespace etak
