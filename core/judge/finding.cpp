// SPDX-License-Identifier: Apache-2.0
#include "core/judge/finding.h"

#include "core/judge/target.h"

namespace etak {

std::string_view name(Severity severity) {
  switch (severity) {
    case Severity::off:
      return "off";
    case Severity::info:
      return "info";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "";
}

std::optional<Severity> severity_named(std::string_view text) {
  for (const Severity severity : {Severity::off, Severity::info, Severity::warning, Severity::error})
    if (text == name(severity)) return severity;
  return std::nullopt;
}

const CheckTarget& CheckedFile::target_of(const Finding& finding) const {
  for (const auto& tile : tiles)
    if (tile->tile == finding.tile) return *tile;
  return *target;
}

}  // namespace etak
