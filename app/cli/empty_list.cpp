// SPDX-License-Identifier: Apache-2.0
#include "app/cli/empty_list.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace etak::cli {

void add_allow_empty_option(CLI::App& verb, bool& allow_empty) {
  verb.add_flag("--allow-empty", allow_empty, "a --files-from that names nothing is no failure");
}

Error empty_list(const std::string& list) {
  return Error::at("--files-from " + printable(list, 200), "names nothing", "names, or --allow-empty");
}

}  // namespace etak::cli
