// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of etak.toml answers with an Error or with settings that can be asked: every
// rule has a severity, and equal settings have equal hashes.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/error.h"
#include "core/judge/rules.h"
#include "core/validate/config.h"

using namespace etak;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // A copy of just this size: the address sanitizer then sees every read beyond the end.
  const std::vector<char> bytes(data, data + size);
  const std::string_view text(bytes.data(), bytes.size());
  ValidateConfig config;
  try {
    config = parse_config(text, "etak.toml");
  } catch (const Error&) {
    return 0;
  }
  assert(config.settings.zone.low < config.settings.zone.high);
  for (const Rule* rule : rules()) {
    assert(can_be_turned_off(*rule) || severity_of(*rule, config.settings) != Severity::off);
    for (const RuleParameter& parameter : rule->parameters)
      (void)parameter_of(*rule, parameter.name, config.settings);
  }
  for (const AllowEntry& entry : config.settings.allow) assert(!entry.rule.empty() && !entry.reason.empty());
  assert(parse_config(text, "again") == config);
  assert(settings_hash(config.settings).size() == 32);
  return 0;
}
