// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace etak {

/// What the program is asked for besides the findings, so that the merge of shards gives the same verdict and
/// text as the whole run.
///   never_fails, exit_zero   findings do not change the exit status
///   max_warnings             more warnings than this fail the run
///   min_severity             the text form leaves out findings below it; empty: none
struct VerdictOptions {
  bool never_fails = false, exit_zero = false;
  std::optional<std::size_t> max_warnings;
  std::string min_severity;
  friend bool operator==(const VerdictOptions&, const VerdictOptions&) = default;
};

}  // namespace etak
