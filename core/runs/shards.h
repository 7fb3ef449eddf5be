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

/// What a shard of a planned run reads.
///   list   as the shard's output will have it; empty where nothing is joined
struct ShardPlan {
  Shard shard;
  std::string list;
  std::vector<std::string> files;  // sorted, each once
};

}  // namespace etak
