// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/tiles.h"

#include <algorithm>
#include <tuple>

#include "core/judge/target.h"

namespace etak {

void add_sums(const CheckedFile& one, CheckedFile& file) {
  file.unreadable = file.unreadable || one.unreadable;
  file.plateau_px += one.plateau_px;
  file.transition_px += one.transition_px;
  file.stats.texels += one.stats.texels;
  file.stats.passes += one.stats.passes;
  file.stats.byte_seconds += one.stats.byte_seconds;
  file.stats.region_seconds += one.stats.region_seconds;
  for (const auto& [what, count] : one.counts) {
    const auto same = std::ranges::find(file.counts, what, &std::pair<std::string, std::int64_t>::first);
    if (same == file.counts.end())
      file.counts.emplace_back(what, count);
    else if (what == "gloss_min")
      same->second = std::min(same->second, count);
    else if (what == "gloss_max")
      same->second = std::max(same->second, count);
    else
      same->second += count;
  }
}

void sort_findings(CheckedFile& file) {
  std::stable_sort(file.findings.begin(), file.findings.end(), [](const Finding& a, const Finding& b) {
    return std::tie(a.rule, a.tile, a.pointer) < std::tie(b.rule, b.tile, b.pointer);
  });
}

CheckedFile joined_tiles(std::vector<CheckedFile> tiles) {
  CheckedFile set;
  set.width = tiles.front().width;
  set.height = tiles.front().height;
  set.target = tiles.front().target;
  set.path = set.target->udim;
  set.is_set = true;
  set.place = tiles.front().place;
  for (CheckedFile& one : tiles) {
    for (Finding& finding : one.findings) {
      if (finding.tile.empty()) finding.tile = one.target->tile;
      set.findings.push_back(std::move(finding));
    }
    set.companions.push_back(one.path);
    std::move(one.companions.begin(), one.companions.end(), std::back_inserter(set.companions));
    std::move(one.roles.begin(), one.roles.end(), std::back_inserter(set.roles));
    set.tiles.push_back(one.target);
    set.stats.pictures_decoded += one.stats.pictures_decoded;
    set.stats.pictures_left_out += one.stats.pictures_left_out;
    set.stats.decode_seconds += one.stats.decode_seconds;
    add_sums(one, set);
  }
  sort_findings(set);
  return set;
}

}  // namespace etak
