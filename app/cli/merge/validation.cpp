// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "app/cli/merge/merge.h"
#include "app/cli/options/options.h"
#include "core/base/error.h"
#include "core/base/files/output_target.h"
#include "core/base/hash/content_hash.h"
#include "core/base/parallel.h"
#include "core/validate/target.h"

namespace etak::cli {
namespace {

struct ReadOutput {
  ReadShard read;
  ShardOutput says;
};

ReadOutput read_output(const ShardText& text) {
  ReadOutput out{read_shard(text.text, text.file), {}};
  const ReportShard& shard = *out.read.report.shard;
  ContentHash hash;
  hash.add(text.text);
  out.says = {text.file, shard.shard, out.read.version, shard.options, shard.list, hash.hex(), shard.groups};
  return out;
}

// The page shows pictures of files, which it reads again where the shards read them.
void check_pictures_are_there(const ValidationReport& report) {
  std::size_t count = 0;
  for (const CheckedFile& file : report.files) {
    if (!may_have_pictures(file) || ++count > most_files_with_pictures) continue;
    std::vector<const CheckTarget*> targets{file.target.get()};
    for (const auto& tile : file.tiles) targets.push_back(tile.get());
    for (const CheckTarget* target : targets)
      for (const TargetFile& part : target->files) {
        std::error_code failure;
        if (!std::filesystem::exists(part.path, failure))
          throw Error::at(part.path, "is not there, and the HTML page shows pictures of it",
                          "a merge in the folder in which the shards ran, or another form");
      }
  }
}

}  // namespace

int merge_validation(MergeArguments& arguments, std::vector<ShardText> texts) {
  ValidateArguments& line = arguments.report;
  if (line.output.format == "jsonl")
    throw Error::at("--format", "jsonl of shards of etak validate",
                    "text, json, sarif, junit, github, csv or html");
  if (!line.write_baseline.empty()) check_file_target(line.write_baseline, true);
  std::vector<ReadOutput> outputs(texts.size());
  parallel_chunks(texts.size(), thread_count(line.threads), 1,
                  [&](std::size_t begin, std::size_t end, unsigned) {
                    for (std::size_t i = begin; i < end; ++i) {
                      outputs[i] = read_output(texts[i]);
                      texts[i].text = {};  // the largest part of the memory
                    }
                  });
  std::vector<ShardOutput> says;
  for (const ReadOutput& each : outputs) says.push_back(each.says);
  std::vector<ValidationReport> shards;
  for (const std::size_t i : complete_shards(says, ETAK_VERSION))
    shards.push_back(std::move(outputs[i].read.report));
  const std::shared_ptr<const ReportShard> shard = shards.front().shard;
  ValidationReport report = merged_report(std::move(shards), !line.write_baseline.empty());
  if (line.output.format == "html") check_pictures_are_there(report);
  line.min_severity = shard->verdict.min_severity;
  tell_not_found(line, report);
  return finish_report(line, shard->settings, shard->verdict, report, {});
}

}  // namespace etak::cli
