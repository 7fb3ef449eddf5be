// SPDX-License-Identifier: Apache-2.0
#include "core/base/setting.h"

#include <algorithm>

namespace etak {
namespace {

SettingStyle setting_style = SettingStyle::words;

}  // namespace

std::string setting(std::string_view name) {
  if (setting_style == SettingStyle::options)
    return "--" + std::string(name == "material-class" ? "class" : name);  // class is a word of Python
  std::string out(name);
  std::replace(out.begin(), out.end(), '-', setting_style == SettingStyle::keywords ? '_' : ' ');
  return out;
}

void settings_are(SettingStyle style) {
  setting_style = style;
}

}  // namespace etak
