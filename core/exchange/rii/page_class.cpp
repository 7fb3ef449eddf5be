// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/rii/page_class.h"

#include <algorithm>
#include <array>

#include "core/base/text/ascii.h"
#include "core/fresnel/fresnel.h"
#include "core/material/dispersion.h"
#include "core/material/f0.h"
#include "core/material/names.h"
#include "core/spectrum/interpolate.h"

namespace etak {
namespace {

constexpr std::array<double, 1> seen_nm{550};
constexpr double metal_k = 1, opaque_k = 1e-3;

constexpr std::array<std::string_view, 23> no_metals{"H",  "He", "B",  "C",  "N",  "O",  "F",  "Ne",
                                                     "Si", "P",  "S",  "Cl", "Ar", "Ge", "As", "Se",
                                                     "Br", "Kr", "Te", "I",  "Xe", "At", "Rn"};

bool is_metal(std::string_view book) {
  const bool element = book.size() == 1 || (book.size() == 2 && !is_upper(book[1]) && !is_digit(book[1]));
  return element && is_formula(book) && std::ranges::find(no_metals, book) == no_metals.end();
}

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

std::string_view class_of_page(const OpticalConstants& optics, std::string_view book) {
  constexpr std::string_view unknown = "crystal";
  if (!optics.k || optics.k->first_nm() > seen_nm[0] || optics.k->last_nm() < seen_nm[0]) return unknown;
  std::array<double, 1> n{}, k{};
  resample(*optics.k, Interpolation::linear, seen_nm, k);
  if (const auto* formula = std::get_if<DispersionFormula>(&optics.n))
    evaluate(*formula, seen_nm, n);
  else
    resample(std::get<Spectrum>(optics.n), Interpolation::linear, seen_nm, n);
  if (!(n[0] > 0) || f64::f0(n[0], k[0]) < forbidden_zone_first) return unknown;
  if (k[0] >= metal_k && is_metal(book)) return "metal";
  if (k[0] >= metal_k && k[0] > n[0]) return "conductor";
  return k[0] >= opaque_k ? "semiconductor" : unknown;
}

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
