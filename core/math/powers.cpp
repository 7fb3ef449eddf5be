// SPDX-License-Identifier: Apache-2.0
// Exponentials, logarithms, powers and what is made of them. Based on
//   Tang 1989, "Table-driven implementation of the exponential function in IEEE floating-point arithmetic"
//   Tang 1990, "Table-driven implementation of the logarithm function in IEEE floating-point arithmetic"
#include <array>
#include <cmath>
#include <limits>

#include "core/math/functions.h"
#include "core/math/pair.h"

namespace etak::math {

namespace {

using Bits = std::uint64_t;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

constexpr int per_octave = 128;  // of both tables in an octave

// 2^(i / 128) as (1 + low) high, so that a result near `high` keeps what `high` lacks.
constexpr std::array<Pair, per_octave> make_powers() {
  const Pair x = ln_2 / per_octave;
  Pair root{1}, now{1};
  for (int n = 12; n > 0; --n) root = Pair{1} + root * x / n;
  std::array<Pair, per_octave> out{};
  for (Pair& each : out) {
    each = {now.high, now.low / now.high};
    now = now * root;
  }
  return out;
}
constexpr std::array<Pair, per_octave> powers = make_powers();

// Octaves begin at the bits `first_bits`, about 0.695, so that 1 is the middle of an interval. A number z of an interval is near
// 1 / inverse, where `inverse` has 13 bits; minus its logarithm is high + low, where `high` is a multiple of 2^-42.
constexpr Bits first_bits = 0x3fe6500000000000;
struct Interval {
  double inverse, high, low;
};
constexpr std::array<Interval, per_octave> make_intervals() {
  std::array<Interval, per_octave> out{};
  for (std::size_t i = 0; i < per_octave; ++i) {
    const double middle = std::bit_cast<double>(first_bits + (Bits{i} << 45) + (Bits{1} << 44));
    const double inverse = (4096 / middle + to_whole - to_whole) / 4096;
    // -log(inverse) = 2 artanh(x), x = (1 - inverse) / (1 + inverse)
    const Pair x = Pair{1 - inverse} / (1 + inverse), x2 = x * x;
    Pair sum{};
    for (int n = 43; n > 0; n -= 2) sum = Pair{1} / n + sum * x2;
    const Pair log = Pair{2} * x * sum;
    const double high = log.high + 0x1.8p10 - 0x1.8p10;
    out[i] = {inverse, high, (log.high - high) + log.low};
  }
  return out;
}
constexpr std::array<Interval, per_octave> intervals = make_intervals();

// 2^(k / 128) e^(r + low) where r is at most 2^-8, and the same but for 2^(k / 128) over it.
inline double exp_rest(double r, double low) {
  const double r2 = r * r;
  return low + r + r2 * (0.5 + r * (1.0 / 6)) + r2 * r2 * (1.0 / 24 + r * (1.0 / 120));
}
inline double exp_near(int k, double r, double low) {
  const Pair& power = powers[static_cast<std::size_t>(k & (per_octave - 1))];
  const double more = exp_rest(r, power.low + low);
  const int octave = k >> 7;
  if (octave < -1021 || octave > 1022) return std::ldexp(power.high + power.high * more, octave);
  const double scale =
      std::bit_cast<double>(std::bit_cast<Bits>(power.high) + (static_cast<Bits>(octave) << 52));
  return scale + scale * more;
}

// x as k ln(2) / 128 + r, for x within +-746.
struct Split {
  int k;
  double r;
};
inline Split split(double x, double low = 0) {
  const double shifted = x * 0x1.71547652b82fep+7 + to_whole, whole = shifted - to_whole;
  return {static_cast<std::int32_t>(std::bit_cast<Bits>(shifted)),
          (x - whole * 0x1.62e42fef80000p-8) - (whole * 0x1.1cf79abc9e3b4p-43 - low)};
}

// e^(x + low), `low` below 2^-40.
inline double exp_of(double x, double low) {
  const Split in = split(x, low);
  return exp_near(in.k, in.r, 0);
}

// The logarithm of 2^k z, where `bits` are those of a normal z, and its r is z * inverse - 1 to the last bit.
struct NearOne {
  double r, r_low;  // log(1 + r + r_low) is to be added to sum + low
  double sum, low;
};
inline NearOne near_one(Bits bits, double k) {
  const Bits from = bits - first_bits;
  const Interval& interval = intervals[from >> 45 & (per_octave - 1)];
  k += static_cast<double>(static_cast<std::int64_t>(from) >> 52);
  const double z = std::bit_cast<double>(bits - (from & Bits{0xfff} << 52)), z_high = without_bits(z, 21);
  const Pair r = quick_sum(z_high * interval.inverse - 1, (z - z_high) * interval.inverse);
  return {r.high, r.low, k * 0x1.62e42fefa3800p-1 + interval.high, k * 0x1.ef35793c76730p-45 + interval.low};
}

// The series of log(1 + r) behind r - r^2 / 2, by r^3; r is at most 2^-8.
inline double log_rest(double r) {
  const double r2 = r * r;
  return (1.0 / 3 - r * 0.25) + r2 * ((0.2 - r * (1.0 / 6)) + r2 * ((1.0 / 7 - r * 0.125) + r2 * (1.0 / 9)));
}

inline double log_of(Bits bits, double k) {
  const NearOne x = near_one(bits, k);
  const double r2 = x.r * x.r;
  const Pair sum = quick_sum(x.sum, x.r);
  return sum.high + ((sum.low + x.low + x.r_low) + (r2 * -0.5 + r2 * x.r * log_rest(x.r)));
}

// The same plus `more` as a pair, of about 68 bits.
inline Pair log_pair(Bits bits, double k, double more = 0) {
  const NearOne x = near_one(bits, k);
  const double r = x.r, high = without_bits(r, 27), square = -0.5 * high * high;
  const Pair sum = quick_sum(x.sum, r), sum2 = quick_sum(sum.high, square);
  const double low = (sum.low + x.low + more) + (x.r_low - x.r_low * r) - 0.5 * ((r - high) * (r + high));
  return quick_sum(sum2.high, sum2.low + low + r * r * r * log_rest(r));
}

// What the logarithms take: the bits of a positive, normal number and the octaves that belong to it. Others have `value`.
struct Positive {
  Bits bits;
  double octaves;
  bool has_value;
  double value;
};
inline Positive positive(double x) {
  const Bits bits = std::bit_cast<Bits>(x);
  if (bits - 0x0010000000000000 < 0x7fe0000000000000) return {bits, 0, false, 0};
  if (x == 0) return {0, 0, true, -infinity};
  if (!(x > 0)) return {0, 0, true, std::isnan(x) ? x : no_number};
  if (x == infinity) return {0, 0, true, x};
  return {std::bit_cast<Bits>(x * 0x1p54), -54, false, 0};
}

// log(x) times a constant, of which `high` has 26 bits.
inline double log_by(double x, Pair constant) {
  const Positive in = positive(x);
  if (in.has_value) return in.value;
  const NearOne near = near_one(in.bits, in.octaves);
  const double r2 = near.r * near.r;
  const Pair sum = quick_sum(near.sum, near.r);
  const double high = without_bits(sum.high, 27);
  const double low =
      (sum.high - high) + ((sum.low + near.low + near.r_low) + (r2 * -0.5 + r2 * near.r * log_rest(near.r)));
  return high * constant.high + (high * constant.low + low * (constant.high + constant.low));
}

bool is_whole(double y) {
  return std::floor(y) == y;
}
bool is_odd(double y) {
  return std::abs(y) < 0x1p53 && is_whole(y) && !is_whole(y / 2);
}

// Powers whose x is no positive, normal number or whose y is 0, tiny, huge or no number.
double rare_pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (std::isnan(x) || std::isnan(y)) return x + y;
  const double size = std::abs(x);
  if (std::isinf(y)) return size == 1 ? 1 : (size > 1) == (y > 0) ? infinity : 0;
  const double sign = x < 0 || (x == 0 && std::signbit(x)) ? (is_odd(y) ? -1 : 1) : 1;
  if (x == 0 || std::isinf(x)) return sign * ((x == 0) == (y > 0) ? 0 : infinity);
  if (x < 0) return is_whole(y) ? sign * pow(size, y) : no_number;
  if (std::abs(y) < 0x1p-65) return 1;
  if (std::abs(y) > 0x1p65) return size == 1 ? 1 : (size > 1) == (y > 0) ? infinity : 0;
  const Positive in = positive(x);
  const Pair log = log_pair(in.bits, in.octaves), power = two_product(y, log.high);
  if (!(std::abs(power.high) < 746)) return power.high > 0 ? infinity : 0;
  return exp_of(power.high, power.low + y * log.low);
}

constexpr Pair erf_slope{0x1.20dd750429b6dp+0, 0x1.1ae3a914fed80p-56};  // at 0: 2 / sqrt(pi)

// The coefficients of x^3, x^5, ... in erf.
constexpr std::array<double, 13> make_erf_series() {
  std::array<double, 13> out{};
  double factor = erf_slope.high;
  for (std::size_t n = 1; n <= out.size(); ++n) {
    factor /= -static_cast<double>(n);
    out[n - 1] = factor / static_cast<double>(2 * n + 1);
  }
  return out;
}
constexpr std::array<double, 13> erf_series = make_erf_series();

// erf about i / 16: the value, and the coefficients of its series in b, of which |b| is at most 1/32. With f the derivative, f' = -2 (a + b)
// f gives these one after the other.
struct ErfNode {
  Pair value;
  std::array<double, 12> series;
};
constexpr std::size_t erf_nodes = 96;
constexpr std::array<ErfNode, erf_nodes + 1> make_erf_nodes() {
  std::array<ErfNode, erf_nodes + 1> out{};
  constexpr double step = 1.0 / 16;
  Pair value{}, slope = erf_slope;
  for (std::size_t i = 0; i <= erf_nodes; ++i) {
    const double a = static_cast<double>(i) * step;
    Pair term = slope, before{}, value_sum = value, slope_sum{};
    out[i].value = value;
    double power = 1;
    for (int n = 0; n < 24; ++n) {
      if (n < 12) out[i].series[static_cast<std::size_t>(n)] = term.high / (n + 1);
      slope_sum = slope_sum + term * Pair{power};
      power *= step;
      value_sum = value_sum + term * Pair{power} / (n + 1);
      const Pair next = -(Pair{2 * a} * term + Pair{2} * before) / (n + 1);
      before = term;
      term = next;
    }
    value = value_sum;
    slope = slope_sum;
  }
  return out;
}
constexpr std::array<ErfNode, erf_nodes + 1> erf_table = make_erf_nodes();

}  // namespace

