// SPDX-License-Identifier: Apache-2.0
#include "core/math/functions.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "core/math/pair.h"

using namespace etak;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

enum class Function {
  exp_of,
  exp2_of,
  expm1_of,
  log_of,
  log2_of,
  log10_of,
  log1p_of,
  cbrt_of,
  erf_of,
  sin_of,
  cos_of,
  tan_of,
  asin_of,
  acos_of,
  atan_of,
  pow_of,
  atan2_of,
  hypot_of
};

using Long = long double;

/// A function of ours, that of <cmath> in long double, and the stated error in units of the last place.
struct Pairing {
  Function function;
  std::string name;
  double (*own)(double, double);
  Long (*known)(Long, Long);
  double error;
};

#define ETAK_ONE(name, error)                                                   \
  Pairing {                                                                     \
    Function::name##_of, #name, [](double x, double) { return math::name(x); }, \
        [](Long x, Long) -> Long { return std::name(x); }, error                \
  }
#define ETAK_TWO(name, error)                                                        \
  Pairing {                                                                          \
    Function::name##_of, #name, [](double x, double y) { return math::name(x, y); }, \
        [](Long x, Long y) -> Long { return std::name(x, y); }, error                \
  }
const std::vector<Pairing> pairings{ETAK_ONE(exp, 0.52),   ETAK_ONE(exp2, 0.52), ETAK_ONE(expm1, 0.7),
                                    ETAK_ONE(log, 0.51),   ETAK_ONE(log2, 0.51), ETAK_ONE(log10, 0.51),
                                    ETAK_ONE(log1p, 0.51), ETAK_ONE(cbrt, 0.51), ETAK_ONE(erf, 0.9),
                                    ETAK_ONE(sin, 0.56),   ETAK_ONE(cos, 0.56),  ETAK_ONE(tan, 0.6),
                                    ETAK_ONE(asin, 0.7),   ETAK_ONE(acos, 0.6),  ETAK_ONE(atan, 0.7),
                                    ETAK_TWO(pow, 0.53),   ETAK_TWO(atan2, 0.7), ETAK_TWO(hypot, 0.51)};
#undef ETAK_ONE
#undef ETAK_TWO

const Pairing& pairing(Function function) {
  return pairings.at(static_cast<std::size_t>(function));
}

// The unit of the last place, also of subnormal numbers.
double unit_of(double x) {
  const double size = std::abs(x);
  if (size < std::numeric_limits<double>::min()) return std::numeric_limits<double>::denorm_min();
  return std::ldexp(1, std::ilogb(size) - 52);
}

// A result below the smallest normal number is rounded twice.
double allowed(const Pairing& of, double result) {
  return std::abs(result) < std::numeric_limits<double>::min() ? 0.5 + of.error / 2 : of.error;
}

struct HardArgument {
  Function function;
  double x, y, nearest, rest;
};
const std::vector<HardArgument> hard_arguments{
#include "tests/core/math/hard_arguments.inc"
};

std::vector<double> between(double low, double high) {
  std::mt19937_64 random(7);
  std::vector<double> out;
  for (int i = 0; i < 20000; ++i)
    out.push_back(low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53));
  return out;
}

double worst_error(const Pairing& of, const std::vector<double>& xs, const std::vector<double>& ys) {
  double worst = 0;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const double y = ys[ys.size() - 1 - i], own = of.own(xs[i], y);
    const Long known = of.known(xs[i], y);
    const auto nearest = static_cast<double>(known);
    if (!(std::abs(nearest) > std::numeric_limits<double>::min()) || std::isinf(nearest)) continue;
    worst = std::max(
        worst, static_cast<double>(std::abs((static_cast<Long>(own) - known) / Long{unit_of(nearest)})));
  }
  return worst;
}

bool same(double a, double b) {
  return std::isnan(a) ? std::isnan(b) : a == b && std::signbit(a) == std::signbit(b);
}

}  // namespace

TEST_CASE("pairs: sums are exact, products are to 2^-104") {
  for (const double x : between(-3, 3)) {
    const double y = 1 / (x + 3.5);
    const math::Pair sum = math::two_sum(x, y), product = math::two_product(x, y);
    CHECK(Long{sum.high} + Long{sum.low} == Long{x} + Long{y});
    CHECK(product.high == x * y);
    if (std::numeric_limits<Long>::digits >= 64)
      CHECK(std::abs(static_cast<double>(Long{x} * Long{y} - product.high) - product.low) <=
            std::abs(x * y) * 0x1p-62);
  }
}

