// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/table.h"

namespace etak {

/// What a column of a user's table holds.
enum class Quantity { wavelength, energy, n, k, reflectance, skipped };

/// One column as its name describes it.
///   unit    of wavelength or energy; none when the name says none
///   scale   what its numbers are multiplied by: 0.01 for reflectance in percent, else 1
struct Column {
  Quantity quantity = Quantity::skipped;
  std::optional<WavelengthUnit> unit;
  double scale = 1;
};

/// Reads a column's name: "wavelength_nm", "wl (um)", "lambda [Å]", "photon energy / eV", "n", "k", "R (%)",
/// "_". Case does not matter. False, with the reason in `problem`, for a name or unit that is not known.
bool parse_column(std::string_view name, Column& column, std::string& problem);

/// The fields of a line. `separator` is ',', ';', '\t', or ' ' for runs of blanks and tabs. Blanks around a
/// field and quotes are taken off; an empty last field of a line that ends in a separator is left out.
void split_fields(std::string_view line, char separator, std::vector<std::string_view>& fields);

/// The separator that a line of numbers uses. Commas are decimal ones where blanks or tabs separate numbers.
char find_separator(std::string_view line);

/// A number of a table, with a decimal point or a decimal comma. False for what is none.
bool parse_cell(std::string_view field, double& value);

/// The names in a header line over columns separated by `separator`. Where blanks separate, "wavelength
/// (nm)", "wavelength / nm" and "photon energy" are still one name each.
std::vector<std::string> header_names(std::string_view line, char separator);

}  // namespace etak
