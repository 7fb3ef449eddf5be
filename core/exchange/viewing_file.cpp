// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/viewing_file.h"

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/setting.h"
#include "core/base/system.h"
#include "core/exchange/table.h"
#include "core/spectrum/own_viewing.h"

namespace etak {
namespace {

// The columns of the file that a setting names; none where it holds a word or nothing.
std::vector<Spectrum> columns_of(const char* name, const std::string& value, bool is_word, std::size_t count,
                                 const char* expected) {
  if (value.empty() || is_word) return {};
  if (sys::FileInfo info; !sys::file_info(value, info))
    throw Error::at(setting(name), printable(value), std::string(expected));
  std::string text;
  read_file(value, text);
  return parse_columns(text, value, count);
}

}  // namespace

void open_viewing(F0Settings& settings) {
  const auto observer =
      columns_of("observer", settings.observer, observer_named(settings.observer).has_value(), 3,
                 "1931-2deg, 1964-10deg or a file of wavelength, x, y and z");
  if (!observer.empty())
    settings.own_observer =
        observer_of_table({observer[0], observer[1], observer[2]}, settings.observer, settings.observer);
  const auto power =
      columns_of("illuminant", settings.illuminant, illuminant_named(settings.illuminant).has_value(), 1,
                 "D65, D50, A, E or a file of wavelength and power");
  if (!power.empty())
    settings.own_illuminant = illuminant_of_table(power[0], settings.illuminant, settings.illuminant);
}

}  // namespace etak
