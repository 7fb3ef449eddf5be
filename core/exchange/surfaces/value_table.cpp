// SPDX-License-Identifier: Apache-2.0
// Tables of `etak export --to values --format csv`.
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/csv.h"
#include "core/color/srgb.h"
#include "core/exchange/engine_values.h"
#include "core/exchange/surfaces/document.h"
#include "core/exchange/surfaces/models.h"

namespace etak {
namespace {

constexpr std::string_view columns = "id,dataset,target,field,text,value1,value2,value3";
constexpr std::size_t at_id = 0, at_target = 2, at_field = 3, at_text = 4, at_value1 = 5, at_value3 = 7;

// The model of a target; "values" where its fields are names of an engine's own.
std::string model_of_target(std::string_view name) {
  constexpr std::array pairs{std::pair{"openpbr", "open_pbr_surface"},
                             std::pair{"openpbr-adobe", "open_pbr_surface"},
                             std::pair{"standard-surface", "standard_surface"},
                             std::pair{"gltf-pbr", "gltf_pbr"},
                             std::pair{"usd", "UsdPreviewSurface"},
                             std::pair{"gltf-specular-glossiness", "gltf"}};
  for (const auto& [of, model] : pairs)
    if (of == name) return model;
  return is_surface_model(name) ? std::string(name) : "values";
}

SurfaceInput input_of(const CsvRow& row, const std::string& file) {
  SurfaceInput out{row.fields[at_field], "line " + std::to_string(row.line), {}};
  for (std::size_t c = at_value1; c <= at_value3 && !row.fields[c].empty(); ++c) {
    double value = 0;
    if (!parse_number(row.fields[c], value))
      throw Error::at_line(file, row.line,
                           "value" + std::to_string(c - at_value1 + 1) + " " + in_quotes(row.fields[c]),
                           "a number");
    out.values.push_back(value);
  }
  // Blender's Metallic BSDF has an IOR of three numbers.
  if (out.name == "IOR" && out.values.size() == 1) out.name = "ior";
  // Codes of 8 bits stand for linear colours.
  if (row.fields[at_target] == "srgb8" || row.fields[at_target] == "hex") {
    out.written = out.values;
    for (double& value : out.values)
      if (std::abs(value) <= 1e6) value = srgb_decode(value / 255);
  }
  return out;
}

}  // namespace

bool is_value_table(std::string_view head) {
  if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
  return head.starts_with(columns);
}

std::vector<DocumentSurface> surfaces_of_table(std::string_view text, const std::string& file) {
  if (!is_value_table(text)) throw Error::at_line(file, 1, "another header", std::string(columns));
  std::vector<DocumentSurface> out;
  std::string last;
  std::vector<CsvRow> rows = csv_rows(text, file);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const CsvRow& row = rows[i];
    if (row.fields.size() <= at_value3)
      throw Error::at_line(file, row.line, std::to_string(row.fields.size()) + " fields",
                           "those of the header");
    if (engine_target(row.fields[at_target]) == nullptr)
      throw Error::at_line(file, row.line, "the target " + in_quotes(row.fields[at_target]),
                           "a target of etak export");
    if (row.fields[at_text].empty()) continue;
    const std::string key = row.fields[at_id] + '/' + row.fields[1] + '/' + row.fields[at_target];
    if (key != last)
      out.push_back(
          {row.fields[at_id], model_of_target(row.fields[at_target]), "line " + std::to_string(row.line)});
    last = key;
    out.back().inputs.push_back(input_of(row, file));
  }
  if (out.empty()) throw Error::at(file, "no row of a field", "rows below the header");
  return out;
}

}  // namespace etak
