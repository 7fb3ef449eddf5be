// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace etak::math {

/// The elementary functions, with the same bits on every processor, system and C library, where those of <cmath> differ in
/// the last one. They are made of + - * / and sqrt, which IEEE 754 rounds in one way, of whole numbers and of tables that the
/// compiler computes (pair.h).
///   arguments  any double, in radians; special values, infinities and signs of zero as in annex F of the C standard
///   error      exp exp2 log log2 log10 log1p pow cbrt hypot stay within 0.53 units of the last place, sin cos within 0.56, the others
///              within 0.8, hypot of three within 1.5. Results that are doubles are met: pow(10, 3), log2(8), cbrt(27).
/// tests/core/math/test_functions.cpp holds them to that.
double exp(double x);
double exp2(double x);
double expm1(double x);  // e^x - 1
double log(double x);
double log2(double x);
double log10(double x);
double log1p(double x);  // log(1 + x)
double pow(double x, double y);
double cbrt(double x);
double erf(double x);

double sin(double x);
double cos(double x);
double tan(double x);
double asin(double x);
double acos(double x);
double atan(double x);
double atan2(double y, double x);
double hypot(double x, double y);
double hypot(double x, double y, double z);

/// The same for floats: computed in double and rounded, which gives the float next to the result but for one in some millions.
float exp(float x);
float exp2(float x);
float log(float x);
float log2(float x);
float log1p(float x);
float pow(float x, float y);
float erf(float x);
float sin(float x);
float cos(float x);
float atan(float x);
float atan2(float y, float x);

}  // namespace etak::math
