// SPDX-License-Identifier: Apache-2.0
// Parts of the JSON form of a shard, for the *json.cpp files: no public header, because it names nlohmann-json.
#pragma once

#include <nlohmann/json.hpp>

#include "core/validate/finding.h"
#include "core/validate/shards/report_shard.h"
#include "core/validate/target.h"

namespace etak {

/// A finding as every report has it (output/json.cpp).
nlohmann::ordered_json finding_json(const Finding& finding);

/// Adds to the findings of a file, as finding_json() wrote them, the numbers that JSON has no form of.
void add_exact_numbers(const CheckedFile& file, nlohmann::ordered_json& findings);

/// The targets of a file, from which its pictures can be opened again: the tiles of a UDIM set, else one.
nlohmann::ordered_json targets_json(const CheckedFile& file);

/// The "shard" member: all that read_shard() needs besides the files. Of the first shard also what belongs to
/// no group of files: folders as typed, and what was not opened.
nlohmann::ordered_json shard_json(const ValidationReport& report);

}  // namespace etak
