// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/material/f0.h"
#include "core/material/material.h"

namespace etak {

/// How far the luminance of F0 may lie from the median of the other datasets before it is doubtful.
inline constexpr double doubtful_distance = 0.1;

/// Median luminance of F0 over the other accepted datasets of the material, by the reference policy (vacuum,
/// D65, CIE 1931 2-degree, 1 nm). Accepted is what is not refused, not named doubtful in its file, not
/// computed (theory is no witness against a measurement), and of the same axis as `dataset`.
///   returns nothing where fewer than two others are accepted, and for a material that gives no F0
std::optional<double> median_of_others(const Material& material, const Dataset& dataset);

/// Why the dataset is doubtful: the reason in its file, else "F0 luminance 0.406 is 0.166 below the median of
/// the other datasets, 0.572". Empty: it is not.
std::string doubt(const Material& material, const Dataset& dataset);

/// The same for each dataset of the material.
///   reference_f0   F0 of one, by F0Solver{F0Options{}}: it is asked again and again, so that the caller keeps the answers
std::vector<std::string> doubts(const Material& material,
                                const std::function<F0Result(const Dataset&)>& reference_f0);

/// Flag::computed, Flag::sparse and Flag::doubtful, as far as they hold.
///   dataset   of `material`
Flags quality_flags(const Material& material, const Dataset& dataset);

/// F0 of one dataset of a material: F0Solver::solve() with the flags of its quality. The colour of a surface
/// has no zone and no channel in it.
///   timing   as F0Solver::solve() takes it
F0Result solve(const F0Solver& solver, const Material& material, const Dataset& dataset,
               F0Timing* timing = nullptr);

/// F0 of a crystal whose grains lie every way: the average over its optical axes.
///   datasets   ids of those averaged, with " + " between
///   doubt      that of the first doubtful one; empty: none
struct AxisAverage {
  F0Result result;
  std::string datasets, doubt;
};

/// The average over the axes of the crystal that `dataset` describes one axis of; refused where the material
/// lacks another axis. Nothing for a dataset without axis.
std::optional<AxisAverage> average_over_axes(const F0Solver& solver, const Material& material,
                                             const Dataset& dataset);

/// The result of average_over_axes() where `averaged`, else or where there is none that of solve().
F0Result solve_averaged(bool averaged, const F0Solver& solver, const Material& material,
                        const Dataset& dataset);

/// Takes the zone out of a result: the colour of a surface lies in none.
void drop_zone(F0Result& result);

/// The kind of a dataset and what makes it doubtful, in few words: "measured", "computed; sparse; doubtful".
///   flags   those of a result or of quality_flags(); only sparse and doubtful are looked at
std::string quality_text(Origin origin, Flags flags);

}  // namespace etak
