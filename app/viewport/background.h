// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <QThreadPool>
#include <functional>
#include <memory>
#include <utility>

namespace etak {

// The only functions by which work leaves the user-interface thread and results come back to it. The thread
// sanitizer cannot see Qt's locks; these functions tell it which thread waits for which, so that it reports
// real races only.

/// Runs `work` on a thread of `pool`. `work` must not throw, and it must own all data that it uses: it may
/// use no object of the user-interface thread.
void run_in(QThreadPool& pool, std::function<void()> work, int priority = 0);

/// A pool of threads that belongs to one object. When it is destroyed, it drops the work that has not begun, and
/// waits for the rest.
class Worker : public QThreadPool {
 public:
  explicit Worker(int threads = 1) { setMaxThreadCount(threads); }
  ~Worker() override {
    clear();
    waitForDone();
  }
};

/// Does `work`, which may throw Error. Returns its message; empty: all went well.
///   no_memory   the message where there is not enough memory
QString failure_of(const std::function<void()>& work, const QString& no_memory = {});

/// Lets threads that somebody waits for have the processors first, from now on and for as long as the calling
/// thread lives. For threads of a pool of their own.
void let_others_go_first();

/// Makes `call` from the event loop of the user-interface thread, in the order in which call_in_ui() was
/// called. Any thread may call it.
void call_in_ui(std::function<void()> call);

/// Runs `work` on a thread of `pool`, then calls `done` with its result on the user-interface thread, unless
/// `context` has been deleted by then. `work` must obey the rules of run_in().
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
