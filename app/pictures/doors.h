// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "core/atlas/sources/sources.h"
#include "core/image/picture.h"
#include "core/material/f0.h"

namespace etak {

// OpenImageIO and OpenColorIO take more time to load than most work of etak takes. The programs therefore have
// the code that needs them in a module, a shared library that is opened when it is first needed.

/// What the modules of all programs offer: functions, so that a program needs no name of their libraries. All
/// functions throw Error.
struct PictureDoors {
  const char* version;  // of etak when the module was built; a module of another version is refused

  PictureDoor (*picture_door)();

  // Colour spaces of an OpenColorIO config. An empty `config` stands for $OCIO, else for etak's own.
  SpaceCurve (*open_source)(const std::string& config, const std::string& name);
  CustomSpace (*open_space)(const std::string& config, const std::string& name);
};

/// The functions themselves (doors.cpp), for modules.
PictureDoors picture_doors(const char* version);

/// The module's functions; throws Error where it cannot be opened.
///   place   the setting, file or verb that needs them, for the message of the error
using OpenDoors = std::function<const PictureDoors&(const std::string& place)>;

/// The reader and writer of pictures that are no plain PNG, and of files of floats, and what draws text. The module
/// is opened with the first of them.
PictureDoor picture_door_behind(const OpenDoors& doors);

}  // namespace etak
