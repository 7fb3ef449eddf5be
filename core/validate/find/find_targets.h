// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/findings/report.h"
#include "core/judge/target.h"
#include "core/validate/find/listing.h"
#include "core/validate/validate.h"

namespace etak {

// The first step of validate().

/// A target and the files its result depends on, for the cache.
///   plain   a search of folders has seen that all of these are files
///   place   of CheckedFile, where the run is cut into shards
struct FoundTarget {
  CheckTarget target;
  std::vector<std::string> depends;
  bool plain = false;
  std::size_t place = 0;
};

/// The targets and files that were found, in the order of labels.
///   failed     one unreadable CheckedFile (ETK001) for everything that was named and cannot be checked
///   lone       sets whose companion is missing (ETK002), which are not opened
///   no_files   pipes, sockets and devices of folders, which were not opened
///   unknown    labels of the pictures, in folders and lists, whose names tell no role
///   listing    everything that was found, where the request asks for it
///   files      how many files were found
///   skipped    how many of those in folders and lists are of a kind that no rule checks
///   typed      folders as labels name them, and as the user typed them
struct FoundTargets {
  std::vector<FoundTarget> targets;
  std::vector<CheckedFile> failed, lone;
  std::vector<std::string> no_files, unknown;
  FileList listing;
  std::size_t files = 0, skipped = 0;
  TypedFolders typed;
};

/// Finds the files that the request names, tells their kinds and puts together what belongs together:
/// pictures of one folder whose names differ in what tells the role only ("crate_diff.png",
/// "crate_spec.png"). A picture named alone takes its companion along. Pictures that a scene or a layout of
/// the run names belong to it alone. Names of the list that lead to no file fail one by one up to a thousand;
/// the others fail as a number, under the name of the list. The names are moved out of `request.inputs.listed`,
/// because there may be a million of them.
FoundTargets find_targets(ValidationRequest& request);

}  // namespace etak
