// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pthread.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QFile>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

namespace etak {

/// Milliseconds that the user-interface thread may work without answering; more where sanitizers slow it
/// down.
inline double most_work_ms() {
  return qEnvironmentVariableIsSet("ETAK_TEST_SANITIZED") ? 250 : 50;
}

/// Watches the event loop of the thread that makes this object. Another thread posts a call to it again and
/// again and measures the time until it is made.
class Watchdog {
 public:
  Watchdog() : schedstat_(QStringLiteral("/proc/self/task/%1/schedstat").arg(::syscall(SYS_gettid))) {
    ::pthread_getcpuclockid(::pthread_self(), &ui_clock_);
    thread_ = std::thread([this] { run(); });
  }
  ~Watchdog() { stop(); }
  void stop() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
  }

  /// After stop(): the longest work before one answer. It is measured as processor time of the thread, which
  /// does not grow on a busy machine.
  double work_ms() const { return work_ms_; }

  /// After stop(): the longest wait for an answer without the time that the thread waited for a processor.
  /// What remains is work and waiting for disks, locks and other threads.
  double held_ms() const { return held_ms_; }

 private:
  double ui_ms() const {
    timespec now{};
    ::clock_gettime(ui_clock_, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
  }

  // Milliseconds that the thread has waited for a processor; 0 where the kernel does not tell.
  double in_line_ms() const {
    QFile file(schedstat_);
    if (!file.open(QIODevice::ReadOnly)) return 0;
    const QList<QByteArray> fields = file.readAll().split(' ');
    return fields.size() < 2 ? 0 : 1e-6 * fields[1].toDouble();
  }

  void run() {
    using Clock = std::chrono::steady_clock;
    struct Answer {
      Clock::time_point at;
      std::atomic<bool> given = false;
    };
    while (!stop_) {
      auto answer = std::make_shared<Answer>();
      const double work = ui_ms(), in_line = in_line_ms();
      const Clock::time_point asked = Clock::now();
      QMetaObject::invokeMethod(
          qApp,
          [answer] {
            answer->at = Clock::now();
            answer->given = true;
          },
          Qt::QueuedConnection);
      while (!answer->given && !stop_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (!answer->given) break;
      work_ms_ = std::max(work_ms_, ui_ms() - work);
      const double waited = std::chrono::duration<double, std::milli>(answer->at - asked).count();
      held_ms_ = std::max(held_ms_, waited - (in_line_ms() - in_line));
    }
  }

  QString schedstat_;
  clockid_t ui_clock_{};
  std::atomic<bool> stop_{false};
  double work_ms_ = 0, held_ms_ = 0;
  std::thread thread_;
};

}  // namespace etak
