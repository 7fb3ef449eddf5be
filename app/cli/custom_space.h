// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/material/f0.h"

namespace etak::cli {

/// The spaces that need no config, for messages.
inline constexpr const char* built_in_spaces =
    "srgb (also Rec.709, linear), acescg, rec2020, display-p3 or xyz";

/// The colour space `name` of an OpenColorIO config ("" : $OCIO, else the one that ships with etak). Throws
/// Error. Two bodies share this declaration. In etak-image (ocio_full.cpp) it opens the space. In etak
/// (ocio_light.cpp), which must start in milliseconds and so links no OpenColorIO, it replaces the process by
/// etak-image with the same arguments and never returns; so it is called before any input is read.
CustomSpace open_custom_space(const std::string& config, const std::string& name);

/// What the light body starts etak-image with; main sets it.
void set_program_arguments(char** argv);

}  // namespace etak::cli
