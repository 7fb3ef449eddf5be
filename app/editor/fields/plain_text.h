// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace etak::editor {

/// From here on all labels, message boxes and tooltips of the program show their text as it is. Qt would take a text
/// that looks like HTML for it, and names from files may: such a name could show a picture or hide what it is.
void show_texts_plain();

}  // namespace etak::editor
