// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace etak {

/// One of the `count` parts that a run is cut into, so that several machines share its work. The first part
/// has the index 1.
///   items   which items it takes, from the first to before the second, where a plan has settled that; none: the
///           sizes of all items tell it
struct Shard {
  std::size_t index = 1, count = 1;
  std::optional<std::pair<std::size_t, std::size_t>> items = {};
  friend bool operator==(const Shard&, const Shard&) = default;

  std::string text() const { return std::to_string(index) + '/' + std::to_string(count); }  // "2/4"
};

/// More parts than this are taken for a mistake.
inline constexpr std::size_t most_shards = 1000000;

/// "2/4", or "2/4:25-50" with the items; nullopt for any other text, and for an index that is not from 1 to the
/// count.
std::optional<Shard> shard_named(std::string_view text);

/// The items of a shard: those from `first` to before `second`. The shards are neighbouring runs of the
/// items, so that their results follow each other in the order of the whole run, and a shard reads
/// neighbouring files. Each run holds about the same number of bytes; where there are more shards than items,
/// some are empty. The same for the same sizes on every machine.
///   bytes   what has to be read for each item; opening it counts as some kilobytes more
std::pair<std::size_t, std::size_t> items_of(const Shard& shard, std::span<const std::uint64_t> bytes);

/// What the output of a shard says of itself.
///   file      that holds it, for messages
///   version   of the program that wrote it
///   options   digest of what decides the result besides the inputs
///   list      digest of the inputs of the whole run by their names
///   content   digest of all bytes of the output
///   items     of the whole run; shard.items are those of the shard
struct ShardOutput {
  std::string file;
  Shard shard;
  std::string version, options, list, content;
  std::size_t items = 0;
};

/// What a shard of a planned run reads.
///   list   as the shard's output will have it
struct ShardPlan {
  Shard shard;
  std::string list;
  std::uint64_t bytes = 0;
  std::vector<std::string> files;  // sorted, each once
};

/// The outputs that make up the whole run, in the order of the shards, as indices. A shard that is there
/// twice with equal bytes is taken once: a task that a queue has started again.
///   version   that wrote them all
/// Throws Error that names the files: of another version, number of shards, options or list of inputs than the
/// first, two of one shard that differ, the shards that are missing, and those whose items do not follow each
/// other, because the sizes of files have changed in between.
std::vector<std::size_t> complete_shards(std::span<const ShardOutput> outputs, std::string_view version);

}  // namespace etak
