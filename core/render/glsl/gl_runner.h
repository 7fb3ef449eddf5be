// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/image.h"
#include "core/render/environment.h"
#include "core/render/glsl/glsl_text.h"
#include "core/render/scene.h"

namespace etak {

/// OpenGL 3.3 without a window or a display (EGL): draws scenes and evaluates models on whatever GL the
/// machine has. All calls come from the thread that made the runner.
class GlRunner {
 public:
  /// Throws Error that says why there is no GL here.
  GlRunner();
  ~GlRunner();
  GlRunner(GlRunner&&) noexcept;

  /// The same; none, and the reason in `why`, where there is no GL.
  static std::optional<GlRunner> open(std::string& why);

  struct Info {
    std::string vendor, renderer, version;
    bool software = false;  // a rasteriser on the CPU: Mesa's llvmpipe or softpipe, SwiftShader
  };
  const Info& info() const;

  /// Compiles and links a pair of shaders; the driver's message, with the lines it speaks of, when that
  /// fails.
  std::optional<std::string> compile_error(const std::string& vertex, const std::string& fragment);

  /// The same picture as render_cpu(): linear radiance over the background, the object's coverage as fourth
  /// channel. Throws Error for scenes that validate() refuses.
  ///   gpu_ms   when given, gets the milliseconds of the drawing alone by the GL's own clock
  ///            (GL_TIME_ELAPSED); none where the GL has no such clock. A software rasteriser draws on after
  ///            that clock has stopped: of llvmpipe's 4 to 8 ms the clock sees 0.1 to 5
  Image render(const Scene& scene, const Environment* environment = nullptr,
               std::optional<double>* gpu_ms = nullptr);

  /// A scene whose material is in a texture pair, RGBA with sRGB-encoded colours, one texel at a time; the
  /// background shows through the holes of a mask. Linear as render().
  Image render(const Scene& scene, const TextureUse& use, const Image8& diffuse_alpha,
               const Image8& specular_gloss);

  /// f_r of the model, one row of three per pair of directions.
  std::vector<std::array<float, 3>> evaluate(const Model& model, const std::vector<double>& values,
                                             const std::vector<Directions>& directions);

  /// The value of an expression of the formula texts (glsl_expression_text).
  float evaluate(std::string_view expression);

  /// Milliseconds per frame with exposure and transfer into an 8-bit target, after a first frame that
  /// compiles: from the call until the GL is done, and (gpu) by its own clock where it has one; see render().
  struct FrameTime {
    double least_ms = 0, median_ms = 0, compile_ms = 0;
    std::optional<double> gpu_least_ms, gpu_median_ms;
  };
  FrameTime frame_time(const Scene& scene, const Environment* environment, int frames);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace etak
