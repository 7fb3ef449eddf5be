// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "core/material/material.h"

namespace etak {

// Alloys and mixed crystals between measured compositions. A series is a material whose datasets are the compositions of
// one publication, each with the fraction of the second part as its id: "0.3". resources/series/ holds those of etak.

/// The widest step between neighbouring compositions of a series that is interpolated.
inline constexpr double widest_step = 0.2;

/// A text such as "silver_gold:0.35".
///   series     the name before the ':', a view into the text
///   fraction   of the second part, [0, 1]
struct AlloyText {
  std::string_view series;
  double fraction = 0;
};

/// Nothing for a text of another form.
std::optional<AlloyText> read_alloy(std::string_view text);

/// Whether all datasets of a material are compositions of a series: tables of n and k, each with a number as its id.
bool is_series(const Material& material);

/// A composition of a series: a dataset of the series, or n and k linear between those of its two neighbours, at the
/// wavelengths of both and within what both cover. Left out one by one, 33 compositions of etak's series are met within
/// 0.019 of linear F0, where n and k squared meet them within 0.021 (resources/doc/uncertainty.md).
///   text     for messages
///   widest   step between the neighbours
/// Throws Error for a fraction outside of what the series has, and between neighbours more than `widest` apart.
Material alloy(const Material& series, double fraction, std::string_view text, double widest = widest_step);

}  // namespace etak
