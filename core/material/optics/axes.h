// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/material/material.h"

namespace etak {

/// One optical axis of a crystal system.
///   tag      in the names of files: "o", "alpha"
///   symbol   in texts: "o", "α"
///   name     in Dataset::axis: "ordinary", "alpha"
///   weight   share in the average over grains of all directions: 2/3 ordinary and 1/3 extraordinary, or 1/3
///            for each of alpha, beta, gamma
struct CrystalAxis {
  std::string_view tag, symbol, name;
  double weight;
};

/// The axes of the crystal system one of whose axes has `text` as its `member`; none where no axis has.
std::span<const CrystalAxis> axes_of_system(std::string_view text, std::string_view CrystalAxis::*member);

/// The axis whose tag or symbol is `text`; null: none.
const CrystalAxis* axis_named(std::string_view text);

/// What stands for one axis of a crystal in the average over the directions of grains.
struct AxisDataset {
  const Dataset* dataset = nullptr;
  double weight = 1;
};

/// The datasets of all axes of the crystal that `dataset` describes one axis of: those with the other axes by
/// the same authors in the same year and, where there is a choice, at the same temperature. Empty for a
/// dataset without axis; a null dataset where one is missing.
std::vector<AxisDataset> axis_datasets(const Material& material, const Dataset& dataset);

}  // namespace etak
