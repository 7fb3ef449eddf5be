// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "app/python/module.h"
#include "core/validate/config.h"
#include "core/validate/validate.h"

namespace etak::python {

/// etak.Report: what the validator found.
struct Report {
  std::shared_ptr<const ValidationReport> report;
  Severity fail_on = Severity::error;
  bool never_fails = false;  // for findings; what could not be checked fails all the same

  bool passed() const { return report->passed || (never_fails && !report->incomplete); }
};

/// The settings of a check that a dictionary holds by their keywords.
ValidateSettings check_settings(const py::dict& given);

/// A list of texts, of a keyword that takes one text or several.
std::vector<std::string> texts_of(const py::handle& value, const std::string& name);

}  // namespace etak::python
