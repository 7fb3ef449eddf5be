// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>
#include <QThreadPool>
#include <functional>
#include <memory>
#include <utility>

namespace etak {

// The one way on which work leaves the thread of windows, and results come back. Qt's locks are invisible to the thread
// sanitizer; these functions tell it which thread waits for which, so that it finds true races.

/// Runs `work` on a thread of `pool`. It must not throw and must own all it touches: nothing of the windows may be
/// reached from it.
void run_in(QThreadPool& pool, std::function<void()> work, int priority = 0);

/// Has `call` made by the thread of windows, when its event loop gets there, in the order of the callers. Any thread
/// may ask.
void call_in_ui(std::function<void()> call);

/// Runs `work` on a thread of `pool`, then hands what it returns to `done` on the thread of windows, unless `context`
/// is gone by then. For `work` holds what run_in() says.
template <class Work, class Done>
void in_background(QThreadPool& pool, QObject* context, Work work, Done done, int priority = 0) {
  run_in(
      pool,
      [guard = QPointer<QObject>(context), work = std::move(work), done = std::move(done)]() mutable {
        auto result = std::make_shared<decltype(work())>(work());
        call_in_ui([guard, result, done = std::move(done)]() mutable {
          if (guard) done(std::move(*result));
        });
      },
      priority);
}

}  // namespace etak
