// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/spectrum/integration.h"

namespace etak::test {

/// Every observer under every illuminant.
inline std::vector<Viewing> all_viewings() {
  std::vector<Viewing> out;
  for (const auto observer : {Observer::cie1931_2deg, Observer::cie1964_10deg})
    for (const auto illuminant : {Illuminant::d65, Illuminant::d50, Illuminant::a, Illuminant::e})
      out.push_back({observer, illuminant});
  return out;
}

}  // namespace etak::test
