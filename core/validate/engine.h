// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/validate/pixels/evidence.h"
#include "core/validate/validate.h"

namespace etak {

// The two halves of a check, for those that gather evidence of their own beside it (files.cpp).

/// Needs of the rules that can say something of such a target: of those that are on, those whose data may be
/// there.
Needs needs_of(const CheckTarget& target, const Settings& settings);

/// Looks at the pixels, where some rule needs them, and adds tiles, counts and float facts to the evidence,
/// and what it cost to `file`. evidence.a and .b are filled in from the pictures when empty.
void look_at_pixels(const CheckTarget& target, const std::function<PictureRows(Needs)>& open,
                    const Settings& settings, unsigned threads, Evidence& evidence, CheckedFile& file);

/// Runs the rules over the evidence; findings in the order of rules, tiles, boxes.
void judge(const CheckTarget& target, const Evidence& evidence, const Settings& settings, CheckedFile& file);

/// What is known of the file before anything is opened: path, companions, roles.
CheckedFile checked_file_of(const CheckTarget& target);

/// The transfer function that holds for a target: its own statement, else that of the settings.
Settings settings_for(const CheckTarget& target, const Settings& settings);

}  // namespace etak
