// SPDX-License-Identifier: Apache-2.0
#include "app/cli/validate/plan.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "app/cli/validate/targets.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/output_file.h"
#include "core/base/number.h"
#include "core/validate/baseline.h"
#include "core/validate/nearest.h"
#include "core/validate/rules.h"
#include "core/validate/suppress.h"

namespace etak::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* config_name = "etak.toml";

// etak.toml in the folder of the first path, or the nearest one above it.
std::string find_config(const ValidateArguments& arguments) {
  if (!arguments.config.empty()) return arguments.config;
  if (arguments.no_config) return {};
  std::error_code failure;
  fs::path folder =
      fs::absolute(arguments.paths.empty() ? "." : arguments.paths.front(), failure).lexically_normal();
  if (!fs::is_directory(folder, failure)) folder = folder.parent_path();
  for (;; folder = folder.parent_path()) {
    const fs::path candidate = folder / config_name;
    if (fs::is_regular_file(candidate, failure)) {
      // Messages name it as the user would, where that is short.
      const fs::path near = candidate.lexically_relative(fs::current_path(failure));
      return near.empty() || *near.begin() == ".." ? candidate.string() : near.string();
    }
    if (folder == folder.parent_path()) return {};
  }
}

}  // namespace

std::shared_ptr<const KnownMaterials> asked_materials(Library& library) {
  if (library.folders.empty() && std::getenv("ETAK_LIBRARY") == nullptr) return nullptr;
  return std::make_shared<const KnownMaterials>(library.get());
}

ValidatePlan validate_plan(const ValidateArguments& arguments, std::shared_ptr<const KnownMaterials> known) {
  ValidatePlan plan;
  plan.config_file = find_config(arguments);
  std::error_code failure;
  fs::path root = fs::current_path(failure);
  if (!plan.config_file.empty()) {
    const fs::path whole = fs::absolute(plan.config_file, failure).lexically_normal();
    root = whole.parent_path();
    plan.config = parse_config(read_file(plan.config_file), plan.config_file);
  }
  plan.root = root.string();
  Settings& settings = plan.config.settings;
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
  const auto failing = [](const std::string& text) -> std::optional<Severity> {
    for (const Severity severity : {Severity::info, Severity::warning, Severity::error})
      if (text == name(severity)) return severity;
    return std::nullopt;
  };
  // "never" leaves the limit alone: the caller ends with 0 whatever it says.
  given("--fail-on", arguments.fail_on == never_fails ? "" : arguments.fail_on, failing, settings.fail_on,
        "error, warning, info or never");
  const auto alpha = [](const std::string& text) -> std::optional<bool> {
    if (text == "mask" || text == "transparency") return text == "transparency";
    return std::nullopt;
  };
  given("--alpha", arguments.alpha, alpha, settings.alpha_is_transparency, "mask or transparency");
  apply_choice(arguments.choice, settings);
  return plan;
}

namespace {

std::string today_of(const ValidateArguments& arguments) {
  if (!arguments.today.empty()) return arguments.today;
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::localtime_r(&now, &parts);
  std::array<char, 16> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts)};
}

}  // namespace

std::unique_ptr<Output> take_out_known(ValidationReport& report, const ValidateArguments& arguments,
                                       const ValidatePlan& plan) {
  const Settings& settings = plan.config.settings;
  if (!settings.allow.empty()) {
    const std::string label = relative_label(plan.config_file, plan.root);
    const Rule& unused = *find_rule("ETK903");
    std::error_code failure;
    const bool whole =
        std::any_of(arguments.paths.begin(), arguments.paths.end(),
                    [&](const std::string& path) { return fs::equivalent(path, plan.root, failure); });
    const auto is_active = [&](std::string_view prefix) {
      const auto meant = rules_with_prefix(prefix);
      return std::any_of(meant.begin(), meant.end(),
                         [&](const Rule* rule) { return severity_of(*rule, settings) != Severity::off; });
    };
    const std::string today = today_of(arguments);
    apply_allowances(report, settings.allow, {today, label, severity_of(unused, settings), whole, is_active});
  }
  std::unique_ptr<Output> written;
  std::vector<KnownDefect> known;
  if (!arguments.baseline.empty()) known = read_baseline(read_file(arguments.baseline), arguments.baseline);
  if (!arguments.write_baseline.empty()) {
    known = baseline_of(report);
    written = std::make_unique<OutputFile>(arguments.write_baseline, baseline_json(known), true);
    remark(arguments.output,
           arguments.write_baseline + ": " + std::to_string(known.size()) + " findings recorded");
  }
  mark_known(report, known);
  return written;
}

}  // namespace etak::cli
