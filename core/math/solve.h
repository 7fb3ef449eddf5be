// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace etak {

/// Solves the first `count` equations a x = b of a positive definite matrix by elimination, which needs no pivots; x is
/// left in `b`, and `a` is changed.
///   Matrix, Row   anything with rows and numbers by index
template <class Matrix, class Row>
void solve_definite(Matrix& a, Row& b, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = i + 1; k < count; ++k) {
      const double factor = a[k][i] / a[i][i];
      for (std::size_t j = i; j < count; ++j) a[k][j] -= factor * a[i][j];
      b[k] -= factor * b[i];
    }
  for (std::size_t i = count; i-- > 0;) {
    for (std::size_t j = i + 1; j < count; ++j) b[i] -= a[i][j] * b[j];
    b[i] /= a[i][i];
  }
}

}  // namespace etak
