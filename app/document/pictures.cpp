// SPDX-License-Identifier: Apache-2.0
#include "app/document/pictures.h"

#include "app/pictures/doors.h"
#include "app/pictures/open_module.h"
#include "core/base/error.h"

namespace etak::editor {
namespace {

constexpr const char* module_file = "libetak-editor-pictures.so";

const PictureDoors& doors(const std::string& place) {
  static const OpenedModule opened =
      open_module_of_program(module_file, ETAK_MODULES_FROM_BIN, "etak_editor_pictures", ETAK_VERSION);
  if (opened.table == nullptr)
    throw Error::at(place, std::string("needs ") + module_file + "; " + opened.fault,
                    "the whole of etak-editor, and memory for OpenImageIO");
  return *static_cast<const PictureDoors*>(opened.table);
}

}  // namespace

PictureDoor picture_door() {
  return picture_door_behind(&doors);
}

}  // namespace etak::editor
