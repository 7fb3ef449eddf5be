// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/layout.h"

#include <algorithm>
#include <span>

#include "core/base/files/output_folder.h"
#include "core/base/json/json_text.h"
#include "core/base/json/node_json.h"
#include "core/image/image.h"
#include "core/image/load.h"

namespace etak {
namespace {

constexpr const char* layout_schema = "etak-atlas-layout/1";
// The schema of layouts in which a material's parts lie apart: a reader of version 1 would take the first region for all.
constexpr const char* parts_schema = "etak-atlas-layout/2";
constexpr int layout_depth = 8;
constexpr std::array<std::string_view, 2> fourth_names{"alpha", "gloss"};  // by Texture
constexpr const char *reduced = "reduced_when_shading", *as_it_is = "as_it_is";

std::string box_json(const PixelBox& box) {
  return "[" + std::to_string(box.x) + ", " + std::to_string(box.y) + ", " + std::to_string(box.width) +
         ", " + std::to_string(box.height) + "]";
}

// The first file is the texture by name; the rest are the same in other formats, and mips in files of
// their own.
std::string page_json(const AtlasPage& page) {
  std::string out = "{";
  for (const Texture texture : both_textures) {
    const auto& files = page.files[static_cast<std::size_t>(texture)];
    out += json(name(texture)) + ": " + (files.empty() ? "null" : json(files[0])) + ", ";
  }
  out += "\"width\": " + std::to_string(page.width) + ", \"height\": " + std::to_string(page.height);
  for (const Texture texture : both_textures) {
    const auto& files = page.files[static_cast<std::size_t>(texture)];
    if (files.size() > 1)
      out += ", " + json(std::string(name(texture)) + "_more") + ": " +
             json_array_of(std::span(files).subspan(1));
  }
  if (!page.in_blocks.empty()) out += ", \"specular_gloss_in_blocks\": " + json_array_of(page.in_blocks);
  std::vector<std::string> apart, tails;
  for (const Texture texture : both_textures) {
    const auto t = static_cast<std::size_t>(texture);
    if (page.fourth_apart[t]) apart.emplace_back(fourth_names[t]);
    if (page.tail_apart[t]) tails.emplace_back(name(texture));
  }
  if (!apart.empty()) out += ", \"apart_in_blocks\": " + json_array_of(apart);
  if (!tails.empty()) out += ", \"tails_apart\": " + json_array_of(tails);
  return out + "}";
}

std::string rect_json(const AtlasRect& r) {
  std::string out = "{\"name\": " + json(r.name) + ", \"page\": " + std::to_string(r.page) +
                    ", \"x\": " + std::to_string(r.x) + ", \"y\": " + std::to_string(r.y) +
                    ", \"w\": " + std::to_string(r.width) + ", \"h\": " + std::to_string(r.height) +
                    ", \"rotated\": " + json(r.rotated) + ", \"crop\": " + box_json(r.crop) +
                    ", \"source\": [" + std::to_string(r.source_width) + ", " +
                    std::to_string(r.source_height) + "], \"gutter\": " + std::to_string(r.gutter) +
                    ", \"mips\": " + std::to_string(r.mips);
  if (r.island > 0) out += ", \"island\": " + std::to_string(r.island);
  if (r.inset > 0) out += ", \"inset\": " + json(r.inset);
  if (r.repeats) out += ", \"repeats\": true";
  if (r.source_gutter) out += ", \"source_gutter\": true";
  if (!r.holds_all()) {
    std::vector<std::string> parts;
    for (std::size_t p = 0; p < channel_parts.size(); ++p)
      if (r.holds[p]) parts.emplace_back(channel_parts[p].name);
    out += ", \"parts\": " + json_array_of(parts);
  }
  return out + "}";
}

std::string material_json(const AtlasMaterialRow& m) {
  std::string constants;
  for (std::size_t c = 0; c < channel_count; ++c)
    if (m.constant[c])
      constants +=
          (constants.empty() ? "" : ", ") + json(channel_names[c]) + ": " + std::to_string(*m.constant[c]);
  std::string out = "{\"name\": " + json(m.name) + ", \"texels\": " + json(m.texels) +
                    ", \"alpha_mode\": " + json(name(m.alpha_mode));
  if (m.alpha_mode == AlphaMode::mask) out += ", \"alpha_cutoff\": " + json(m.alpha_cutoff);
  out += ", \"constant\": {" + constants + "}";
  std::string values;
  for (std::size_t c = 0; c < channel_count; ++c)
    if (m.value[c])
      values += (values.empty() ? "" : ", ") + json(channel_names[c]) + ": " + json(*m.value[c]);
  if (!values.empty()) out += ", \"value\": {" + values + "}";
  if (!m.layers.empty()) out += ", \"layers\": " + json(m.layers);
  return out + ", \"defines\": " + json_array_of(m.defines) + "}";
}

template <class Rows, class Form>
std::string rows_json(const Rows& rows, Form form) {
  std::string out = "[";
  for (std::size_t i = 0; i < rows.size(); ++i)
    out += std::string(i == 0 ? "\n" : ",\n") + "    " + form(rows[i]);
  return out + (rows.empty() ? "]" : "\n  ]");
}

PixelBox box_of(const JsonNode& node) {
  node.expect_array();
  if (node.size() != 4) node.fail_type("[x, y, width, height]");
  return {node.at(0).integer(0, max_image_side), node.at(1).integer(0, max_image_side),
          node.at(2).integer(1, max_image_side), node.at(3).integer(1, max_image_side)};
}

// The name of a file of the atlas. The packer replaces and removes files of these names in its folder, and a
// layout may come from anyone: a name with a folder in it is refused.
std::string read_file_name(const JsonNode& node) {
  std::string out = node.text();
  if (!is_plain_file_name(out)) node.fail(in_quotes(out), "a file name without folders");
  return out;
}

bool is_container(std::string_view file) {
  return is_gpu_texture(file.substr(file.rfind('.') + 1));
}

AtlasPage read_page(const JsonNode& node) {
  node.expect_object();
  AtlasPage out;
  out.width = node.at("width").integer(1, max_image_side);
  out.height = node.at("height").integer(1, max_image_side);
  for (const Texture texture : both_textures) {
    auto& files = out.files[static_cast<std::size_t>(texture)];
    const JsonNode first = node.at(name(texture));
    if (!first.value.is_null()) files.push_back(read_file_name(first));
    const std::string more = std::string(name(texture)) + "_more";
    if (!node.has(more)) continue;
    if (files.empty()) node.at(more).fail_type("nothing where " + std::string(name(texture)) + " is null");
    for (std::string& each : node.at(more).each(read_file_name)) files.push_back(std::move(each));
  }
  out.in_blocks = read_channels_in_blocks(node);
  out.fourth_apart = read_fourth_apart(node);
  out.tail_apart = read_tail_apart(node);
  return out;
}

AtlasMaterialRow read_material_row(const JsonNode& node) {
  node.expect_object();
  AtlasMaterialRow out;
  out.name = node.at("name").text();
  out.texels = node.at("texels").boolean();
  out.alpha_mode = node.at("alpha_mode").word(alpha_mode_named, alpha_mode_names);
  if (out.alpha_mode == AlphaMode::mask && node.has("alpha_cutoff"))
    out.alpha_cutoff = node.at("alpha_cutoff").number();
  const JsonNode constant = node.at("constant");
  constant.expect_object();
  for (std::size_t c = 0; c < channel_count; ++c)
    if (constant.has(channel_names[c]))
      out.constant[c] = static_cast<std::uint8_t>(constant.at(channel_names[c]).integer(0, 255));
  if (node.has("value"))
    for (std::size_t c = 0; c < channel_count; ++c)
      if (node.at("value").has(channel_names[c]))
        out.value[c] = node.at("value").at(channel_names[c]).number();
  out.layers = node.text_or_empty("layers");
  out.defines = node.at("defines").texts();
  return out;
}

}  // namespace

bool AtlasPage::first_in_blocks() const {
  const auto& all = files[static_cast<std::size_t>(Texture::specular_gloss)];
  return !in_blocks.empty() && !all.empty() && is_container(all[0]);
}

namespace {

std::string file_beside(const std::string& page_file, Texture texture, const std::string& what) {
  const std::size_t at = page_file.rfind('_' + std::string(name(texture)) + '.');
  if (at == page_file.npos || !is_container(page_file)) return {};
  return page_file.substr(0, at + 1) + what + page_file.substr(page_file.rfind('.'));
}

}  // namespace

std::string fourth_file_beside(const std::string& page_file, Texture texture) {
  return file_beside(page_file, texture, std::string(fourth_names[static_cast<std::size_t>(texture)]));
}

std::string tail_file_beside(const std::string& page_file, Texture texture) {
  return file_beside(page_file, texture, std::string(name(texture)) + "_tail");
}

std::string AtlasPage::fourth_beside_first(Texture texture) const {
  const auto t = static_cast<std::size_t>(texture);
  return fourth_apart[t] && !files[t].empty() ? fourth_file_beside(files[t].front(), texture) : "";
}

std::string AtlasPage::tail_beside_first(Texture texture) const {
  const auto t = static_cast<std::size_t>(texture);
  return tail_apart[t] && !files[t].empty() ? tail_file_beside(files[t].front(), texture) : "";
}

namespace {

// By Texture whether a list of a page has its name.
std::array<bool, 2> read_marks(const JsonNode& page, std::string_view key,
                               const std::array<std::string_view, 2>& names) {
  std::array<bool, 2> out{};
  if (!page.has(key)) return out;
  for (const std::string& each : page.at(key).texts()) {
    const auto found = std::ranges::find(names, each);
    if (found == names.end())
      page.at(key).fail_type("some of " + std::string(names[0]) + " and " + std::string(names[1]));
    out[static_cast<std::size_t>(found - names.begin())] = true;
  }
  return out;
}

}  // namespace

std::array<bool, 2> read_fourth_apart(const JsonNode& page) {
  return read_marks(page, "apart_in_blocks", fourth_names);
}

std::array<bool, 2> read_tail_apart(const JsonNode& page) {
  return read_marks(page, "tails_apart", {name(Texture::diffuse_alpha), name(Texture::specular_gloss)});
}

std::vector<std::string> read_channels_in_blocks(const JsonNode& page) {
  constexpr const char* key = "specular_gloss_in_blocks";
  if (!page.has(key)) return {};
  std::vector<std::string> out = page.at(key).texts();
  if (out != std::vector<std::string>{"gloss"} && out != std::vector<std::string>{"specular", "gloss"})
    page.at(key).fail_type("[\"gloss\"], or [\"specular\", \"gloss\"]");
  return out;
}

AtlasRect read_layout_rect(const JsonNode& node, std::size_t pages) {
  node.expect_object();
  AtlasRect out;
  out.name = node.at("name").text();
  out.page = node.at("page").integer(0, static_cast<int>(pages) - 1);
  out.x = node.at("x").integer(0, max_image_side);
  out.y = node.at("y").integer(0, max_image_side);
  out.width = node.at("w").integer(1, max_image_side);
  out.height = node.at("h").integer(1, max_image_side);
  out.rotated = node.at("rotated").boolean();
  out.crop = box_of(node.at("crop"));
  const auto side = [](const JsonNode& each) { return each.integer(1, max_image_side); };
  const auto source = node.at("source").each_of<2>(side, "[width, height]");
  out.source_width = source[0];
  out.source_height = source[1];
  out.gutter = node.at("gutter").integer(0, max_image_side);
  out.mips = node.at("mips").integer(1, 15);
  if (node.has("island")) out.island = node.at("island").integer(0);
  if (node.has("inset")) {
    out.inset = node.at("inset").number();
    if (out.inset < 0) node.at("inset").fail_type("a number of texels, 0 or above");
  }
  if (node.has("repeats")) out.repeats = node.at("repeats").boolean();
  if (node.has("source_gutter")) out.source_gutter = node.at("source_gutter").boolean();
  if (!node.has("parts")) return out;
  out.holds.fill(false);
  const std::vector<std::string> parts = node.at("parts").texts();
  for (const std::string& part : parts) {
    const auto found = std::ranges::find(channel_parts, part, &ChannelPart::name);
    if (found == channel_parts.end()) node.at("parts").fail_type("diffuse, alpha, specular or gloss");
    out.holds[static_cast<std::size_t>(found - channel_parts.begin())] = true;
  }
  return out;
}

std::string layout_json(const AtlasLayout& layout) {
  std::vector<JsonMember> members{
      {"schema",
       json(std::ranges::all_of(layout.rects, &AtlasRect::holds_all) ? layout_schema : parts_schema)},
      {"settings_hash", json(layout.settings_hash)},
      {"content_hash", json(layout.content_hash)},
      {"gloss", json(name(layout.gloss))},
      {"diffuse", json(layout.diffuse_reduced ? reduced : as_it_is)},
      {"levels", std::to_string(layout.levels)},
      {"pages", rows_json(layout.pages, page_json)},
      {"rects", rows_json(layout.rects, rect_json)},
      {"materials", rows_json(layout.materials, material_json)},
      {"other_files", json_array_of(layout.other_files)},
  };
  std::vector<JsonMember> hashes;
  for (const auto& [file, hash] : layout.xxh128) hashes.push_back({file, json(hash)});
  if (!hashes.empty()) members.push_back({"xxh128", json_object(hashes, 2)});
  return json_object(members, 0) + "\n";
}

AtlasLayout parse_layout(std::string_view text, std::string_view file) {
  const JsonDocument document = parse_json_strictly(text, file, layout_depth, "an atlas layout");
  const JsonNode root{document, file, {}};
  root.expect_object();
  if (const std::string schema = root.text_or_empty("schema");
      schema != layout_schema && schema != parts_schema)
    root.fail("not an atlas layout", std::string("\"schema\": \"") + layout_schema + "\"");
  AtlasLayout out;
  out.gloss = root.at("gloss").word(gloss_form_named, "schueler, one_minus_roughness or roughness");
  if (root.has("diffuse")) {
    const std::string diffuse = root.at("diffuse").text();
    if (diffuse != reduced && diffuse != as_it_is)
      root.at("diffuse").fail_type("reduced_when_shading or as_it_is");
    out.diffuse_reduced = diffuse == reduced;
  }
  out.levels = root.at("levels").integer(1, 15);
  out.settings_hash = root.text_or_empty("settings_hash");
  out.content_hash = root.text_or_empty("content_hash");
  out.pages = root.at("pages").each(read_page);
  out.rects =
      root.at("rects").each([&](const JsonNode& rect) { return read_layout_rect(rect, out.pages.size()); });
  out.materials = root.at("materials").each(read_material_row);
  if (root.has("other_files")) out.other_files = root.at("other_files").each(read_file_name);
  if (root.has("xxh128")) {
    const JsonNode hashes = root.at("xxh128");
    hashes.expect_object();
    for (const auto& [name, ignored] : hashes.value.items()) out.xxh128[name] = hashes.at(name).text();
  }
  return out;
}

}  // namespace etak