TEST_CASE("functions are within their stated errors at hard arguments, whose results mpmath computed") {
  CHECK(hard_arguments.size() > 400);
  for (const HardArgument& row : hard_arguments) {
    const Pairing& of = pairing(row.function);
    const double own = of.own(row.x, row.y);
    INFO(of.name << "(" << row.x << ", " << row.y << ") = " << own);
    CHECK(std::abs((own - row.nearest) / unit_of(row.nearest) - row.rest) <= allowed(of, row.nearest));
  }
}

TEST_CASE("functions are within their stated errors over their ranges, beside those of long double") {
  if (std::numeric_limits<Long>::digits < 64) return;
  const std::vector<std::pair<double, double>> ranges{{-1, 1},      {-0.01, 0.01},   {0.2, 0.3}, {0.5, 2},
                                                      {0.99, 1.01}, {-700, 700},     {0, 1e5},   {1e5, 1e300},
                                                      {-30, 0},     {1e-300, 1e-290}};
  for (const Pairing& of : pairings)
    for (const auto& [low, high] : ranges) {
      INFO(of.name << " in [" << low << ", " << high << "]");
      CHECK(worst_error(of, between(low, high), between(-50, 50)) <= of.error);
    }
  // Powers near 1 with exponents that are large.
  CHECK(worst_error(pairing(Function::pow_of), between(0.999, 1.001), between(-5e5, 5e5)) <= 0.53);
  CHECK(worst_error(pairing(Function::hypot_of), between(-1e-3, 1e-3), between(-1, 1)) <= 0.51);
  double worst = 0;
  for (const double x : between(-1, 1)) {
    const Long length = std::sqrt(Long{x} * x + Long{0.3} * 0.3 + Long{x / 3} * (x / 3));
    const double own = math::hypot(x, 0.3, x / 3);
    worst = std::max(worst, std::abs(static_cast<double>((own - length) / Long{unit_of(own)})));
  }
  CHECK(worst < 1.5);
}

TEST_CASE("results that are doubles are met") {
  for (int i = -1074; i < 1024; ++i) {
    CHECK(math::exp2(static_cast<double>(i)) == std::ldexp(1, i));
    CHECK(math::pow(2.0, i) == std::ldexp(1, i));
    CHECK(math::log2(std::ldexp(1, i)) == i);
  }
  double power = 1;
  for (int i = 0; i <= 22; ++i, power *= 10) {
    CHECK(math::pow(10.0, i) == power);
    CHECK(math::log10(power) == i);
  }
  for (double i = 1; i < 1000; ++i) {
    const double cube = i * i * i;
    CHECK(math::cbrt(cube) == i);
    CHECK(math::cbrt(-cube) == -i);
    CHECK(math::pow(i, 3) == cube);
    CHECK(math::pow(i, 5) == cube * i * i);
    CHECK(math::pow(i * i, 0.5) == i);
    CHECK(math::hypot(3 * i, -4 * i) == 5 * i);
    CHECK(math::hypot(2 * i, 3 * i, 6 * i) == 7 * i);
  }
  for (const double x : between(-5, 5)) {
    CHECK(math::pow(x, 1) == x);
    CHECK(math::pow(x, 2) == x * x);
    CHECK(math::sin(-x) == -math::sin(x));
    CHECK(math::cos(-x) == math::cos(x));
    CHECK(math::atan2(x, 1) == math::atan(x));
  }
  CHECK(math::exp(0.0) == 1);
  CHECK(same(math::log(1.0), 0));
  CHECK(same(math::log1p(-0.0), -0.0));
  CHECK(same(math::expm1(-0.0), -0.0));
  CHECK(same(math::sin(-0.0), -0.0));
  CHECK(same(math::tan(-0.0), -0.0));
  CHECK(same(math::asin(-0.0), -0.0));
  CHECK(same(math::erf(-0.0), -0.0));
  CHECK(same(math::cbrt(-0.0), -0.0));
  CHECK(same(math::acos(1), 0));
  CHECK(math::cos(0.0) == 1);
}

