// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/validate/baseline.h"
#include "core/validate/config.h"
#include "core/validate/finding.h"
#include "core/validate/pixels/evidence.h"
#include "core/validate/rule.h"
#include "core/validate/settings.h"
#include "core/validate/target.h"

namespace etak {

// The parts that validate() (validate.h) and PackCheck (check_pack.h) are made of. Other programs ask those
// two.

/// What the rules that are not off need together.
Needs needs_of(const Settings& settings);

/// Needs of the rules that can say something of such a target: of those that are on, those whose data may be
/// there.
Needs needs_of(const CheckTarget& target, const Settings& settings);

/// Looks at the pixels, where some rule needs them, and adds tiles, counts and float facts to the evidence,
/// and what it cost to `file`. evidence.a and .b are filled in from the pictures when empty.
void look_at_pixels(const CheckTarget& target, const std::function<PictureRows(Needs)>& open,
                    const Settings& settings, unsigned threads, Evidence& evidence, CheckedFile& file);

/// Runs the rules over the evidence; findings in the order of rules, tiles, boxes.
void judge(const CheckTarget& target, const Evidence& evidence, const Settings& settings, CheckedFile& file);

/// What is known of the file before anything is opened: path, companions, roles.
CheckedFile checked_file_of(const CheckTarget& target);

/// The settings that hold for a target: its transfer function is its own statement, else that of the
/// settings; of pages that are judged with their scene only the rules about layouts are on.
Settings settings_for(const CheckTarget& target, const Settings& settings);

/// Checks pictures in memory. Files of the target are not opened; their labels and roles go into the report.
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

/// What a run knows besides its configuration.
///   today         "YYYY-MM-DD" for allowances that expire; empty: the system's date
///   whole_tree    everything below the configuration's folder was looked at
///   known         findings of a baseline
///   renew_known   everything that is found counts as known, in the place of `known`
struct ReportRun {
  std::string today;
  bool whole_tree = false;
  std::span<const KnownDefect> known;
  bool renew_known = false;
};

/// The same with what the configuration allows and what is known marked, and the fingerprint of the settings.
ValidationReport report_of_run(std::vector<CheckedFile> files, const ValidateConfig& config,
                               const ReportRun& run);

}  // namespace etak
