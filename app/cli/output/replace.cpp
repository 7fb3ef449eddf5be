// SPDX-License-Identifier: Apache-2.0
#include "app/cli/output/replace.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/files/output_target.h"
#include "core/base/files/paths.h"
#include "core/base/files/read_places.h"
#include "core/base/system.h"
#include "core/findings/baseline.h"
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

}  // namespace

ReplaceDefault replace_default() {
  const std::string asked = variable("ETAK_FORCE");
  if (asked == "1" || asked == "0") return {asked == "1", "ETAK_FORCE"};
  if (!asked.empty()) throw Error::at("ETAK_FORCE", printable(asked), "1 or 0");
  const std::string file = user_config_file();
  sys::FileInfo info;
  if (file.empty() || !sys::file_info(file, info)) return {false, "default"};
  return {parse_user_config(read_file(file), file).force, file};
}

bool may_replace(bool force) {
  return force || replace_default().replace;
}

void refuse_input(const std::string& file, std::span<const std::string> more) {
  sys::FileInfo info;
  if (!sys::file_info(file, info) || info.kind != sys::FileInfo::Kind::file) return;
  ReadPlaces(accepted_inputs(), ReadPlaces::Of::files_alone).refuse(info, file);
  ReadPlaces(more, ReadPlaces::Of::files_alone).refuse(info, file);
}

void check_output(const OutputArguments& arguments) {
  if (is_standard_output(arguments)) return;
  check_file_target(arguments.file, may_replace(arguments.force));
  refuse_input(arguments.file);
}

bool replaces_baseline(const std::string& path) {
  check_file_target(path, true);
  sys::FileInfo info;
  if (!sys::file_info(path, info) || info.kind != sys::FileInfo::Kind::file) return false;
  try {
    (void)read_baseline(read_file(path), path);
  } catch (const Error&) {
    throw Error::at(path, "exists already and is no baseline of etak",
                    "a new name, or a baseline: --write-baseline replaces nothing else");
  }
  return true;
}

void refuse_same_outputs(std::initializer_list<NamedOutput> outputs) {
  namespace fs = std::filesystem;
  std::map<std::tuple<std::uint64_t, std::uint64_t, fs::path>, const char*> known;
  for (const auto& [option, path] : outputs) {
    using Kind = sys::FileInfo::Kind;
    const auto kind = kind_at(path).value_or(Kind::file);
    if (path.empty() || path == "-" || (kind != Kind::file && kind != Kind::folder))
      continue;  // a pipe takes any number
    const fs::path whole = (plain_path(path) / "").parent_path();
    sys::FileInfo folder;
    if (!sys::file_info(sys::path_text(whole.parent_path()), folder)) continue;  // its own check tells so
    const auto [first, fresh] = known.try_emplace({folder.device, folder.number, whole.filename()}, option);
    if (!fresh)
      throw Error::at(option, printable(path, 200) + " is the output of " + first->second + " too",
                      "a name of its own for each output");
  }
}

}  // namespace etak::cli
