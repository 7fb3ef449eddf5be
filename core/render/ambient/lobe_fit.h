// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace etak {

/// How many round lobes stand for the lobe of a model.
inline constexpr std::size_t probe_count = 2;

/// A round lobe that stands for a part of a model's lobe.
///   angle   of its axis from the normal, in the plane of normal and viewer, radians; above 0 on the side of the
///           mirrored viewer
///   level   its width: see round_lobe.h
///   share   of the light
struct Probe {
  double angle = 0, level = 0, share = 0;
};
using Probes = std::array<Probe, probe_count>;

/// A direction that a surface reflects light from: along the tangent that points to the mirrored viewer, across the
/// plane of normal and viewer, and along the normal; and how much of it.
struct LobeSample {
  float along, across, up, weight;
};

/// The round lobes that are closest to the lobe that `samples` have: by least squares in the share of light beyond
/// planes, along the plane of normal and viewer and across it, at angles from the lobe's middle that grow by a factor,
/// because surroundings have edges of all sizes.
///   before     of a view nearby: where the search begins, so that what the samples do not decide stays; null: none
///   angle      of the mirrored viewer from the normal, radians, where no sample has a weight
///   sharpest   least level. A stretched lobe is as narrow across as a sharper round one, which alone would show a ghost
Probes fitted_probes(std::span<const LobeSample> samples, const Probes* before, double angle,
                     double sharpest);

}  // namespace etak
