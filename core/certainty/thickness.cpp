// SPDX-License-Identifier: Apache-2.0
#include "core/certainty/thickness.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/color/delta_e.h"
#include "core/material/optics/optics_at.h"
#include "core/material/seen_stack.h"

namespace etak {
namespace {

// How badly a thickness fits.
using Misfit = std::function<double(double)>;

constexpr double step_nm = 1;
constexpr double exact_nm = 1e-4;
constexpr auto steps = static_cast<std::size_t>(most_thickness_nm / step_nm);

// The thickness of the least misfit within an interval that has one minimum, by golden section.
double least_within(const Misfit& misfit, double first, double last) {
  constexpr double golden = 0.6180339887498949;
  double a = last - golden * (last - first), b = first + golden * (last - first);
  double at_a = misfit(a), at_b = misfit(b);
  while (last - first > exact_nm) {
    if (at_a <= at_b) {
      last = b;
      b = a;
      at_b = at_a;
      a = last - golden * (last - first);
      at_a = misfit(a);
    } else {
      first = a;
      a = b;
      at_a = at_b;
      b = first + golden * (last - first);
      at_b = misfit(b);
    }
  }
  return (first + last) / 2;
}

// All thicknesses that are minima, ascending.
std::vector<FittedThickness> minima(const Misfit& misfit) {
  std::vector<double> values(steps + 1);
  for (std::size_t i = 0; i <= steps; ++i) values[i] = misfit(step_nm * double(i));
  std::vector<FittedThickness> out;
  for (std::size_t i = 0; i <= steps; ++i) {
    const bool falls = i == 0 || values[i] < values[i - 1], rises = i == steps || values[i] <= values[i + 1];
    if (!falls || !rises) continue;
    const double first = step_nm * double(i == 0 ? 0 : i - 1),
                 last = step_nm * double(std::min(i + 1, steps));
    double best = least_within(misfit, first, last);
    if (misfit(step_nm * double(i)) <= misfit(best)) best = step_nm * double(i);
    out.push_back({best, {best, best}, misfit(best)});
  }
  return out;
}

// The farthest thickness in one direction up to which the misfit stays within a limit.
double edge(const Misfit& misfit, double inside, double direction, double limit) {
  double outside = inside;
  for (;;) {
    outside = std::clamp(inside + direction * step_nm, 0.0, most_thickness_nm);
    if (outside == inside) return inside;
    if (misfit(outside) > limit) break;
    inside = outside;
  }
  while (std::abs(outside - inside) > exact_nm) {
    const double middle = (inside + outside) / 2;
    (misfit(middle) > limit ? outside : inside) = middle;
  }
  return inside;
}

// The minima within a limit, best first, each with its interval; of those that share one the best.
std::vector<FittedThickness> within(const Misfit& misfit, std::vector<FittedThickness> found, double limit) {
  std::erase_if(found, [&](const FittedThickness& each) { return each.misfit > limit; });
  std::stable_sort(found.begin(), found.end(),
                   [](const FittedThickness& a, const FittedThickness& b) { return a.misfit < b.misfit; });
  std::vector<FittedThickness> out;
  for (FittedThickness& each : found) {
    const bool known = std::any_of(out.begin(), out.end(), [&](const FittedThickness& other) {
      return each.thickness_nm >= other.interval_nm[0] && each.thickness_nm <= other.interval_nm[1];
    });
    if (known) continue;
    each.interval_nm = {edge(misfit, each.thickness_nm, -1, limit),
                        edge(misfit, each.thickness_nm, 1, limit)};
    out.push_back(each);
  }
  return out;
}

// Student's t for a large number of degrees of freedom, from the normal quantile (Cornish and Fisher's first term).
double student_t(double normal, double freedom) {
  return normal + (normal * normal * normal + normal) / (4 * freedom);
}
constexpr double normal_90 = 1.644854, normal_999 = 3.290527;

}  // namespace

std::vector<FittedThickness> thickness_of_colour(const Stack& stack, std::size_t layer,
                                                 const LinearRgb& colour, double tolerance,
                                                 const F0Options& options) {
  SeenStack seen(stack, options);
  const Lab wanted = to_lab(colour);
  const Misfit misfit = [&](double thickness_nm) {
    seen.set_thickness(layer, thickness_nm);
    return delta_e2000(wanted, to_lab(to_rgb(seen(1))));
  };
  return within(misfit, minima(misfit), tolerance);
}

SpectrumFit thickness_of_spectrum(const Stack& stack, std::size_t layer, const Spectrum& measured,
                                  const F0Options& options) {
  constexpr std::size_t least_samples = 10;
  SeenStack seen(stack, options);
  std::vector<double> at_nm, wanted;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const double wavelength = measured.wavelength_nm[i];
    if (wavelength < grid_first_nm || wavelength > grid_last_nm) continue;
    at_nm.push_back(wavelength);
    wanted.push_back(measured.value[i]);
  }
  if (at_nm.size() < least_samples)
    throw Error::at(stack.text,
                    std::to_string(at_nm.size()) + " samples of the measurement within 360-830 nm",
                    "at least 10");
  const FilmSpectra& film = seen.spectra();
  std::vector<double> reflectance(film.wavelength_nm.size());
  const auto model = [&](double thickness_nm) {
    seen.set_thickness(layer, thickness_nm);
    film_reflectance(film, 1, reflectance);
    return values_at({{film.wavelength_nm.begin(), film.wavelength_nm.end()}, reflectance}, at_nm,
                     "the model");
  };
  const Misfit misfit = [&](double thickness_nm) {
    const std::vector<double> values = model(thickness_nm);
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += (values[i] - wanted[i]) * (values[i] - wanted[i]);
    return sum;
  };
  const std::vector<FittedThickness> found = minima(misfit);
  const double least =
      std::min_element(found.begin(), found.end(), [](const FittedThickness& a, const FittedThickness& b) {
        return a.misfit < b.misfit;
      })->misfit;
  const double freedom = double(at_nm.size() - 1);
  const auto limit = [&](double normal) {
    const double t = student_t(normal, freedom);
    return least * (1 + t * t / freedom);
  };
  SpectrumFit out;
  out.best = within(misfit, found, limit(normal_90)).front();
  const double count = double(at_nm.size());
  for (FittedThickness& each : within(misfit, found, limit(normal_999))) {
    if (each.thickness_nm == out.best.thickness_nm) continue;
    each.misfit = std::sqrt(each.misfit / count);
    out.others.push_back(each);
  }
  out.best.misfit = std::sqrt(out.best.misfit / count);
  const F0Solver solver{options};
  const F0Result seen_colour = solver.solve(Reflectance{measured});
  seen.set_thickness(layer, out.best.thickness_nm);
  if (!seen_colour.refused())
    out.delta_e = delta_e2000(to_lab(seen_colour.srgb_linear), to_lab(to_rgb(seen(1))));
  return out;
}

}  // namespace etak
