// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/exchange/f0_row.h"
#include "core/material/f0.h"
#include "core/material/material.h"

namespace etak {

/// A stack with several thicknesses of one layer.
///   layer   its number, the outermost being 1
struct FilmSweep {
  Stack stack;
  std::size_t layer = 1;
  std::vector<double> thickness_nm;
};

/// A sweep from text, "1=0nm:400nm:81" or "1=0nm,20nm,1um". Throws Error for another form, and for a layer that is not
/// there.
FilmSweep film_sweep(const Stack& stack, const std::string& text);

/// A row for each thickness; its path is the text of the stack.
std::vector<F0Row> film_rows(const FilmSweep& sweep, const F0Solver& solver, const Material& material,
                             const Dataset& dataset);

/// The CSV form of the rows: that of f0_csv_header() behind a column `thickness_nm`.
std::string film_csv(const FilmSweep& sweep, std::span<const F0Row> rows);

/// An SVG strip of the stack's colours as they are seen in sRGB: thickness from left to right, the angle of incidence from 0
/// to 85 degrees downwards. Throws Error for data that have no colour.
std::string film_strip(const FilmSweep& sweep, const F0Options& options);

}  // namespace etak
