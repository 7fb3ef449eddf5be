// SPDX-License-Identifier: Apache-2.0
// Sine, cosine and tangent, their inverses, and lengths. Based on
//   Gal and Bachelis 1991, "An accurate elementary mathematical library for the IEEE floating point standard": sums of angles
//     over a table
//   Payne and Hanek 1983, "Radian reduction for trigonometric functions"
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/math/functions.h"
#include "core/math/pair.h"

namespace etak::math {

namespace {

constexpr double no_angle = std::numeric_limits<double>::quiet_NaN();
constexpr double per_radian = 64;  // of the tables in a radian

// Sine and cosine of i / 64, up to pi / 4, each turned on from the one before.
using Turn = std::array<Pair, 2>;
constexpr std::array<Turn, 52> make_turns() {
  constexpr double x2 = 1 / per_radian / per_radian;
  Pair sine{}, cosine{};
  for (int n = 19; n > 0; n -= 2) {  // Taylor's series from its end
    sine = Pair{1} + -(sine * Pair{x2} / ((n + 1) * (n + 2)));
    cosine = Pair{1} + -(cosine * Pair{x2} / (n * (n + 1)));
  }
  sine = sine / per_radian;
  std::array<Turn, 52> out{};
  out[0] = {Pair{}, Pair{1}};
  for (std::size_t i = 1; i < out.size(); ++i) {
    const auto& [s, c] = out[i - 1];
    out[i] = {s * cosine + c * sine, c * cosine + -(s * sine)};
  }
  return out;
}
constexpr std::array<Turn, 52> turns = make_turns();

// atan(i / 64) up to 1, as the sum of atan(64 / (4096 + i (i - 1))).
constexpr std::array<Pair, 65> make_arcs() {
  std::array<Pair, 65> out{};
  for (std::size_t i = 1; i < out.size(); ++i) {
    const Pair x = Pair{per_radian} / (per_radian * per_radian + static_cast<double>(i * (i - 1))),
               x2 = x * x;
    Pair sum{};
    for (int n = 19; n > 0; n -= 2) sum = Pair{1} / n + -(sum * x2);
    out[i] = out[i - 1] + x * sum;
  }
  return out;
}
constexpr std::array<Pair, 65> arcs = make_arcs();

// An angle within pi / 4 and the quarter turns before it.
struct Reduced {
  double high, low;
  int quarters;
};

// The bits of 2 / pi behind the point.
constexpr std::array<std::uint32_t, 38> two_over_pi{
    0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab, 0xdebbc561,
    0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
    0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f,
    0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b,
    0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab};

// Of a positive, finite x of at least 2^19: the digits of x * 2 / pi from 2 before the point to some 190 behind it, as whole numbers. Words
// of 2 / pi whose products are multiples of 4 are left out.
Reduced long_reduced(double x) {
  constexpr std::size_t taken = 7;
  int exponent = 0;
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  exponent -= 53;
  const std::size_t first = exponent < 34 ? 0 : static_cast<std::size_t>(exponent - 2) / 32;
  std::array<std::uint64_t, taken + 5> words{};  // of 32 bits, the lowest first
  for (std::size_t half = 0; half < 2; ++half) {
    const std::uint64_t factor = half == 0 ? mantissa & 0xffffffff : mantissa >> 32;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < taken; ++i) {
      const std::uint64_t sum = factor * two_over_pi[first + taken - 1 - i] + words[i + half] + carry;
      words[i + half] = sum & 0xffffffff;
      carry = sum >> 32;
    }
    words[taken + half] += carry;
  }
  const auto point = static_cast<std::size_t>(32 * static_cast<int>(first + taken) - exponent);
  const auto digits = [&](std::size_t from) {  // 32 of them
    const std::size_t word = from / 32;
    return ((words[word + 1] << 32 | words[word]) >> from % 32) & 0xffffffff;
  };
  const auto quarters = static_cast<int>(digits(point) & 3);
  const std::uint64_t top = digits(point - 32);
  const bool up = top >> 31 != 0;  // to the nearest
  Pair part{static_cast<double>(top) - (up ? 0x1p32 : 0)};
  double scale = 1;
  for (std::size_t i = 2; i < 6; ++i) {
    scale *= 0x1p-32;
    part = part + Pair{static_cast<double>(digits(point - 32 * i)) * scale};
  }
  part = Pair{part.high * 0x1p-32, part.low * 0x1p-32} * half_pi;
  return {part.high, part.low, quarters + (up ? 1 : 0)};
}

// Of a finite x. The constants are pi / 2 in pieces of 33 bits, whose products with a whole number are exact (Cody and Waite 1980).
inline Reduced reduced(double x) {
  const double size = std::abs(x);
  if (size <= 0x1.921fb54442d18p-1) return {x, 0, 0};
  if (size >= 0x1p19) {
    const Reduced out = long_reduced(size);
    return x < 0 ? Reduced{-out.high, -out.low, -out.quarters} : out;
  }
  const double whole = (x * 0x1.45f306dc9c883p-1 + to_whole) - to_whole;
  const Pair part = two_sum(x - whole * 0x1.921fb54400000p+0, -(whole * 0x1.0b4611a600000p-34));
  Pair out = quick_sum(part.high, part.low - whole * 0x1.3198a2e037073p-69);
  if (std::abs(out.high) <= 0x1p-20) {  // next to a quarter turn more digits are left
    const Pair next = two_sum(part.high, -(whole * 0x1.3198a2e000000p-69));
    out = quick_sum(next.high, next.low + (part.low - whole * 0x1.b839a252049c1p-104));
  }
  return {out.high, out.low, static_cast<int>(whole)};
}

// x, or -x where `flip` has its highest bit.
inline double flipped(double x, std::uint64_t flip) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ (flip & std::uint64_t{1} << 63));
}

