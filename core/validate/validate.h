// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/validate/finding.h"
#include "core/validate/rule.h"
#include "core/validate/settings.h"
#include "core/validate/target.h"

namespace etak {

/// What the rules that are not off need together.
Needs needs_of(const Settings& settings);

/// Checks pictures in memory: the packer's and the editor's way to the same rules. Files of the target are
/// not opened; their labels and roles go into the report.
///   threads   never changes the result
CheckedFile check_pictures(const CheckTarget& target, const PicturesInMemory& pictures,
                           const Settings& settings, unsigned threads = 1);

/// Checks pictures that come in strips of rows.
///   open   called once per pass over the pixels, with what the pass needs; almost always once
CheckedFile check_rows(const CheckTarget& target, const std::function<PictureRows(Needs)>& open,
                       const Settings& settings, unsigned threads = 1);

/// Which texels of a picture a region rule means: one channel, 0 none, 1 transition (masked, no plateau), 2
/// plateau.
Image8 region_picture(RegionKind kind, const PicturesInMemory& pictures, const CheckTarget& target,
                      const Settings& settings);

/// Puts checked files into a report: path order, sums, verdict (suppressed and baseline findings do not
/// count). Called again after findings have been marked.
ValidationReport report_of(std::vector<CheckedFile> files, const Settings& settings);

}  // namespace etak
