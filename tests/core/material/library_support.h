// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "core/material/library.h"

namespace etak::test {

/// The built-in library, read once.
inline const MaterialLibrary& library() {
  static const MaterialLibrary built_in = MaterialLibrary::builtin();
  return built_in;
}

/// A material of it that must be there.
inline Material material(const std::string& id) {
  const auto found = library().find(id);
  INFO(id);
  REQUIRE(found);
  return *found;
}

}  // namespace etak::test