// The sine of the angle as a sum whose second part is small: below 1/4 by its series, else as that of i / 64 plus the rest. There
// are no branches for quarters, which no processor can foresee.
inline Pair sine_of(const Reduced& angle) {
  const auto quarters = static_cast<std::uint64_t>(angle.quarters), flip = quarters << 62;
  const std::size_t odd = quarters & 1;
  const double h = angle.high, size = std::abs(h);
  if (odd == 0 && size < 0.25) {
    const double h2 = h * h;
    const double rest =
        (-1.0 / 6 + h2 * (1.0 / 120)) +
        h2 * h2 *
            ((-1.0 / 5040 + h2 * (1.0 / 362880)) + h2 * h2 * (-1.0 / 39916800 + h2 * (1.0 / 6227020800)));
    return {flipped(h, flip), flipped(angle.low + h * h2 * rest, flip)};
  }
  const std::uint64_t side = std::bit_cast<std::uint64_t>(h);
  const double shifted = size * per_radian + to_whole;
  const Turn& turn = turns[std::bit_cast<std::uint64_t>(shifted) & 63];
  const double b = (size - (shifted - to_whole) * (1 / per_radian)) + flipped(angle.low, side), b2 = b * b;
  const double sine = b + b * b2 * ((-1.0 / 6 + b2 * (1.0 / 120)) - b2 * b2 * (1.0 / 5040));
  const double cosine = b2 * ((-0.5 + b2 * (1.0 / 24)) - b2 * b2 * (1.0 / 720));  // - 1
  const Pair at = turn[odd];
  const double rest = at.low + (at.high * cosine + flipped(turn[1 - odd].high, quarters << 63) * sine);
  const std::uint64_t sign = flip ^ (odd == 0 ? side : 0);
  return {flipped(at.high, sign), flipped(rest, sign)};
}

// The angle of the direction (x, y) where 0 <= y <= x, x > 0; as a sum whose second part is small.
Pair first_octant(Pair y, Pair x) {
  const double t = y.high / x.high, shifted = t * per_radian + to_whole;
  const auto i = std::bit_cast<std::uint64_t>(shifted) & 127;
  if (i < 8) {
    const Pair back = two_product(t, x.high);
    const double t2 = t * t, low = ((y.high - back.high) - back.low + (y.low - t * x.low)) / x.high;
    double sum = 0;
    for (int n = 19; n > 1; n -= 2) sum = 1.0 / n - sum * t2;
    return {t, (t > 0x1p-30 ? low : 0) - t * t2 * sum};
  }
  const double c = static_cast<double>(i) / per_radian, x_high = without_bits(x.high, 21);
  const double above = ((y.high - c * x_high) - c * (x.high - x_high)) + (y.low - c * x.low);
  const double b = above / (x.high + c * y.high), b2 = b * b;
  return {arcs[i].high, arcs[i].low + (b + b * b2 * (-1.0 / 3 + b2 * (0.2 - b2 * (1.0 / 7))))};
}

