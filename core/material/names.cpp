// SPDX-License-Identifier: Apache-2.0
#include "core/material/names.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/text/ascii.h"
#include "core/base/text/edit_distance.h"
#include "core/base/text/text.h"
#include "core/material/qualifiers.h"

namespace etak {
namespace {

// Elements 1 to 103, sorted.
constexpr std::array<std::string_view, 103> elements{
    "Ac", "Ag", "Al", "Am", "Ar", "As", "At", "Au", "B",  "Ba", "Be", "Bi", "Bk", "Br", "C",
    "Ca", "Cd", "Ce", "Cf", "Cl", "Cm", "Co", "Cr", "Cs", "Cu", "Dy", "Er", "Es", "Eu", "F",
    "Fe", "Fm", "Fr", "Ga", "Gd", "Ge", "H",  "He", "Hf", "Hg", "Ho", "I",  "In", "Ir", "K",
    "Kr", "La", "Li", "Lr", "Lu", "Md", "Mg", "Mn", "Mo", "N",  "Na", "Nb", "Nd", "Ne", "Ni",
    "No", "Np", "O",  "Os", "P",  "Pa", "Pb", "Pd", "Pm", "Po", "Pr", "Pt", "Pu", "Ra", "Rb",
    "Re", "Rh", "Rn", "Ru", "S",  "Sb", "Sc", "Se", "Si", "Sm", "Sn", "Sr", "Ta", "Tb", "Tc",
    "Te", "Th", "Ti", "Tl", "Tm", "U",  "V",  "W",  "Xe", "Y",  "Yb", "Zn", "Zr"};

constexpr std::string_view between_words = " ,()", between_parts = " ,()-_";

std::vector<std::string_view> split(std::string_view name, std::string_view separators) {
  std::vector<std::string_view> out;
  for (std::size_t at = name.find_first_not_of(separators); at != name.npos;) {
    const std::size_t end = std::min(name.find_first_of(separators, at), name.size());
    out.push_back(name.substr(at, end - at));
    at = name.find_first_not_of(separators, end);
  }
  return out;
}

// Letters of the element that `text` begins with, the longer symbol first ("Co" before "C"); 0: none.
std::size_t element_size(std::string_view text) {
  for (const std::size_t size : {std::size_t{2}, std::size_t{1}})
    if (text.size() >= size && std::binary_search(elements.begin(), elements.end(), text.substr(0, size)))
      return size;
  return 0;
}

// Letters of the words that two names share, those without meaning of their own left out. Lime is no word of
// "soda-lime".
std::size_t shared_letters(std::string_view asked, std::string_view known) {
  constexpr std::size_t least_word = 3;
  const std::vector<std::string_view> words = split(known, between_words);
  const auto is = [](std::string_view a, std::string_view b) {
    return lower_case(a.front()) == lower_case(b.front()) && folded_name(a) == folded_name(b);
  };
  std::size_t out = 0;
  for (const std::string_view word : words_of(asked))
    if (word.size() >= least_word &&
        std::any_of(words.begin(), words.end(), [&](std::string_view other) { return is(other, word); }) &&
        qualifier(word) == nullptr)
      out += word.size();
  return out;
}

std::string ids_of(const std::vector<const Dataset*>& datasets) {
  return joined(datasets, ", ", &Dataset::id);
}

}  // namespace

std::string folded_name(std::string_view name) {
  std::string out;
  for (const char c : name) {
    if (c == ' ' || c == '-' || c == '_') continue;
    out.push_back(lower_case(c));
  }
  return out;
}

std::vector<std::string_view> words_of(std::string_view name) {
  return split(name, between_parts);
}

std::string identifier(std::string_view text, char separator, std::string_view otherwise) {
  std::string id;
  for (const char c : text)
    if (is_letter(c) || is_digit(c))
      id.push_back(lower_case(c));
    else if (!id.empty() && id.back() != separator)
      id.push_back(separator);
  while (!id.empty() && id.back() == separator) id.pop_back();
  return id.empty() ? std::string(otherwise) : id;
}

std::string_view file_stem(std::string_view path) {
  path.remove_prefix(path.rfind('/') + 1);  // npos + 1 is 0
  return path.substr(0, path.rfind('.'));
}

bool is_formula(std::string_view name) {
  constexpr std::size_t most_digits = 3;
  std::size_t atoms = 0;
  for (std::size_t i = 0; i < name.size();) {
    if (atoms > 0 && name[i] == '-') ++i;
    const std::size_t symbol = element_size(name.substr(i));
    if (symbol == 0) return false;
    ++atoms;
    i += symbol;
    std::size_t digits = 0;
    for (; i < name.size() && (is_digit(name[i]) || name[i] == '.'); ++i) digits += is_digit(name[i]);
    if (digits > most_digits) return false;
  }
  return atoms > 0;
}

std::optional<NameDistance> name_distance(std::string_view asked_name, std::string_view known_name) {
  using Kind = NameDistance::Kind;
  if (asked_name.size() > longest_suggested) return std::nullopt;
  constexpr std::size_t least_edited = 4, least_of_two_edits = 8;
  const std::string asked = folded_name(asked_name), known = folded_name(known_name);
  if (asked.empty() || known.empty()) return std::nullopt;
  if (asked == known) return NameDistance{Kind::same, 0};
  if (const std::size_t shared = shared_letters(asked_name, known_name); shared > 0)
    return NameDistance{Kind::word,
                        asked.size() + known.size() - 2 * std::min({shared, asked.size(), known.size()})};
  if (std::max(asked.size(), known.size()) < least_edited || asked.front() != known.front())
    return std::nullopt;
  const std::size_t most = asked.size() < least_of_two_edits ? 1 : 2;
  if (asked.size() > known.size() + most || known.size() > asked.size() + most) return std::nullopt;
  const std::size_t edits = edit_distance(asked, known);
  if (edits > most) return std::nullopt;
  return NameDistance{Kind::edits, edits};
}

std::vector<const Dataset*> datasets_named(const Material& material, std::string_view text,
                                           std::string_view label) {
  if (const Dataset* exact = material.dataset(text)) return {exact};
  const bool any_number = text.ends_with('*');
  const std::string_view beginning = text.substr(0, text.size() - any_number);
  std::vector<const Dataset*> all, found;
  for (const Dataset& each : material.datasets) {
    all.push_back(&each);
    if (each.id.starts_with(beginning)) found.push_back(&each);
  }
  if (found.empty() || (beginning.empty() && !any_number))
    throw Error::at(label, "has no dataset " + printable(text), ids_of(all));
  if (found.size() > 1 && !any_number)
    throw Error::at(label, "more than one dataset begins with " + printable(text), "one of " + ids_of(found));
  return found;
}

const Dataset& dataset_named(const Material& material, std::string_view text, std::string_view label) {
  if (text.empty()) return material.preferred_dataset();
  const std::vector<const Dataset*> found = datasets_named(material, text, label);
  if (found.size() > 1)
    throw Error::at(label, printable(text) + " names " + std::to_string(found.size()) + " datasets",
                    "one of " + ids_of(found));
  return *found.front();
}

std::string_view alias_note(const std::vector<AliasNote>& notes, std::string_view name) {
  const std::string key = folded_name(name);
  for (const AliasNote& each : notes)
    if (folded_name(each.alias) == key) return each.note;
  return {};
}

}  // namespace etak
