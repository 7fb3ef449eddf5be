// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/render/environment.h"
#include "core/render/glsl_text.h"
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
  Image render(const Scene& scene, const Environment* environment = nullptr);

  /// f_r of the model, one row of three per pair of directions.
  std::vector<std::array<float, 3>> evaluate(const Model& model, const std::vector<double>& values,
                                             const std::vector<Directions>& directions);

  /// Milliseconds per frame with exposure and transfer into an 8-bit target, after a first frame that
  /// compiles.
  struct FrameTime {
    double least_ms = 0, median_ms = 0, compile_ms = 0;
  };
  FrameTime frame_time(const Scene& scene, const Environment* environment, int frames);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace etak
