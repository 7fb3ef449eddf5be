// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/film/stack.h"

namespace etak {

/// film_reflectance() of coherent layers, in vector lanes over the wavelengths. The cosine is above 0.
void film_lanes(const FilmSpectra& film, double cosine, std::span<double> out);

}  // namespace etak
