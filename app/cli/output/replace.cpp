// SPDX-License-Identifier: Apache-2.0
#include "app/cli/output/replace.h"

#include <sys/stat.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/output_target.h"
#include "core/validate/user_config.h"

namespace etak::cli {
namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// A relative path in XDG_CONFIG_HOME is ignored, as the XDG Base Directory Specification demands.
std::string user_config_file() {
  if (const std::string home = variable("XDG_CONFIG_HOME"); home.starts_with('/'))
    return home + "/etak/config.toml";
  const std::string home = variable("HOME");
  return home.empty() ? "" : home + "/.config/etak/config.toml";
}

UserConfig user_config() {
  const std::string file = user_config_file();
  struct stat info {};
  if (file.empty() || ::stat(file.c_str(), &info) != 0) return {};
  return parse_user_config(read_file(file), file);
}

}  // namespace

bool may_replace(bool force) {
  if (force) return true;
  const std::string asked = variable("ETAK_FORCE");
  if (asked == "1") return true;
  if (asked == "0") return false;
  if (!asked.empty()) throw Error::at("ETAK_FORCE", printable(asked), "1 or 0");
  return user_config().force;
}

void check_output(const OutputArguments& arguments) {
  if (!is_standard_output(arguments)) check_file_target(arguments.file, may_replace(arguments.force));
}

}  // namespace etak::cli
