// SPDX-License-Identifier: Apache-2.0
// What a metal reflects under a clear coat, from its F0 and F82 in air, through n and k of each channel: OpenPBR has a metal by
// these two and asks for those under the coat. Needs conductor.glsl, schlick.glsl and f82.glsl.
// Based on:
//   Gulbrandsen 2014, "Artist Friendly Metallic Fresnel": n and k of one F0 lie on a circle
// Light is reflected head on with the amplitude (N - 1) / (N + 1), N = n + i k, of size sqrt(F0): media of one F0 differ by its
// phase alone. With the phase F82 rises all the way from that of k = 0, n = (1 + sqrt F0) / (1 - sqrt F0), to that of k = 0
// and the inverse of this n, so that F0 and F82 have one n and k.
//   f0     taken as 0 below 0 (n = 1, k = 0: no interface), and as 1 above 1, which reflects everything under any coat
//   f82    at cosine 1/7. Below what k = 0 reflects there, that is the nearest n and k, and above the other end likewise
//   turn   squared sine of half the phase, [0, 1]; the nearest n and k of F82 out of reach have 0 or 1

struct EdgeIndex {
  real n;
  real k;
};

EdgeIndex index_of_turn(real f0_value, real turn) {
  real root = sqrt(f0_value);
  real least = (1 - f0_value) / (1 + root);
  // |1 - amplitude|^2
  real gap = max(least * least + 4 * root * turn, tiny);
  EdgeIndex index;
  index.n = (1 - f0_value) / gap;
  index.k = 4 * root * sqrt(turn * (1 - turn)) / gap;
  return index;
}

real edge_of_turn(real f0_value, real turn) {
  EdgeIndex index = index_of_turn(f0_value, turn);
  return fresnel_exact(index.n, index.k, f82_cosine);
}

// Where the turn lies between, what F82 misses at both ends, and the next place to look at.
//   side   the end that moved last: -1 low, 1 high
struct EdgeSearch {
  real low;
  real high;
  real below;
  real above;
  real turn;
  real side;
};

// The line between the ends, with the end that stays twice drawn nearer (Anderson and Bjorck 1973).
EdgeSearch edge_narrowed(EdgeSearch at, real f0_value, real f82) {
  real miss = edge_of_turn(f0_value, at.turn) - f82;
  real side = miss < 0 ? real(-1) : real(1);
  real moved = miss < 0 ? at.below : at.above;
  real rest = 1 - miss / (abs(moved) > 0 ? moved : real(1));
  real drawn = at.side * side > 0 ? (rest > 0 ? rest : real(0.5)) : real(1);
  EdgeSearch next;
  next.low = miss < 0 ? at.turn : at.low;
  next.below = miss < 0 ? miss : at.below * drawn;
  next.high = miss < 0 ? at.high : at.turn;
  next.above = miss < 0 ? at.above * drawn : miss;
  next.side = side;
  next.turn = clamp(next.low - next.below * (next.high - next.low) / max(next.above - next.below, tiny), next.low, next.high);
  return next;
}

EdgeSearch edge_narrowed_4_times(EdgeSearch at, real f0_value, real f82) {
  EdgeSearch twice = edge_narrowed(edge_narrowed(at, f0_value, f82), f0_value, f82);
  return edge_narrowed(edge_narrowed(twice, f0_value, f82), f0_value, f82);
}

// The turn by the equations for |N| far above 1, R_s = |c - N|^2 / |c + N|^2 and R_p = |N c - 1|^2 / |N c + 1|^2, which are
// quadratic in the gap.
real edge_guess(real f0_value, real f82) {
  real loss = 1 - f0_value;
  real p = 2 * f82_cosine * (f82_cosine * (1 + f0_value) + loss);
  real s = 2 * (1 + f0_value + f82_cosine * loss);
  real square = (s + p) * (s + p - 8 * f82_cosine * loss / max(1 - f82, tiny));
  real gap = (s - p - sqrt(max(square, real(0)))) / (2 * (1 - f82_cosine * f82_cosine));
  real root = sqrt(f0_value);
  real least = loss / (1 + root);
  return clamp((gap - least * least) / max(4 * root, tiny), real(0), real(1));
}

//   error   of F82 that n and k give: 1e-9 for F0 of at least 0.02, and 1e-4 in float
EdgeIndex index_of_edge(real f0_value, real f82) {
  real r = clamp(f0_value, real(0), real(1));
  EdgeSearch at;
  at.low = real(0);
  at.high = real(1);
  at.below = edge_of_turn(r, real(0)) - f82;
  at.above = edge_of_turn(r, real(1)) - f82;
  at.turn = edge_guess(r, f82);
  at.side = real(0);
  EdgeSearch end = edge_narrowed_4_times(edge_narrowed_4_times(edge_narrowed_4_times(at, r, f82), r, f82), r, f82);
  return index_of_turn(r, at.below < 0 ? (at.above > 0 ? end.turn : real(1)) : real(0));
}

//   n   index of the coat against the outside, above 0
real f0_under(real f0_value, real f82, real n) {
  EdgeIndex index = index_of_edge(f0_value, f82);
  return f0(index.n / n, index.k / n);
}

// At cosine 1/7 in the coat.
real f82_under(real f0_value, real f82, real n) {
  EdgeIndex index = index_of_edge(f0_value, f82);
  return fresnel_exact(index.n / n, index.k / n, f82_cosine);
}
