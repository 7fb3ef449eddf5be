// SPDX-License-Identifier: Apache-2.0
// Layers as textbooks have them: products of characteristic matrices (Born and Wolf, section 1.6.2). Their exponentials grow
// with the layer, so that opaque layers overflow, and differences of nearly equal indices lose their digits: no verdict of
// etak uses them. `etak stability` shows what they give beside etak's own.

// Electric and magnetic field at the upper side of a stack, for both polarisations.
struct NaiveStack {
  Complex e_s;
  Complex h_s;
  Complex e_p;
  Complex h_p;
};

// N cos of a medium: the root of N^2 - n0^2 sin^2.
Complex naive_step(real n0, real c, real n, real k) {
  real re = n * n - k * k - n0 * n0 * (1 - c * c);
  real im = 2 * n * k;
  real size = sqrt(re * re + im * im);
  return complex_of(sqrt(max((size + re) / 2, real(0))), sqrt(max((size - re) / 2, real(0))));
}

// N / cos of a medium.
Complex naive_slope(Complex step, real n, real k) {
  return complex_quotient(complex_of(n * n - k * k, 2 * n * k), step);
}

NaiveStack naive_on(real n0, real c, real n, real k) {
  NaiveStack stack;
  stack.e_s = complex_of(real(1), real(0));
  stack.e_p = stack.e_s;
  stack.h_s = naive_step(n0, c, n, k);
  stack.h_p = naive_slope(stack.h_s, n, k);
  return stack;
}

NaiveStack naive_over(NaiveStack under, real n0, real c, real n, real k, real turns) {
  Complex step = naive_step(n0, c, n, k);
  Complex slope = naive_slope(step, n, k);
  real grows = exp(turns * step.im);
  real cosine_h = (grows + 1 / grows) / 2;
  real sine_h = (grows - 1 / grows) / 2;
  Complex cosine = complex_of(cos(turns * step.re) * cosine_h, -sin(turns * step.re) * sine_h);
  Complex sine = complex_of(cos(turns * step.re) * sine_h, -sin(turns * step.re) * cosine_h);  // times -i
  NaiveStack stack;
  stack.e_s = complex_sum(complex_product(cosine, under.e_s), complex_quotient(complex_product(sine, under.h_s), step));
  stack.h_s = complex_sum(complex_product(complex_product(sine, step), under.e_s), complex_product(cosine, under.h_s));
  stack.e_p = complex_sum(complex_product(cosine, under.e_p), complex_quotient(complex_product(sine, under.h_p), slope));
  stack.h_p = complex_sum(complex_product(complex_product(sine, slope), under.e_p), complex_product(cosine, under.h_p));
  return stack;
}

real naive_seen(Complex e, Complex h, real y) {
  Complex in_front = complex_of(e.re * y, e.im * y);
  return complex_square(complex_quotient(complex_difference(in_front, h), complex_sum(in_front, h)));
}

real naive_mean(NaiveStack stack, real n0, real c) {
  return (naive_seen(stack.e_s, stack.h_s, n0 * c) + naive_seen(stack.e_p, stack.h_p, n0 / c)) / 2;
}
