// SPDX-License-Identifier: Apache-2.0
// No include guard: the exp, sin and cos of glsl.h without branches or calls, so that loops over them run in vector lanes; for
// a namespace where `real` is double. Coefficients: Taylor's, of as many terms as the stated ranges need. Constants in
// two and three pieces after Cody and Waite 1980: products of the first pieces with whole numbers are exact.

// Adding it rounds a number below 2^31 to a whole one and leaves that in the low bits.
constexpr double to_whole = 6755399441055744.0;  // 1.5 2^52

// e^x for x clamped to [-708, 708]: relative error 3e-16.
inline real exp(real x) {
  const real in = min(max(x, real(-708)), real(708));
  const real shifted = in * 1.4426950408889634 + to_whole;
  const real whole = shifted - to_whole;
  const real r = in - whole * 0x1.62e42fefa3800p-1 - whole * 0x1.ef35793c76730p-45;
  real sum = 1.0 / 6227020800;
  for (const real share : {1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320,
                           1.0 / 5040, 1.0 / 720, 1.0 / 120, 1.0 / 24, 1.0 / 6, 0.5, 1.0, 1.0})
    sum = sum * r + share;
  return sum * __builtin_bit_cast(double, (__builtin_bit_cast(long long, shifted) + 1023) << 52);
}

// sin and cos of angles up to 1e6: absolute error 3e-16.
inline real turned_sine(real x, long long quarters_ahead) {
  const real shifted = x * 0.63661977236758134308 + to_whole;
  const real whole = shifted - to_whole;
  const real r =
      x - whole * 0x1.921fb54400000p0 - whole * 0x1.0b4611a600000p-34 - whole * 0x1.3198a2e037073p-69;
  const real r2 = r * r;
  real odd = -1.0 / 1307674368000;
  for (const real share : {1.0 / 6227020800, -1.0 / 39916800, 1.0 / 362880, -1.0 / 5040, 1.0 / 120, -1.0 / 6})
    odd = odd * r2 + share;
  real even = 1.0 / 20922789888000;
  for (const real share :
       {-1.0 / 87178291200, 1.0 / 479001600, -1.0 / 3628800, 1.0 / 40320, -1.0 / 720, 1.0 / 24, -0.5})
    even = even * r2 + share;
  const long long quarters = __builtin_bit_cast(long long, shifted) + quarters_ahead;
  const real value = (quarters & 1) != 0 ? 1 + r2 * even : r + r * r2 * odd;
  return (quarters & 2) != 0 ? -value : value;
}
inline real sin(real x) {
  return turned_sine(x, 0);
}
inline real cos(real x) {
  return turned_sine(x, 1);
}
