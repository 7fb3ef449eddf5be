// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pack_findings.h"
#include "core/base/error.h"

namespace etak::cli {

void judge_by_library(Library&) {}

struct PackFindings::Parts {};

PackFindings::PackFindings(const PackArguments& arguments) {
  if (!arguments.fail_on.empty() || !arguments.config.empty())
    throw Error::at("etak pack", "this etak was built without its validator", "no --fail-on and no --config");
}
PackFindings::~PackFindings() = default;

void PackFindings::attach(PackOptions&) {}
void PackFindings::finish(PackReport&) {}
const ValidationReport* PackFindings::report() const {
  return nullptr;
}
std::string PackFindings::text(bool) const {
  return {};
}
std::string PackFindings::verdict() const {
  return {};
}
bool PackFindings::failed() const {
  return false;
}
bool PackFindings::incomplete() const {
  return false;
}

}  // namespace etak::cli
