// SPDX-License-Identifier: Apache-2.0
#include "app/cli/validate/request.h"

#include <cstdlib>

#include "app/cli/inputs/inputs.h"
#include "app/cli/options/empty_list.h"
#include "app/cli/pictures/pictures.h"
#include "app/cli/validate/changed.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/number.h"
#include "core/validate/baseline.h"
#include "core/validate/nearest.h"

namespace etak::cli {

std::shared_ptr<const KnownMaterials> asked_materials(Library& library) {
  if (library.folders.empty() && std::getenv("ETAK_LIBRARY") == nullptr) return nullptr;
  return std::make_shared<const KnownMaterials>(library.get());
}

std::optional<Severity> told_severity(const std::string& text) {
  for (const Severity severity : {Severity::info, Severity::warning, Severity::error})
    if (text == name(severity)) return severity;
  return std::nullopt;
}

std::string config_of(const ValidateArguments& arguments) {
  if (!arguments.config.empty()) return arguments.config;
  if (arguments.no_config) return "";
  return find_config(arguments.paths.empty() ? "." : arguments.paths.front());
}

ValidateConfig validate_config(const ValidateArguments& arguments,
                               std::shared_ptr<const KnownMaterials> known) {
  ValidateConfig config = read_config(config_of(arguments));
  Settings& settings = config.settings;
  settings.known = std::move(known);
  const auto given = [](const char* option, const std::string& text, auto named, auto& value,
                        const char* expected) {
    if (text.empty()) return;
    const auto found = named(text);
    if (!found) throw Error::at(option, printable(text), expected);
    value = *found;
  };
  given("--profile", arguments.profile, profile_named, settings.profile, "default, strict, film or custom");
  given("--transfer", arguments.transfer, texture_transfer_named, settings.transfer,
        "srgb, gamma22 or linear");
  settings.transfer_stated = settings.transfer_stated || !arguments.transfer.empty();
  // "never" does not change the limit: the caller then ignores findings.
  given("--fail-on", arguments.fail_on == never_fails ? "" : arguments.fail_on, told_severity,
        settings.fail_on, "error, warning, info or never");
  const auto alpha = [](const std::string& text) -> std::optional<bool> {
    if (text == "mask" || text == "transparency") return text == "transparency";
    return std::nullopt;
  };
  given("--alpha", arguments.alpha, alpha, settings.alpha_is_transparency, "mask or transparency");
  apply_choice(arguments.choice, settings);
  return config;
}

ValidationRequest validation_request(ValidateArguments& arguments) {
  ValidationRequest out;
  auto known = asked_materials(arguments.library);
  out.config = validate_config(arguments, std::move(known));
  out.list = arguments.files_from;
  if (!arguments.files_from.empty()) out.listed = ListedNames(arguments.files_from).take();
  if (!arguments.changed_since.empty()) {
    if (!arguments.files_from.empty())
      throw Error::at("--changed-since", "is given beside --files-from", "one of both");
    arguments.allow_empty = true;
    out.list = "--changed-since " + printable(arguments.changed_since);
    out.listed = changed_since(arguments.changed_since, arguments.paths);
  } else {
    out.paths = arguments.paths;
  }
  if (out.paths.empty() && out.listed.empty() && !arguments.allow_empty)
    throw empty_list(arguments.files_from);
  out.manifest.material = arguments.material;
  out.manifest.surface_class = arguments.surface_class;
  if (!arguments.role.empty()) {
    out.role = role_named(arguments.role);
    if (!out.role) throw Error::at("--role", printable(arguments.role), picture_roles);
  }
  out.today = arguments.today;
  if (!arguments.baseline.empty())
    out.known = read_baseline(read_file(arguments.baseline), arguments.baseline);
  out.renew_known = !arguments.write_baseline.empty();
  out.door = picture_door();
  out.cache = cache_options(arguments.cache);
  out.before = arguments.before;
  out.version = ETAK_VERSION;
  out.must_check = !arguments.allow_empty;
  out.pass_unknown = arguments.allow_empty;
  // JSON is the only form that holds hashes of the files.
  out.hashes = arguments.output.format == "json";
  out.threads = thread_count(arguments.threads);
  return out;
}

}  // namespace etak::cli
