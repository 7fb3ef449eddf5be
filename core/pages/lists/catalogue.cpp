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

// The distance over the nine-tenths radius of the band.
std::optional<double> share_of(const NearMaterial& near, const BandOfF0& its) {
  return its.band ? std::optional(near.delta_e / its.band->de90) : std::nullopt;
}

std::string near_object(const NearMaterial& near, std::optional<double> share) {
  const Material& material = near.entry->material;
  return json_object({{"delta_e2000", number(near.delta_e, list_digits)},
                      {"band_share", share ? number(*share, list_digits) : "null"},
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

std::string nearest_table(std::span<const NearMaterial> found, std::span<const BandOfF0> bands, bool color) {
  std::vector<TextRow> rows{
      {{"dE2000", "of band", "sRGB   ", "id", "name", "class", "quality"}, color ? "   " : ""}};
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Material& material = found[i].entry->material;
    const F0Result& result = found[i].entry->result;
    const auto share = share_of(found[i], bands[i]);
    rows.push_back({{number(found[i].delta_e, 4), share ? fixed(*share, 2) : "-", hex(result.srgb8),
                     material.id, material.name, material.material_class, quality_text(*found[i].entry)},
                    color ? swatch_cell(result) : ""});
  }
  std::string out = text_table(rows);
  for (const auto& group : not_told_apart(bands))
    append(out, "not told apart: ",
           joined(group, ", ", [&](std::size_t i) { return found[i].entry->material.id; }), '\n');
  return out;
}

std::string nearest_csv(std::span<const NearMaterial> found, std::span<const BandOfF0> bands) {
  std::string out = "delta_e2000,hex,id,name,class,kind,flags,band_share\n";
  for (std::size_t i = 0; i < found.size(); ++i) {
    const NearMaterial& near = found[i];
    const Material& material = near.entry->material;
    const auto share = share_of(near, bands[i]);
    append_csv_row(out, {number(near.delta_e, list_digits), hex(near.entry->result.srgb8), material.id,
                         material.name, material.material_class, name(material.preferred_dataset().origin),
                         flag_names(*near.entry), share ? number(*share, list_digits) : ""});
  }
  return out;
}

std::string nearest_json(std::span<const NearMaterial> found, std::span<const BandOfF0> bands,
                         std::string_view asked, bool linear) {
  std::vector<std::string> rows, groups;
  for (std::size_t i = 0; i < found.size(); ++i)
    rows.push_back(near_object(found[i], share_of(found[i], bands[i])));
  for (const auto& group : not_told_apart(bands)) {
    std::vector<std::string> ids;
    for (const std::size_t i : group) ids.push_back(json(found[i].entry->material.id));
    groups.push_back(json_array(ids));
  }
  return json_document("etak-nearest/1", {{"color", json(asked)},
                                          {"linear", json(linear)},
                                          {"nearest", json_lines(rows, 2)},
                                          {"groups", json_array(groups)}});
}

}  // namespace etak
