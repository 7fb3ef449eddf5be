// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/findings/baseline.h"
#include "core/findings/output/formats.h"
#include "core/findings/shards/report_shard.h"
#include "core/pages/finding_pictures.h"

namespace etak::test {

inline const OutputOptions sharded_options{Severity::error, "1.2.3"};

/// Every form of the report, one behind the other.
inline std::vector<std::string> forms_of(const ValidationReport& report, const Settings& settings) {
  std::vector<std::string> out{validation_json(report, sharded_options),
                               validation_sarif(report, sharded_options),
                               validation_junit(report, sharded_options),
                               validation_csv(report),
                               validation_github(report),
                               validation_text(report),
                               baseline_json(baseline_of(report))};
  // The page of a merge has no pictures and says so; all else is that of the whole run.
  ValidationReport merged = report;
  merged.merged = true;
  const std::vector<ValidationPageFile> no_pictures(report.files.size());
  out.push_back(validation_page(merged, no_pictures, {sharded_options.version, settings}));
  return out;
}

/// A report that is all of a run of one shard.
inline ValidationReport one_shard(std::vector<CheckedFile> files) {
  ValidationReport out = report_of(std::move(files), {});
  const std::string digest(32, 'a');
  out.settings_hash = digest;
  out.shard = std::make_shared<const ReportShard>(
      ReportShard{{1, 1, std::pair<std::size_t, std::size_t>(0, 1)}, digest, digest, 1, {}, {}, {}, {}});
  return out;
}

}  // namespace etak::test
