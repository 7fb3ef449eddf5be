// SPDX-License-Identifier: Apache-2.0
#include "core/material/quality.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "core/base/number.h"
#include "core/material/f0/f0_data.h"
#include "core/material/optics/axes.h"

namespace etak {
namespace {

std::optional<double> luminance_in(const F0Result& result) {
  if (result.refused()) return std::nullopt;
  return result.luminance;
}

// Luminance of F0; nothing where the data have none. Datasets of one material are compared under these options,
// whatever options the caller has: a dataset does not become doubtful under water.
std::optional<double> luminance_of(const Dataset& dataset) {
  static const F0Solver solver{[] {
    F0Options options;
    options.f82 = false;  // the luminance alone is looked at
    return options;
  }()};
  return luminance_in(solver.solve(dataset.optics));
}

using LuminanceOf = std::function<std::optional<double>(const Dataset&)>;

bool is_witness(const Dataset& other, const Dataset& dataset) {
  return other.id != dataset.id && other.axis == dataset.axis && other.doubtful.empty() &&
         other.origin != Origin::computed;
}

std::optional<double> median_by(const LuminanceOf& luminance_of_one, const Material& material,
                                const Dataset& dataset) {
  if (!gives_f0(material.material_class)) return std::nullopt;
  // Most materials have one or two datasets: for these nothing needs to be solved.
  if (std::count_if(material.datasets.begin(), material.datasets.end(),
                    [&](const Dataset& other) { return is_witness(other, dataset); }) < 2)
    return std::nullopt;
  std::vector<double> luminance;
  for (const Dataset& other : material.datasets) {
    if (!is_witness(other, dataset)) continue;
    if (const auto found = luminance_of_one(other)) luminance.push_back(*found);
  }
  if (luminance.size() < 2) return std::nullopt;
  std::sort(luminance.begin(), luminance.end());
  const std::size_t middle = luminance.size() / 2;
  return luminance.size() % 2 == 1 ? luminance[middle] : (luminance[middle - 1] + luminance[middle]) / 2;
}

std::string doubt_by(const LuminanceOf& luminance_of_one, const Material& material, const Dataset& dataset) {
  if (!dataset.doubtful.empty()) return dataset.doubtful;
  const auto median = median_by(luminance_of_one, material, dataset);
  const auto own = median ? luminance_of_one(dataset) : std::nullopt;
  if (!own) return {};
  const double off = *own - *median;
  if (std::abs(off) <= doubtful_distance) return {};
  return "F0 luminance " + number(*own, 3) + " is " + number(std::abs(off), 3) +
         (off < 0 ? " below" : " above") + " the median of the other datasets, " + number(*median, 3);
}

}  // namespace

std::vector<std::string> doubts(const Material& material,
                                const std::function<F0Result(const Dataset&)>& reference_f0) {
  const LuminanceOf luminance = [&](const Dataset& dataset) { return luminance_in(reference_f0(dataset)); };
  std::vector<std::string> out;
  for (const Dataset& dataset : material.datasets) out.push_back(doubt_by(luminance, material, dataset));
  return out;
}

std::optional<double> median_of_others(const Material& material, const Dataset& dataset) {
  return median_by(luminance_of, material, dataset);
}

std::string doubt(const Material& material, const Dataset& dataset) {
  return doubt_by(luminance_of, material, dataset);
}

Flags quality_flags(const Material& material, const Dataset& dataset) {
  Flags flags;
  // A stack is computed, but its media were measured.
  if (dataset.origin == Origin::computed && !std::holds_alternative<Stack>(dataset.optics))
    flags.set(Flag::computed);
  if (is_sparse(dataset.optics)) flags.set(Flag::sparse);
  if (!doubt(material, dataset).empty()) flags.set(Flag::doubtful);
  return flags;
}

F0Result solve(const F0Solver& solver, const Material& material, const Dataset& dataset, F0Timing* timing) {
  Flags flags = quality_flags(material, dataset);
  flags |= dataset.flags;
  F0Result result = solver.solve(dataset.optics, flags, timing);
  if (!gives_f0(material.material_class)) drop_zone(result);
  return result;
}

std::optional<AxisAverage> average_over_axes(const F0Solver& solver, const Material& material,
                                             const Dataset& dataset) {
  const std::vector<AxisDataset> axes = axis_datasets(material, dataset);
  if (axes.empty()) return std::nullopt;
  AxisAverage out;
  std::vector<F0Solver::Part> parts;
  Flags flags;
  for (const AxisDataset& axis : axes) {
    if (axis.dataset == nullptr) {
      out.result.refusal = "no average over axes: " + material.id + " lacks another axis of " + dataset.id;
      out.result.flags = dataset.flags;
      return out;
    }
    parts.push_back({&axis.dataset->optics, axis.weight});
    flags |= axis.dataset->flags;
    flags |= quality_flags(material, *axis.dataset);
    if (out.doubt.empty()) out.doubt = doubt(material, *axis.dataset);
    out.datasets += (out.datasets.empty() ? "" : " + ") + axis.dataset->id;
  }
  out.result = solver.solve(parts, flags);
  return out;
}

F0Result solve_averaged(bool averaged, const F0Solver& solver, const Material& material,
                        const Dataset& dataset) {
  if (averaged)
    if (auto average = average_over_axes(solver, material, dataset)) return std::move(average->result);
  return solve(solver, material, dataset);
}

void drop_zone(F0Result& result) {
  result.zone.reset();
  result.channel_in_zone = {};
  result.flags.clear(Flag::channel_in_zone);
}

std::string quality_text(Origin origin, Flags flags) {
  std::string out(name(origin));
  for (const Flag flag : {Flag::sparse, Flag::doubtful})
    if (flags.has(flag)) out.append("; ").append(name(flag));
  return out;
}

}  // namespace etak
