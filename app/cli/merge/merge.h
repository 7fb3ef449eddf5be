// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/validate/validate.h"

namespace etak::cli {

/// The options of `etak merge`.
struct MergeArguments {
  std::vector<std::string> files;
  // What the merge of a validation shares with the run of all: form and file of the output, the baseline.
  ValidateArguments report;
};

/// The output of a shard as it lies on the disk.
struct ShardText {
  std::string file, text;
};

/// Joins the outputs of shards to the output of the whole run. Returns its exit status; throws Error.
int merge_shards(MergeArguments& arguments);

/// The same for shards of `etak validate`.
int merge_validation(MergeArguments& arguments, std::vector<ShardText> texts);

/// The same for a verb whose result is a list: that of the document's schema, etak-f0/1, etak-export/1 or
/// etak-pack-batch/1.
bool is_list_schema(std::string_view schema);
int merge_list(MergeArguments& arguments, const std::vector<ShardText>& texts, std::string_view schema);

}  // namespace etak::cli
