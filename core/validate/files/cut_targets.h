// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/runs/shards.h"
#include "core/validate/find/find_targets.h"

namespace etak {

/// What belongs together and is checked by one shard: targets, a set without its companion, or something that
/// cannot be checked.
///   targets, lone, failed   indices into the lists of FoundTargets
///   bytes                   of the files of its targets, each once
struct TargetGroup {
  std::vector<std::size_t> targets, lone, failed;
  std::uint64_t bytes = 0;
};

/// The groups of everything that was found, in the order in which shards take them. One group are the tiles of
/// a UDIM set, the pages of a layout with the scene that reads them, and the maps of a material with its
/// colours. Two scenes that share a texture are two groups.
std::vector<TargetGroup> groups_of(const FoundTargets& found, unsigned threads);

/// A digest of what was found, by names and roles: equal where the same groups are made of it. Sizes are left
/// out, so that a file that changes concerns its own shard alone.
std::string digest_of(const FoundTargets& found, const std::vector<TargetGroup>& groups);

/// Keeps what the shard takes of `found`, with the place of each result in the run of all. What belongs to no
/// group stays in the first shard alone. Returns which groups the shard takes.
std::pair<std::size_t, std::size_t> keep_groups(FoundTargets& found, const std::vector<TargetGroup>& groups,
                                                const Shard& shard);

}  // namespace etak
