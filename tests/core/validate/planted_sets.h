// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/judge/finding.h"

/// Made-up folders with one set of pictures each: right ones, and the same with one defect. Everything follows from
/// the seed.
namespace etak::test {

/// A folder with the defect that is in it.
///   kind       of the defect, in words; empty: the set is right
///   rule       that is to find it
///   severity   that the finding is to have
///   status     of a run over the folder
///   files      by name: their bytes
struct PlantedSet {
  std::string kind, rule;
  Severity severity = Severity::error;
  int status = 1;
  std::map<std::string, std::string> files;
};

/// Right sets, `count` of them, as PNG: metal-rough by single and packed files, with maps.
std::vector<PlantedSet> right_sets(int count, std::uint64_t seed);

/// For each kind of defect `count` sets that have it.
std::vector<PlantedSet> planted_sets(int count, std::uint64_t seed);

}  // namespace etak::test
