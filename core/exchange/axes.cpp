// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/axes.h"

#include <array>
#include <span>
#include <string_view>

namespace etak {
namespace {

struct Axis {
  std::string_view tag, name;  // in file names, in datasets
  double weight;
};
constexpr std::array uniaxial{Axis{"o", "ordinary", 2.0 / 3}, Axis{"e", "extraordinary", 1.0 / 3}};
constexpr std::array biaxial{Axis{"alpha", "alpha", 1.0 / 3}, Axis{"beta", "beta", 1.0 / 3},
                             Axis{"gamma", "gamma", 1.0 / 3}};

// The axes of the crystal system that `text` is an axis of.
std::span<const Axis> system_of(std::string_view text, std::string_view Axis::*key) {
  for (const std::span<const Axis> system : {std::span<const Axis>(uniaxial), std::span<const Axis>(biaxial)})
    for (const Axis& axis : system)
      if (axis.*key == text) return system;
  return {};
}

}  // namespace

std::vector<AxisPage> axis_pages(const std::string& path) {
  const std::size_t stem_end = path.rfind('.');
  const std::size_t stem_begin = path.rfind('/') + 1;
  // The last part wins: an author's initial may come before it.
  for (std::size_t end = stem_end; end != std::string::npos && end > stem_begin;) {
    const std::size_t dash = path.rfind('-', end - 1);
    if (dash == std::string::npos || dash < stem_begin) break;
    const auto axes = system_of(std::string_view(path).substr(dash + 1, end - dash - 1), &Axis::tag);
    std::vector<AxisPage> out;
    for (const Axis& axis : axes)
      out.push_back({path.substr(0, dash + 1) + std::string(axis.tag) + path.substr(end), axis.weight});
    if (!out.empty()) return out;
    end = dash;
  }
  return {};
}

std::vector<AxisDataset> axis_datasets(const Material& material, const Dataset& dataset) {
  std::vector<AxisDataset> out;
  for (const Axis& axis : system_of(dataset.axis, &Axis::name)) {
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
