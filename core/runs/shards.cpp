// SPDX-License-Identifier: Apache-2.0
#include "core/runs/shards.h"

#include <algorithm>

#include "core/base/number.h"

namespace etak {
namespace {

// To open and close an item takes about the time of reading so many bytes.
constexpr std::uint64_t bytes_of_opening = 16384;

// The numbers of "2/4" or "25-50"; nullopt for any other text.
std::optional<std::pair<std::size_t, std::size_t>> two_numbers(std::string_view text, char between) {
  const std::size_t at = text.find(between);
  if (at == text.npos) return std::nullopt;
  const auto first = whole_number<std::size_t>(text.substr(0, at)),
             second = whole_number<std::size_t>(text.substr(at + 1));
  return first && second ? std::optional(std::pair(*first, *second)) : std::nullopt;
}

}  // namespace

std::optional<Shard> shard_named(std::string_view text) {
  const std::size_t colon = text.find(':');
  const auto part = two_numbers(text.substr(0, colon), '/');
  if (!part || part->first < 1 || part->first > part->second || part->second > most_shards)
    return std::nullopt;
  Shard out{part->first, part->second, {}};
  if (colon == text.npos) return out;
  out.items = two_numbers(text.substr(colon + 1), '-');
  return out.items && out.items->first <= out.items->second ? std::optional(out) : std::nullopt;
}

std::pair<std::size_t, std::size_t> items_of(const Shard& shard, std::span<const std::uint64_t> bytes) {
  if (shard.items)
    return {std::min(shard.items->first, bytes.size()), std::min(shard.items->second, bytes.size())};
  std::uint64_t all = 0;
  for (const std::uint64_t each : bytes) all += each + bytes_of_opening;
  // An item belongs to the shard in whose share of all bytes its middle lies. Shares are whole numbers: the
  // shards before this one hold `below`, these and this one `below_next`.
  const auto share = [&](std::size_t shards) {
    return all / shard.count * shards + all % shard.count * shards / shard.count;
  };
  const std::uint64_t below = share(shard.index - 1), below_next = share(shard.index);
  std::size_t first = bytes.size(), last = bytes.size();
  std::uint64_t before = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::uint64_t size = bytes[i] + bytes_of_opening;
    const std::uint64_t middle = before + size / 2;
    if (middle >= below && first == bytes.size()) first = i;
    if (middle >= below_next) {
      last = i;
      break;
    }
    before += size;
  }
  return {first, last};
}

}  // namespace etak