// The angle of (x, y) in [0, pi], where y is not below 0 and neither is huge or tiny.
double angle_of(Pair y, Pair x, bool x_is_negative) {
  const bool swapped = y.high > x.high;
  Pair angle = swapped ? first_octant(x, y) : first_octant(y, x);
  const auto from = [&angle](Pair whole) {
    const Pair rest = two_sum(whole.high, -angle.high);
    angle = {rest.high, rest.low + (whole.low - angle.low)};
  };
  if (swapped) from(half_pi);
  if (x_is_negative) from({2 * half_pi.high, 2 * half_pi.low});
  return angle.high + angle.low;
}

// sqrt(1 - x^2) as a pair, for 0 <= x <= 1.
Pair across(double x) {
  const Pair product = two_product(x, x), rest = quick_sum(1, -product.high);
  const Pair square = quick_sum(rest.high, rest.low - product.low);
  const double root = std::sqrt(square.high);
  if (root == 0) return {};
  const Pair back = two_product(root, root);
  return {root, ((square.high - back.high) - back.low + square.low) / (2 * root)};
}

}  // namespace

double sin(double x) {
  if (!std::isfinite(x)) return x - x;
  if (x == 0) return x;
  const Pair out = sine_of(reduced(x));
  return out.high + out.low;
}

double cos(double x) {
  if (!std::isfinite(x)) return x - x;
  Reduced angle = reduced(x);
  ++angle.quarters;
  const Pair out = sine_of(angle);
  return out.high + out.low;
}

double tan(double x) {
  if (!std::isfinite(x)) return x - x;
  if (std::abs(x) < 0x1p-30) return x;
  Reduced angle = reduced(x);
  const Pair sine = sine_of(angle);
  ++angle.quarters;
  const Pair cosine = sine_of(angle), y = quick_sum(sine.high, sine.low),
             z = quick_sum(cosine.high, cosine.low);
  const double q = y.high / z.high;
  const Pair back = two_product(q, z.high);
  return q + (((y.high - back.high) - back.low) + (y.low - q * z.low)) / z.high;
}

double asin(double x) {
  const double size = std::abs(x);
  if (!(size <= 1)) return std::isnan(x) ? x : no_angle;
  return size < 0x1p-30 ? x : std::copysign(angle_of({size}, across(size), false), x);
}

double acos(double x) {
  const double size = std::abs(x);
  if (!(size <= 1)) return std::isnan(x) ? x : no_angle;
  return angle_of(across(size), {size}, x < 0);
}

double atan(double x) {
  return atan2(x, 1);
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return x + y;
  double up = std::abs(y), right = std::abs(x);
  const bool back = std::signbit(x);
  double angle = 0;
  if (up == 0) {
    angle = back ? 2 * half_pi.high : 0;
  } else if (std::isinf(up) || std::isinf(right)) {
    const auto one_of = [](double v) { return std::isinf(v) ? 1.0 : 0.0; };
    angle = angle_of({one_of(up)}, {one_of(right)}, back);
  } else {
    const double larger = up > right ? up : right;
    const double scale = larger > 0x1p900 ? 0x1p-200 : larger < 0x1p-700 ? 0x1p300 : 1;
    angle = angle_of({up * scale}, {right * scale}, back);
  }
  return std::copysign(angle, y);
}

double hypot(double x, double y) {
  double large = std::abs(x), small = std::abs(y);
  if (std::isinf(large) || std::isinf(small)) return std::numeric_limits<double>::infinity();
  if (!(large >= small)) std::swap(large, small);
  if (!(large < 0x1p500) || small < 0x1p-450) {  // rare
    if (!(large + small >= 0) || small == 0) return large + small;
    if (large > 0x1p500) return 0x1p600 * hypot(large * 0x1p-600, small * 0x1p-600);
    if (small < large * 0x1p-60) return large + small;
    return 0x1p-600 * hypot(large * 0x1p600, small * 0x1p600);
  }
  const Pair a = two_product(large, large), b = two_product(small, small), sum = quick_sum(a.high, b.high);
  const double root = std::sqrt(sum.high);
  const Pair back = two_product(root, root);
  return root + ((sum.high - back.high) - back.low + (sum.low + (a.low + b.low))) / (2 * root);
}

double hypot(double x, double y, double z) {
  const double square = x * x + y * y + z * z;
  if (square > 0x1p-900 && square < 0x1p1000) return std::sqrt(square);
  return hypot(hypot(x, y), z);
}

float sin(float x) {
  return static_cast<float>(sin(double{x}));
}

float cos(float x) {
  return static_cast<float>(cos(double{x}));
}

float atan(float x) {
  return static_cast<float>(atan(double{x}));
}

float atan2(float y, float x) {
  return static_cast<float>(atan2(double{y}, double{x}));
}

}  // namespace etak::math
