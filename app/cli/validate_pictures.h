// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/report/validation_page.h"
#include "core/validate/finding.h"
#include "core/validate/target.h"

namespace etak::cli {

/// Makes the folder of --mask where it is missing. Throws Error where it cannot be one.
void check_mask_folder(const std::string& folder);

/// Writes a mask picture for every finding that counts and has a place in a picture, as
/// FOLDER/LABEL.TILE.RULE.png with '/' in names as '_'. Returns how many. Throws Error.
///   files   the report's, side by side with `targets` (null: none, as for a configuration)
std::size_t write_masks(const ValidationReport& report, const std::vector<const CheckTarget*>& targets,
                        const Settings& settings, const std::string& folder, unsigned threads);

/// Thumbnails, heat maps and histograms of the files with findings for the HTML page; of the first `most` of
/// them, so that the page of a folder of thousands still opens.
std::vector<ValidationPageFile> page_pictures(const ValidationReport& report,
                                              const std::vector<const CheckTarget*>& targets,
                                              const Settings& settings, std::size_t most, unsigned threads);

}  // namespace etak::cli
