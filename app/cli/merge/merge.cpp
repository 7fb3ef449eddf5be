// SPDX-License-Identifier: Apache-2.0
#include "app/cli/merge/merge.h"

#include "app/cli/output/replace.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/output_target.h"

namespace etak::cli {
namespace {

constexpr std::string_view validation_schema = "etak-validation/1";

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
  const std::string schema(schema_of(texts.front().text));
  for (const ShardText& each : texts) {
    const std::string_view own = schema_of(each.text);
    if (own != validation_schema && !is_list_schema(own))
      throw Error::at(
          each.file, "is no JSON output of a shard",
          "what a verb with --shard I/N --format json wrote; etak merge makes the other forms of it");
    if (own != schema)
      throw Error::at(each.file,
                      "is " + in_quotes(own) + ", and " + texts.front().file + " is " + in_quotes(schema),
                      "shards of one run");
  }
  if (schema == validation_schema) return merge_validation(arguments, std::move(texts));
  return merge_list(arguments, texts, schema);
}

}  // namespace etak::cli
