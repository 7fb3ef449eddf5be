// SPDX-License-Identifier: Apache-2.0
#include "app/cli/merge/merge.h"

#include <memory>

#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"

namespace etak::cli {

void add_merge(CommandLine& line) {
  const auto arguments = std::make_shared<MergeArguments>();
  MergeArguments& a = *arguments;
  Command verb = line.verb("merge", "join what the shards of a run wrote to the output of the whole run");
  verb.option("file", a.files, "what each shard wrote with --format json, in any order")
      .reads_file()
      .value_name("SHARD.json...");
  add_output_options(verb, a.report.output,
                     {"text", "json", "jsonl", "sarif", "junit", "github", "csv", "html"});
  verb.option("--write-baseline", a.report.write_baseline,
              "record all findings as known, as etak validate --write-baseline does")
      .value_name("FILE");
  add_thread_option(verb, a.report.threads);
  verb.footer(
      "Every form is equal, byte by byte, to that of the run without --shard, and so is the exit status.\n"
      "Exit status: that of the whole run; 2 where a shard is missing or does not belong to the others.\n"
      "Example:\n  etak merge part-1.json part-2.json --format sarif -o findings.sarif");
  verb.runs([arguments] { return merge_shards(*arguments); });
}

}  // namespace etak::cli
