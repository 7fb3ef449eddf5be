// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/validate/baseline.h"
#include "core/validate/engine.h"
#include "core/validate/shards/report_shard.h"

namespace etak {

ValidationReport merged_report(std::vector<ValidationReport> shards, bool renew_known) {
  ValidationReport& first = shards.front();
  const Settings& settings = first.shard->settings;
  std::vector<CheckedFile> files;
  std::vector<AllowanceUse> uses = first.shard->allowances;
  for (ValidationReport& each : shards) {
    std::move(each.files.begin(), each.files.end(), std::back_inserter(files));
    for (std::size_t i = 0; i < std::min(uses.size(), each.shard->allowances.size()); ++i) {
      uses[i].used |= each.shard->allowances[i].used;
      uses[i].met |= each.shard->allowances[i].met;
    }
  }
  // From here on the steps are those of report_of_run(), with the same order of files that have equal paths.
  std::sort(files.begin(), files.end(),
            [](const CheckedFile& a, const CheckedFile& b) { return a.place < b.place; });
  ValidationReport out = report_of(std::move(files), settings);
  add_unused_allowances(out, uses);
  if (renew_known) mark_known(out, baseline_of(out));
  out = report_of(std::move(out.files), settings);
  out.settings_hash = first.settings_hash;
  out.not_opened = std::move(first.not_opened);
  out.unknown = std::move(first.unknown);
  out.typed = std::move(first.typed);
  out.run = first.shard->run;
  out.nothing_checked = first.nothing_checked;
  if (out.nothing_checked) {
    out.incomplete = true;
    out.passed = false;
  }
  return out;
}

}  // namespace etak
