// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/files/output.h"
#include "core/pages/validation_page.h"
#include "core/validate/finding.h"
#include "core/validate/target.h"

namespace etak::cli {

/// Makes the folders above that of --mask where they are missing. Throws Error where it cannot be a folder.
void check_mask_folder(const std::string& folder);

/// A mask picture for every finding that counts and has a place in a picture, as FOLDER/LABEL.TILE.RULE.png
/// with '/' in names as '_', to be put in place with the other outputs of the run. Throws Error.
///   files   the report's, side by side with `targets` (null: none, as for a configuration)
std::unique_ptr<Output> masks(const ValidationReport& report, const std::vector<const CheckTarget*>& targets,
                              const Settings& settings, const std::string& folder, unsigned threads);

/// Thumbnails, heat maps and histograms of the files with findings for the HTML page; of the first `most` of
/// them, so that the page of a folder of thousands still opens.
std::vector<ValidationPageFile> page_pictures(const ValidationReport& report,
                                              const std::vector<const CheckTarget*>& targets,
                                              const Settings& settings, std::size_t most, unsigned threads);

}  // namespace etak::cli
