// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/validate/rules/rows.h"

namespace etak {

namespace {

void etk406(RuleCheck& check) {
  for (const TileEvidence& tile : check.evidence.tiles) {
    const Detail& d = tile.detail;
    if (!d.every_row || d.opaque < 4096 ||
        static_cast<double>(d.smooth) < 0.8 * static_cast<double>(d.texels))
      continue;
    const Histogram& green = d.a[1];
    std::uint64_t below = 0;
    int first = -1, last = -1;
    for (int code = 0; code < 256; ++code) {
      below += green[static_cast<std::size_t>(code)];
      if (first < 0 && 100 * below > d.opaque) first = code;
      if (last < 0 && 100 * below >= 99 * d.opaque) last = code;
    }
    std::vector<int> steps;
    int used = 0, before = -1;
    for (int code = first; code <= last; ++code) {
      if (green[static_cast<std::size_t>(code)] == 0) continue;
      ++used;
      if (before >= 0) steps.push_back(code - before);
      before = code;
    }
    if (used < 8 || 4 * used >= last - first + 1) continue;
    std::sort(steps.begin(), steps.end());
    if (steps.back() > 2 * steps[steps.size() / 2]) continue;
    Finding& finding = check.report(tile, FileRole::diffuse_alpha);
    finding.value = std::to_string(used) + " codes";
    finding.limit = "a quarter of " + std::to_string(last - first + 1);
    finding.message = "a smooth gradient uses " + finding.value + " between " + std::to_string(first) +
                      " and " + std::to_string(last);
  }
}

}  // namespace

constinit const Rule etk406_posterised{
    "ETK406",
    "posterised",
    "A gradient in few steps",
    Severity::info,
    Severity::warning,
    {Need::bytes_a},
    {},
    "etak (proposed); at least 8 steps of similar width are asked for, because flat artwork "
    "of a few colours is no mistake",
    "Diffuse (green) is smooth along 80 % of neighbouring texels, and uses less than a "
    "quarter of the codes between its 1st and 99th percentile, in at least 8 steps of "
    "similar width.",
    "Bands show in gradients.",
    "A texture saved with a palette, or quantised by a video codec.",
    "Export again from the source.",
    &etk406};

}  // namespace etak
