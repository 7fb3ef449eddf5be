// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/material/f0/f0_settings.h"

namespace etak {

/// Opens the files that `observer` and `illuminant` name: what is none of their words is a table of wavelength with x, y
/// and z, or with power, read as parse_columns() does. Throws Error that names the file and the place in it, or
/// the setting where there is no such file.
void open_viewing(F0Settings& settings);

}  // namespace etak
