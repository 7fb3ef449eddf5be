// SPDX-License-Identifier: Apache-2.0
#include "core/material/find.h"

#include <utility>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/material/names.h"
#include "core/material/stack.h"
#include "core/material/stack_text.h"

namespace etak {

void fail_unknown_name(const MaterialLibrary& library, std::string_view text, const NameWords& words) {
  // The part that is not known of "milk/jensen-2001" is the material.
  const MaterialLibrary::Missing missing = library.missing(text.substr(0, text.find('/')));
  const std::string shown = printable(text);
  std::string expected(words.instead);
  if (!expected.empty() && !missing.expected.empty()) expected += ", or ";
  expected += missing.expected;
  if (expected.empty() && missing.found.empty()) expected = "a name that etak list shows";
  if (words.place.empty())
    throw Error::at(shown, missing.found.empty() ? words.found : missing.found, expected);
  throw Error::at(
      words.place,
      missing.found.empty() ? "no material of the library is called " + shown : shown + ": " + missing.found,
      expected);
}

std::optional<NamedMaterial> find_material(const MaterialLibrary& library, std::string_view text) {
  if (auto answer = library.answer(text)) return NamedMaterial{std::move(*answer), std::string(text), {}};
  const std::size_t slash = text.find('/');
  if (slash == text.npos) return std::nullopt;
  const std::string_view name = text.substr(0, slash);
  auto answer = library.answer(name);
  if (!answer) return std::nullopt;
  return NamedMaterial{std::move(*answer), std::string(name), std::string(text.substr(slash + 1))};
}

FoundDataset find_dataset(const MaterialLibrary& library, std::string_view name, std::string_view dataset,
                          const NameWords& words) {
  auto material = library.find(name);
  if (!material) fail_unknown_name(library, name, words);
  const std::string place = words.place.empty() ? std::string() : std::string(words.place) + ": ";
  FoundDataset out{std::move(*material), 0};
  const Dataset& chosen = dataset_named(out.material, dataset, place + out.material.id);
  out.dataset = static_cast<std::size_t>(&chosen - out.material.datasets.data());
  return out;
}

OutsideMedium outside_medium(const MaterialLibrary& library, std::string_view text, const std::string& place,
                             const NameWords& words) {
  OutsideMedium out;
  if (text.empty()) return out;
  out.label = text;
  if (double index = 0; parse_number(text, index)) {
    if (!(index > 0))
      throw Error::at(place, printable(text), "an index of refraction above 0, or a material");
    out.index = index;
    return out;
  }
  const auto found = find_material(library, text);
  if (!found || found->answer.by == NameKind::qualified) fail_unknown_name(library, text, words);
  const Material& material = found->answer.material;
  const Dataset& dataset = dataset_named(material, found->dataset, place + ": " + material.id);
  const auto* constants = std::get_if<OpticalConstants>(&dataset.optics);
  if (constants == nullptr)
    throw Error::at(place, printable(text) + " " + std::string(without_constants(dataset.optics)),
                    "n of a transparent medium");
  out.index = *constants;
  return out;
}

}  // namespace etak
