// SPDX-License-Identifier: Apache-2.0
#include "app/cli/options/empty_list.h"

namespace etak::cli {

void add_allow_empty_option(Command verb, bool& allow_empty) {
  verb.flag("--allow-empty", allow_empty, "a --files-from that names nothing is no failure");
}

Error empty_list(const std::string& list) {
  return Error::at("--files-from " + printable(list, 200), "names nothing", "names, or --allow-empty");
}

}  // namespace etak::cli
