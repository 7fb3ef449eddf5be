// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace etak {

// Limits of the files of materials in every format: larger values are of a wrong unit or a broken file.

/// Bytes that the name of a material may have in the files of materials, manifests and projects. Every list,
/// tree and message that shows a name lays it out whole, and no person reads a longer one.
inline constexpr std::size_t most_name_bytes = 1000;

/// Largest index n and extinction k.
inline constexpr double most_n = 1e4, most_k = 1e6;

/// Longest wavelength: a kilometre.
inline constexpr double most_wavelength_nm = 1e12;

}  // namespace etak
