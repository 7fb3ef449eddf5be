// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/cut_targets.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string_view>
#include <unordered_map>

#include "core/base/hash/content_hash.h"
#include "core/base/parallel.h"
#include "core/base/system.h"
#include "core/validate/files/result_text.h"

namespace etak {
namespace {

// Sets of indices that are joined step by step. The least index stands for its set.
class JoinedIndices {
 public:
  explicit JoinedIndices(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), 0); }

  std::size_t least(std::size_t i) {
    while (above_[i] != i) i = above_[i] = above_[above_[i]];
    return i;
  }

  void join(std::size_t a, std::size_t b) {
    a = least(a);
    b = least(b);
    above_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> above_;
};

// Joins all indices that come with the same key.
class ByKey {
 public:
  explicit ByKey(JoinedIndices& joined) : joined_(joined) {}
  void add(std::string_view key, std::size_t i) {
    const auto [same, fresh] = first_.try_emplace(key, i);
    if (!fresh) joined_.join(same->second, i);
  }

 private:
  JoinedIndices& joined_;
  std::unordered_map<std::string_view, std::size_t> first_;
};

bool is_picture_set(const FoundTarget& found) {
  return !found.depends.empty() && !found.target.files.empty() &&
         is_picture(found.target.files.front().role) &&
         found.depends.front() == found.target.files.front().path;
}

std::uint64_t size_of(const std::string& path) {
  sys::FileInfo info;
  return sys::file_info(path, info) ? info.size : 0;
}

}  // namespace

std::vector<TargetGroup> groups_of(const FoundTargets& found, unsigned threads) {
  const auto& targets = found.targets;
  JoinedIndices joined(targets.size());
  // The first file that a result depends on is the layout of a page, else the scene or picture itself.
  ByKey files(joined), tiles(joined), maps(joined);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const CheckTarget& target = targets[i].target;
    if (!targets[i].depends.empty()) files.add(targets[i].depends.front(), i);
    if (!target.manifest.scene.empty()) files.add(target.manifest.scene, i);
    if (!target.udim.empty()) tiles.add(target.udim, i);
    if (is_picture_set(targets[i]))
      for (const std::string& path : targets[i].depends) maps.add(path, i);
  }
  std::vector<TargetGroup> out;
  std::unordered_map<std::size_t, std::size_t> group_of;  // by the least index of its targets
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const auto [at, fresh] = group_of.try_emplace(joined.least(i), out.size());
    if (fresh) out.emplace_back();
    out[at->second].targets.push_back(i);
  }
  parallel_chunks(out.size(), threads, 16, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t g = begin; g < end; ++g) {
      std::set<std::string_view> once;
      for (const std::size_t i : out[g].targets)
        for (const std::string& path : targets[i].depends)
          if (once.insert(path).second) out[g].bytes += size_of(path);
    }
  });
  for (std::size_t i = 0; i < found.lone.size(); ++i) out.emplace_back().lone = {i};
  for (std::size_t i = 0; i < found.failed.size(); ++i) out.emplace_back().failed = {i};
  return out;
}

std::string digest_of(const FoundTargets& found, const std::vector<TargetGroup>& groups) {
  ContentHash hash;
  const auto add = [&](std::string_view text) { hash.add_part(text); };
  for (const TargetGroup& group : groups) {
    add("group");
    for (const std::size_t i : group.targets) add(identity_of(found.targets[i]));
    for (const std::size_t i : group.lone) {
      add(found.lone[i].path);
      for (const std::string& companion : found.lone[i].companions) add(companion);
    }
    for (const std::size_t i : group.failed) add(found.failed[i].path);
  }
  for (const std::string& label : found.unknown) add(label);
  return hash.hex();
}

std::pair<std::size_t, std::size_t> keep_groups(FoundTargets& found, const std::vector<TargetGroup>& groups,
                                                const Shard& shard) {
  // The order of results in validate(): targets, sets of tiles by their labels, lone sets, failures.
  std::size_t next = 0;
  std::map<std::string_view, std::vector<FoundTarget*>> sets;
  for (FoundTarget& each : found.targets)
    if (each.target.udim.empty())
      each.place = next++;
    else
      sets[each.target.udim].push_back(&each);
  for (const auto& [label, tiles] : sets) {
    for (FoundTarget* const tile : tiles) tile->place = next;
    ++next;
  }
  for (auto* const list : {&found.lone, &found.failed})
    for (CheckedFile& file : *list) file.place = next++;

  std::vector<std::uint64_t> bytes;
  for (const TargetGroup& group : groups) bytes.push_back(group.bytes);
  const auto [first, last] = items_of(shard, bytes);
  std::vector<char> targets(found.targets.size()), lone(found.lone.size()), failed(found.failed.size());
  for (std::size_t g = first; g < last; ++g) {
    for (const std::size_t i : groups[g].targets) targets[i] = 1;
    for (const std::size_t i : groups[g].lone) lone[i] = 1;
    for (const std::size_t i : groups[g].failed) failed[i] = 1;
  }
  const auto keep = [](auto& list, const std::vector<char>& kept) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (kept[i] == 0) continue;
      if (count != i) list[count] = std::move(list[i]);
      ++count;
    }
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(count), list.end());
  };
  keep(found.targets, targets);
  keep(found.lone, lone);
  keep(found.failed, failed);
  if (shard.index > 1) {
    found.unknown.clear();
    found.no_files.clear();
  }
  return {first, last};
}

}  // namespace etak
