// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

namespace etak::math {

/// A number as the sum of two doubles, about 106 bits. `low` is at most half a unit of the last place of `high`, where a function
/// does not say otherwise.
struct Pair {
  double high = 0, low = 0;
};

/// The exact sum: of any two (Knuth 1969, TAOCP 2, 4.2.2), and of two of which the first is the larger or 0 (Dekker 1971).
constexpr Pair two_sum(double a, double b) {
  const double sum = a + b, of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}
constexpr Pair quick_sum(double large, double small) {
  const double sum = large + small;
  return {sum, (large - sum) + small};
}

/// x without its last bits, so that products of what is left are exact.
constexpr double without_bits(double x, int bits) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~std::uint64_t{0} << bits);
}

/// The product to 2^-104 of it, where nothing overflows or gets subnormal (after Dekker 1971).
constexpr Pair two_product(double a, double b) {
  const double p = a * b, ah = without_bits(a, 27), al = a - ah, bh = without_bits(b, 27), bl = b - bh;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

constexpr Pair operator+(Pair a, Pair b) {
  const Pair sum = two_sum(a.high, b.high), rest = two_sum(a.low, b.low);
  const Pair part = quick_sum(sum.high, sum.low + rest.high);
  return quick_sum(part.high, part.low + rest.low);
}
constexpr Pair operator*(Pair a, Pair b) {
  const Pair p = two_product(a.high, b.high);
  return quick_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}
constexpr Pair operator/(Pair a, double b) {
  const double q = a.high / b;
  const Pair back = two_product(q, b);
  return quick_sum(q, ((a.high - back.high) - back.low + a.low) / b);
}
constexpr Pair operator-(Pair a) {
  return {-a.high, -a.low};
}

// Added to a number below 2^51, it rounds to a whole one and leaves that in the low bits.
constexpr double to_whole = 0x1.8p52;

constexpr Pair ln_2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
constexpr Pair half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

}  // namespace etak::math
