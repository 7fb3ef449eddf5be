// SPDX-License-Identifier: Apache-2.0
#include "core/findings/baseline.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <tuple>

#include "core/base/bytes/hex.h"
#include "core/findings/output/formats.h"
#include "core/judge/rules.h"

namespace etak {
namespace {

constexpr int steps = 16;

// floor and ceiling of value * parts / side; the sides of a picture are far below what would overflow.
int step_down(int value, int side, int parts) {
  return side <= 0 ? 0 : static_cast<int>(std::int64_t{value} * parts / side);
}
int step_up(int value, int side, int parts) {
  return side <= 0 ? 0 : static_cast<int>((std::int64_t{value} * parts + side - 1) / side);
}

auto name_of(const KnownDefect& defect) {
  return std::tie(defect.rule, defect.file, defect.tile, defect.material, defect.pointer);
}

auto place_of(const KnownDefect& defect) {
  return std::tuple_cat(name_of(defect), std::tie(defect.region));
}

// Whether `sorted`, in the order of place_of(), holds the wanted defect: one of the same name, with each edge
// of its region at most one step away. Each such region is looked up, so that a thousand defects of one name
// take no longer than a thousand of different names.
bool is_known(const std::vector<const KnownDefect*>& sorted, const KnownDefect& wanted) {
  const auto before = [](const KnownDefect* a, const KnownDefect* b) { return place_of(*a) < place_of(*b); };
  constexpr int neighbours = 81;  // 3^4: each of four edges a step back, unchanged or a step on
  KnownDefect moved = wanted;
  for (int i = 0; i < (wanted.region ? neighbours : 1); ++i) {
    if (wanted.region)
      for (std::size_t edge = 0, digits = static_cast<std::size_t>(i); edge < 4; ++edge, digits /= 3)
        (*moved.region)[edge] = (*wanted.region)[edge] + static_cast<int>(digits % 3) - 1;
    if (std::binary_search(sorted.begin(), sorted.end(), &moved, before)) return true;
  }
  return false;
}

}  // namespace

KnownDefect known_defect(const Finding& finding, int width, int height) {
  KnownDefect out{finding.rule, finding.file, finding.tile, finding.material, finding.pointer, {}};
  if (!finding.box || width <= 0 || height <= 0) return out;
  const PixelBox& box = *finding.box;
  if (!finding.tile.empty())
    out.region = {0, 0, step_up(box.width, width, steps), step_up(box.height, height, steps)};
  else
    out.region = {step_down(box.x, width, steps), step_down(box.y, height, steps),
                  step_up(box.x + box.width, width, steps), step_up(box.y + box.height, height, steps)};
  return out;
}

std::vector<KnownDefect> baseline_of(const ValidationReport& report) {
  std::vector<KnownDefect> out;
  for (const CheckedFile& file : report.files)
    for (const Finding& finding : file.findings)
      if (!finding.suppressed && !is_of_the_tool(finding.rule))
        out.push_back(known_defect(finding, file.width, file.height));
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

void mark_known(ValidationReport& report, std::span<const KnownDefect> known) {
  std::vector<const KnownDefect*> sorted;
  for (const KnownDefect& defect : known) sorted.push_back(&defect);
  std::sort(sorted.begin(), sorted.end(),
            [](const KnownDefect* a, const KnownDefect* b) { return place_of(*a) < place_of(*b); });
  for (CheckedFile& file : report.files)
    for (Finding& finding : file.findings) {
      if (is_of_the_tool(finding.rule)) continue;
      finding.baseline = !sorted.empty() && is_known(sorted, known_defect(finding, file.width, file.height));
    }
}

std::string region_fingerprint(const Finding& finding, int width, int height) {
  constexpr int parts = 8;
  std::string key;
  for (const std::string* part :
       {&finding.rule, &finding.file, &finding.tile, &finding.material, &finding.pointer})
    (key += *part) += '\n';
  if (finding.box && width > 0 && height > 0 && finding.tile.empty())
    key += std::to_string(step_down(finding.box->x + finding.box->width / 2, width, parts)) + ',' +
           std::to_string(step_down(finding.box->y + finding.box->height / 2, height, parts));
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : key) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hex(hash);
}

}  // namespace etak
