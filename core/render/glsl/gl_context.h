// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/egl.h>

#include <string>

namespace etak {

/// A GL 3.3 core context without a window, current on this thread when made and from make_current() on; destroyed with
/// the value. Throws Error where there is none.
class GlContext {
 public:
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Another context may have come between.
  void make_current() const;

 private:
  bool open(EGLDisplay display, std::string& why);

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace etak
