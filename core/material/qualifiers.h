// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/material/material.h"

namespace etak {

/// The groups and classes of what things are made of.
inline constexpr std::string_view solid_families =
    "metal alloy glass plastic building fabric leather paper rubber stone wood conductor household mineral";

/// Words beside the name of a material that change something else than what it is: "brushed" of "brushed
/// aluminium". The answer to the name alone then answers the whole, with one sentence on what the word
/// changes.
struct Qualifier {
  std::string_view words;       // lower case, blanks between them
  std::string_view of_f0;       // what they change where the answer is an F0; empty: it would mislead
  std::string_view of_surface;  // where it is a diffuse colour
  // Groups of surfaces, classes, or "dielectric", of which the sentences are true, blanks between them; empty:
  // all. A colour is of dielectrics: F0 of a metal or a measured surface has its own.
  std::string_view of = {};
  std::string_view seen = {};  // what is seen instead of the material: "paint" where it is painted
  bool hides = false;          // what stands before the word is seen, and hides what follows: "plated"
};

/// The qualifier that `word` is, in any case; null: none.
const Qualifier* qualifier(std::string_view word);

/// A name that is left when the words around it are set aside.
struct NameWithQualifiers {
  std::string base;                                                  // "aluminium"
  std::vector<std::pair<std::string_view, const Qualifier*>> words;  // views into the name
};

/// The ways to read `name` as another name with qualifiers, those with the fewest first; none for a name of
/// more than six words.
std::vector<NameWithQualifiers> qualified_names(std::string_view name);

/// What the words change in an answer by `material`: "brushed: a roughness, not an F0". Empty where the
/// answer would mislead.
std::string qualifier_note(const NameWithQualifiers& name, const Material& material);

}  // namespace etak
