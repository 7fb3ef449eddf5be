// SPDX-License-Identifier: Apache-2.0
#include "app/document/saved_pictures.h"

#include <QFile>
#include <algorithm>

#include "app/document/files.h"
#include "app/viewport/background.h"
#include "core/base/error.h"
#include "core/render/view_moves.h"

namespace etak::editor {
namespace {

struct Cancelled {};

}  // namespace

QString save_pictures(const SavedView& view, const QSize& size, bool transparent, const QStringList& files,
                      const std::atomic<bool>& cancelled, const std::function<void(int)>& done) {
  QStringList saved;
  const auto save_all = [&] {
    const std::size_t all = view.rows(size, transparent) * static_cast<std::size_t>(files.size());
    std::atomic<std::size_t> rows = 0;
    for (const QString& file : files) {
      SavedView turned = view;
      turned.state.camera =
          on_turntable(view.state.camera, static_cast<int>(saved.size()), static_cast<int>(files.size()));
      const QImage picture = turned.picture(size, transparent, [&](std::size_t more, unsigned) {
        if (cancelled) throw Cancelled{};
        done(static_cast<int>(100 * (rows += more) / std::max<std::size_t>(1, all)));
      });
      if (const QString failure = save_png(picture, file); !failure.isEmpty())
        throw Error(failure.toStdString());
      saved << file;
    }
  };
  QString failure;
  try {
    failure = failure_of(save_all, QObject::tr("There is not enough memory for a picture of this size"));
  } catch (const Cancelled&) {
    failure = QObject::tr("Cancelled: nothing was saved.");
  }
  if (!failure.isEmpty() && files.size() > 1)
    for (const QString& each : saved) QFile::remove(each);
  return failure;
}

}  // namespace etak::editor
