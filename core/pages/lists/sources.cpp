// SPDX-License-Identifier: Apache-2.0
#include "core/pages/lists/sources.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/base/text/csv.h"
#include "core/base/text/text.h"
#include "core/base/text/text_table.h"
#include "core/color/gloss.h"
#include "core/color/srgb.h"
#include "core/light/functions.h"
#include "core/material/find.h"
#include "core/material/names.h"
#include "core/material/quality.h"
#include "core/math/functions.h"
#include "core/pages/lists/sources_file.h"
#include "core/study/choose/choose.h"

namespace etak {
namespace {

constexpr const char* place = "resources/sources.csv";
constexpr int reader_digits = 4, program_digits = 9;

std::vector<double> numbers_of(std::string_view text) {
  std::vector<double> out;
  for (const std::string& part : parts_of(text, ' ')) {
    double value = 0;
    if (!parse_number(part, value)) throw Error::at(place, part, "a number");
    out.push_back(value);
  }
  return out;
}

// F0 of a dataset "gold" or "gold/johnson-1972", by the method of a last word "method=NAME".
F0Result f0_of(const MaterialLibrary& library, const std::string& name,
               const std::vector<std::string>& words) {
  const auto found = find_material(library, name);
  if (!found) throw Error::at(place, name, "a material of the library");
  const Material& material = found->answer.material;
  F0Options options;
  if (const std::string& last = words.back(); last.starts_with("method="))
    options.method = *method_named(last.substr(last.find('=') + 1));
  return solve(F0Solver(options), material, dataset_named(material, found->dataset, place));
}

// What etak has for a row, and its 8-bit codes where these are not those of the values.
struct Computed {
  std::vector<double> value;
  std::vector<double> coded;
};

Computed computed(const MaterialLibrary& library, const SourceRow& row) {
  const std::vector<std::string> words = parts_of(row.by, ' ');
  if (words.empty()) return {};
  const std::string& how = words.front();
  const std::vector<std::string> rest(words.begin() + 1, words.end());
  Computed out;
  if (how == "f0" || how == "channels") {
    const F0Result f0 = f0_of(library, rest.at(0), words);
    out.coded = {f0.srgb_linear.r, f0.srgb_linear.g, f0.srgb_linear.b};
    const auto [least, most] = std::ranges::minmax(out.coded);
    out.value = how == "f0" ? out.coded : std::vector{least, most};
    if (row.printed_codes.size() == 2) out.coded = out.value;
  } else if (how == "Y") {
    for (const std::string& name : rest) out.value.push_back(f0_of(library, name, {name}).luminance);
  } else if (how == "codes") {
    out.value = row.printed;
  } else if (how == "gloss") {
    for (const std::string& g : rest) out.value.push_back(Gloss(numbers_of(g)[0]).exponent());
  } else if (how == "contrast") {
    out.value = {rest.at(0) == "srgb" ? 1 / srgb_decode(1 / 255.0) : math::pow(255, 2.2)};
  } else if (how == "cost") {
    out.value = {shipped_costs().of(rest.at(0))};
  } else if (how == "lambert") {
    out.value = {2};  // of 1 / pi over the hemisphere's 2 pi
  } else if (const Function* const function = how == "eval" ? find_function(rest.at(0)) : nullptr) {
    std::vector<NamedText> inputs;
    for (std::size_t i = 1; i < rest.size(); ++i) inputs.push_back(split_input(rest[i], place));
    out.value = {evaluate(*function, inputs, place)};
  } else {
    throw Error::at(place, row.by, "f0, channels, Y, codes, gloss, contrast, cost, lambert or eval FUNCTION");
  }
  if (out.coded.empty()) out.coded = out.value;
  return out;
}

std::string shown(const std::vector<double>& values, int digits) {
  return joined(values, " ", [&](double value) { return number(value, digits); });
}
std::string shown(const std::vector<int>& codes) {
  return joined(codes, " ", [](int code) { return std::to_string(code); });
}
std::string difference_text(const SourceRow& row, int digits) {
  const double most = row.difference();
  return std::isnan(most) ? "" : number(most, digits);
}

std::string numbers_json(const std::vector<double>& values) {
  return "[" + joined(values, ", ", [](double value) { return number(value, program_digits); }) + "]";
}

std::string row_json(const SourceRow& row) {
  return json_object(
      {{"source", json(row.source)},
       {"table", json(row.table)},
       {"row", json(row.row)},
       {"printed", numbers_json(row.printed)},
       {"etak", numbers_json(row.value)},
       {"difference", std::isnan(row.difference()) ? "null" : number(row.difference(), program_digits)},
       {"printed_codes",
        "[" + joined(row.printed_codes, ", ", [](int c) { return std::to_string(c); }) + "]"},
       {"codes", "[" + joined(row.codes, ", ", [](int c) { return std::to_string(c); }) + "]"},
       {"by", json(row.by)},
       {"reason", json(row.reason)}},
      -1);
}

// The numbers of a reader's table: printed and etak's, with the codes in brackets.
std::string with_codes(const std::vector<double>& values, const std::vector<int>& codes) {
  std::string out = shown(values, reader_digits);
  if (!codes.empty()) append(out, out.empty() ? "" : " ", "(", shown(codes), ")");
  return out.empty() ? "-" : out;
}

}  // namespace

double SourceRow::difference() const {
  if (printed.empty() || printed.size() != value.size()) return std::numeric_limits<double>::quiet_NaN();
  double most = 0;
  for (std::size_t i = 0; i < value.size(); ++i) most = std::max(most, std::abs(value[i] - printed[i]));
  return most;
}

std::vector<SourceRow> source_rows(const MaterialLibrary& library) {
  std::vector<SourceRow> out;
  for (const CsvRow& line : csv_rows(sources_file, place)) {
    const std::vector<std::string>& fields = line.fields;
    if (fields.front() == "source") continue;
    if (fields.size() != 7)
      throw Error::at_line(place, line.line, std::to_string(fields.size()) + " fields", "7");
    SourceRow row{fields[0], fields[1], fields[2], fields[5], fields[6], numbers_of(fields[3]), {}, {}, {}};
    for (const double code : numbers_of(fields[4])) row.printed_codes.push_back(static_cast<int>(code));
    const Computed found = computed(library, row);
    row.value = found.value;
    if (!row.printed_codes.empty() || row.by == "codes")
      for (const double value : found.coded)
        row.codes.push_back(row.source == "Schueler" ? power22_u8(value) : srgb_u8(value));
    out.push_back(std::move(row));
  }
  return out;
}

std::string sources_table(const std::vector<SourceRow>& rows) {
  std::vector<TextRow> lines{{{"source", "table", "row", "printed (codes)", "etak (codes)", "by", "reason"}}};
  for (const SourceRow& row : rows)
    lines.push_back({{row.source, row.table, row.row, with_codes(row.printed, row.printed_codes),
                      with_codes(row.value, row.codes), row.by.empty() ? "-" : row.by, row.reason}});
  return text_table(lines);
}

std::string sources_csv(const std::vector<SourceRow>& rows) {
  std::string out = "source,table,row,printed,etak,difference,printed_codes,codes,by,reason\n";
  for (const SourceRow& row : rows)
    append_csv_row(out, {row.source, row.table, row.row, shown(row.printed, program_digits),
                         shown(row.value, program_digits), difference_text(row, program_digits),
                         shown(row.printed_codes), shown(row.codes), row.by, row.reason});
  return out;
}

std::string sources_json(const std::vector<SourceRow>& rows) {
  return json_document("etak-sources/1", {{"rows", json_lines_of(rows, 2, row_json)}});
}

std::string sources_markdown(const std::vector<SourceRow>& rows) {
  std::string out =
      "# What the sources print, and what etak has\n\nMade by `etak sources --format markdown` from `resources/sources.csv`. Schüler is \"An Efficient and Physically Plausible\nReal-Time Shading Model\", Hoffman \"Physically "
      "Based Shading\", TU Graz its lecture \"Shading Models\". Reflectances are linear; 8-bit\ncodes stand in brackets, by a power 1/2.2 for Schüler and by the sRGB curve else. What is wrong in print says so; what etak leaves out\nstands "
      "last, with the reason.\n";
  for (const std::string_view table : {"metals", "dielectrics", "zone", "gloss", "energy", "display",
                                       "models", "cost", "formulas", "left out"}) {
    append(out, "\n## ", table,
           "\n\n| source | row | printed | etak | by | |\n| --- | --- | --- | --- | --- | --- |\n");
    for (const SourceRow& row : rows)
      if (row.table == table)
        append(out, "| ", row.source, " | ", row.row, " | ", with_codes(row.printed, row.printed_codes),
               " | ", with_codes(row.value, row.codes), " | ", row.by.empty() ? "-" : "`" + row.by + "`",
               " | ", row.reason, " |\n");
  }
  return out;
}

}  // namespace etak
