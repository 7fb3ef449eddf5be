// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/egl.h>

#include <string>

namespace etak {

/// An OpenGL 3.3 core context without a window. It is current on the thread that makes it, and is destroyed
/// with the value. The constructor throws Error where OpenGL is missing.
class GlContext {
 public:
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Makes the context current again on this thread, after another one may have been made current.
  void make_current() const;

 private:
  bool open(EGLDisplay display, std::string& why);

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace etak