double exp(double x) {
  if (std::abs(x) < 746) return exp_of(x, 0);
  return std::isnan(x) ? x : x > 0 ? infinity : 0;
}

double exp2(double x) {
  if (!(std::abs(x) < 1076)) return std::isnan(x) ? x : x > 0 ? infinity : 0;
  const double shifted = x * per_octave + to_whole, rest = x - (shifted - to_whole) / per_octave;
  return exp_near(static_cast<std::int32_t>(std::bit_cast<Bits>(shifted)), rest * ln_2.high, rest * ln_2.low);
}

double expm1(double x) {
  if (!(std::abs(x) < 708)) return x < 0 ? -1 : exp(x);
  if (std::abs(x) < 0x1p-4) {
    if (x == 0) return x;
    double sum = 1;
    for (int n = 11; n > 2; --n) sum = 1 + sum * x / n;
    return x + x * x * (sum / 2);
  }
  const Split in = split(x);
  const Pair& power = powers[static_cast<std::size_t>(in.k & (per_octave - 1))];
  const double scale = std::ldexp(power.high, in.k >> 7);
  const Pair without = two_sum(scale, -1);
  return without.high + (without.low + scale * exp_rest(in.r, power.low));
}

double log(double x) {
  const Positive in = positive(x);
  return in.has_value ? in.value : log_of(in.bits, in.octaves);
}

