// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/findings/report.h"

namespace etak {

/// A defect that was there when the baseline was written.
///   region   left, top, right, bottom of the finding's box in 1/16 of the picture's sides; of a tile only
///            the size (0, 0, width, height), because a new layout moves tiles about; none where the finding
///            has no box
struct KnownDefect {
  std::string rule, file, tile, material, pointer;
  std::optional<std::array<int, 4>> region;
  friend auto operator<=>(const KnownDefect&, const KnownDefect&) = default;
};

/// The finding as an entry; `width` and `height` are of its picture.
KnownDefect known_defect(const Finding& finding, int width, int height);

/// The findings of `report` that count now, sorted. Findings that an [[allow]] entry covers are left out, and
/// those of ETK001 and 9xx, which can never be known.
std::vector<KnownDefect> baseline_of(const ValidationReport& report);

/// Sets `baseline` of every finding: whether `known` holds it. Every edge of the region may differ by one
/// step, so that a defect stays known after an export with other softness or compression. A defect that has
/// grown or moved further is new.
void mark_known(ValidationReport& report, std::span<const KnownDefect> known);

/// {"schema": "etak-baseline/1", "findings": [...]}, one entry per line.
std::string baseline_json(std::span<const KnownDefect> known);

/// Throws Error with file and JSON pointer.
std::vector<KnownDefect> read_baseline(std::string_view text, std::string_view file);

}  // namespace etak
