// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/cli/output/output.h"
#include "app/cli/program.h"
#include "core/base/signals.h"
#include "core/base/system.h"

namespace {

// Ends the program with a message where an exception leaves a thread, an object that is made before main(), or the
// start-up code of a library, which no handler of main() sees. The libraries of libetak-pictures.so, for one, start
// threads when they are loaded.
[[noreturn]] void tell_want_and_end() {
  const auto end = [](std::string_view text) {
    (void)etak::sys::write(etak::sys::standard_error, text.data(), text.size());
    std::_Exit(etak::cli::exit_failure);
  };
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    end("etak: a library needs more memory than there is; expected a higher limit\n");
  } catch (const std::system_error&) {
    end("etak: a library could not start a thread; expected a higher limit of processes or memory\n");
  } catch (...) {
  }
  std::abort();
}

// Set before the objects that are made ahead of main(): option parsers and tables, which need memory too.
[[gnu::constructor(101)]] void take_lost_exceptions() {
  std::set_terminate(tell_want_and_end);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words = etak::sys::start_program(argc, argv);
  etak::end_by_signals();
  // Never destroyed: to free the options, the library that they hold and each of its names takes a seventh of the time of
  // `etak f0 gold`, and the end of the process does it at once.
  static etak::cli::CommandLine& line = *new etak::cli::CommandLine(etak::cli::empty_line());
  return etak::cli::run_line(words, line);
}
