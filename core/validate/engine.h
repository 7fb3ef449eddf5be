// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/validate/baseline.h"
#include "core/validate/config.h"
#include "core/validate/finding.h"
#include "core/validate/pixels/evidence.h"
#include "core/validate/rule.h"
#include "core/validate/settings.h"
#include "core/validate/target.h"

namespace etak {

// The parts that validate() (validate.h) and PackCheck (check_pack.h) are made of. Other programs call those
// two.

/// The needs of all rules that are not off, together.
Needs needs_of(const Settings& settings);

/// The needs of those rules that are not off and whose data the target may have.
Needs needs_of(const CheckTarget& target, const Settings& settings);

/// Reads the pixels, where some rule needs them. Adds tiles and the facts of float pictures to the evidence,
/// and size, counts, areas and times to `file`. evidence.a and .b are filled in from the pictures where they
/// are empty.
///   open   gives the pictures with what the rules need; called once for each pass over the pixels
void look_at_pixels(const CheckTarget& target, const std::function<PictureRows(Needs)>& open,
                    const Settings& settings, unsigned threads, Evidence& evidence, CheckedFile& file);

/// Runs the rules over the evidence and adds their findings to `file`, in the order of rules, tiles, boxes.
void judge(const CheckTarget& target, const Evidence& evidence, const Settings& settings, CheckedFile& file);

/// The names of CheckedFile::counts, in their order. Of a target without a specular picture only the first
/// `counts_without_specular` are there.
inline constexpr std::array<std::string_view, 10> count_names{"texels",
                                                              "opaque_px",
                                                              "alpha_zero_px",
                                                              "forbidden_any_channel_px",
                                                              "forbidden_all_channels_px",
                                                              "specular_black_px",
                                                              "metal_px",
                                                              "gloss_min",
                                                              "gloss_max",
                                                              "energy_over_px"};
inline constexpr std::size_t counts_without_specular = 3;

/// A CheckedFile with what is known before anything is opened: path, companions, roles.
CheckedFile checked_file_of(const CheckTarget& target);

/// The settings for one target: the transfer function that its manifest states replaces that of `settings`. For
/// pages that are judged with their scene, only the rules about layouts are on.
Settings settings_for(const CheckTarget& target, const Settings& settings);

/// Checks pictures in memory. Files of the target are not opened; their labels and roles go into the report.
///   threads   never changes the result
CheckedFile check_pictures(const CheckTarget& target, const PicturesInMemory& pictures,
                           const Settings& settings, unsigned threads = 1);

/// Checks pictures that come in strips of rows.
///   open   called once per pass over the pixels, with what the pass needs; almost always once
CheckedFile check_rows(const CheckTarget& target, const std::function<PictureRows(Needs)>& open,
                       const Settings& settings, unsigned threads = 1);

/// Marks the texels that a rule on regions is about, in a picture of one channel: 0 the condition is not met,
/// 1 it is met, but not on a plateau (transition), 2 plateau.
Image8 region_picture(RegionKind kind, const PicturesInMemory& pictures, const CheckTarget& target,
                      const Settings& settings);

/// Puts checked files into a report: path order, sums, verdict (suppressed and baseline findings do not
/// count). Called again after findings have been marked.
ValidationReport report_of(std::vector<CheckedFile> files, const Settings& settings);

/// Where several sets find the same of a picture that they share, adds to each finding which set it is of. Done
/// last, in reports of whole runs only: a shard does not know the sets of the others.
void tell_sets_apart(ValidationReport& report);

/// What report_of_run() needs besides the configuration.
///   today         "YYYY-MM-DD" for allowances that expire; empty: the system's date
///   whole_tree    everything below the configuration's folder was looked at
///   known         findings of a baseline
///   renew_known   everything that is found counts as known, instead of `known`
///   shard         of a shard: it takes the use of the allowances, and none is reported as unused
struct ReportRun {
  std::string today;
  bool whole_tree = false;
  std::span<const KnownDefect> known;
  bool renew_known = false;
  ReportShard* shard = nullptr;
};

/// The system's date, "YYYY-MM-DD".
std::string today_here();

/// report_of(), with the hash of the settings, and with the findings marked that the configuration allows or
/// that are known.
ValidationReport report_of_run(std::vector<CheckedFile> files, const ValidateConfig& config,
                               const ReportRun& run);

}  // namespace etak