double log2(double x) {
  return log_by(x, {0x1.7154760000000p+0, 0x1.4ae0bf85ddf44p-26});
}

double log10(double x) {
  return log_by(x, {0x1.bcb7b10000000p-2, 0x1.49b9438ca9aaep-28});
}

double log1p(double x) {
  if (std::abs(x) < 0x1p-9) return x - x * x * (0.5 - x * log_rest(x));
  if (!(x > -1) || x > 0x1p60) return log(1 + x);
  const Pair sum = two_sum(1, x);
  const Pair log = log_pair(std::bit_cast<Bits>(sum.high), 0, sum.low / sum.high);
  return log.high + log.low;
}

double pow(double x, double y) {
  if (y == 2) return x * x;
  const Bits bits = std::bit_cast<Bits>(x), y_bits = std::bit_cast<Bits>(y) & ~Bits{0} >> 1;
  // x is normal and positive, and |y| in [2^-65, 2^65)
  if (bits - 0x0010000000000000 >= 0x7fe0000000000000 || y_bits - 0x3be0000000000000 >= 0x0820000000000000)
    return rare_pow(x, y);
  const Pair log = log_pair(bits, 0), power = two_product(y, log.high);
  if (!(std::abs(power.high) < 746)) return power.high > 0 ? infinity : 0;
  return exp_of(power.high, power.low + y * log.low);
}

