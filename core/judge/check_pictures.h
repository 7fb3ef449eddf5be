// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/judge/finding.h"
#include "core/judge/rule.h"
#include "core/judge/settings.h"
#include "core/judge/target.h"

namespace etak {

/// Checks pictures in memory. Files of the target are not opened; their labels and roles go into the report.
///   threads   never changes the result
CheckedFile check_pictures(const CheckTarget& target, const Pictures& pictures, const Settings& settings,
                           unsigned threads = 1);

/// Checks pictures that come in strips of rows.
///   open   called once per pass over the pixels, with what the pass needs; almost always once
CheckedFile check_rows(const CheckTarget& target, const std::function<PictureRows(Needs)>& open,
                       const Settings& settings, unsigned threads = 1);

}  // namespace etak
