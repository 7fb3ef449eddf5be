// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>

#include "core/glsl/gl_runner.h"

namespace etak::test {

/// The OpenGL runner of this machine, the same for all tests of a run. Where there is no OpenGL, prints the
/// reason and returns null.
inline GlRunner* gl_here() {
  static std::string why;
  static std::optional<GlRunner> runner = GlRunner::open(why);
  if (!runner) std::printf("skipped: %s\n", why.c_str());
  return runner ? &*runner : nullptr;
}

}  // namespace etak::test
