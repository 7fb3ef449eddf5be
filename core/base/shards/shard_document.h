// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/shards/shards.h"

namespace etak {

// A shard of a run whose result is a list: the JSON document of the whole run (json_document() of json_text.h)
// with the items of the shard alone, and a member "shard" before the list. The items follow each other in the
// order of the shards.

/// A form that is made of rows, besides JSON.
///   head   what stands before the rows of all
struct ShardForm {
  std::string head, rows;
};

/// The "shard" member.
///   says     of which shard; its digests and version
///   counts   for the exit status of the merge, by names that the verb chooses
///   forms    the items in other forms, by the names of --format
struct ShardMember {
  ShardOutput says;
  std::map<std::string, std::uint64_t> counts;
  std::map<std::string, ShardForm> forms;
};

/// The document of a shard. Throws Error for a form that is no UTF-8, which JSON cannot hold.
///   text   the document of its items alone
///   list   the key of the list: the document's last member
std::string shard_document(std::string_view text, std::string_view list, const ShardMember& member);

/// A document of shard_document(), taken apart.
///   head    what stands before the "shard" member
///   items   of the list, as they stand there; empty: none
struct ShardDocument {
  ShardMember member;
  std::string head, items;
};

/// Throws Error naming `file` where the text is no such document.
ShardDocument read_shard_document(std::string_view text, std::string_view list, const std::string& file);

/// The document of the whole run.
///   shards   all of them, in order (complete_shards())
std::string joined_document(const std::vector<ShardDocument>& shards, std::string_view list);

/// A form of the whole run; it must be among the forms of the shards.
std::string joined_form(const std::vector<ShardDocument>& shards, const std::string& form);

}  // namespace etak
