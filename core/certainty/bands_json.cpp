// SPDX-License-Identifier: Apache-2.0
// The table of quantiles as JSON: resources/bands.json.
#include "core/base/json/json_text.h"
#include "core/base/json/node_json.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/certainty/bands.h"
#include "core/certainty/bands_file.h"

namespace etak {
namespace {

constexpr std::string_view bands_schema = "etak-bands/1";
constexpr int band_digits = 4;

std::string json(const Offsets& values) {
  return "[" + joined(values, ", ", [](double value) { return number(value, band_digits); }) + "]";
}

Offsets offsets_of(const JsonNode& node) {
  Offsets out{};
  if (!node.value.is_array() || node.value.size() != out.size()) node.fail_type("5 numbers");
  for (std::size_t i = 0; i < out.size(); ++i) {
    const JsonNode value = node.at(i);
    out[i] = value.number();
    if (!(out[i] >= 0)) value.fail_type("a number of at least 0");
  }
  return out;
}

std::size_t count_of(const JsonNode& node) {
  const double value = node.number();
  if (!(value >= 0 && value < 1e6)) node.fail_type("a count");
  return static_cast<std::size_t>(value);
}

}  // namespace

BandTable parse_bands(std::string_view text, std::string_view file) {
  const JsonDocument document = parse_json_strictly(text, file, 4, "a table of bands");
  const JsonNode root{document, file, ""};
  root.expect_object({"schema", "made", "classes", "nine", "computed"});
  if (root.at("schema").text() != bands_schema)
    root.at("schema").fail_type('"' + std::string(bands_schema) + '"');
  BandTable out;
  out.made = root.at("made").text();
  const JsonNode classes = root.at("classes");
  classes.expect_object();
  for (std::size_t kind = 0; kind < band_class_count; ++kind) {
    const JsonNode node = classes.at(name(static_cast<BandClass>(kind)));
    node.expect_object({"materials", "publications", "mean", "half_one", "half_several"});
    BandTable::OfClass& of = out.classes[kind];
    of.materials = count_of(node.at("materials"));
    of.publications = count_of(node.at("publications"));
    of.mean = offsets_of(node.at("mean"));
    of.half_one = offsets_of(node.at("half_one"));
    of.half_several = offsets_of(node.at("half_several"));
  }
  root.at("nine").expect_object({"one", "several"});
  out.nine_one = offsets_of(root.at("nine").at("one"));
  out.nine_several = offsets_of(root.at("nine").at("several"));
  const JsonNode computed = root.at("computed");
  computed.expect_object({"pairs", "half", "nine"});
  out.computed = count_of(computed.at("pairs"));
  out.computed_half = offsets_of(computed.at("half"));
  out.computed_nine = offsets_of(computed.at("nine"));
  return out;
}

const BandTable& shipped_bands() {
  static const BandTable table = parse_bands(bands_file, "<built-in table of bands>");
  return table;
}

std::string format_bands(const BandTable& table) {
  std::vector<JsonMember> classes;
  for (std::size_t kind = 0; kind < band_class_count; ++kind) {
    const BandTable::OfClass& of = table.classes[kind];
    classes.push_back(
        {name(static_cast<BandClass>(kind)), json_object({{"materials", etak::json(of.materials)},
                                                          {"publications", etak::json(of.publications)},
                                                          {"mean", json(of.mean)},
                                                          {"half_one", json(of.half_one)},
                                                          {"half_several", json(of.half_several)}},
                                                         -1)});
  }
  return json_document(
      bands_schema,
      {{"made", etak::json(table.made)},
       {"classes", json_object(classes, 2)},
       {"nine", json_object({{"one", json(table.nine_one)}, {"several", json(table.nine_several)}}, -1)},
       {"computed", json_object({{"pairs", etak::json(table.computed)},
                                 {"half", json(table.computed_half)},
                                 {"nine", json(table.computed_nine)}},
                                -1)}});
}

}  // namespace etak