TEST_CASE("infinities, zeros and what is no number are as annex F of the C standard has them") {
  const std::vector<double> specials{0,      -0.0, 1,   -1,        0.5,    -0.5,     2,         -2,
                                     3,      -3,   2.5, 1e308,     -1e308, 1e-320,   -1e-320,   745.2,
                                     -745.2, -746, 1e5, 1023.9999, 1024,   infinity, -infinity, no_number};
  for (const Pairing& of : pairings)
    for (const double x : specials)
      for (const double y : specials) {
        const double own = of.own(x, y), known = static_cast<double>(of.known(x, y));
        INFO(of.name << "(" << x << ", " << y << ") = " << own << ", expected " << known);
        if (std::isnan(known) || std::isinf(known) || known == 0)
          CHECK(same(own, known));
        else
          CHECK(std::abs(own - known) <= 1.01 * unit_of(known));
        if (of.function < Function::pow_of) break;
      }
  CHECK(std::isnan(math::hypot(1, no_number, 2)));
  CHECK(math::hypot(infinity, no_number, 2) == infinity);
  CHECK(math::hypot(3e300, 4e300, 0) == 5e300);
  CHECK(math::hypot(3e-310, 0, 4e-310) == Approx(5e-310));
}

TEST_CASE("functions rise and fall where they should, also where their tables and series meet") {
  const auto rises = [](auto function, double from, double step, int count) {
    double x = from, last = function(x);
    for (int i = 0; i < count; ++i, x += step) {
      const double now = function(x);
      if (now < last) return false;
      last = now;
    }
    return true;
  };
  for (const double at : {0.0625, 0.125, 0.25, 0.5, 0.6937, 0.7071, 1.0, 1.0078125, 1.3984, 0.00390625}) {
    const double step = at * 0x1p-50, from = at - 3000 * step;
    INFO(at);
    for (double (*const function)(double) :
         {math::exp, math::exp2, math::expm1, math::log, math::log2, math::log10, math::log1p, math::cbrt,
          math::erf, math::sin, math::tan, math::atan})
      CHECK(rises(function, from, step, 6000));
    CHECK(rises([](double x) { return -math::cos(x); }, from, step, 6000));
    CHECK(rises([](double x) { return math::pow(x, 2.4); }, from, step, 6000));
    CHECK(rises([](double x) { return math::pow(x, 1 / 2.4); }, from, step, 6000));
    if (at < 1) CHECK(rises([](double x) { return math::asin(x); }, from, step, 6000));
    if (at < 1) CHECK(rises([](double x) { return -math::acos(x); }, from, step, 6000));
  }
}

TEST_CASE("functions of floats have the float that is nearest to the result") {
  int apart = 0;
  for (const double value : between(0.001, 5)) {
    const auto x = static_cast<float>(value);
    const auto nearest = [](Long y) { return static_cast<float>(y); };
    apart += (math::exp(x) != nearest(std::exp(Long{x}))) + (math::exp2(x) != nearest(std::exp2(Long{x}))) +
             (math::log(x) != nearest(std::log(Long{x}))) + (math::log2(x) != nearest(std::log2(Long{x}))) +
             (math::log1p(x) != nearest(std::log1p(Long{x}))) + (math::erf(x) != nearest(std::erf(Long{x}))) +
             (math::sin(x) != nearest(std::sin(Long{x}))) + (math::cos(x) != nearest(std::cos(Long{x}))) +
             (math::pow(x, 2.2f) != nearest(std::pow(Long{x}, Long{2.2f}))) +
             (math::atan2(x, 0.7f) != nearest(std::atan2(Long{x}, Long{0.7f})));
  }
  CHECK(apart <= 1);
  CHECK(math::pow(0.0f, 2.2f) == 0);
  CHECK(math::pow(-2.0f, 3.0f) == -8);
  CHECK(math::pow(1e-30f, 2.0f) == 0);
  CHECK(std::isinf(math::pow(1e30f, 2.0f)));
  CHECK(math::log2(0.0f) == -std::numeric_limits<float>::infinity());
  for (int i = -149; i < 128; ++i) CHECK(math::log2(std::ldexp(1.0f, i)) == static_cast<float>(i));
}
