// SPDX-License-Identifier: Apache-2.0
// Torrance and Sparrow 1967, Cook and Torrance 1981: shadowing and masking of symmetric V-grooves,
// G = min(1, 2 nh nv / vh, 2 nh nl / vh).
real g_cook_torrance(real nh, real nv, real nl, real vh) {
  return min(real(1), 2 * nh / max(vh, tiny) * min(nv, nl));
}

// G / (4 nl nv) with the small cosine divided out where it can be: finite at grazing light or view unless
// both graze.
real v_cook_torrance(Angles a) {
  real most = max(a.nl, a.nv);
  real least = min(a.nl, a.nv);
  return min(1 / (4 * max(least, tiny)), a.nh / (2 * max(a.lh, tiny))) / max(most, tiny);
}
