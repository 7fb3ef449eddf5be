// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "app/cli/merge/merge.h"
#include "core/base/error.h"
#include "core/base/shards/shard_document.h"

namespace etak::cli {
namespace {

// A document that is a list of items.
struct ListDocument {
  std::string_view schema, list, verb;
  std::string_view forms;  // for messages
};
constexpr std::array list_documents{ListDocument{"etak-f0/1", "results", "etak f0", "json, jsonl or csv"},
                                    ListDocument{"etak-export/1", "materials", "etak export", "json or csv"},
                                    ListDocument{"etak-pack-batch/1", "jobs", "etak pack", "json"}};

std::uint64_t sum_of(const std::vector<ShardDocument>& shards, const std::string& count) {
  std::uint64_t out = 0;
  for (const ShardDocument& each : shards)
    if (const auto found = each.member.counts.find(count); found != each.member.counts.end())
      out += found->second;
  return out;
}

std::uint64_t count_of(const ShardDocument& shard, const std::string& count) {
  const auto found = shard.member.counts.find(count);
  return found == shard.member.counts.end() ? 0 : found->second;
}

}  // namespace

bool is_list_schema(std::string_view schema) {
  return std::ranges::find(list_documents, schema, &ListDocument::schema) != list_documents.end();
}

int merge_list(MergeArguments& arguments, const std::vector<ShardText>& texts, std::string_view schema) {
  const auto kind = std::ranges::find(list_documents, schema, &ListDocument::schema);
  const OutputArguments& output = arguments.report.output;
  if (!arguments.report.write_baseline.empty())
    throw Error::at("--write-baseline", "shards of " + std::string(kind->verb), "shards of etak validate");
  std::vector<ShardDocument> read;
  for (const ShardText& each : texts) read.push_back(read_shard_document(each.text, kind->list, each.file));
  std::vector<ShardOutput> says;
  for (const ShardDocument& each : read) says.push_back(each.member.says);
  std::vector<ShardDocument> shards;
  for (const std::size_t i : complete_shards(says, ETAK_VERSION)) shards.push_back(std::move(read[i]));
  const ShardDocument& first = shards.front();
  for (const ShardDocument& each : shards)
    if (each.head != first.head)
      throw Error::at(each.member.says.file, "was run with other options than " + first.member.says.file,
                      "the same options for every shard");
  if (output.format != "json" && !first.member.forms.contains(output.format))
    throw Error::at("--format", output.format + " of shards of " + std::string(kind->verb), kind->forms);
  const std::uint64_t inputs = count_of(first, "inputs"), rows = sum_of(shards, "rows"),
                      failed = sum_of(shards, "failed");
  // As the run of all ends where it has found nothing.
  if (inputs == 0 && count_of(first, "allowEmpty") == 0)
    throw Error::at("etak merge", "the shards had no inputs", "names, or shards run with --allow-empty");
  if (rows == 0 && failed == 0 && inputs > 0 && schema == "etak-f0/1")
    throw Error::at("etak merge", "the inputs hold no page of n and k", "a page, table or material file");
  if (rows > 0 || inputs == 0)
    write_output(output, output.format == "json" ? joined_document(shards, kind->list)
                                                 : joined_form(shards, output.format));
  if (failed > 0) return exit_failure;
  return sum_of(shards, "refused") > 0 ? exit_findings : exit_ok;
}

}  // namespace etak::cli
