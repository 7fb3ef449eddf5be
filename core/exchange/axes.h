// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/material/material.h"

namespace etak {

/// What stands for one axis of a crystal in the average over grain directions.
///   weight   2/3 ordinary and 1/3 extraordinary, or 1/3 for each of alpha, beta, gamma
struct AxisPage {
  std::string path;
  double weight = 1;
};
struct AxisDataset {
  const Dataset* dataset = nullptr;
  double weight = 1;
};

/// The pages of all axes of the crystal that `path` describes one axis of, told by the parts of the file name
/// ("Malitson-o", "Zheng-o-21C"; alpha, beta, gamma likewise). Files are not looked for. Empty where the name
/// has no axis.
std::vector<AxisPage> axis_pages(const std::string& path);

/// The same for a dataset of a material: those with the other axes by the same authors in the same year and,
/// where there is a choice, at the same temperature. Empty for a dataset without axis; a null dataset where
/// one is missing.
std::vector<AxisDataset> axis_datasets(const Material& material, const Dataset& dataset);

}  // namespace etak
