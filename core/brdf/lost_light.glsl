// SPDX-License-Identifier: Apache-2.0
// Written by tests/bench/fit_lost_light.cpp: the share of light that a rough surface of F = 1 loses, because one
// reflection sends it to other facets, for Smith's height-correlated masking; and its mean over a diffuse hemisphere.
// At most 0.0071 below the integral and never above it, so that no light is gained, for widths from 0.01 to 1.
//   c       cosine of the direction and the normal, [0, 1]
//   alpha   width, (0, 1]

real lost_ggx(real c, real alpha) {
  real t = c / max(c + real(0.5) * alpha, tiny);
  real u = 2 * t - 1;
  real a = 2 * alpha - 1;
  real k0 = real(0.46636) + a * (real(0.546094) + a * (real(0.164867) + a * (real(-0.0769274))));
  real k1 = real(-0.0230513) + a * (real(-0.082128) + a * (real(-0.0679905) + a * (real(-0.0757547))));
  real k2 = real(0.128685) + a * (real(0.19633) + a * (real(-0.0538467) + a * (real(-0.095094))));
  real k3 = real(-0.238527) + a * (real(-0.372321) + a * (real(-0.102414) + a * (real(0.408342))));
  real k4 = real(-0.852975) + a * (real(-0.185874) + a * (real(0.854354) + a * (real(0.485698))));
  real k5 = real(0.104321) + a * (real(0.89761) + a * (real(1.22275) + a * (real(0.0612722))));
  real k6 = real(0.986937) + a * (real(1.01328) + a * (real(0.402474) + a * (real(0.269815))));
  return max(t * (k0 + u * (k1 + u * (k2 + u * (k3 + u * (k4 + u * (k5 + u * (k6))))))) - real(0.0019), real(0));
}

real mean_lost_ggx(real alpha) {
  real a = 2 * max(sqrt(alpha), real(0.1)) - 1;
  return alpha * alpha * (real(1.86833) + a * (real(-1.5554) + a * (real(-0.0439925) + a * (real(-4.37059) + a * (real(10.9612) + a * (real(9.60634) +
      a * (real(-40.3763) + a * (real(15.5047) + a * (real(30.4565) + a * (real(-26.5321) + a * (real(5.07011))))))))))));
}

real lost_beckmann(real c, real alpha) {
  real t = c / max(c + real(2) * alpha, tiny);
  real u = 2 * t - 1;
  real a = 2 * alpha - 1;
  real k0 = real(0.121089) + a * (real(0.121233) + a * (real(0.713919) + a * (real(1.71917) + a * (real(1.64017) + a * (real(0.540023))))));
  real k1 = real(-1.25545) + a * (real(-2.27287) + a * (real(0.0564527) + a * (real(8.55055) + a * (real(12.5444) + a * (real(5.49929))))));
  real k2 = real(-1.30707) + a * (real(-6.08333) + a * (real(0.695176) + a * (real(25.9202) + a * (real(33.8468) + a * (real(12.9792))))));
  real k3 = real(1.00591) + a * (real(1.71072) + a * (real(17.5266) + a * (real(40.4242) + a * (real(31.1623) + a * (real(7.27083))))));
  real k4 = real(3.01722) + a * (real(19.0227) + a * (real(35.0691) + a * (real(21.3474) + a * (real(-2.34102) + a * (real(-4.08882))))));
  real k5 = real(1.60165) + a * (real(14.1543) + a * (real(18.8203) + a * (real(-0.799494) + a * (real(-10.595) + a * (real(-3.68883))))));
  return max(t * (k0 + u * (k1 + u * (k2 + u * (k3 + u * (k4 + u * (k5)))))) - real(0.0036), real(0));
}

real mean_lost_beckmann(real alpha) {
  real a = 2 * max(sqrt(alpha), real(0.1)) - 1;
  return alpha * alpha * (real(0.444934) + a * (real(0.00235315) + a * (real(-0.58463) + a * (real(0.195632) + a * (real(3.07388) + a * (real(-2.34579) +
      a * (real(-5.7857) + a * (real(5.67868) + a * (real(2.95782) + a * (real(-4.16075) + a * (real(0.856168))))))))))));
}
