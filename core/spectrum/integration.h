// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/spectrum/cie.h"

namespace etak {

/// How the integral of reflectance x illuminant x colour-matching function is taken. Every method normalises
/// with its own sum for R = 1, so that a flat reflectance has no hue under any of them.
///   nm1                sum over 360..830 nm in steps of 1 nm: the reference policy
///   exact              Gauss-Legendre on every piece between neighbouring knots of data, observer and
///                      illuminant
///   nm5, nm10, nm20    sums over 360..830 nm in wider steps, with weights sampled at those steps
///   e308_10, e308_20   weights for 360..830 nm samples, 10 or 20 nm apart, folded from the 1 nm tables
///                      through third-order Lagrange interpolation of the reflectance (the way of ASTM E2022
///                      that makes the tables of ASTM E308)
///   legacy_point       R at 650, 550 and 450 nm taken as linear red, green and blue
///   legacy_schueler    R at 643, 562 and 396 nm (inferred from Schueler's table 2.5.1), 8 bit by the pure
///                      power 1/2.2
///   automatic          the coarsest of 20, 10, 5, 1 nm and exact whose estimated error is within a bound
///                      (core/spectrum/refinement.h)
enum class Method { nm1, exact, nm5, nm10, nm20, e308_10, e308_20, legacy_point, legacy_schueler, automatic };

/// The methods with weights of their own: all but automatic, which chooses among them.
inline constexpr std::array all_methods{Method::nm1,     Method::exact,        Method::nm5,
                                        Method::nm10,    Method::nm20,         Method::e308_10,
                                        Method::e308_20, Method::legacy_point, Method::legacy_schueler};

/// "1nm", "exact", "5nm", "10nm", "20nm", "e308-10nm", "e308-20nm", "point-650-550-450", "point-643-562-396",
/// "auto"
std::string_view name(Method method);
std::optional<Method> method_named(std::string_view text);

/// True for the two methods that take three samples as red, green and blue and know no observer or
/// illuminant.
bool samples_rgb(Method method);

/// Distance between the samples of a sum, in nm; 0 for the methods that are none.
int step_nm(Method method);

/// A weighted sum that turns reflectance samples into X, Y, Z (or, for the point methods, into linear R, G,
/// B).
///   wavelength_nm   where the reflectance is needed, ascending
///   weight          weight[c][i] of sample i for X, Y, Z; scaled so that R = 1 gives Y = 1
struct Quadrature {
  std::vector<double> wavelength_nm;
  std::array<std::vector<double>, 3> weight;

  /// sum over i of weight[c][i] * reflectance[i]; four partial sums, so the order is fixed and vectors help.
  std::array<double, 3> integrate(std::span<const double> reflectance) const;

  /// integrate() of R = 1: the white point, with Y = 1; the same rounding as any flat reflectance has.
  std::array<double, 3> white() const;
};

/// The quadrature of every method with a fixed one; for exact and automatic that of data without knots.
Quadrature make_quadrature(Method method, Viewing viewing);

/// The exact method for data whose samples lie at `knots_nm` (ascending, any range): piecewise smooth between
/// them. With n and k linear between knots the integrand is rational there; five Gauss points leave a
/// relative error below 1e-11 for published data, and 3e-7 for a spike of n from 0.5 to 9 within half a
/// nanometre.
Quadrature make_exact_quadrature(Viewing viewing, std::span<const double> knots_nm);

/// An estimate of the error of the exact method in X, Y or Z: the change when only three of the five points
/// of every piece are used, all changes added. It is far above the real error.
///   exact   of make_exact_quadrature()
double exact_method_error(const Quadrature& exact, std::span<const double> reflectance);

/// Share of each of the X, Y, Z weights (sums at 1 nm over 360..830 nm) that lies inside [first_nm, last_nm];
/// a grid point stands for the nanometre around it, so it counts up to half a nanometre outside.
std::array<double, 3> weight_inside(Viewing viewing, double first_nm, double last_nm);

}  // namespace etak
