// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>
#include <memory>
#include <utility>

namespace etak::editor {

/// Runs `work` on a thread of `pool`, then hands what it returns to `done` on the UI thread, unless `context`
/// is gone by then. `work` must not throw and must own all it touches: nothing of the UI may be reached from
/// it.
template <class Work, class Done>
void in_background(QThreadPool& pool, QObject* context, Work work, Done done, int priority = 0) {
  pool.start(
      [guard = QPointer<QObject>(context), work = std::move(work), done = std::move(done)]() mutable {
        auto result = std::make_shared<decltype(work())>(work());
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [guard, result, done = std::move(done)]() mutable {
              if (guard) done(std::move(*result));
            },
            Qt::QueuedConnection);
      },
      priority);
}

}  // namespace etak::editor
