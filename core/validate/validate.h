// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/findings/baseline.h"
#include "core/findings/report.h"
#include "core/findings/verdict_options.h"
#include "core/image/picture.h"
#include "core/judge/target.h"
#include "core/project/project.h"
#include "core/runs/cache_use.h"
#include "core/runs/shards.h"
#include "core/validate/config.h"
#include "core/validate/find/listing.h"

namespace etak {

class CheckedBefore;  // core/validate/files/result_text.h
class KeptPictures;

// The interface of the validator (target etak::validate_files). check_pack.h checks an atlas while it is
// packed, core/pages/finding_pictures.h makes masks and thumbnails of findings, and
// core/findings/output/formats.h writes the report.

/// Materials of a project, which are no files: their pictures or colours are checked, and the records that
/// their F0 comes from.
///   library       with the project's own spectra (library_of); not null where there are materials
///   most_texels   larger pictures are not checked, which is a finding; 0: no limit
///   kept          for a program that checks a material again after each change: its pictures are then read
///                 once (core/project/project_pictures.h); null: each time
struct MaterialsToCheck {
  std::vector<ProjectMaterial> materials;
  std::shared_ptr<const MaterialLibrary> library;
  std::size_t most_texels = 0;
  std::shared_ptr<KeptPictures> kept;
};

/// The files that are checked. Those that belong together are found by their names: diffuse and specular pictures that differ in the
/// ending of their role only, the pictures of a layout or of a scene.
struct ValidationInputs {
  std::vector<std::string> paths;    // files and folders, as the user named them
  std::vector<std::string> listed;   // the names in a list of files
  std::string list;                  // the name of that list, for messages
  std::vector<CheckTarget> targets;  // made by the caller, in addition to those found
  MaterialsToCheck materials;
  std::optional<FileRole> role;  // of all pictures; none: by their names
  Manifest manifest;             // what is stated about all pictures
  bool pass_unknown = false;     // named files of no known kind are passed over, as those of folders are
};

/// Defects that are known already.
struct ValidationAllowances {
  std::string today;  // "YYYY-MM-DD", for allowances that expire; empty: the system's date
  std::vector<KnownDefect> known;
  bool renew_known = false;  // everything found counts as known, instead of `known`
};

/// Results of earlier runs.
///   cache     without a path: none
///   before    of a program that checks the same files again and again: what they were the last time; null: none
///   version   of the program: results of other versions do not count
struct ValidationMemory {
  CacheOptions cache;
  std::shared_ptr<CheckedBefore> before;
  std::string version;
};

/// A part of a run that is cut into shards.
///   shard         only this part of what is found is checked; none: all
///   verdict       kept in the shard for the merge
///   line_digest   of all options that the shard was asked for with
struct ValidationPart {
  std::optional<Shard> shard;
  VerdictOptions verdict;
  std::string line_digest;
};

/// How the checks run.
///   door       of pictures that are no plain PNG
///   threads    the report is the same for any number of them
///   progress   called by the thread that called validate(), with how many of the checks are done
///   stop       called before each check, from any thread; true: no other check is begun, and the report is marked
///              stopped
struct ValidationRun {
  PictureDoor door;
  unsigned threads = 1;
  std::function<void(std::size_t done, std::size_t all)> progress;
  std::function<bool()> stop;
};

/// What is to be checked, by which rules, and how.
struct ValidationRequest {
  ValidationInputs inputs;
  ValidateConfig config;
  ValidationAllowances allowed;
  ValidationMemory memory;
  ValidationPart part;
  ValidationRun run;
  bool hashes = false;      // the report gives the SHA-256 of every file, which reads all files once more
  bool must_check = false;  // a run that checks nothing is incomplete
  bool list_files = false;  // for list_files()
};

/// The files that validate() would find, with their roles and what would be done with each. No picture is
/// opened.
FileList list_files(ValidationRequest request);

/// How validate() would cut the run into `count` shards, and what each reads. No picture is opened.
std::vector<ShardPlan> plan_shards(ValidationRequest request, std::size_t count);

/// Checks what the request names. A file that cannot be read is a finding (ETK001), never an exception; an
/// error of a rule is ETK901. Throws Error where the path of the cache leads to something that is no folder.
ValidationReport validate(ValidationRequest request);

}  // namespace etak
