// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/material/material.h"

namespace etak {

/// A name without what does not matter in a look-up: case, blanks, '-' and '_'.
std::string folded_name(std::string_view name);

/// The words of a name, views into it: blanks, '-', '_', ',' and brackets separate them.
std::vector<std::string_view> words_of(std::string_view name);

/// An id made of a text: ASCII letters in lower case and digits, one `separator` for whatever stands between
/// them. `otherwise` where the text has neither.
std::string identifier(std::string_view text, char separator, std::string_view otherwise);

/// A file's name without folders and ending.
std::string_view file_stem(std::string_view path);

/// Whether a name reads as a chemical formula: symbols of elements, each with or without a count of at most
/// three digits ("TiN", "SiO2", "Au80Ag20", "Si0.47Ge0.53", "In2O3-SnO2"). A formula is found in its own case
/// only, so that "tin" is not TiN and "co" not Co. An abbreviation that reads as a formula, such as PC, is
/// listed in lower case too where it is to be found in any case.
bool is_formula(std::string_view name);

/// How near a name comes to the one asked for; less is nearer.
struct NameDistance {
  /// In which way the names are alike, the nearest first.
  enum class Kind { same, word, edits };
  Kind kind = Kind::same;
  std::size_t amount = 0;  // letters that only one of them has, or edits
  friend auto operator<=>(const NameDistance&, const NameDistance&) = default;
};

/// Nothing where `known` does not come near enough to `asked` to be worth a suggestion, and where `asked` has more
/// than 100 bytes.
///   same    written alike but for case: a formula in another case
///   word    a whole word of three letters or more is in both ("steel", "stainless steel"), which is no
///           qualifier()
///   edits   the first letter is the same, and one letter is wrong, missing or too much, or two neighbours
///           are exchanged; of eight letters and more two such mistakes. Of names with less than four letters
///           none: ham is no misspelt hay
std::optional<NameDistance> name_distance(std::string_view asked, std::string_view known);

/// The datasets of `material` that `text` names: an id, the unique beginning of one, or with a '*' at the end
/// all that begin so. Throws Error with the ids it has, or with those that begin so, where there is none or
/// more than one.
///   label   name for messages
std::vector<const Dataset*> datasets_named(const Material& material, std::string_view text,
                                           std::string_view label);

/// The one dataset that the text names; the preferred one where `text` is empty.
const Dataset& dataset_named(const Material& material, std::string_view text, std::string_view label);

/// What `notes` of a material say where it is asked for as `name`, a view into them; empty: nothing.
std::string_view alias_note(const std::vector<AliasNote>& notes, std::string_view name);

}  // namespace etak
