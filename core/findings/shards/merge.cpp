// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/error.h"
#include "core/findings/baseline.h"
#include "core/findings/report.h"
#include "core/findings/shards/report_shard.h"

namespace etak {
namespace {

const ReportShard& said_by(const ReadShard& shard) {
  return *shard.report.shard;
}

void check_same_run(const ReadShard& each, const ReadShard& first) {
  const ReportShard &own = said_by(each), &of_first = said_by(first);
  const std::string other = printable(first.file, 200);
  if (own.shard.count != of_first.shard.count)
    throw Error::at(each.file, "is shard " + own.shard.text(),
                    "one of " + std::to_string(of_first.shard.count) + ", as " + other + " is");
  if (own.options != of_first.options || own.allowances.size() != of_first.allowances.size())
    throw Error::at(each.file, "was run with other options than " + other,
                    "the same options, configuration, baseline and library for every shard");
  if (own.list != of_first.list || own.groups != of_first.groups)
    throw Error::at(each.file, "was cut from another list of inputs than " + other,
                    "inputs that stay the same while the shards run; run all shards again");
}

// Throws Error where a shard is missing; the shards are in order and each is there once.
void check_none_is_missing(const std::vector<ReadShard>& shards) {
  constexpr std::size_t most_named = 20;
  const std::size_t count = said_by(shards.front()).shard.count, lacking = count - shards.size();
  if (lacking == 0) return;
  std::string missing;
  auto next = shards.begin();
  for (std::size_t index = 1, named = 0; named < std::min(lacking, most_named); ++index) {
    if (next != shards.end() && said_by(*next).shard.index == index) {
      ++next;
      continue;
    }
    missing += (named++ == 0 ? "" : ", ") + Shard{index, count}.text();
  }
  if (lacking > most_named) missing += " and " + std::to_string(lacking - most_named) + " more";
  throw Error::at("etak merge", (lacking == 1 ? "missing: shard " : "missing: shards ") + missing,
                  "every shard from 1/" + std::to_string(count) + " on; run what is missing and merge again");
}

// Puts the shards in order. Throws Error where they are not the shards of one run, each of them once.
void put_in_order(std::vector<ReadShard>& shards) {
  std::ranges::stable_sort(shards, {}, [](const ReadShard& each) { return said_by(each).shard.index; });
  for (const ReadShard& each : shards) check_same_run(each, shards.front());
  for (std::size_t i = 1; i < shards.size(); ++i)
    if (said_by(shards[i]).shard.index == said_by(shards[i - 1]).shard.index)
      throw Error::at(shards[i].file,
                      "is shard " + said_by(shards[i]).shard.text() + ", as " +
                          printable(shards[i - 1].file, 200) + " is",
                      "each shard once");
  check_none_is_missing(shards);
  std::size_t next = 0;
  for (const ReadShard& each : shards) {
    const auto [first, last] = said_by(each).shard.items.value_or(std::pair(next, next));
    if (first != next || (&each == &shards.back() && last != said_by(each).groups))
      throw Error::at(each.file, "holds other items than follow those of the shards before it",
                      "files whose sizes stay the same while the shards run; run all shards again");
    next = last;
  }
}

}  // namespace

ValidationReport merged_report(std::vector<ReadShard> shards, bool renew_known) {
  put_in_order(shards);
  ValidationReport& first = shards.front().report;
  const Settings& settings = first.shard->settings;
  std::vector<CheckedFile> files;
  std::vector<AllowanceUse> uses = first.shard->allowances;
  for (ReadShard& each : shards) {
    std::ranges::move(each.report.files, std::back_inserter(files));
    for (std::size_t i = 0; i < uses.size(); ++i) {
      uses[i].used |= said_by(each).allowances[i].used;
      uses[i].met |= said_by(each).allowances[i].met;
    }
  }
  // From here on the steps are those of report_of_run(), with the same order of files that have equal paths.
  std::ranges::sort(files, {}, &CheckedFile::place);
  ValidationReport out = report_of(std::move(files), settings);
  add_unused_allowances(out, uses);
  if (renew_known) mark_known(out, baseline_of(out));
  out = report_of(std::move(out.files), settings);
  tell_sets_apart(out);
  out.settings_hash = first.settings_hash;
  out.not_opened = std::move(first.not_opened);
  out.unknown = std::move(first.unknown);
  out.typed = std::move(first.typed);
  out.run = first.shard->run;
  out.merged = true;
  out.nothing_checked = first.nothing_checked;
  if (out.nothing_checked) {
    out.incomplete = true;
    out.passed = false;
  }
  return out;
}

}  // namespace etak
