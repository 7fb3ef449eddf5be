// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/files/output_tree.h"
#include "core/base/files/read_places.h"
#include "core/findings/report.h"
#include "core/image/picture.h"
#include "core/judge/settings.h"

namespace etak {

/// How repaired copies are made.
///   folder   as the user named it, for the report
///   shown    called once for each repaired file, with its codes before and after (8 bits, the file's
///            channels), for pages; may be empty
struct RepairRequest {
  Settings settings;
  PictureDoor door;
  unsigned threads = 1;
  std::string folder;
  std::function<void(const RepairedFile&, const Image8& before, const Image8& after)> shown;
};

/// Repairs what can be repaired of the findings of a report, and writes the sets that have changed to
/// `copies`: repaired pictures and, byte for byte, the other files of their sets, at their places below the
/// deepest folder that holds all checked pictures, with the permissions of the originals. No original is written.
///
/// A repair counts only where the check of the repaired set finds the rule no more in the file (or less of
/// it, where some of it is left on purpose) and no error that was not there before; else the texels go back.
/// Texels that no repair changes keep their codes, and the files their depth and channels. PNG keeps its
/// colour profile and texts (png_keep.h); other formats are written as PNG. What is lost stands in
/// `not_kept`.
///
/// Findings that are allowed or known, pages of an atlas, textures of a scene and pictures of floats are
/// left. Throws Error where a copy cannot be written or an original has become unreadable.
RepairReport repair_files(const ValidationReport& report, const RepairRequest& request, OutputTree& copies);

/// Throws Error where an input is the folder, or lies in it or below: no copy may take an original's place. Returns
/// what the copies are to keep off, since a folder in that folder may lead to an input too.
///   inputs   paths of files and folders
std::shared_ptr<const ReadPlaces> refuse_inputs_below(const std::string& folder,
                                                      std::span<const std::string> inputs);

/// The paths of all files that a report is about.
std::vector<std::string> checked_paths(const ValidationReport& report);

}  // namespace etak
