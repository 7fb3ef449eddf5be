// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/rii/sample_name.h"

#include <algorithm>

#include "core/base/text/ascii.h"

namespace etak {
namespace {

// "25nm" as "25 nm".
std::string with_unit_apart(std::string_view part) {
  const auto letter = std::ranges::find_if(part, is_letter);
  const bool measure = letter != part.begin() && letter != part.end() &&
                       std::all_of(part.begin(), letter, [](char c) { return is_digit(c) || c == '.'; }) &&
                       std::all_of(letter, part.end(), is_letter);
  if (!measure) return std::string(part);
  return std::string(part.begin(), letter) + ' ' + std::string(letter, part.end());
}

}  // namespace

std::string sample_name(std::string_view book, std::string_view page, int year) {
  const std::string known_year = std::to_string(year);
  const std::size_t dash = page.find('-');
  std::string out = std::string(book) + ", " + std::string(page.substr(0, dash));
  if (year != 0) out += ' ' + known_year;
  for (std::size_t at = dash; at != page.npos;) {
    const std::size_t next = page.find('-', at + 1);
    const std::string_view part = page.substr(at + 1, next == page.npos ? next : next - at - 1);
    if (!part.empty() && (year == 0 || part != known_year)) out += ", " + with_unit_apart(part);
    at = next;
  }
  return out;
}

}  // namespace etak
