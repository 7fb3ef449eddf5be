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

/// What needs OpenImageIO, OpenColorIO, OpenGL or the timing library, in a module of its own (libetak-pictures.so), for
/// loading these libraries takes longer and more memory than most runs of etak. The module holds none of core's code:
/// it finds that in the program. All functions throw Error.
struct PicturesModule {
  const char* version;  // of the etak that it was built with; another's is refused

  PictureDoor (*picture_door)();

  // Spaces of an OpenColorIO config; `config` empty: $OCIO, else etak's own.
  SpaceCurve (*open_source)(const std::string& config, const std::string& name);
  CustomSpace (*open_space)(const std::string& config, const std::string& name);

  // The work of verbs.
  int (*draw)(RenderArguments& arguments);
  int (*measure)(ReportArguments& arguments);
  std::vector<StabilityCase> (*stability_on_gl)(const std::string& device);
  int (*choose_materials)(ChooseArguments& arguments);
};

/// Opens the module when first called, from any thread.
///   place   what needs it, for the message where it is missing: an option, a file or a verb
const PicturesModule& pictures(const std::string& place);

/// The same for pictures that are no plain PNG and for files of floats, opened with the first of them.
PictureDoor picture_door();

/// The spaces that need no config, for messages.
inline constexpr const char* built_in_spaces =
    "srgb (also Rec.709, linear), acescg, rec2020, display-p3 or xyz";

}  // namespace etak::cli
