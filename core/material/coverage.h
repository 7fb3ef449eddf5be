// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace etak {

/// The least share of the Y weight that data must hold for a colour: with less, the ends that are held would
/// say more than the measurement. One limit for all: F0Solver refuses below it, ETK601 is an error below it.
inline constexpr double least_coverage = 0.95;

/// Whether data that hold so much of the Y weight have a colour.
constexpr bool covers_enough(double y_weight) {
  return y_weight >= least_coverage;
}

/// The share of the Y weight (1931 2-degree observer, D65) that data from first_nm to last_nm hold, as
/// F0Result::coverage counts it.
double luminous_coverage(double first_nm, double last_nm);

}  // namespace etak
