// SPDX-License-Identifier: Apache-2.0
// Torrance and Sparrow 1967, Cook and Torrance 1981: shadowing and masking of symmetric V-grooves,
// G = min(1, 2 nh nv / vh, 2 nh nl / vh).
real g_cook_torrance(real nh, real nv, real nl, real vh) {
  return min(real(1), 2 * nh / max(vh, tiny) * min(nv, nl));
}

// G / (4 nl nv) = min(1 / (4 nl nv), nh / (2 lh max(nl, nv))) over one divisor: finite at grazing light or view unless
// both graze.
real v_cook_torrance(Angles a) {
  real most = max(a.nl, a.nv);
  real least = min(a.nl, a.nv);
  return min(a.lh, 2 * a.nh * least) / max(4 * a.lh * least * most, tiny);
}
