// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the table reader answers with an Error or with optics that keep their promises. The
// first byte picks the options.
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "core/base/error.h"
#include "core/exchange/table.h"
#include "core/material/optics/medium.h"

using namespace etak;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::uint8_t pick = data[0];
  TableOptions options;
  if ((pick & 3) == 1) options.unit = WavelengthUnit::micrometre;
  if ((pick & 3) == 2) options.unit = WavelengthUnit::electronvolt;
  if ((pick & 4) != 0) options.columns = {"wavelength_nm", "n", "k"};
  if ((pick & 8) != 0) options.duplicates = Duplicates::first;
  if ((pick & 16) != 0) options.duplicates = Duplicates::mean;
  const std::vector<char> bytes(data + 1, data + size);
  Table table;
  try {
    table = parse_table({bytes.data(), bytes.size()}, "table", options);
  } catch (const Error&) {
    return 0;
  }
  if (const auto* reflectance = std::get_if<Reflectance>(&table.optics)) {
    validate(reflectance->spectrum, "R");
    for (const double r : reflectance->spectrum.value) assert(r >= 0 && r <= 1);
    return 0;
  }
  const auto& constants = std::get<OpticalConstants>(table.optics);
  validate(std::get<Spectrum>(constants.n), "n");
  for (const double n : std::get<Spectrum>(constants.n).value) assert(n >= 0);
  assert(!no_medium_at(constants));
  if (!constants.k) return 0;
  validate(*constants.k, "k");
  for (const double k : constants.k->value) assert(k >= 0);
  return 0;
}
