// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace etak {

/// A broken or foreign input, or a bad option: what a user can mend. Never thrown for a doubtful material.
/// what() is one line: "PLACE: FOUND; expected EXPECTED".
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  /// The error whose what() says that something other than the expected was found at a place.
  ///   place      file, "file:line" or "file#/json/pointer"; "<stdin>" for standard input, "--option" for
  ///              options
  ///   found      what is there
  ///   expected   what should be there; may be empty
  static Error at(std::string_view place, std::string_view found, std::string_view expected = {});

  /// An error at a 1-based line, which is put behind the file's name.
  static Error at_line(std::string_view file, std::size_t line, std::string_view found,
                       std::string_view expected = {});
};

/// The system's words for an errno: "No such file or directory".
std::string reason_of(int error_number);

/// For quoting foreign bytes in a message: line_text() of text.h, cut after `most` bytes.
std::string printable(std::string_view bytes, std::size_t most = 40);
/// printable() bytes between double quotes.
std::string in_quotes(std::string_view bytes, std::size_t most = 40);

}  // namespace etak
