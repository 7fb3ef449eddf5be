// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace etak::editor {

/// Makes all labels, message boxes and tooltips of the program show their texts as plain text. Qt would
/// interpret a text that looks like HTML, and a name from a file may look so: it could then show a picture or
/// hide itself.
void show_texts_plain();

}  // namespace etak::editor
