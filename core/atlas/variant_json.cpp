// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/variant.h"

#include <algorithm>
#include <set>

#include "core/base/json/node_json.h"

namespace etak {
namespace {

constexpr std::string_view choices_schema = "etak-choose/2";

std::array<double, 3> colour(const JsonNode& node) {
  return node.each_of<3>(&JsonNode::number, "three numbers");
}

MaterialVariant read_variant(const JsonNode& node) {
  node.expect_object();
  MaterialVariant out;
  out.material = node.at("material").text();
  out.library = node.text_or_empty("library");
  out.model = node.at("model").text();
  out.method = node.text_or_empty("integration");
  out.filter = node.at("filter").text();
  out.textured = node.at("textured").boolean();
  out.values = node.at("values").each(&JsonNode::number);
  out.diffuse = colour(node.at("diffuse"));
  out.f0 = colour(node.at("f0"));
  out.gloss = node.at("gloss").number();
  // Files of earlier versions hold the gloss alone. Where a file holds a roughness too, that one is read: the
  // value is then equal to the one that was written.
  if (node.has("roughness"))
    if (const Gloss rough = Gloss::of_roughness(node.at("roughness").number()); rough.held())
      out.gloss = rough;
  const auto code = [](const JsonNode& each) { return static_cast<std::uint8_t>(each.integer(0, 255)); };
  out.codes = node.at("codes").each_of<channel_count>(code, "eight codes");
  out.defines = node.at("defines").texts();
  return out;
}

}  // namespace

ShadingVariants parse_choices(std::string_view text, std::string_view file) {
  const JsonDocument document = parse_json_strictly(text, file, 6, "a choice");
  const JsonNode root{document, file, {}};
  root.expect_object();
  if (root.text_or_empty("schema") != choices_schema)
    root.fail("not what etak choose --format json writes",
              "\"schema\": \"" + std::string(choices_schema) + '"');
  ShadingVariants out;
  out.png_level = root.at("png_level").text();
  const JsonNode choices = root.at("choices");
  choices.expect_array();
  std::set<std::string> names;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    MaterialVariant variant = read_variant(choices.at(i));
    if (!names.insert(variant.material).second)
      choices.at(i).at("material").fail("\"" + variant.material + "\" a second time", "each material once");
    out.materials.push_back(std::move(variant));
  }
  std::ranges::sort(out.materials, {}, &MaterialVariant::material);
  return out;
}

}  // namespace etak
