// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/iridescence/form.h"

namespace etak {

// OpenPBR's numbers, which its renderers share; the thickness in nm.
inline constexpr std::array<FilmNumber, 9> open_pbr_metal_numbers{{{"base_color.r"},
                                                                   {"base_color.g"},
                                                                   {"base_color.b"},
                                                                   {"specular_color.r"},
                                                                   {"specular_color.g"},
                                                                   {"specular_color.b"},
                                                                   {"thin_film_ior", 1, 3},
                                                                   {"thin_film_thickness", 1, 1200},
                                                                   {"thin_film_weight"}}};
inline constexpr std::array<FilmNumber, 7> open_pbr_dielectric_numbers{{{"specular_color.r"},
                                                                        {"specular_color.g"},
                                                                        {"specular_color.b"},
                                                                        {"specular_ior", 1, 3},
                                                                        {"thin_film_ior", 1, 3},
                                                                        {"thin_film_thickness", 1, 1200},
                                                                        {"thin_film_weight"}}};
FilmNumbers open_pbr_metal_honest(const FilmFacts& facts);
FilmNumbers open_pbr_dielectric_honest(const FilmFacts& facts);

// The rows of the table, in the files of this folder.
#define ETAK_FILM_FORM(name) extern const FilmForm film_form_##name;
#include "core/iridescence/forms/forms.inc"
#undef ETAK_FILM_FORM

}  // namespace etak
