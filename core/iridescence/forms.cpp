// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/iridescence/forms/rows.h"

namespace etak {

std::span<const FilmForm* const> film_forms() {
  static constexpr const FilmForm* rows[] = {
#define ETAK_FILM_FORM(name) &film_form_##name,
#include "core/iridescence/forms/forms.inc"
#undef ETAK_FILM_FORM
  };
  return rows;
}

const FilmForm* film_form(std::string_view id) {
  const auto rows = film_forms();
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const FilmForm* row) { return row->id == id; });
  return found == rows.end() ? nullptr : *found;
}

}  // namespace etak
