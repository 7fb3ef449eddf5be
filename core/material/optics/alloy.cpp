// SPDX-License-Identifier: Apache-2.0
#include "core/material/optics/alloy.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/material/names.h"
#include "core/material/optics/optics_at.h"
#include "core/material/stack_text.h"

namespace etak {
namespace {

constexpr double same_fraction = 1e-9;

const OpticalConstants& constants_of(const Dataset& dataset) {
  return std::get<OpticalConstants>(dataset.optics);
}

// The compositions by their fractions.
std::vector<std::pair<double, const Dataset*>> compositions(const Material& series) {
  std::vector<std::pair<double, const Dataset*>> out;
  for (const Dataset& each : series.datasets) {
    double fraction = 0;
    (void)parse_number(each.id, fraction);
    out.emplace_back(fraction, &each);
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string fraction_text(double fraction) {
  return number(fraction, 4);
}

// The wavelengths of two tables where both have values.
std::vector<double> shared_wavelengths(const Spectrum& a, const Spectrum& b) {
  std::vector<double> out;
  std::set_union(a.wavelength_nm.begin(), a.wavelength_nm.end(), b.wavelength_nm.begin(),
                 b.wavelength_nm.end(), std::back_inserter(out));
  const double first = std::max(a.first_nm(), b.first_nm()), last = std::min(a.last_nm(), b.last_nm());
  std::erase_if(out, [&](double nm) { return nm < first || nm > last; });
  return out;
}

Spectrum between(const Spectrum& a, const Spectrum& b, double share, std::string_view text) {
  Spectrum out{shared_wavelengths(a, b), {}};
  if (out.empty()) throw Error::at(text, "its neighbours share no wavelength", "another composition");
  out.value = values_at(a, out.wavelength_nm, text);
  const std::vector<double> other = values_at(b, out.wavelength_nm, text);
  for (std::size_t i = 0; i < other.size(); ++i) out.value[i] += share * (other[i] - out.value[i]);
  return out;
}

}  // namespace

std::optional<AlloyText> read_alloy(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  if (colon == text.npos || colon == 0 || !is_fraction(text.substr(colon + 1))) return std::nullopt;
  AlloyText out{text.substr(0, colon), 0};
  (void)parse_number(text.substr(colon + 1), out.fraction);
  return out;
}

bool is_series(const Material& material) {
  return material.datasets.size() > 1 &&
         std::all_of(material.datasets.begin(), material.datasets.end(), [](const Dataset& each) {
           const auto* constants = std::get_if<OpticalConstants>(&each.optics);
           return is_fraction(each.id) && constants != nullptr && constants->k &&
                  std::holds_alternative<Spectrum>(constants->n);
         });
}

Material alloy(const Material& series, double fraction, std::string_view text, double widest) {
  const auto known = compositions(series);
  const std::string place = printable(text);
  const auto upper = std::find_if(known.begin(), known.end(),
                                  [&](const auto& each) { return each.first >= fraction - same_fraction; });
  const bool exact = upper != known.end() && upper->first <= fraction + same_fraction;
  const std::string of = " of " + series.preferred_reason;
  if (upper == known.end() || (upper == known.begin() && !exact))
    throw Error::at(place, fraction_text(fraction) + " is outside of what is measured",
                    fraction_text(known.front().first) + " to " + fraction_text(known.back().first) + of);
  Material out = series;
  out.name = series.name + " " + fraction_text(fraction);
  out.id = identifier(series.id + " " + fraction_text(fraction), '_', series.id);
  out.aliases.clear();
  out.preferred = 0;
  if (exact) {
    out.datasets = {*upper->second};
    return out;
  }
  const auto& [low, a] = *std::prev(upper);
  const auto& [high, b] = *upper;
  const std::string neighbours = fraction_text(low) + " and " + fraction_text(high);
  if (high - low > widest + same_fraction)
    throw Error::at(place, "the nearest that are measured, " + neighbours + of + ", are too far apart",
                    "neighbours at most " + fraction_text(widest) + " apart");
  Dataset dataset = *a;
  const double share = (fraction - low) / (high - low);
  const OpticalConstants &from = constants_of(*a), &to = constants_of(*b);
  dataset.citation.via += " and " + b->citation.via;
  dataset.id = a->id + "-" + b->id;
  dataset.optics =
      OpticalConstants{between(std::get<Spectrum>(from.n), std::get<Spectrum>(to.n), share, place),
                       between(*from.k, *to.k, share, place)};
  dataset.sample = fraction_text(fraction) + of + ", n and k linear between " + neighbours;
  dataset.flags |= b->flags;
  out.datasets = {std::move(dataset)};
  return out;
}

}  // namespace etak
