// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/atlas/sources/sources.h"
#include "core/image/picture.h"
#include "core/material/f0.h"
#include "core/study/stability/stability.h"

namespace etak::cli {

struct ChooseArguments;
struct RenderArguments;
struct ReportArguments;

/// The functions that need OpenImageIO, OpenColorIO, OpenGL or the timing library. They are in a module of
/// their own (libetak-pictures.so), because loading these libraries takes more time and memory than most runs
/// of etak. The module holds no code of core, but uses that of the program. All functions throw Error.
struct PicturesModule {
  const char* version;  // of etak when the module was built; a module of another version is refused

  PictureDoor (*picture_door)();

  // Colour spaces of an OpenColorIO config. An empty `config` stands for $OCIO, else for etak's own.
  SpaceCurve (*open_source)(const std::string& config, const std::string& name);
  CustomSpace (*open_space)(const std::string& config, const std::string& name);

  // The work of verbs.
  int (*draw)(RenderArguments& arguments);
  int (*measure)(ReportArguments& arguments);
  std::vector<StabilityCase> (*stability_on_gl)(const std::string& device);
  int (*choose_materials)(ChooseArguments& arguments);
};

/// The module, which the first call opens. Any thread may call it. Throws Error where the module cannot be
/// opened.
///   place   the option, file or verb that needs the module, for the message of the error
const PicturesModule& pictures(const std::string& place);

/// The reader and writer of pictures that are no plain PNG, and of files of floats. The module is opened with
/// the first of them.
PictureDoor picture_door();

}  // namespace etak::cli
