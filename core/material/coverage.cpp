// SPDX-License-Identifier: Apache-2.0
#include "core/material/coverage.h"

#include "core/material/f0/f0_data.h"

namespace etak {

double luminous_coverage(double first_nm, double last_nm) {
  static const WeightSums sums = weight_sums(Viewing{});
  return coverage_of({first_nm, last_nm}, nullptr, sums).weight[1];
}

}  // namespace etak
