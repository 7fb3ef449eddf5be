// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "core/judge/pixels/evidence.h"

namespace etak {

/// The ends of the range of a table or formula, in nm; 0 for a table without rows.
inline double first_nm(const SpectralRows& rows) {
  if (rows.is_formula) return rows.first_nm;
  return rows.wavelength_nm.empty() ? 0
                                    : *std::min_element(rows.wavelength_nm.begin(), rows.wavelength_nm.end());
}
inline double last_nm(const SpectralRows& rows) {
  if (rows.is_formula) return rows.last_nm;
  return rows.wavelength_nm.empty() ? 0
                                    : *std::max_element(rows.wavelength_nm.begin(), rows.wavelength_nm.end());
}

/// Whether two rows of a table have equal values.
inline bool equal_rows(const SpectralRows& rows, std::size_t i, std::size_t j) {
  const auto same = [&](const std::vector<double>& values) {
    return i >= values.size() || j >= values.size() || values[i] == values[j];
  };
  return same(rows.n) && same(rows.k) && same(rows.reflectance);
}

}  // namespace etak
