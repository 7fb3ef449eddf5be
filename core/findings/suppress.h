// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/findings/report.h"
#include "core/judge/settings.h"

namespace etak {

/// Whether `pattern` covers `path`: '*' stands for any characters but '/', '?' for one of them, "**" for any
/// characters. A pattern without '/' is compared with the last part of the path alone.
bool glob_matches(std::string_view pattern, std::string_view path);

/// Whether the text is "YYYY-MM-DD" with a month and day that exist. The order of such texts is their order
/// in time.
bool is_date(std::string_view text);

/// What apply_allowances() needs of the run.
///   today        "YYYY-MM-DD"
///   config       the configuration's file name for messages and findings
///   unused       severity of ETK903; off: no entry is reported as unused
///   whole_tree   everything below the configuration's folder was looked at, so an entry that met no file is
///                stale
///   is_active    whether some rule of the prefix ran; entries for rules that did not run are neither used
///                nor unused
struct AllowanceRun {
  std::string_view today, config;
  Severity unused = Severity::warning;
  bool whole_tree = false;
  std::function<bool(std::string_view prefix)> is_active;
};

/// What became of an entry in the files that were looked at.
///   used      it suppressed a finding
///   met       a file that it is about was among them
///   anyhow    it is reported as unused also where it met no file
///   unused    the ETK903 that reports it; none: it is never reported
struct AllowanceUse {
  bool used = false, met = false, anyhow = false;
  std::optional<Finding> unused;
};

template <class To, MembersOf<AllowanceUse> Value>
void members(To& to, Value& use) {
  to.member("used", use.used);
  to.member("met", use.met);
  to.member("anyhow", use.anyhow);
  to.member("unused", use.unused);
}

/// Marks what the entries allow, and tells of each entry what became of it. ETK001 and the 9xx rules cannot be
/// allowed: a file that was not looked at is never clean.
std::vector<AllowanceUse> mark_allowed(ValidationReport& report, std::span<const AllowEntry> entries,
                                       const AllowanceRun& run);

/// Adds an ETK903 for every entry that suppressed nothing or has expired, to a CheckedFile for the
/// configuration, with the role "config". The report's files are in path order.
void add_unused_allowances(ValidationReport& report, std::span<const AllowanceUse> uses);

/// Marks what the entries allow, and adds the findings about entries that allowed nothing.
void apply_allowances(ValidationReport& report, std::span<const AllowEntry> entries, const AllowanceRun& run);

}  // namespace etak
