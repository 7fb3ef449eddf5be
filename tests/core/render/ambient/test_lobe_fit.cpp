// SPDX-License-Identifier: Apache-2.0
#include "core/render/ambient/lobe_fit.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/color/gloss.h"
#include "core/render/ambient/round_lobe.h"

namespace etak {
namespace {

using std::numbers::pi;

// A round lobe whose axis lies `angle` from the normal in the plane of normal and viewer.
void add_lobe(double level, double angle, double share, std::vector<LobeSample>& out) {
  const double e = exponent_of_gloss(gloss_of_level(level));
  double total = 0;
  const std::size_t first = out.size();
  for (int i = 0; i < 120; ++i)
    for (int j = 0; j < 32; ++j) {
      const double t = (i + 0.5) / 120, away = pi / 2 * t * t, around = 2 * pi * (j + 0.5) / 32;
      const double x = std::sin(away) * std::cos(around), y = std::sin(away) * std::sin(around),
                   z = std::cos(away);
      const double weight = round_lobe(e, z) * std::sin(away) * t;
      total += weight;
      out.push_back({float(x * std::cos(angle) + z * std::sin(angle)), float(y),
                     float(z * std::cos(angle) - x * std::sin(angle)), float(weight)});
    }
  for (std::size_t i = first; i < out.size(); ++i) out[i].weight *= float(share / total);
}

double mean_of(const Probes& probes, double Probe::*member) {
  double out = 0;
  for (const Probe& each : probes) out += each.share * each.*member;
  return out;
}

}  // namespace

TEST_CASE("a round lobe is found as itself: its axis and its level") {
  for (const double level : {1.0, 4.0, 6.0})
    for (const double angle : {0.0, 0.4, 0.9}) {
      std::vector<LobeSample> samples;
      add_lobe(level, angle, 1, samples);
      const Probes found = fitted_probes(samples, nullptr, 0, 0);
      CAPTURE(level, angle);
      CHECK(mean_of(found, &Probe::angle) == Approx(angle).margin(0.03));
      CHECK(mean_of(found, &Probe::level) == Approx(level).margin(0.4));
      double shares = 0;
      for (const Probe& each : found) shares += each.share;
      CHECK(shares == Approx(1));
    }
}

TEST_CASE("a narrow lobe within a wide one is found as two levels, not as one between them") {
  std::vector<LobeSample> samples;
  add_lobe(1, 0.2, 0.6, samples);
  add_lobe(6, 0.2, 0.4, samples);
  const Probes found = fitted_probes(samples, nullptr, 0, 0);
  double narrow = 8, wide = 0;
  for (const Probe& each : found) {
    narrow = std::min(narrow, each.level);
    wide = std::max(wide, each.level);
  }
  CHECK(narrow == Approx(1).margin(0.5));
  CHECK(wide == Approx(6).margin(0.7));
}

TEST_CASE("a lobe without light stays where the viewer is mirrored") {
  const Probes found = fitted_probes({}, nullptr, 0.7, 0);
  for (const Probe& each : found) CHECK(each.angle == 0.7);
}

}  // namespace etak
