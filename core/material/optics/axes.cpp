// SPDX-License-Identifier: Apache-2.0
#include "core/material/optics/axes.h"

#include <array>

namespace etak {
namespace {

constexpr std::array uniaxial{CrystalAxis{"o", "o", "ordinary", 2.0 / 3},
                              CrystalAxis{"e", "e", "extraordinary", 1.0 / 3}};
constexpr std::array biaxial{CrystalAxis{"alpha", "α", "alpha", 1.0 / 3},
                             CrystalAxis{"beta", "β", "beta", 1.0 / 3},
                             CrystalAxis{"gamma", "γ", "gamma", 1.0 / 3}};
constexpr std::array<std::span<const CrystalAxis>, 2> systems{uniaxial, biaxial};

}  // namespace

std::span<const CrystalAxis> axes_of_system(std::string_view text, std::string_view CrystalAxis::*member) {
  for (const std::span<const CrystalAxis> system : systems)
    for (const CrystalAxis& axis : system)
      if (axis.*member == text) return system;
  return {};
}

const CrystalAxis* axis_named(std::string_view text) {
  for (const std::span<const CrystalAxis> system : systems)
    for (const CrystalAxis& axis : system)
      if (text == axis.tag || text == axis.symbol) return &axis;
  return nullptr;
}

std::vector<AxisDataset> axis_datasets(const Material& material, const Dataset& dataset) {
  std::vector<AxisDataset> out;
  for (const CrystalAxis& axis : axes_of_system(dataset.axis, &CrystalAxis::name)) {
    AxisDataset found{nullptr, axis.weight};
    for (const Dataset& other : material.datasets) {
      const bool fits = other.axis == axis.name && other.citation.authors == dataset.citation.authors &&
                        other.citation.year == dataset.citation.year;
      if (fits && (found.dataset == nullptr || other.temperature_kelvin == dataset.temperature_kelvin))
        found.dataset = &other;
    }
    if (axis.name == dataset.axis) found.dataset = &dataset;
    out.push_back(found);
  }
  return out;
}

}  // namespace etak
