// SPDX-License-Identifier: Apache-2.0
#include "core/material/seen_stack.h"

#include <vector>

#include "core/base/error.h"
#include "core/base/text/ascii.h"
#include "core/material/f0_steps.h"

namespace etak {

struct SeenStack::State {
  F0Setup setup;
  StackSpectra spectra = {};  // with views into the setup

  Vec3 seen(std::span<const double> values) const {
    return setup.spaces.to_srgb * setup.quadrature.integrate(values);
  }
};

SeenStack::SeenStack(const Stack& stack, F0Options options, Method sum) {
  options.method = sum;
  state_ = std::make_unique<State>(State{f0_setup(std::move(options))});
  const F0Setup& setup = state_->setup;
  if (const std::string why = stack_spectra(setup, stack, setup.quadrature, state_->spectra); !why.empty())
    throw Error::at(printable(stack.text, 80), why);
}
SeenStack::~SeenStack() = default;
SeenStack::SeenStack(SeenStack&&) noexcept = default;

Vec3 SeenStack::operator()(double cosine) const {
  std::vector<double> reflectance(spectra().wavelength_nm.size());
  film_reflectance(spectra(), cosine, reflectance);
  return state_->seen(reflectance);
}

Vec3 SeenStack::passed_twice(double cosine) const {
  const FilmSpectra& film = spectra();
  std::vector<double> passed(film.wavelength_nm.size());
  for (std::size_t i = 0; i < passed.size(); ++i) {
    const auto [s, p] = film_light(film_at(film, i), film.wavelength_nm[i], cosine).passed;
    passed[i] = (s * s + p * p) / 2;
  }
  return state_->seen(passed);
}

const FilmSpectra& SeenStack::spectra() const {
  return state_->spectra.film;
}

void SeenStack::set_thickness(std::size_t layer, double thickness_nm) {
  state_->spectra.film.layers.at(layer).thickness_nm = thickness_nm;
}

}  // namespace etak
