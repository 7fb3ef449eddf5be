// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/background.h"

#include <QCoreApplication>
#include <QEvent>
#include <QRunnable>
#include <QThread>
#include <algorithm>
#include <new>

#include "core/base/error.h"

#ifdef __linux__
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

#ifdef __SANITIZE_THREAD__
extern "C" void __tsan_acquire(void* address);
extern "C" void __tsan_release(void* address);
#endif

namespace etak {
namespace {

// Tells the thread sanitizer that the thread that calls take_over() with the same address sees all that
// happened before this call.
void hand_over([[maybe_unused]] void* address) {
#ifdef __SANITIZE_THREAD__
  __tsan_release(address);
#endif
}

void take_over([[maybe_unused]] void* address) {
#ifdef __SANITIZE_THREAD__
  __tsan_acquire(address);
#endif
}

class Task : public QRunnable {
 public:
  explicit Task(std::function<void()> work) : work_(std::move(work)) {}

  void run() override {
    take_over(this);
    work_();
  }

 private:
  std::function<void()> work_;
};

class Call : public QEvent {
 public:
  explicit Call(std::function<void()> call) : QEvent(kind()), call_(std::move(call)) {}

  static Type kind() {
    static const auto type = static_cast<Type>(QEvent::registerEventType());
    return type;
  }
  void make() { call_(); }

 private:
  std::function<void()> call_;
};

// An object of the user-interface thread, which makes the calls that are posted to it.
class Caller : public QObject {
 protected:
  bool event(QEvent* event) override {
    take_over(event);
    if (event->type() != Call::kind()) return QObject::event(event);
    static_cast<Call*>(event)->make();
    return true;
  }
};

}  // namespace

void run_in(QThreadPool& pool, std::function<void()> work, int priority) {
  auto* const task = new Task(std::move(work));
  hand_over(task);
  pool.start(task, priority);  // the pool deletes the task
}

QString failure_of(const std::function<void()>& work, const QString& no_memory) {
  try {
    work();
    return {};
  } catch (const Error& error) {
    return QString::fromUtf8(error.what());
  } catch (const std::bad_alloc&) {
    return no_memory.isEmpty() ? QObject::tr("not enough memory") : no_memory;
  }
}

void let_others_go_first() {
#ifdef __linux__
  // QThread::setPriority() has no effect under Linux's usual scheduling, in which a thread has a nice value of
  // its own. A system that refuses it only makes others wait longer.
  constexpr int nicer = 10, nicest = 19;
  const int nice = ::getpriority(PRIO_PROCESS, static_cast<id_t>(::getpid())) + nicer;  // of the first thread
  (void)::setpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid)), std::min(nice, nicest));
#else
  QThread::currentThread()->setPriority(QThread::LowPriority);
#endif
}

void call_in_ui(std::function<void()> call) {
  // Never deleted, because threads may post calls until the program ends.
  static Caller* const caller = [] {
    auto* const created = new Caller;
    created->moveToThread(QCoreApplication::instance()->thread());
    return created;
  }();
  auto* const event = new Call(std::move(call));
  hand_over(event);
  QCoreApplication::postEvent(caller, event);  // Qt deletes the event
}

}  // namespace etak
