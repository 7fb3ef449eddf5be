// SPDX-License-Identifier: Apache-2.0
#include "app/cli/validate.h"

namespace etak::cli {

void need_readers_of(const std::vector<std::string>&) {}

}  // namespace etak::cli
