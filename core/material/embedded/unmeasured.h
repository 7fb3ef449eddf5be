// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace etak {

/// A thing that people ask for by name and of which no open measurement is known, so that the library has no
/// material for it.
struct Unmeasured {
  std::vector<std::string> words;    // what it is called; the first is shown
  std::string why;                   // what was found instead; a clause without full stop
  std::vector<std::string> nearest;  // ids of measured materials that come near; may be empty
  friend bool operator==(const Unmeasured&, const Unmeasured&) = default;
};

/// Reads resources/unmeasured.json (resources/schema/unmeasured.schema.json). Throws Error with the JSON
/// pointer of what is wrong: a word twice, an empty reason.
///   file   name for messages
std::vector<Unmeasured> parse_unmeasured(std::string_view text, std::string_view file);

}  // namespace etak
