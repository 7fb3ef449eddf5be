// SPDX-License-Identifier: Apache-2.0
// Reflectance of homogeneous layers on a base, under a medium that does not absorb. Based on:
//   Born and Wolf, "Principles of Optics", section 1.6; Heavens 1955, "Optical Properties of Thin Solid Films": the
//   recursion of amplitudes from the base outwards
// Waves go as exp(-i w t), so that N = n + i k has k >= 0. The recursion multiplies by the wave's decay on its way through a
// layer and back, which is never above 1: nothing overflows for opaque layers, as products of matrices do.
//   n0   index of the outside medium
//   c    cosine of incidence there, [0, 1]

struct Complex {
  real re;
  real im;
};

Complex complex_of(real re, real im) {
  Complex number;
  number.re = re;
  number.im = im;
  return number;
}

Complex complex_product(Complex a, Complex b) {
  return complex_of(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re);
}

Complex complex_sum(Complex a, Complex b) {
  return complex_of(a.re + b.re, a.im + b.im);
}

Complex complex_difference(Complex a, Complex b) {
  return complex_of(a.re - b.re, a.im - b.im);
}

Complex complex_quotient(Complex a, Complex b) {
  real inverse = 1 / max(b.re * b.re + b.im * b.im, tiny);
  return complex_of((a.re * b.re + a.im * b.im) * inverse, (a.im * b.re - a.re * b.im) * inverse);
}

real complex_square(Complex a) {
  return a.re * a.re + a.im * a.im;
}

// A wave in a medium.
//   index  N of the medium
//   q      n0^2 times the squared sine of incidence, which all media of a stack have alike
//   w      1 / N^2
//   s, p   N cos and cos / N, by which media differ for light polarised across and along the plane of incidence
struct FilmWave {
  Complex index;
  real q;
  Complex w;
  Complex s;
  Complex p;
};

// The square of N cos is N^2 - q. Of its two forms that one is taken whose parts cancel less: near normal incidence
// n^2 - k^2 - q, at grazing angles (n - n0)(n + n0) - k^2 + (n0 c)^2.
FilmWave film_wave(real n0, real c, real n, real k) {
  FilmWave wave;
  wave.index = complex_of(n, k);
  wave.q = n0 * n0 * ((1 - c) * (1 + c));
  real grazing = n0 * c * (n0 * c);
  real excess = (n - n0) * (n + n0);
  real x_normal = (n - k) * (n + k) - wave.q;
  real x_grazing = excess - k * k + grazing;
  real x = max(n * n, wave.q) < max(abs(excess), grazing) ? x_normal : x_grazing;
  real y = 2 * n * k;
  real big = sqrt((sqrt(x * x + y * y) + abs(x)) / 2);
  real small = y / (2 * max(big, tiny));
  wave.s = complex_of(x < 0 ? small : big, x < 0 ? big : small);
  real inverse = 1 / max(n * n + k * k, tiny);
  wave.w = complex_of((n - k) * (n + k) * inverse * inverse, -y * inverse * inverse);
  wave.p = complex_product(wave.s, wave.w);
  return wave;
}

// Amplitudes of both polarisations.
struct FilmPair {
  Complex s;
  Complex p;
};

// What an interface reflects of a wave in `a` that meets `b`. Differences are formed from N_a - N_b alone, so that media
// of nearly the same index keep their digits: (a - b) / (a + b) = (a^2 - b^2) / (a + b)^2, and the same for cos / N.
FilmPair film_interface(FilmWave a, FilmWave b) {
  Complex squares = complex_product(complex_difference(a.index, b.index), complex_sum(a.index, b.index));
  Complex s = complex_sum(a.s, b.s);
  Complex p = complex_sum(a.p, b.p);
  Complex brewster = complex_of(a.q * (a.w.re + b.w.re) - 1, a.q * (a.w.im + b.w.im));
  FilmPair r;
  r.s = complex_quotient(complex_quotient(squares, s), s);
  r.p = complex_product(complex_quotient(complex_product(squares, a.w), p),
                        complex_quotient(complex_product(brewster, b.w), p));
  return r;
}

// The amplitude that a wave keeps on its way through a layer and back, exp(2 i phase).
//   s       N cos of the wave in the layer
//   turns   2 pi times the layer's thickness over the wavelength in vacuum
Complex film_way_back(Complex s, real turns) {
  real decay = exp(-2 * turns * s.im);
  real angle = 2 * turns * s.re;
  return complex_of(decay * cos(angle), decay * sin(angle));
}

// The amplitude that is seen above an interface that reflects `above`, where `back` comes back to its lower side.
Complex film_seen(Complex above, Complex back) {
  Complex under = complex_product(above, back);
  under.re = under.re + 1;
  return complex_quotient(complex_sum(above, back), under);
}

FilmPair film_seen(FilmPair above, FilmPair back) {
  FilmPair seen;
  seen.s = film_seen(above.s, back.s);
  seen.p = film_seen(above.p, back.p);
  return seen;
}

// What comes back to the upper side of a layer of what its lower side reflects.
FilmPair film_back(FilmPair below, Complex way) {
  FilmPair back;
  back.s = complex_product(below.s, way);
  back.p = complex_product(below.p, way);
  return back;
}

// At normal incidence, where both polarisations are one and N cos is N.
//   a, b   N of the media above and below
Complex film_interface_ahead(Complex a, Complex b) {
  return complex_quotient(complex_difference(a, b), complex_sum(a, b));
}

// A stack from the base up, a layer at a time: film_mean(film_over(film_on(n0, c, n, k), n0, c, n1, k1, turns1), n0, c) is
// the reflectance of one layer on a base, and so on for any number.
//   top    the wave in the outermost medium so far
//   back   the amplitude that comes back to its upper side from below; 0 in the base
struct FilmStack {
  FilmWave top;
  FilmPair back;
};

// The base.
FilmStack film_on(real n0, real c, real n, real k) {
  FilmStack stack;
  stack.top = film_wave(n0, c, n, k);
  stack.back.s = complex_of(real(0), real(0));
  stack.back.p = stack.back.s;
  return stack;
}

// A layer on what is there.
//   turns   2 pi times the layer's thickness over the wavelength in vacuum
FilmStack film_over(FilmStack under, real n0, real c, real n, real k, real turns) {
  FilmStack stack;
  stack.top = film_wave(n0, c, n, k);
  FilmPair below = film_seen(film_interface(stack.top, under.top), under.back);
  stack.back = film_back(below, film_way_back(stack.top.s, turns));
  return stack;
}

// The unpolarised reflectance under the outside medium.
real film_mean(FilmStack stack, real n0, real c) {
  FilmPair r = film_seen(film_interface(film_wave(n0, c, n0, real(0)), stack.top), stack.back);
  return (complex_square(r.s) + complex_square(r.p)) / 2;
}
