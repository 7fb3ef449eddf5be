// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/table_columns.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/ascii.h"

namespace etak {
namespace {

// ASCII letters in lower case, blanks and '-' as '_'.
std::string folded(std::string_view text) {
  std::string out = lower_case(trimmed(text));
  for (char& c : out)
    if (is_blank(c) || c == '-') c = '_';
  return out;
}

struct NamedQuantity {
  std::string_view name;
  Quantity quantity;
};

constexpr std::array quantities{
    NamedQuantity{"wavelength", Quantity::wavelength},
    NamedQuantity{"wavelengths", Quantity::wavelength},
    NamedQuantity{"vacuum_wavelength", Quantity::wavelength},
    NamedQuantity{"wl", Quantity::wavelength},
    NamedQuantity{"wvl", Quantity::wavelength},
    NamedQuantity{"lambda", Quantity::wavelength},
    NamedQuantity{"λ", Quantity::wavelength},
    NamedQuantity{"energy", Quantity::energy},
    NamedQuantity{"photon_energy", Quantity::energy},
    NamedQuantity{"n", Quantity::n},
    NamedQuantity{"index", Quantity::n},
    NamedQuantity{"ior", Quantity::n},
    NamedQuantity{"refractive_index", Quantity::n},
    NamedQuantity{"k", Quantity::k},
    NamedQuantity{"kappa", Quantity::k},
    NamedQuantity{"κ", Quantity::k},
    NamedQuantity{"extinction", Quantity::k},
    NamedQuantity{"extinction_coefficient", Quantity::k},
    NamedQuantity{"r", Quantity::reflectance},
    NamedQuantity{"reflectance", Quantity::reflectance},
    NamedQuantity{"reflectivity", Quantity::reflectance},
    NamedQuantity{"_", Quantity::skipped},
};

std::optional<Quantity> quantity_named(std::string_view name) {
  const auto found = std::find_if(quantities.begin(), quantities.end(),
                                  [&](const NamedQuantity& known) { return known.name == name; });
  return found == quantities.end() ? std::nullopt : std::optional(found->quantity);
}

// Parts "name (unit)", "name [unit]", "name / unit" and "name, unit"; `unit` is empty when there is none.
std::pair<std::string_view, std::string_view> split_unit(std::string_view name) {
  for (const auto& [open, close] : {std::pair{'(', ')'}, std::pair{'[', ']'}}) {
    const std::size_t begin = name.find(open);
    if (begin == name.npos || begin == 0 || name.back() != close) continue;
    return {trimmed(name.substr(0, begin)), trimmed(name.substr(begin + 1, name.size() - begin - 2))};
  }
  const std::size_t slash = name.find_first_of("/,");
  if (slash == name.npos || slash == 0) return {name, {}};
  return {trimmed(name.substr(0, slash)), trimmed(name.substr(slash + 1))};
}

bool is_percent(std::string_view unit) {
  return unit == "%" || folded(unit) == "percent";
}

}  // namespace

bool parse_column(std::string_view name, Column& column, std::string& problem) {
  column = {};
  auto [base, unit] = split_unit(trimmed(name));
  std::string known = folded(base);
  auto quantity = quantity_named(known);
  // "wavelength_nm", "wl_um", "energy_eV", "r_%": the unit is what follows the last '_'.
  const std::size_t underscore = known.rfind('_');
  if (!quantity && unit.empty() && underscore != known.npos) {
    unit = base.substr(underscore + 1);
    quantity = quantity_named(std::string_view(known).substr(0, underscore));
  }
  // A unit alone names its quantity.
  if (!quantity && unit.empty()) {
    if (const auto alone = wavelength_unit_named(base); alone && known != "a") {
      quantity = *alone == WavelengthUnit::electronvolt ? Quantity::energy : Quantity::wavelength;
      unit = base;
    }
  }
  if (!quantity) {
    problem = "the column " + in_quotes(name);
    return false;
  }
  column.quantity = *quantity;
  if (*quantity == Quantity::reflectance && is_percent(unit)) column.scale = 0.01;
  if ((*quantity != Quantity::wavelength && *quantity != Quantity::energy) || unit.empty()) return true;
  column.unit = wavelength_unit_named(unit);
  if (!column.unit)
    problem = "the unit " + in_quotes(unit);
  else if ((*column.unit == WavelengthUnit::electronvolt) != (*quantity == Quantity::energy))
    problem = "the unit " + in_quotes(unit) + " of the column " + in_quotes(base);
  else
    return true;
  return false;
}

void split_fields(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  fields.clear();
  std::size_t at = 0;
  const auto skip_blanks = [&] {
    while (at < line.size() && is_blank(line[at]) && line[at] != separator) ++at;
  };
  line = separator == '\t' ? line : trimmed(line);
  while (at < line.size()) {
    skip_blanks();
    std::size_t stop = at;
    if (at < line.size() && line[at] == '"') {
      stop = line.find('"', at + 1);
      if (stop == line.npos) stop = line.size();
      fields.push_back(line.substr(at + 1, stop - at - 1));
      at = std::min(stop + 1, line.size());
      skip_blanks();
      // Text behind the closing quote becomes a field of its own, so that the row has too many fields.
      if (at < line.size() && line[at] != separator) continue;
    } else {
      while (stop < line.size() && line[stop] != separator && !(separator == ' ' && is_blank(line[stop])))
        ++stop;
      fields.push_back(trimmed(line.substr(at, stop - at)));
      at = stop;
    }
    if (separator == ' ')
      while (at < line.size() && is_blank(line[at])) ++at;
    else if (at < line.size())
      ++at;
  }
}

bool parse_cell(std::string_view field, double& value) {
  const std::size_t comma = field.find(',');
  if (comma == field.npos) return parse_number(field, value);
  if (field.find('.') != field.npos) return false;
  std::string pointed(field);
  pointed[comma] = '.';
  return parse_number(pointed, value);
}

namespace {

// Whether commas are decimal points: blanks or tabs separate numbers, and no number has a point.
bool has_decimal_commas(std::string_view line) {
  if (line.find('.') != line.npos) return false;
  std::vector<std::string_view> fields;
  split_fields(line, ' ', fields);
  double value = 0;
  return fields.size() > 1 && std::all_of(fields.begin(), fields.end(),
                                          [&](std::string_view field) { return parse_cell(field, value); });
}

}  // namespace

char find_separator(std::string_view line) {
  for (const char c : {';', ',', '\t'}) {
    if (line.find(c) == line.npos || (c == ',' && has_decimal_commas(line))) continue;
    // Columns that are separated by both tabs and blanks.
    if (c == '\t' && trimmed(line).find(' ') != line.npos) return ' ';
    return c;
  }
  return ' ';
}

std::vector<std::string> header_names(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  split_fields(line, separator, fields);
  std::vector<std::string> names;
  bool joins = false;  // the next word belongs to the name before
  for (const auto field : fields) {
    const bool starts_unit = field.starts_with('(') || field.starts_with('[') || field == "/";
    if (separator == ' ' && !names.empty() && (joins || starts_unit))
      names.back().append(" ").append(field);
    else
      names.emplace_back(field);
    const std::string word = folded(field);
    joins =
        field == "/" || word == "photon" || word == "refractive" || word == "extinction" || word == "vacuum";
  }
  return names;
}

std::string_view name(WavelengthUnit unit) {
  switch (unit) {
    case WavelengthUnit::nanometre:
      return "nm";
    case WavelengthUnit::micrometre:
      return "um";
    case WavelengthUnit::angstrom:
      return "A";
    case WavelengthUnit::electronvolt:
      return "eV";
  }
  return {};
}

std::optional<WavelengthUnit> wavelength_unit_named(std::string_view text) {
  std::string folded = lower_case(text);
  if (folded.size() > 3 && folded.back() == 's') folded.pop_back();
  struct Named {
    std::string_view name;
    WavelengthUnit unit;
  };
  // The micro sign and the Greek letter mu; the letter with ring, the Angstrom sign, and A with a combining
  // ring.
  static constexpr std::array known{Named{"nm", WavelengthUnit::nanometre},
                                    Named{"nanometre", WavelengthUnit::nanometre},
                                    Named{"nanometer", WavelengthUnit::nanometre},
                                    Named{"um", WavelengthUnit::micrometre},
                                    Named{"\xC2\xB5m", WavelengthUnit::micrometre},
                                    Named{"\xCE\xBCm", WavelengthUnit::micrometre},
                                    Named{"micron", WavelengthUnit::micrometre},
                                    Named{"micrometre", WavelengthUnit::micrometre},
                                    Named{"micrometer", WavelengthUnit::micrometre},
                                    Named{"a", WavelengthUnit::angstrom},
                                    Named{"\xC3\x85", WavelengthUnit::angstrom},
                                    Named{"\xE2\x84\xAB", WavelengthUnit::angstrom},
                                    Named{"a\xCC\x8A", WavelengthUnit::angstrom},
                                    Named{"angstrom", WavelengthUnit::angstrom},
                                    Named{"\xC3\x85ngstr\xC3\xB6m", WavelengthUnit::angstrom},
                                    Named{"ev", WavelengthUnit::electronvolt},
                                    Named{"electronvolt", WavelengthUnit::electronvolt}};
  for (const Named& unit : known)
    if (unit.name == folded) return unit.unit;
  return {};
}

double to_nm(double value, WavelengthUnit unit) {
  switch (unit) {
    case WavelengthUnit::nanometre:
      return value;
    case WavelengthUnit::micrometre:
      return value * 1000;
    case WavelengthUnit::angstrom:
      return value / 10;
    case WavelengthUnit::electronvolt:
      return ev_nm / value;
  }
  return value;
}

}  // namespace etak
