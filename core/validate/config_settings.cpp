// SPDX-License-Identifier: Apache-2.0
#include "core/base/setting.h"
#include "core/validate/config.h"

namespace etak {
namespace {

// A severity of findings that a run may fail for: "off" is none.
std::optional<Severity> finding_severity(const std::string& text) {
  const auto out = severity_named(text);
  return out == Severity::off ? std::nullopt : out;
}

std::optional<bool> is_transparency(const std::string& text) {
  if (text == "mask" || text == "transparency") return text == "transparency";
  return std::nullopt;
}

}  // namespace

std::string config_of(const ValidateSettings& given, const std::string& near) {
  if (!given.config.empty() || given.no_config) return given.config;
  return find_config(near.empty() ? "." : near);
}

ValidateConfig validate_config(const ValidateSettings& given, const std::string& near,
                               std::shared_ptr<const KnownMaterials> known) {
  ValidateConfig config = read_config(config_of(given, near));
  Settings& out = config.settings;
  out.known = std::move(known);
  out.profile =
      setting_value("profile", given.profile, out.profile, profile_named, "default, strict, film or custom");
  out.transfer = setting_value("transfer", given.transfer, out.transfer, texture_transfer_named,
                               "srgb, power-2.2 or linear");
  if (!given.transfer.empty() && given.transfer != name(out.transfer))
    config.remarks.push_back(setting("transfer") + " " + given.transfer + ": is now called " +
                             std::string(name(out.transfer)));
  out.transfer_stated = out.transfer_stated || !given.transfer.empty();
  if (given.fail_on != never_fails)
    out.fail_on = setting_value("fail-on", given.fail_on, out.fail_on, finding_severity,
                                "error, warning, info or never");
  out.alpha_is_transparency =
      setting_value("alpha", given.alpha, out.alpha_is_transparency, is_transparency, "mask or transparency");
  apply_choice(given.choice, out);
  return config;
}

}  // namespace etak
