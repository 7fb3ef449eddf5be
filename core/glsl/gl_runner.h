// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/glsl/glsl_text.h"
#include "core/image/image.h"
#include "core/render/environment.h"
#include "core/render/scene.h"

namespace etak {

/// Draws scenes and evaluates models by OpenGL 3.3, without a window or a display (by EGL), on whatever
/// implementation the machine has. All calls must come from the thread that made the runner.
class GlRunner {
 public:
  /// Throws Error that says why OpenGL cannot be used on this machine.
  GlRunner();
  ~GlRunner();
  GlRunner(GlRunner&&) noexcept;

  /// Opens without an exception: nullopt, and the reason in `why`, where OpenGL cannot be used.
  static std::optional<GlRunner> open(std::string& why);

  /// What the driver says of itself.
  struct Info {
    std::string vendor, renderer, version;
    bool software = false;  // a rasteriser on the CPU: Mesa's llvmpipe or softpipe, SwiftShader
  };
  const Info& info() const;

  /// Compiles and links a pair of shaders. Returns nullopt when that works, else the driver's messages and
  /// the lines that they name.
  std::optional<std::string> compile_error(const std::string& vertex, const std::string& fragment);

  /// Draws the same picture as render_cpu(): linear radiance over the background, and the object's coverage
  /// as fourth channel. Throws Error for scenes that validate() refuses.
  ///   gpu_ms   where given, gets the milliseconds of the drawing alone by OpenGL's own clock
  ///            (GL_TIME_ELAPSED); nullopt where there is no such clock. A software rasteriser goes on
  ///            drawing after that clock has stopped: of the 4 to 8 ms of llvmpipe the clock sees 0.1 to 5
  Image render(const Scene& scene, const Environment* environment = nullptr,
               std::optional<double>* gpu_ms = nullptr);

  /// Draws a scene whose material is in the two textures of an atlas: RGBA with sRGB-encoded colours (the
  /// second of no sRGB format where `use` says so), without filtering. Fourth channels that `use` reads apart are taken from
  /// these. The background shows through the holes of a mask. The picture is that of render() above.
  Image render(const Scene& scene, const TextureUse& use, const Image8& diffuse_alpha,
               const Image8& specular_gloss);

  /// f_r of the model in 1/sr: three channels for each pair of directions.
  std::vector<std::array<float, 3>> evaluate(const Model& model, const std::vector<double>& values,
                                             const std::vector<Directions>& directions);

  /// The value of an expression in the language of the formula texts; see glsl_expression_text().
  float evaluate(std::string_view expression);

  /// Milliseconds for a frame, drawn with exposure and transfer into an 8-bit target.
  struct FrameTime {
    double least_ms = 0, median_ms = 0;  // from the call until OpenGL has finished
    double compile_ms = 0;               // of the first frame, for which the shaders are compiled
    // Times by OpenGL's own clock; nullopt where it has none. See render().
    std::optional<double> gpu_least_ms, gpu_median_ms;
  };

  /// Draws a first frame, then `frames` more, and measures their times.
  FrameTime frame_time(const Scene& scene, const Environment* environment, int frames);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace etak
