// SPDX-License-Identifier: Apache-2.0
// The functions that libetak-editor-pictures.so offers to etak-editor; see app/document/pictures.h. The module has a
// core of its own, of which it uses what reads and writes pictures.
#include "app/pictures/doors.h"

extern "C" __attribute__((visibility("default"))) const etak::PictureDoors* etak_editor_pictures() {
  static const etak::PictureDoors doors = etak::picture_doors(ETAK_VERSION);
  return &doors;
}
