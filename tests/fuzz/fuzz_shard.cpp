// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of what shards wrote answers with an Error, or with a part of which a whole run
// and every form of it can be made; what the merge writes as JSON parses.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/hash/sha256.h"
#include "core/findings/output/formats.h"
#include "core/findings/shards/report_shard.h"

using namespace etak;

namespace {

constexpr std::string_view version = "0";  // that the seeds name

// The text with its own SHA-256 in the place of the one that it states, as a stranger would give it: else no
// changed text would get past the seal.
std::string sealed(std::string text) {
  constexpr std::string_view seal = "\"sha256\": \"";
  constexpr std::size_t digits = 64;
  const std::size_t at = text.find(seal);
  if (at == text.npos || text.size() < at + seal.size() + digits) return text;
  text.replace(at + seal.size(), digits, std::string(digits, '0'));
  return text.replace(at + seal.size(), digits, sha256(text));
}

void merge(const std::string& text) {
  ReadShard read;
  try {
    read = read_shard(text, "shard.json", version);
  } catch (const Error&) {
    return;
  }
  // What is taken is, byte for byte, what etak writes for these values.
  const OutputOptions options{read.report.shard->settings.fail_on, std::string(version)};
  assert(validation_json(read.report, options) == text);
  ValidationReport whole;
  try {
    std::vector<ReadShard> shards;
    shards.push_back(std::move(read));
    whole = merged_report(std::move(shards), false);
  } catch (const Error&) {
    return;  // not all of a run
  }
  assert(nlohmann::json::accept(validation_json(whole, options)));
  assert(nlohmann::json::accept(validation_sarif(whole, options)));
  for (const std::string& form : {validation_text(whole), validation_csv(whole), validation_github(whole),
                                  validation_junit(whole, options)})
    assert(form.find('\x1b') == form.npos);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(data, data + size);
  merge(bytes);
  merge(sealed(bytes));
  return 0;
}