double cbrt(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  const double scale = std::abs(x) < 0x1p-900 ? 0x1p60 : std::abs(x) > 0x1p900 ? 0x1p-60 : 1;
  const double size = std::abs(x) * scale;
  // A third of the exponent and one of Halley's steps give t to 2^-15. Of 17 bits, its cube is exact; the rest is a series.
  double t = std::bit_cast<double>(std::bit_cast<Bits>(size) / 3 + 0x2a9f789300000000);
  const double near = t * t * t;
  t = without_bits(t + t * ((size - near) / (near + near + size)), 36);
  const double cube = t * t * t, off = (size - cube) / cube;
  t += t * off * ((1.0 / 3 - off * (1.0 / 9)) + off * off * (5.0 / 81 - off * (10.0 / 243)));
  return std::copysign(t * (scale > 1 ? 0x1p-20 : scale < 1 ? 0x1p20 : 1), x);
}

double erf(double x) {
  const double size = std::abs(x);
  if (!(size < 6)) return std::isnan(x) ? x : std::copysign(1, x);
  if (size < 0.5) {
    const Pair first = two_product(size, erf_slope.high);
    double sum = 0;
    for (std::size_t n = erf_series.size(); n-- > 0;) sum = sum * (x * x) + erf_series[n];
    return std::copysign(first.high + (first.low + size * (erf_slope.low + x * x * sum)), x);
  }
  const double whole = size * 16 + to_whole - to_whole, b = size - whole / 16;
  const ErfNode& node = erf_table[static_cast<std::size_t>(whole)];
  double sum = 0;
  for (std::size_t n = node.series.size(); n-- > 0;) sum = sum * b + node.series[n];
  return std::copysign(node.value.high + (node.value.low + sum * b), x);
}

float exp(float x) {
  return static_cast<float>(exp(double{x}));
}

float exp2(float x) {
  return static_cast<float>(exp2(double{x}));
}

float log(float x) {
  return static_cast<float>(log(double{x}));
}

float log2(float x) {
  const Positive in = positive(x);
  return static_cast<float>(in.has_value ? in.value : log_of(in.bits, in.octaves) * 0x1.71547652b82fep+0);
}

float log1p(float x) {
  return static_cast<float>(log1p(double{x}));
}

float pow(float x, float y) {
  if (!(x > 0) || x > std::numeric_limits<float>::max()) return static_cast<float>(pow(double{x}, double{y}));
  if (y == 2) return x * x;
  const double power = y * log_of(std::bit_cast<Bits>(double{x}), 0);
  return static_cast<float>(std::abs(power) < 700 ? exp_of(power, 0) : exp(power));
}

float erf(float x) {
  return static_cast<float>(erf(double{x}));
}

}  // namespace etak::math
