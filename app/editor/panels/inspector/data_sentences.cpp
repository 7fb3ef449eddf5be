// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/inspector/data_sentences.h"

#include <QObject>

#include "app/viewport/qt_text.h"

namespace etak::editor {

QString data_sentences(Flags flags, const std::string& doubt) {
  QString out;
  const auto add = [&](QString text) {
    text[0] = text[0].toUpper();
    out += '\n' + text + '.';
  };
  flags.for_each([&](Flag flag) {
    if (flag != Flag::doubtful) add(qt_text(meaning(flag)));
  });
  if (!doubt.empty()) add(QObject::tr("the data are doubtful: %1").arg(qt_text(doubt)));
  return out;
}

}  // namespace etak::editor
