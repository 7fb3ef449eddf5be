// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/output/replace.h"
#include "app/cli/validate/validate.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/parallel.h"

namespace etak::cli {
namespace {

// Joins the outputs of shards to that of the whole run.
//   line   what the merge shares with the run of all: form and file of the output, the baseline; its paths are
//          those of the shards
int merge_shards(ValidateArguments& line) {
  const std::vector<std::string>& files = line.paths;
  if (files.empty())
    throw Error::at("etak merge", "nothing to merge", "what each shard wrote with --format json");
  check_output(line.output);
  if (!line.write_baseline.empty()) (void)replaces_baseline(line.write_baseline);
  refuse_same_outputs({{"-o", line.output.file}, {"--write-baseline", line.write_baseline}});
  std::vector<ReadShard> shards(files.size());
  parallel_chunks(files.size(), thread_count(line.threads), 1,
                  [&](std::size_t begin, std::size_t end, unsigned) {
                    for (std::size_t i = begin; i < end; ++i)
                      shards[i] = read_shard(read_file(files[i]), files[i], ETAK_VERSION);
                  });
  const std::shared_ptr<const ReportShard> shard = shards.front().report.shard;
  ValidationReport report = merged_report(std::move(shards), !line.write_baseline.empty());
  line.min_severity = shard->verdict.min_severity;
  tell_not_found(line, report);
  return finish_report(line, shard->settings, shard->verdict, report, {});
}

}  // namespace

void add_merge(CommandLine& line) {
  const auto arguments = std::make_shared<ValidateArguments>();
  ValidateArguments& a = *arguments;
  Command verb = line.verb("merge", "join what the shards of a run wrote to the output of the whole run");
  verb.option("file", a.paths, "what each shard wrote with --format json, in any order")
      .reads_file()
      .value_name("SHARD.json...");
  add_output_options(verb, a.output, {"text", "json", "sarif", "junit", "github", "csv", "html"});
  verb.option("--write-baseline", a.write_baseline,
              "record all findings as known, as etak validate --write-baseline does")
      .value_name("FILE");
  add_thread_option(verb, a.threads);
  verb.footer(
      "Every form is equal, byte by byte, to that of the run without --shard, but for the pictures of HTML, and so is the exit status.\n"
      "Exit status: that of the whole run; 2 where a shard is missing, damaged or of another run.\n"
      "Example:\n  etak merge part-1.json part-2.json --format sarif -o findings.sarif");
  verb.runs([arguments] { return merge_shards(*arguments); });
}

}  // namespace etak::cli
