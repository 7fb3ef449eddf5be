// SPDX-License-Identifier: Apache-2.0
#include "core/base/setting.h"

#include <algorithm>

namespace etak {
namespace {

bool are_options = false;

}  // namespace

std::string setting(std::string_view name) {
  if (are_options) return "--" + std::string(name);
  std::string out(name);
  std::replace(out.begin(), out.end(), '-', ' ');
  return out;
}

void settings_are_options() {
  are_options = true;
}

}  // namespace etak
