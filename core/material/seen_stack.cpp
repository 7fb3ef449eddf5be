// SPDX-License-Identifier: Apache-2.0
#include "core/material/seen_stack.h"

#include <vector>

#include "core/base/error.h"
#include "core/base/text/ascii.h"
#include "core/material/f0_steps.h"

namespace etak {
namespace {

// All but method and space.
F0Options on_grid(const F0Options& options, Method sum) {
  F0Options out;
  out.method = sum;
  out.viewing = options.viewing;
  out.interpolation = options.interpolation;
  out.outside = options.outside;
  out.allow_extrapolation = options.allow_extrapolation;
  out.own_observer = options.own_observer;
  out.own_illuminant = options.own_illuminant;
  return out;
}

}  // namespace

struct SeenStack::State {
  F0Setup setup;
  StackSpectra spectra;
  FilmSpectra film;  // views into both
};

SeenStack::SeenStack(const Stack& stack, const F0Options& options, Method sum)
    : state_(std::make_unique<State>(State{f0_setup(on_grid(options, sum)), {}, {}})) {
  const Quadrature& q = state_->setup.quadrature;
  if (const std::string why = stack_spectra(state_->setup, stack, q, state_->spectra); !why.empty())
    throw Error::at(printable(stack.text, 80), why);
  state_->film = state_->spectra.film(stack, q);
}
SeenStack::~SeenStack() = default;
SeenStack::SeenStack(SeenStack&&) noexcept = default;

Vec3 SeenStack::operator()(double cosine) const {
  std::vector<double> reflectance(state_->film.wavelength_nm.size());
  film_reflectance(state_->film, cosine, reflectance);
  return state_->setup.spaces.to_srgb * state_->setup.quadrature.integrate(reflectance);
}

Vec3 SeenStack::passed_twice(double cosine) const {
  const FilmSpectra& film = state_->film;
  std::vector<double> passed(film.wavelength_nm.size());
  for (std::size_t i = 0; i < passed.size(); ++i) {
    const auto [s, p] = film_light(film_at(film, i), film.wavelength_nm[i], cosine).passed;
    passed[i] = (s * s + p * p) / 2;
  }
  return state_->setup.spaces.to_srgb * state_->setup.quadrature.integrate(passed);
}

const FilmSpectra& SeenStack::spectra() const {
  return state_->film;
}

void SeenStack::set_thickness(std::size_t layer, double thickness_nm) {
  state_->film.layers.at(layer).thickness_nm = thickness_nm;
}

}  // namespace etak
