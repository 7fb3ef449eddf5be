// SPDX-License-Identifier: Apache-2.0
#include "core/spectrum/spectrum.h"

#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/base/number.h"

namespace etak {

void validate(const Spectrum& spectrum, std::string_view what) {
  if (spectrum.value.size() != spectrum.size())
    throw Error::at(what, std::to_string(spectrum.size()) + " wavelengths and " +
                              std::to_string(spectrum.value.size()) + " values");
  if (spectrum.empty()) throw Error::at(what, "no samples", "at least one");
  for (std::size_t i = 0; i < spectrum.size(); ++i) {
    const double w = spectrum.wavelength_nm[i];
    if (!std::isfinite(w) || w <= 0)
      throw Error::at(what, "wavelength " + number(w, 9) + " nm", "a positive number");
    if (!std::isfinite(spectrum.value[i]))
      throw Error::at(what, number(spectrum.value[i], 9) + " at " + number(w, 9) + " nm", "a finite number");
    if (i > 0 && spectrum.wavelength_nm[i - 1] >= w)
      throw Error::at(what, number(w, 9) + " nm behind " + number(spectrum.wavelength_nm[i - 1], 9) + " nm",
                      "strictly ascending wavelengths");
  }
}

std::optional<double> in_micrometres(double nm) {
  double um = 0;
  if (parse_number(number(nm / 1000, 15), um) && um * 1000 == nm) return um;
  return std::nullopt;
}

std::optional<std::vector<double>> in_micrometres(const std::vector<double>& wavelengths_nm) {
  std::vector<double> out;
  for (const double nm : wavelengths_nm)
    if (const auto um = in_micrometres(nm))
      out.push_back(*um);
    else
      return std::nullopt;
  return out;
}

}  // namespace etak
