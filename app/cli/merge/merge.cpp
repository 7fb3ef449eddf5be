// SPDX-License-Identifier: Apache-2.0
#include "app/cli/merge/merge.h"

#include "app/cli/output/replace.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/output_target.h"

namespace etak::cli {
namespace {

// The value of the member "schema", which the documents of etak begin with; empty where there is none.
std::string_view schema_of(std::string_view text) {
  constexpr std::string_view begin = "{\n  \"schema\": \"";
  if (!text.starts_with(begin)) return {};
  text.remove_prefix(begin.size());
  return text.substr(0, text.find('"'));
}

}  // namespace

int merge_shards(MergeArguments& arguments) {
  if (arguments.files.empty())
    throw Error::at("etak merge", "nothing to merge", "what each shard wrote with --format json");
  check_output(arguments.report.output);
  std::vector<ShardText> texts;
  for (const std::string& file : arguments.files) texts.push_back({file, read_file(file)});
  for (const ShardText& each : texts)
    if (schema_of(each.text) != "etak-validation/1")
      throw Error::at(
          each.file, "is no JSON output of a shard",
          "what etak validate --shard I/N --format json wrote; etak merge makes every other form of it");
  return merge_validation(arguments, std::move(texts));
}

}  // namespace etak::cli
