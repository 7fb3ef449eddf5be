// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "app/python/module.h"
#include "core/findings/report.h"
#include "core/validate/config.h"

namespace etak::python {

/// The settings of a check that a dictionary holds by their keywords.
ValidateSettings check_settings(const Keywords& given);

/// A function of Python that writes the report in the form of a name, for etak/documents.py.
py::function forms_of(std::shared_ptr<const ValidationReport> report, Severity fail_on);

}  // namespace etak::python
