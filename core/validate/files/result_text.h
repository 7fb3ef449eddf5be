// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/judge/finding.h"
#include "core/runs/kept_results.h"
#include "core/validate/find/find_targets.h"

namespace etak {

/// The results of the last run, in a program that checks the same files again and again.
class CheckedBefore : public KeptResults<CheckedFile> {};

/// All that decides the result of a target besides the bytes of its files and the settings, as bytes.
std::string identity_of(const FoundTarget& found);

/// A CheckedFile as bytes and back: doubles come back equal. Nothing where the bytes are not of that form.
std::string result_text(const CheckedFile& file);
std::optional<CheckedFile> read_result_text(std::string_view bytes);

}  // namespace etak
