// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/judge/target.h"

namespace etak {

struct AtlasLayout;

/// An atlas layout: one target per page, with tiles and gutter, and last one for the materials that are on no
/// page because constants replace their texels. Paths of pages are relative to the folder of the file. Throws
/// Error naming file and JSON pointer.
std::vector<CheckTarget> targets_of_layout(const std::string& path, const std::string& label);

/// The targets of a layout as text, and of one in memory; `path` is where its file is, or will be.
std::vector<CheckTarget> targets_of_layout_text(const std::string& text, const std::string& path,
                                                const std::string& label);
std::vector<CheckTarget> targets_of_layout(const AtlasLayout& layout, const std::string& path,
                                           const std::string& label);

}  // namespace etak
