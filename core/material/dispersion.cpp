// SPDX-License-Identifier: Apache-2.0
// Based on
//   refractiveindex.info, "Dispersion formulas" (the numbering 1..9 and the meaning of C1, C2, ...)
//   Sellmeier 1871 (1, 2), Cauchy 1836 (5), Herzberger 1942 (7); wavelength L in micrometres throughout
// L goes through the formula in short blocks: the loop over coefficients is outside, the loop over the block
// inside, so the compiler makes vectors of it, and L^2, L^-4, ... are products (pow would be nine tenths of
// the run time).
#include "core/material/dispersion.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "core/base/error.h"
#include "core/math/functions.h"

namespace etak {
namespace {

constexpr std::size_t block_size = 64;
using Block = std::array<double, block_size>;

// L, L^2 and L^-2 of one block; unused places repeat the last wavelength, so that no loop needs a tail.
struct Wavelengths {
  Block um, um2, per_um2;
};

// C1, C2, ... with absent ones as 0.
struct Coefficients {
  const std::vector<double>& values;
  std::size_t size() const { return values.size(); }
  double operator()(std::size_t number) const { return number <= values.size() ? values[number - 1] : 0.0; }
};

void fill(Block& out, double value) {
  out.fill(value);
}

// out = L^exponent. Whole exponents up to 64 by squaring, the rest by pow.
void power(const Wavelengths& l, double exponent, Block& out) {
  if (exponent != std::trunc(exponent) || std::abs(exponent) > 64) {
    for (std::size_t i = 0; i < block_size; ++i) out[i] = math::pow(l.um[i], exponent);
    return;
  }
  auto rest = static_cast<unsigned>(std::abs(exponent));
  if (rest == 0) return fill(out, 1);
  const bool even = rest % 2 == 0;
  Block square = even ? (exponent < 0 ? l.per_um2 : l.um2) : l.um;
  if (!even && exponent < 0)
    for (double& x : square) x = 1 / x;
  if (even) rest /= 2;
  const auto square_again = [&] {
    for (double& x : square) x *= x;
    rest /= 2;
  };
  while (rest % 2 == 0) square_again();
  out = square;
  while (rest > 1) {
    square_again();
    if (rest % 2 == 1)
      for (std::size_t i = 0; i < block_size; ++i) out[i] *= square[i];
  }
}

// sum += C L^exponent
void add_power(const Wavelengths& l, double c, double exponent, Block& sum) {
  Block term;
  power(l, exponent, term);
  for (std::size_t i = 0; i < block_size; ++i) sum[i] += c * term[i];
}

// The polynomial tail C_first L^C_(first+1) + ... of formulas 3, 4 and 5.
void add_powers(const Wavelengths& l, const Coefficients& c, std::size_t first, Block& sum) {
  for (std::size_t j = first; j + 1 <= c.size(); j += 2) add_power(l, c(j), c(j + 1), sum);
}

// n^2 - 1 = C1 + sum C2i L^2 / (L^2 - P), P = C(2i+1)^2 (formula 1) or C(2i+1) (formula 2)
void sellmeier(const Wavelengths& l, const Coefficients& c, bool squared, Block& n2) {
  fill(n2, 1 + c(1));
  for (std::size_t j = 2; j + 1 <= c.size(); j += 2) {
    const double strength = c(j);
    const double pole = squared ? c(j + 1) * c(j + 1) : c(j + 1);
    for (std::size_t i = 0; i < block_size; ++i) n2[i] += strength * l.um2[i] / (l.um2[i] - pole);
  }
}

// n^2 = C1 + C2 L^C3/(L^2 - C4^C5) + C6 L^C7/(L^2 - C8^C9) + C10 L^C11 + ...
void mixed(const Wavelengths& l, const Coefficients& c, Block& n2) {
  fill(n2, c(1));
  for (const std::size_t j : {std::size_t{2}, std::size_t{6}}) {
    if (c.size() < j) break;
    // An absent pole is 0, not 0^0.
    const double pole = c.size() < j + 2 ? 0.0 : math::pow(c(j + 2), c(j + 3));
    Block numerator;
    power(l, c(j + 1), numerator);
    const double strength = c(j);
    for (std::size_t i = 0; i < block_size; ++i) n2[i] += strength * numerator[i] / (l.um2[i] - pole);
  }
  add_powers(l, c, 10, n2);
}

// n - 1 = C1 + sum C2i / (C(2i+1) - L^-2)
void gases(const Wavelengths& l, const Coefficients& c, Block& n) {
  fill(n, 1 + c(1));
  for (std::size_t j = 2; j + 1 <= c.size(); j += 2) {
    const double strength = c(j), pole = c(j + 1);
    for (std::size_t i = 0; i < block_size; ++i) n[i] += strength / (pole - l.per_um2[i]);
  }
}

// n = C1 + C2/(L^2 - 0.028) + C3 (1/(L^2 - 0.028))^2 + C4 L^2 + C5 L^4 + C6 L^6
void herzberger(const Wavelengths& l, const Coefficients& c, Block& n) {
  for (std::size_t i = 0; i < block_size; ++i) {
    const double l2 = l.um2[i], r = 1 / (l2 - 0.028);
    n[i] = c(1) + (c(2) + c(3) * r) * r + (c(4) + (c(5) + c(6) * l2) * l2) * l2;
  }
}

// (n^2 - 1)/(n^2 + 2) = C1 + C2 L^2/(L^2 - C3) + C4 L^2
void retro(const Wavelengths& l, const Coefficients& c, Block& n2) {
  for (std::size_t i = 0; i < block_size; ++i) {
    const double l2 = l.um2[i], q = c(1) + c(2) * l2 / (l2 - c(3)) + c(4) * l2;
    n2[i] = (1 + 2 * q) / (1 - q);
  }
}

// n^2 = C1 + C2/(L^2 - C3) + C4 (L - C5)/((L - C5)^2 + C6)
void exotic(const Wavelengths& l, const Coefficients& c, Block& n2) {
  for (std::size_t i = 0; i < block_size; ++i) {
    const double d = l.um[i] - c(5);
    n2[i] = c(1) + c(2) / (l.um2[i] - c(3)) + (c.size() < 4 ? 0.0 : c(4) * d / (d * d + c(6)));
  }
}

// True when `out` is n^2, false when it is n.
bool evaluate_block(int number, const Wavelengths& l, const Coefficients& c, Block& out) {
  switch (number) {
    case 1:
      sellmeier(l, c, true, out);
      return true;
    case 2:
      sellmeier(l, c, false, out);
      return true;
    case 3:
      fill(out, c(1));
      add_powers(l, c, 2, out);
      return true;
    case 4:
      mixed(l, c, out);
      return true;
    case 5:
      fill(out, c(1));
      add_powers(l, c, 2, out);
      return false;
    case 6:
      gases(l, c, out);
      return false;
    case 7:
      herzberger(l, c, out);
      return false;
    case 8:
      retro(l, c, out);
      return true;
    default:
      exotic(l, c, out);
      return true;
  }
}

std::size_t most_coefficients(int number) {
  switch (number) {
    case 7:
    case 9:
      return 6;
    case 8:
      return 4;
    default:
      return 17;
  }
}

}  // namespace

void evaluate(const DispersionFormula& formula, std::span<const double> at_nm, std::span<double> n) {
  assert(formula.number >= 1 && formula.number <= 9 && !formula.coefficients.empty() &&
         n.size() == at_nm.size());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Coefficients coefficients{formula.coefficients};
  Wavelengths l;
  Block out;
  for (std::size_t begin = 0; begin < at_nm.size(); begin += block_size) {
    const std::size_t count = std::min(block_size, at_nm.size() - begin);
    for (std::size_t i = 0; i < block_size; ++i) {
      const double nm = at_nm[begin + std::min(i, count - 1)];
      l.um[i] = std::min(std::max(nm, formula.first_nm), formula.last_nm) / 1000;
    }
    for (std::size_t i = 0; i < block_size; ++i) l.um2[i] = l.um[i] * l.um[i];
    for (std::size_t i = 0; i < block_size; ++i) l.per_um2[i] = 1 / l.um2[i];
    if (evaluate_block(formula.number, l, coefficients, out))
      for (double& x : out) x = std::sqrt(x);
    // A pole gives an infinity (or 0/0); neither is an index.
    for (std::size_t i = 0; i < count; ++i) n[begin + i] = std::abs(out[i]) < infinity ? out[i] : nan;
  }
}

std::string_view defect(const DispersionFormula& formula) {
  if (formula.number < 1 || formula.number > 9) return "formula number outside 1..9";
  const std::size_t count = formula.coefficients.size();
  if (count == 0) return "no coefficients";
  if (count > most_coefficients(formula.number)) return "more coefficients than the formula has";
  const bool in_pairs = (formula.number <= 6 && formula.number != 4) || (formula.number == 4 && count > 9);
  if (in_pairs && count % 2 == 0) return "the last coefficient has no partner";
  for (const double c : formula.coefficients)
    if (!std::isfinite(c)) return "a coefficient is not finite";
  if (!(formula.first_nm > 0 && std::isfinite(formula.last_nm))) return "wavelength range not positive";
  if (!(formula.first_nm < formula.last_nm)) return "empty wavelength range";
  return {};
}

void validate(const DispersionFormula& formula, std::string_view what) {
  const std::string_view found = defect(formula);
  if (!found.empty()) throw Error::at(what, found);
}

}  // namespace etak
