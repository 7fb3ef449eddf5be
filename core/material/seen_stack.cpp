// SPDX-License-Identifier: Apache-2.0
#include "core/material/seen_stack.h"

#include <vector>

#include "core/base/error.h"
#include "core/base/text/ascii.h"
#include "core/fresnel/fresnel.h"
#include "core/material/f0/f0_steps.h"

namespace etak {

struct SeenStack::State {
  F0Setup setup;
  StackSpectra spectra = {};           // with views into the setup
  std::vector<double> n = {}, k = {};  // of bare_index()
};

SeenStack::SeenStack(const Optics& optics, F0Options options, Method sum, std::string_view what) {
  options.method = sum;
  state_ = std::make_unique<State>(State{f0_setup(std::move(options))});
  const F0Setup& setup = state_->setup;
  const Stack stack = stack_of(optics);
  if (const std::string why = stack_spectra(setup, stack, setup.quadrature, state_->spectra); !why.empty())
    throw Error::at(stack.text.empty() ? std::string(what) : printable(stack.text, 80), why);
  const FilmSpectra& film = spectra();
  for (std::size_t i = 0; i < film.outside.size() && film.layers.empty(); ++i) {
    state_->n.push_back(film.base.n[i] / film.outside[i]);
    state_->k.push_back(film.base.k[i] / film.outside[i]);
  }
}
SeenStack::~SeenStack() = default;
SeenStack::SeenStack(SeenStack&&) noexcept = default;

Vec3 SeenStack::operator()(double cosine) const {
  std::vector<double> reflectance(spectra().wavelength_nm.size());
  if (const auto [n, k] = bare_index(); !n.empty())
    f64::fresnel_exact(n, k, cosine, reflectance);
  else
    film_reflectance(spectra(), cosine, reflectance);
  return seen(reflectance);
}

Vec3 SeenStack::passed_twice(double cosine) const {
  const FilmSpectra& film = spectra();
  std::vector<double> passed(film.wavelength_nm.size());
  for (std::size_t i = 0; i < passed.size(); ++i) {
    const auto [s, p] = film_light(film_at(film, i), film.wavelength_nm[i], cosine).passed;
    passed[i] = (s * s + p * p) / 2;
  }
  return seen(passed);
}

Vec3 SeenStack::seen(std::span<const double> values) const {
  return state_->setup.spaces.to_srgb * state_->setup.quadrature.integrate(values);
}

FilmSpectra::Medium SeenStack::bare_index() const {
  return {state_->n, state_->k};
}

const FilmSpectra& SeenStack::spectra() const {
  return state_->spectra.film;
}

void SeenStack::set_thickness(std::size_t layer, double thickness_nm) {
  state_->spectra.film.layers.at(layer).thickness_nm = thickness_nm;
}

}  // namespace etak
