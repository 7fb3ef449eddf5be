// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/exchange/rii/yaml_lines.h"
#include "core/material/material.h"

namespace etak {

/// The columns of a database table behind the wavelength.
enum class RowKind { n, k, nk };

/// The rows of one table as columns: wavelength in nanometres, then n, k or both.
///   values   at least `count` long, of which the first `count` hold the table. They only grow, so that one
///            object reads table after table without an allocation
struct Rows {
  std::array<std::vector<double>, 3> values;
  std::size_t count = 0;
  double least_n = 1;

  void copy(std::size_t column, std::vector<double>& out) const {
    out.assign(values[column].begin(), values[column].begin() + static_cast<std::ptrdiff_t>(count));
  }
};

/// Reads the rows below a key that stands at column `indent`; `lines` is left behind them. Afterwards
/// wavelengths ascend strictly: unsorted rows are sorted, of rows with equal wavelength identical ones are
/// dropped and different ones averaged, k below zero is 0; each sets its flag. Throws Error, with the line,
/// for short and long rows, for what is no number, and for wavelengths, n and k outside (0, 1e9] um, [-1e4,
/// 1e4] and [-1e6, 1e6].
void read_rows(YamlLines& lines, int indent, RowKind kind, Rows& rows, Flags& flags);

}  // namespace etak
