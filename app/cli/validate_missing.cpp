// SPDX-License-Identifier: Apache-2.0
#include "app/cli/validate.h"
#include "core/base/error.h"

namespace etak::cli {

int check_files(ValidateArguments&) {
  throw Error::at("etak validate", "this etak was built without its picture readers", "one built with zlib");
}

}  // namespace etak::cli
