// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/color/rgb.h"

namespace etak {

// Films as renderers take them: a few numbers and a formula that each renderer has published. The formulas are written
// from their published definitions, which each row cites; they are here to be judged, and etak draws nothing by them.

/// A number that a form takes.
///   name          as the target calls it; colours have ".r", ".g", ".b"
///   least, most   the range in which it is fitted: the target's own, or narrower where the target has none
struct FilmNumber {
  std::string_view name;
  double least = 0, most = 1;
};
inline constexpr std::size_t most_film_numbers = 12;
using FilmNumbers = std::array<double, most_film_numbers>;

/// What an author knows of one film on a base, and types in.
///   base_f0, base_f82   of the bare base in air, linear sRGB, unclipped; whole_f0, whole_f82 with the film
///   base_n, base_k      of the base, for red, green and blue
///   film_n              of the film at 550 nm
struct FilmFacts {
  LinearRgb base_f0 = {}, base_f82 = {}, whole_f0 = {}, whole_f82 = {};
  Vec3 base_n{1, 1, 1}, base_k{};
  double film_n = 1, thickness_nm = 0;
};

/// What a film lies on.
enum class FilmBase { metal, dielectric };

/// A form: one file of core/iridescence/forms and one row of forms.inc.
///   definition   where its formula is published, with the version
///   metal, dielectric   the bases that it has
///   numbers      as many as it takes, at most most_film_numbers
///   index        which of them is the film's index; its thickness in nm follows. The number of numbers: it has no film
///   seen         F at a cosine of incidence above 0, linear sRGB; in air
///   honest       the numbers of a film as they are known, not yet brought into their ranges
struct FilmForm {
  std::string_view id, title, definition;
  bool metal = true, dielectric = true;
  std::span<const FilmNumber> numbers;
  std::size_t index;
  Vec3 (*seen)(const FilmNumbers& numbers, double cosine);
  FilmNumbers (*honest)(const FilmFacts& facts);

  bool has_film() const { return index < numbers.size(); }
  bool has(FilmBase base) const { return base == FilmBase::metal ? metal : dielectric; }
};

/// All forms, in the order of forms.inc.
std::span<const FilmForm* const> film_forms();
const FilmForm* film_form(std::string_view id);

}  // namespace etak
