// SPDX-License-Identifier: Apache-2.0
#include "core/validate/finding.h"

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

}  // namespace etak
