// SPDX-License-Identifier: Apache-2.0
// No include guard: the transcendental functions of glsl.h without branches or calls, so that loops over them
// run in vector lanes; for a namespace where `real` is float. Coefficients: weighted minimax fits over the
// stated ranges.

inline unsigned bits_of(float x) {
  return __builtin_bit_cast(unsigned, x);
}
inline float float_of(unsigned bits) {
  return __builtin_bit_cast(float, bits);
}

// The lesser of x and a bound in one instruction: with -fno-trapping-math GCC 12 compares and blends floats,
// which takes a tenth of the time of a whole model. The bits of positive floats are in the floats' order as
// signed numbers with the negative ones below, those of negative floats in the reverse order as unsigned
// numbers with the positive ones below.
#ifdef __SSE4_1__
template <class Bits>
inline real lesser_bits(real a, real b) {
  const Bits x = __builtin_bit_cast(Bits, a), y = __builtin_bit_cast(Bits, b);
  return __builtin_bit_cast(float, y < x ? y : x);
}
template <class Bits>
inline real greater_bits(real a, real b) {
  const Bits x = __builtin_bit_cast(Bits, a), y = __builtin_bit_cast(Bits, b);
  return __builtin_bit_cast(float, x < y ? y : x);
}
inline real min(real a, real b) {
  if (!__builtin_constant_p(b)) return b < a ? b : a;
  return b < 0 ? greater_bits<unsigned>(a, b) : lesser_bits<int>(a, b);
}
inline real max(real a, real b) {
  if (!__builtin_constant_p(b)) return a < b ? b : a;
  return b < 0 ? lesser_bits<unsigned>(a, b) : greater_bits<int>(a, b);
}
#else
inline real min(real a, real b) {
  return b < a ? b : a;
}
inline real max(real a, real b) {
  return a < b ? b : a;
}
#endif

inline real abs(real x) {
  return __builtin_fabsf(x);
}
inline real sqrt(real x) {
  return __builtin_sqrtf(x);
}

// 2^x for x clamped to [-126, 127]; relative error 6e-8 (2e-9 in the polynomial). Adding 1.5 2^23 rounds x to
// a whole number and leaves it in the low bits.
inline real exp2(real x) {
  const real in = min(max(x, real(-126)), real(127));
  const real shifted = in + real(12582912);
  const real f = in - (shifted - real(12582912));
  const real power =
      1 + f * (0.693147203f +
               f * (0.240226479f +
                    f * (0.0555033247f + f * (0.00961843736f + f * (0.00133988744f + f * 0.000153533619f)))));
  return float_of((bits_of(shifted) << 23) + 0x3f800000u) * power;
}

// log2 x for normal x > 0; relative error 1e-7, near x = 1 too (3e-8 in the polynomial). x = 2^e m with m in
// [sqrt(1/2), sqrt 2): 0x3f3504f3 is sqrt(1/2).
inline int log2_exponent(real x) {
  return static_cast<int>(bits_of(x) - 0x3f3504f3u) >> 23;
}
inline real log2_mantissa(real x, int e) {
  return float_of(bits_of(x) - (static_cast<unsigned>(e) << 23));
}
inline real log2_near_1(real t) {  // log2(1 + t)
  const real over_t =
      1.442695f +
      t * (-0.721347347f +
           t * (0.480910643f +
                t * (-0.360703683f +
                     t * (0.287916248f + t * (-0.23894482f + t * (0.215715604f + t * (-0.207269753f +
                                                                                      t * 0.125837033f)))))));
  return t * over_t;
}
inline real log2(real x) {
  const int e = log2_exponent(x);
  return static_cast<real>(e) + log2_near_1(log2_mantissa(x, e) - 1);
}

// See glsl.h.
inline real log2_complement(real c2, real s2) {
  const real safe = max(c2, tiny);
  const int e = log2_exponent(safe);
  const real t = s2 < real(0.29) ? -s2 : log2_mantissa(safe, e) - 1;
  const real whole = s2 < real(0.29) ? real(0) : static_cast<real>(e);
  return whole + log2_near_1(t);
}

inline real exp(real x) {
  return exp2(x * real(1.44269504088896340736));
}
inline real log(real x) {
  return log2(x) * real(0.69314718055994530942);
}
inline real pow(real x, real e) {
  return exp2(e * log2(x));
}

// Abramowitz and Stegun 7.1.26, absolute error 1.5e-7.
inline real erf(real x) {
  const real t = 1 / (1 + real(0.3275911) * abs(x));
  const real tail =
      t * (0.254829592f + t * (-0.284496736f + t * (1.421413741f + t * (-1.453152027f + t * 1.061405429f))));
  const real positive = 1 - tail * exp(-x * x);
  return x < 0 ? -positive : positive;
}
