// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/iridescence/form.h"

namespace etak {

// The rows of the table, in the files of this folder.
#define ETAK_FILM_FORM(name) extern const FilmForm film_form_##name;
#include "core/iridescence/forms/forms.inc"
#undef ETAK_FILM_FORM

}  // namespace etak
