// SPDX-License-Identifier: Apache-2.0
#include "app/cli/output/replace.h"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/output_target.h"
#include "core/base/system.h"
#include "core/validate/user_config.h"

namespace etak::cli {
namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// A relative path in XDG_CONFIG_HOME is ignored, as the XDG Base Directory Specification demands.
std::string user_config_file() {
  if (const std::string home = variable("XDG_CONFIG_HOME"); std::filesystem::path(home).has_root_directory())
    return home + "/etak/config.toml";
  if (const std::string home = sys::settings_folder(); !home.empty()) return home + "/etak/config.toml";
  const std::string home = variable("HOME");
  return home.empty() ? "" : home + "/.config/etak/config.toml";
}

UserConfig user_config() {
  const std::string file = user_config_file();
  sys::FileInfo info;
  if (file.empty() || !sys::file_info(file, info)) return {};
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
