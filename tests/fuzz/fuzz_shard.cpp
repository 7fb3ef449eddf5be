// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the readers of what shards wrote answer with an Error, or with a part of which a whole run
// and every form of it can be made.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/shards/shard_document.h"
#include "core/validate/output/formats.h"
#include "core/validate/shards/report_shard.h"

using namespace etak;

namespace {

void merge_validation(std::string_view text) {
  std::vector<ValidationReport> shards;
  OutputOptions options;
  try {
    ReadShard read = read_shard(text, "shard.json");
    const ReportShard& says = *read.report.shard;
    const ShardOutput output{"shard.json", says.shard, read.version, says.options,
                             says.list,    "",         says.groups};
    (void)complete_shards({&output, 1}, read.version);
    options.version = read.version;
    // As a shard wrote it, it is read again as the same.
    const std::string written = validation_json(read.report, options);
    assert(validation_json(read_shard(written, "written").report, options) == written);
    shards.push_back(std::move(read.report));
  } catch (const Error&) {
    return;
  }
  const ValidationReport whole = merged_report(std::move(shards), false);
  (void)validation_text(whole);
  (void)validation_csv(whole);
  (void)validation_github(whole);
  try {
    (void)validation_json(whole, options);
    (void)validation_sarif(whole, options);
    (void)validation_junit(whole, options);
  } catch (const Error&) {
    // A form that cannot hold a name of the report.
  }
}

void merge_list(std::string_view text) {
  try {
    const std::vector<ShardDocument> shards{read_shard_document(text, "results", "shard.json")};
    (void)complete_shards({&shards.front().member.says, 1}, shards.front().member.says.version);
    (void)joined_document(shards, "results");
    for (const auto& [form, rows] : shards.front().member.forms) (void)joined_form(shards, form);
  } catch (const Error&) {
    return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<char> bytes(data, data + size);
  merge_validation({bytes.data(), bytes.size()});
  merge_list({bytes.data(), bytes.size()});
  return 0;
}
