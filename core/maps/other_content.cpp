// SPDX-License-Identifier: Apache-2.0
#include "core/maps/other_content.h"

#include <array>
#include <cmath>

#include "core/maps/normals.h"

namespace etak {

namespace {

double mean(double sum, std::uint64_t count) {
  return sum / static_cast<double>(count);
}

double variance(double of_squares, double of_values, std::uint64_t count) {
  const double middle = mean(of_values, count);
  return std::max(0.0, mean(of_squares, count) - middle * middle);
}

}  // namespace

void NormalSums::add(const std::uint8_t* rgb) {
  std::array<double, 3> v{};
  for (std::size_t c = 0; c < v.size(); ++c) v[c] = (2.0 * rgb[c] - 255) / 255;
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  unit += std::abs(length - 1) <= normal_tolerance && rgb[2] >= least_upward_code;
  leaning.add(v[0], v[1]);
  lengths.add(length, v[2]);
}

double NormalSums::unit_share() const {
  return leaning.count == 0 ? 0 : static_cast<double>(unit) / static_cast<double>(leaning.count);
}

bool are_normals(const NormalSums& sums) {
  constexpr double least_spread = 1.5 / 127.5, most_of_spread = 1 / 3.0, least_up = 0.5,
                   least_unit_share = 0.8;
  const std::uint64_t count = sums.leaning.count;
  const PairSums &leaning = sums.leaning, &lengths = sums.lengths;
  if (sums.unit_share() < least_unit_share || mean(lengths.y, count) < least_up) return false;
  const double spread =
      std::sqrt(variance(leaning.xx, leaning.x, count) + variance(leaning.yy, leaning.y, count));
  const double lean = std::max(std::abs(mean(leaning.x, count)), std::abs(mean(leaning.y, count)));
  return spread >= least_spread && lean <= spread &&
         std::sqrt(variance(lengths.xx, lengths.x, count)) <= most_of_spread * spread;
}

}  // namespace etak
