// SPDX-License-Identifier: Apache-2.0
#include "core/base/shards/shards.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/number.h"

namespace etak {
namespace {

// To open and close an item takes about the time of reading so many bytes.
constexpr std::uint64_t bytes_of_opening = 16384;

}  // namespace

std::optional<Shard> shard_named(std::string_view text) {
  std::optional<std::pair<std::size_t, std::size_t>> items;
  if (const std::size_t colon = text.find(':'); colon != text.npos) {
    const std::string_view range = text.substr(colon + 1);
    const std::size_t dash = range.find('-');
    if (dash == range.npos) return std::nullopt;
    const auto first = whole_number<std::size_t>(range.substr(0, dash)),
               last = whole_number<std::size_t>(range.substr(dash + 1));
    if (!first || !last || *first > *last) return std::nullopt;
    items.emplace(*first, *last);
    text = text.substr(0, colon);
  }
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const auto index = whole_number<std::size_t>(text.substr(0, slash)),
             count = whole_number<std::size_t>(text.substr(slash + 1));
  if (!index || !count || *index < 1 || *index > *count || *count > most_shards) return std::nullopt;
  return Shard{*index, *count, items};
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

std::vector<std::size_t> complete_shards(std::span<const ShardOutput> outputs, std::string_view version) {
  const ShardOutput& first = outputs.front();
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> out(first.shard.count, none);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const ShardOutput& each = outputs[i];
    const auto fail = [&](const std::string& found, const std::string& expected) {
      throw Error::at(each.file, found, expected);
    };
    if (each.version != version)
      fail("was written by etak " + printable(each.version), "all shards of etak " + std::string(version));
    if (each.shard.count != first.shard.count)
      fail("is shard " + each.shard.text(),
           "one of " + std::to_string(first.shard.count) + ", as " + printable(first.file, 200) + " is");
    if (each.options != first.options)
      fail("was run with other options than " + printable(first.file, 200),
           "the same options, configuration, baseline and library for every shard");
    if (each.list != first.list)
      fail("was cut from another list of inputs than " + printable(first.file, 200),
           "inputs that stay the same while the shards run; run all shards again");
    std::size_t& place = out[each.shard.index - 1];
    if (place == none)
      place = i;
    else if (outputs[place].content != each.content)
      fail("is shard " + each.shard.text() + " like " + printable(outputs[place].file, 200) +
               ", and their bytes differ",
           "each shard once, or twice the same");
  }
  constexpr std::size_t most_named = 20;
  std::string missing;
  std::size_t count = 0;
  for (std::size_t i = 0; i < out.size(); ++i)
    if (out[i] == none && ++count <= most_named)
      missing += (missing.empty() ? "" : ", ") + Shard{i + 1, out.size()}.text();
  if (count > most_named) missing += " and " + std::to_string(count - most_named) + " more";
  if (count > 0)
    throw Error::at(
        "etak merge", (count == 1 ? "missing: shard " : "missing: shards ") + missing,
        "every shard from 1/" + std::to_string(out.size()) + " on; run what is missing and merge again");
  std::size_t next = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const ShardOutput& each = outputs[out[i]];
    const auto [from, to] = each.shard.items.value_or(std::pair(next, next));
    const bool fits = from == next && (i + 1 < out.size() || to == each.items);
    if (!fits)
      throw Error::at(each.file, "holds other items than follow those of the shards before it",
                      "files whose sizes stay the same while the shards run; run all shards again");
    next = to;
  }
  return out;
}

}  // namespace etak
