// SPDX-License-Identifier: Apache-2.0
#include "core/glsl/gl_context.h"

#include <dlfcn.h>

#include <array>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace etak {
namespace {

constexpr const char* needed = "EGL with OpenGL 3.3 (Debian: libegl1, libgl1-mesa-dri)";

bool has_word(const char* list, std::string_view word) {
  return list != nullptr &&
         (" " + std::string(list) + " ").find(" " + std::string(word) + " ") != std::string::npos;
}

// The EGL displays to try, in this order: Mesa's surfaceless platform and each device, which need no window
// system; then the default display. Throws Error where there is no libEGL.
std::vector<EGLDisplay> displays() {
  // libEGL is looked for here, because libepoxy ends the program when there is none.
  if (void* const library = dlopen("libEGL.so.1", RTLD_LAZY); library == nullptr)
    throw Error::at("OpenGL", "there is no libEGL.so.1", needed);
  std::vector<EGLDisplay> out;
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (has_word(client, "EGL_EXT_platform_base")) {
    if (has_word(client, "EGL_MESA_platform_surfaceless"))
      out.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    if (has_word(client, "EGL_EXT_platform_device") && has_word(client, "EGL_EXT_device_enumeration")) {
      std::array<EGLDeviceEXT, 8> devices{};
      EGLint count = 0;
      if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count))
        for (EGLint i = 0; i < count; ++i)
          out.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT,
                                                 devices[static_cast<std::size_t>(i)], nullptr));
    }
  }
  out.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
  return out;
}

}  // namespace

GlContext::GlContext() {
  std::string why = "EGL gives no display";
  for (const EGLDisplay display : displays())
    if (open(display, why)) return;
  throw Error::at("OpenGL", why, needed);
}

GlContext::~GlContext() {
  if (eglGetCurrentContext() == context_)
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

void GlContext::make_current() const {
  if (eglGetCurrentContext() != context_) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
}

bool GlContext::open(EGLDisplay display, std::string& why) {
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return false;
  why = "no OpenGL 3.3 core context without a surface";
  if (!eglBindAPI(EGL_OPENGL_API)) return false;
  const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  eglChooseConfig(display, wanted, &config, 1, &count);
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               3,
                               EGL_CONTEXT_MINOR_VERSION,
                               3,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_NONE};
  const EGLContext context =
      eglCreateContext(display, count > 0 ? config : nullptr, EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT) return false;
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    eglDestroyContext(display, context);
    return false;
  }
  display_ = display;
  context_ = context;
  return true;
}

}  // namespace etak
