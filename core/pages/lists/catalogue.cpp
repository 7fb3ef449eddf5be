// SPDX-License-Identifier: Apache-2.0
#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/base/text/csv.h"
#include "core/base/text/text_table.h"
#include "core/color/srgb.h"
#include "core/pages/lists/lists.h"
#include "core/pages/swatch.h"

namespace etak {
namespace {

constexpr int list_digits = 9;

// A swatch of two columns and a blank; only blanks where there is no colour.
std::string swatch_cell(const F0Result& result) {
  return (result.refused() ? "  " : swatch(result.srgb8, 2)) + " ";
}

std::string flag_names(const CatalogueEntry& entry) {
  std::string out;
  entry.result.flags.for_each([&](Flag flag) { append(out, out.empty() ? "" : ";", name(flag)); });
  return out;
}

std::string flag_array(const CatalogueEntry& entry) {
  std::vector<std::string> out;
  entry.result.flags.for_each([&](Flag flag) { out.push_back(json(name(flag))); });
  return json_array(out);
}

std::string catalogue_object(const CatalogueEntry* entry) {
  const Material& material = entry->material;
  const F0Result& result = entry->result;
  std::vector<JsonMember> members{{"id", json(material.id)},
                                  {"name", json(material.name)},
                                  {"aliases", json_array_of(material.aliases)},
                                  {"class", json(material.material_class)}};
  if (!material.group.empty()) members.push_back({"group", json(material.group)});
  members.push_back({"datasets", json(material.datasets.size())});
  members.push_back({"preferred", json(material.preferred_dataset().id)});
  members.push_back({"kind", json(name(material.preferred_dataset().origin))});
  members.push_back({"flags", flag_array(*entry)});
  if (result.refused()) {
    members.push_back({"refusal", json(result.refusal)});
  } else {
    members.push_back({"hex", json(hex(result.srgb8))});
    members.push_back({"Y", number(result.luminance, list_digits)});
    members.push_back({"zone", result.zone ? json(name(*result.zone)) : "null"});
  }
  return json_object(members, -1);
}

std::string near_object(const NearMaterial& near) {
  const Material& material = near.entry->material;
  return json_object({{"delta_e2000", number(near.delta_e, list_digits)},
                      {"hex", json(hex(near.entry->result.srgb8))},
                      {"id", json(material.id)},
                      {"name", json(material.name)},
                      {"class", json(material.material_class)},
                      {"kind", json(name(material.preferred_dataset().origin))},
                      {"flags", flag_array(*near.entry)}},
                     -1);
}

}  // namespace

std::string catalogue_table(std::span<const CatalogueEntry* const> entries, bool color) {
  std::vector<TextRow> rows{
      {{"id", "name", "class", "datasets", "sRGB   ", "Y     ", "zone  ", "quality"}, color ? "   " : ""}};
  for (const CatalogueEntry* entry : entries) {
    const Material& material = entry->material;
    const F0Result& result = entry->result;
    TextRow& row = rows.emplace_back();
    if (color) row.before = swatch_cell(result);
    row.cells = {material.id, material.name, material.material_class,
                 std::to_string(material.datasets.size())};
    const std::vector<std::string> rest =
        result.refused() ? std::vector<std::string>{"refused: " + result.refusal}
                         : std::vector<std::string>{hex(result.srgb8), number(result.luminance, 4),
                                                    std::string(result.zone ? name(*result.zone) : "-"),
                                                    quality_text(*entry)};
    row.cells.insert(row.cells.end(), rest.begin(), rest.end());
  }
  return text_table(rows);
}

std::string catalogue_csv(std::span<const CatalogueEntry* const> entries) {
  std::string out = "id,name,class,datasets,preferred,hex,Y,zone,refusal,kind,flags\n";
  for (const CatalogueEntry* entry : entries) {
    const Material& material = entry->material;
    const F0Result& result = entry->result;
    const bool good = !result.refused();
    append_csv_row(
        out, {material.id, material.name, material.material_class, std::to_string(material.datasets.size()),
              material.preferred_dataset().id, good ? hex(result.srgb8) : "",
              good ? number(result.luminance, list_digits) : "", result.zone ? name(*result.zone) : "",
              result.refusal, name(material.preferred_dataset().origin), flag_names(*entry)});
  }
  return out;
}

std::string catalogue_json(std::span<const CatalogueEntry* const> entries) {
  return json_document("etak-list/1", {{"materials", json_lines_of(entries, 2, catalogue_object)}});
}

std::string catalogue_jsonl(std::span<const CatalogueEntry* const> entries) {
  std::string out;
  for (const CatalogueEntry* entry : entries) append(out, catalogue_object(entry), '\n');
  return out;
}

std::string nearest_table(std::span<const NearMaterial> found, bool color) {
  std::vector<TextRow> rows{{{"dE2000", "sRGB   ", "id", "name", "class", "quality"}, color ? "   " : ""}};
  for (const NearMaterial& near : found) {
    const Material& material = near.entry->material;
    const F0Result& result = near.entry->result;
    rows.push_back({{number(near.delta_e, 4), hex(result.srgb8), material.id, material.name,
                     material.material_class, quality_text(*near.entry)},
                    color ? swatch_cell(result) : ""});
  }
  return text_table(rows);
}

std::string nearest_csv(std::span<const NearMaterial> found) {
  std::string out = "delta_e2000,hex,id,name,class,kind,flags\n";
  for (const NearMaterial& near : found) {
    const Material& material = near.entry->material;
    append_csv_row(
        out, {number(near.delta_e, list_digits), hex(near.entry->result.srgb8), material.id, material.name,
              material.material_class, name(material.preferred_dataset().origin), flag_names(*near.entry)});
  }
  return out;
}

std::string nearest_json(std::span<const NearMaterial> found, std::string_view asked, bool linear) {
  return json_document(
      "etak-nearest/1",
      {{"color", json(asked)}, {"linear", json(linear)}, {"nearest", json_lines_of(found, 2, near_object)}});
}

}  // namespace etak
