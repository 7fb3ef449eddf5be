// SPDX-License-Identifier: Apache-2.0
// The functions that etak/_pictures.so offers to etak._core; see app/pictures/doors.h.
#include "app/pictures/doors.h"
#include "core/base/setting.h"

extern "C" __attribute__((visibility("default"))) const etak::PictureDoors* etak_python_pictures() {
  etak::settings_are(etak::SettingStyle::keywords);
  static const etak::PictureDoors doors = etak::picture_doors(ETAK_VERSION);
  return &doors;
}
