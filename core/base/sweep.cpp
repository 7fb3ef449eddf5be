// SPDX-License-Identifier: Apache-2.0
#include "core/base/sweep.h"

#include <cmath>

#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"

namespace etak {
namespace {

// None where the parts are no steps.
std::vector<std::string> even_steps(const std::vector<std::string>& parts, const SweepForm& form) {
  double first = 0, last = 0, count = 0;
  if (parts.size() != 3 || !form.read(parts[0], first) || !form.read(parts[1], last) ||
      !parse_number(parts[2], count) ||
      !(count <= static_cast<double>(form.most) && count == std::floor(count)))
    return {};
  std::vector<std::string> out;
  for (double i = 0; i < count; ++i)
    out.push_back(number(std::lerp(first, last, count > 1 ? i / (count - 1) : 0), 6) + form.unit);
  return out;
}

}  // namespace

Sweep parse_sweep(const std::string& text, const SweepForm& form) {
  Sweep out;
  if (const std::size_t equals = text.find('='); equals != text.npos && equals > 0) {
    out.name = text.substr(0, equals);
    const std::string values = text.substr(equals + 1);
    out.values =
        values.find(':') == values.npos ? parts_of(values, ',') : even_steps(parts_of(values, ':'), form);
  }
  if (out.values.size() < 2 || out.values.size() > form.most)
    throw Error::at(setting("sweep"), printable(text), form.expected);
  return out;
}

}  // namespace etak
