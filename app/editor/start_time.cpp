// SPDX-License-Identifier: Apache-2.0
#include "app/editor/start_time.h"

#include <time.h>
#include <unistd.h>

#include <QFile>

namespace etak::editor {
namespace {

double ms_of(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

}  // namespace

SinceStart since_start() {
  SinceStart out;
  out.work_ms = ms_of(CLOCK_PROCESS_CPUTIME_ID);
  QFile file("/proc/self/stat");
  if (!file.open(QIODevice::ReadOnly)) return out;
  // The name of the program in brackets may hold any character. The start time is the twentieth field behind
  // it, in ticks since boot.
  const QByteArray text = file.readAll();
  const QList<QByteArray> fields = text.mid(text.lastIndexOf(')') + 2).split(' ');
  constexpr qsizetype start = 19;
  if (fields.size() <= start) return out;
  const double ticks_a_second = static_cast<double>(::sysconf(_SC_CLK_TCK));
  out.clock_ms = ms_of(CLOCK_BOOTTIME) - 1e3 * fields[start].toDouble() / ticks_a_second;
  return out;
}

}  // namespace etak::editor
