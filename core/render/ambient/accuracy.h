// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace etak {

/// How far the light of an environment is off from the integral of the model itself, in CIEDE2000 with the brightest pixel
/// white: a ball of gold, osmium and water in etak's five environments (tests/bench/ambient_errors.cpp writes
/// resources/ambient_errors.csv).
///   mean     over all of these pictures
///   picture  the mean of the worst of them
///   p99      the largest 99th percentile of the pixels of one of them
struct AmbientAccuracy {
  double mean, picture, p99;
  friend bool operator==(const AmbientAccuracy&, const AmbientAccuracy&) = default;
};

/// The glosses that were measured.
inline constexpr std::array measured_glosses{0.2, 0.5, 0.8, 1.0};

/// The error of the moving or of the refined picture (Scene::refined), linear between the measured glosses; nullopt for
/// a model that is not in the table, such as one of three terms.
std::optional<AmbientAccuracy> ambient_accuracy(std::string_view model, double gloss, bool refined);

/// "mean dE2000 0.7 (worst picture 2.1), 1 % of its pixels above 9"; empty for a model that is not in the table.
std::string ambient_accuracy_text(std::string_view model, double gloss, bool refined);

}  // namespace etak
