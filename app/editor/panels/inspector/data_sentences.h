// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string>

#include "core/material/material.h"

namespace etak::editor {

/// What the flags of data mean: one sentence for each, in a line of its own that begins with a line break.
///   doubt   the reason why the data are doubtful, in place of what that flag means; empty: they are not
QString data_sentences(Flags flags, const std::string& doubt);

}  // namespace etak::editor
