// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/image/picture.h"
#include "core/judge/finding.h"
#include "core/judge/settings.h"
#include "core/judge/target.h"
#include "core/validate/files/load.h"

namespace etak {

struct Evidence;

/// Checks one target. Never throws for what is in the files: an unreadable one is finding ETK001, an error of
/// a rule ETK901, and the file is marked `unreadable`.
CheckedFile check(const CheckTarget& target, const PictureDoor& door, const Settings& settings,
                  unsigned threads = 1);

/// Adds evidence of a target to what is there, and what was found meanwhile to `file`. May throw.
using EvidenceGatherer = std::function<void(const Settings&, Evidence&, CheckedFile& file)>;

/// Gathers the evidence under the settings for the target and judges it. An error of `look` becomes a
/// finding, as in check().
CheckedFile check_by(const CheckTarget& target, const Settings& settings, const EvidenceGatherer& look);

/// Checks a pair whose pictures `open` gives, as check() does: no file of the target is read.
CheckedFile check_opened(const CheckTarget& target, const PictureOpener& open, const Settings& settings,
                         unsigned threads = 1);

}  // namespace etak
