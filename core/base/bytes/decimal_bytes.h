// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace etak {

/// The numbers as decimal mantissas, in the fewest bytes of five forms: as they are or as first or second differences
/// under one exponent, each with an exponent of its own, or as doubles. Numbers with three to six digits, as tables
/// print them, take one to three bytes each. Every double is read back bit for bit, those that are not finite too.
std::string decimal_bytes(const std::vector<double>& values);

/// Reads what decimal_bytes() wrote. Returns false for other bytes, of which nothing is read beyond their end.
bool read_decimal_bytes(std::string_view bytes, std::vector<double>& out);

}  // namespace etak
