// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "core/material/library.h"
#include "core/study/choose/choose.h"

namespace etak::test {

/// What choose() takes for a subject at the shipped costs.
inline Choice chosen(const ChooseSubject& subject, double budget = 1, ErrorUnit unit = ErrorUnit::delta_e) {
  return choose(subject, {budget, unit}, shipped_costs());
}

/// The choice for a material of the library, of gloss 0.75.
inline Choice chosen(const std::string& id, double budget = 1) {
  const auto material = MaterialLibrary::builtin().find(id);
  REQUIRE(material);
  return choose(library_subject(*material, material->preferred_dataset(), 0.75), {budget, ErrorUnit::delta_e},
                shipped_costs());
}

}  // namespace etak::test
