// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace etak {

/// A quantity tabulated over wavelength: n, k, reflectance, a colour-matching function, an illuminant.
///   wavelength_nm   vacuum wavelength in nanometres, strictly ascending, positive
///   value           one per wavelength; what it is and its unit depend on the use
struct Spectrum {
  std::vector<double> wavelength_nm;
  std::vector<double> value;

  std::size_t size() const { return wavelength_nm.size(); }
  bool empty() const { return wavelength_nm.empty(); }
  double first_nm() const { return wavelength_nm.front(); }
  double last_nm() const { return wavelength_nm.back(); }
  friend bool operator==(const Spectrum&, const Spectrum&) = default;
};

/// Throws Error (naming `what` and the first offending wavelength) unless the spectrum holds at least one
/// sample, all numbers are finite and the wavelengths are positive and strictly ascending.
void validate(const Spectrum& spectrum, std::string_view what);

/// Micrometres with the digits that their source printed; none where no 15 digits read back as the same nanometres, and
/// of several wavelengths where one of them has none.
std::optional<double> in_micrometres(double nm);
std::optional<std::vector<double>> in_micrometres(const std::vector<double>& wavelengths_nm);

/// The reference grid: 360, 361, ..., 830 nm.
inline constexpr int grid_first_nm = 360;
inline constexpr int grid_last_nm = 830;
inline constexpr std::size_t grid_size = grid_last_nm - grid_first_nm + 1;

/// The range of visible light that tables are asked to cover, the shorter one of ASTM E308.
inline constexpr double visible_first_nm = 380;
inline constexpr double visible_last_nm = 780;

/// The range every F0 result reports on: samples and gaps are counted here.
inline constexpr double core_first_nm = 400;
inline constexpr double core_last_nm = 700;

}  // namespace etak
