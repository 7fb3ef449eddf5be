// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace etak::editor {

/// Milliseconds since this process began, with the loading of its libraries.
struct SinceStart {
  double clock_ms =
      0;  // by the clock, in steps of the kernel's ticks, mostly 10 ms; 0 where there is no /proc
  double work_ms = 0;  // processor time of all threads
};
SinceStart since_start();

}  // namespace etak::editor
