// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/base/files/output.h"
#include "core/findings/report.h"
#include "core/image/picture.h"
#include "core/judge/settings.h"
#include "core/pages/validation_page.h"

namespace etak {

// Pictures of the findings of validate() (target etak::finding_pictures). The check reads pictures in strips
// and keeps no texels, so these functions read the files again; `door` reads those that are no plain PNG.

/// A mask picture for every finding that counts and has a place in a picture, as FOLDER/LABEL.TILE.RULE.png
/// with '/' in names as '_'. The caller puts the result in place with the other outputs of the run. Throws
/// Error where a picture cannot be written.
std::unique_ptr<Output> masks(const ValidationReport& report, const Settings& settings,
                              const PictureDoor& door, const std::string& folder, unsigned threads);

/// Thumbnails, heat maps and histograms of the files with findings, for validation_page(): an entry for each
/// of report.files. Files get pictures in page_order() as long as these come to no more than `most_bytes` of the page,
/// so that a browser can open the page of a folder of thousands of files and a mail can carry it. Where many files have
/// findings, their pictures are smaller. A file is left out from the first whose pictures have no room.
/// A merged report has none: its files were checked elsewhere.
inline constexpr std::size_t most_page_pictures = 1'400'000;
std::vector<ValidationPageFile> page_pictures(const ValidationReport& report, const Settings& settings,
                                              const PictureDoor& door, std::size_t most_bytes,
                                              unsigned threads);

}  // namespace etak
