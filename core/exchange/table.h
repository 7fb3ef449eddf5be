// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/material/material.h"

namespace etak {

enum class WavelengthUnit { nanometre, micrometre, angstrom, electronvolt };
std::string_view name(WavelengthUnit unit);                                  // "nm", "um", "A", "eV"
std::optional<WavelengthUnit> wavelength_unit_named(std::string_view text);  // also "µm", "Å", "micron", ...

/// hc/e in eV nm (exact SI values of 2019): wavelength = this / photon energy.
inline constexpr double ev_nm = 1239.8419843320026;
double to_nm(double value, WavelengthUnit unit);

enum class Duplicates { refuse, first, mean };

/// What a table does not say itself. Class and origin stand in place of what any input says of them.
struct TableOptions {
  std::optional<WavelengthUnit> unit;  // wins over the header; needed when the header names none
  std::vector<std::string> columns;  // names of the columns ("wavelength,n,k"), when there is no header: then
                                     // the first line is data; "_" skips a column
  Duplicates duplicates = Duplicates::refuse;
  std::string material_class;  // empty: that of the input, or by its numbers (decide_class())
  std::optional<Origin> origin;

  bool states() const { return !material_class.empty() || origin; }
};

/// The options of a table as a person writes them: on a command line, as keywords of a call. `columns` has ',' between;
/// empty texts stand for the default.
struct TableSettings {
  std::string unit, columns, duplicates = "refuse", material_class, origin;
};
/// The settings as values. Throws Error that names the setting and what it takes.
TableOptions table_options(const TableSettings& settings);

/// Gives a material the class and the origin of the options, where they have one.
void state(Material& material, const TableOptions& options);

/// The data of a table, and what is odd about them.
struct Table {
  Optics optics;
  Flags flags;
};

/// Reads a user's table: comma, semicolon, tab or blanks between columns (found from the first data line), a decimal
/// point or, where no comma separates columns, a decimal comma, '#' comments, optional header. Column names: wavelength | wavelength_nm | wl | lambda | energy ..., n, k,
/// R | reflectance (optionally with "%": then divided by 100). Throws Error with file and line for a missing
/// unit, unknown or missing columns, NaN, n <= 0, k < 0, R outside [-0.02, 1.02], equal wavelengths (both
/// rows named), no row inside 300..900 nm (with a hint which unit would fit).
Table parse_table(std::string_view text, std::string_view file, const TableOptions& options);

/// Reads a table of other quantities in the same way: one column of wavelength or energy and `count` more (1 to 3),
/// whatever their names say, in the order of the file.
std::vector<Spectrum> parse_columns(std::string_view text, std::string_view file, std::size_t count,
                                    const TableOptions& options = {});

}  // namespace etak
