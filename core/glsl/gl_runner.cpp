// SPDX-License-Identifier: Apache-2.0
#include "core/glsl/gl_runner.h"

#include <algorithm>
#include <chrono>
#include <map>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/glsl/gl_context.h"
#include "core/glsl/gl_objects.h"
#include "core/render/ambient/ambient.h"
#include "core/render/ambient/light_samples.h"
#include "core/render/surface_textures.h"

namespace etak {
namespace {

using namespace gl;
using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::string gl_string(GLenum which) {
  const GLubyte* text = glGetString(which);
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

GlRunner::Info read_info() {
  GlRunner::Info info{gl_string(GL_VENDOR), gl_string(GL_RENDERER), gl_string(GL_VERSION), false};
  for (const char* each : {"llvmpipe", "softpipe", "SwiftShader", "swrast"})
    info.software = info.software || info.renderer.find(each) != std::string::npos;
  return info;
}

}  // namespace

struct GlRunner::State {
  GlContext context;
  Info info = read_info();
  GLuint no_vertices = 0;
  std::map<std::string, std::unique_ptr<Program>> programs;  // by fragment text

  State() {
    glGenVertexArrays(1, &no_vertices);
    glBindVertexArray(no_vertices);
    glDisable(GL_DITHER);
    glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
  }
  ~State() { context.make_current(); }  // the programs belong to this context
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  const Program& use(const GlslText& text) {
    auto& program = programs[text.fragment];
    if (!program) program = std::make_unique<Program>(text.vertex, text.fragment);
    glUseProgram(program->id());
    for (const GlslUniform& uniform : text.uniforms) program->set(uniform);
    return *program;
  }

  static void draw(int corners = 3) { glDrawArrays(GL_TRIANGLE_FAN, 0, corners); }

  static std::vector<float> read_rows_up(int width, int height) {
    std::vector<float> out(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, out.data());
    return out;
  }
};

namespace {

// Puts the program of a scene into use with its uniforms and textures, which stay bound while the value
// lives.
class Prepared {
 public:
  template <class State>
  Prepared(State& state, const Scene& scene, const Environment* environment) {
    validate(scene);
    Scene drawn = with_bright_lights(scene, environment, thread_count(0));
    // The pointer alone says whether there is an environment; a file name without its picture gives no light.
    drawn.lights.environment = environment != nullptr ? "given" : "";
    const GlslText text = glsl_text(drawn);
    corners_ = text.corners;
    const Program& program = state.use(text);
    const auto add = [&](const char* name, const Image& map, bool round = true) {
      program.set_sampler(name, int(textures_.size()));
      textures_.emplace_back(std::make_unique<FloatTexture>(int(textures_.size()), map, round));
    };
    if (scene.textures)
      for (const auto& [name, texture] : samplers_of(*scene.textures)) add(name, *texture, false);
    const auto lobe = drawn.refined ? ambient_table(drawn, held_by_textures(drawn)) : nullptr;
    if (lobe != nullptr && !lobe->samples.empty()) add("ambient_samples", lobe->samples.picture);
    if (environment == nullptr) return;
    if (drawn.refined) {
      const LightSamples& light = environment->samples(drawn.bright_apart, thread_count(0));
      add("environment_samples", light.stack);
      add("environment_irradiance", light.irradiance);
    } else {
      add("environment_irradiance", environment->irradiance_map());
    }
    add("environment_levels", environment->level_stack());
    if (!scene.backdrop.environment) return;
    const Environment::Blurred behind = environment->blurred(scene.backdrop.blur);
    add("backdrop_sharp", *behind.sharp);
    add("backdrop_dull", *behind.dull);
    program.set({"backdrop_share", 1, 1, false, {static_cast<float>(behind.share)}});
  }
  int corners() const { return corners_; }

 private:
  int corners_ = 3;
  std::vector<std::unique_ptr<FloatTexture>> textures_;
};

void clear_to(const Vec3& background) {
  glClearColor(float(background[0]), float(background[1]), float(background[2]), 0);
  glClear(GL_COLOR_BUFFER_BIT);
}

// A picture with rows from the top, made of rows that OpenGL gives from the bottom.
Image rows_down(const Scene& scene, const std::vector<float>& rows_up) {
  Image out(scene.width, scene.height, 4);
  const std::ptrdiff_t row = scene.width * std::ptrdiff_t{4};
  for (int y = 0; y < scene.height; ++y)
    std::copy_n(rows_up.begin() + (scene.height - 1 - y) * row, row, out.values.begin() + y * row);
  return out;
}

// The fourth channel of a texture in the red one.
Image8 fourth_in_red(const Image8& of) {
  Image8 out(of.width, of.height, 4);
  for (std::size_t i = 0; i < out.values.size(); i += 4) out.values[i] = of.values[i + 3];
  return out;
}

}  // namespace

GlRunner::GlRunner() : state_(std::make_unique<State>()) {}
GlRunner::~GlRunner() = default;
GlRunner::GlRunner(GlRunner&&) noexcept = default;

std::optional<GlRunner> GlRunner::open(std::string& why) {
  try {
    return GlRunner();
  } catch (const Error& error) {
    why = error.what();
    return std::nullopt;
  }
}

const GlRunner::Info& GlRunner::info() const {
  return state_->info;
}

std::optional<std::string> GlRunner::compile_error(const std::string& vertex, const std::string& fragment) {
  state_->context.make_current();
  try {
    const Program program(vertex, fragment);
    return std::nullopt;
  } catch (const Error& error) {
    return error.what();
  }
}

Image GlRunner::render(const Scene& scene, const Environment* environment, std::optional<double>* gpu_ms) {
  Scene linear = scene;
  linear.exposure = 1;
  linear.tone = Tone::plain;
  linear.transfer = Transfer::linear;
  state_->context.make_current();
  const Target target(GL_RGBA32F, scene.width, scene.height);
  const Prepared prepared(*state_, linear, environment);
  clear_to(scene.background);
  const GpuClock clock;
  clock.start();
  State::draw(prepared.corners());
  clock.stop();
  const std::vector<float> rows_up = State::read_rows_up(scene.width, scene.height);
  if (gpu_ms != nullptr) *gpu_ms = clock.milliseconds();
  return rows_down(scene, rows_up);
}

Image GlRunner::render(const Scene& scene, const TextureUse& use, const Image8& diffuse_alpha,
                       const Image8& specular_gloss) {
  validate(scene);
  Scene linear = scene;
  linear.exposure = 1;
  linear.tone = Tone::plain;
  linear.transfer = Transfer::linear;
  linear.lights.environment.clear();
  state_->context.make_current();
  const Target target(GL_RGBA32F, scene.width, scene.height);
  clear_to(scene.background);
  const GlslText text = glsl_text(linear, use);
  const Program& program = state_->use(text);
  const CodeTexture a(0, diffuse_alpha),
      b(1, specular_gloss, use.channels == TextureUse::Channels::rgb_alpha);
  program.set_sampler("diffuse_alpha", 0);
  program.set_sampler("specular_gloss", 1);
  std::optional<CodeTexture> alpha, gloss;
  if (use.alpha_apart) {
    alpha.emplace(2, fourth_in_red(diffuse_alpha), false);
    program.set_sampler("alpha_apart", 2);
  }
  if (use.gloss_apart) {
    gloss.emplace(3, fourth_in_red(specular_gloss), false);
    program.set_sampler("gloss_apart", 3);
  }
  State::draw(text.corners);
  return rows_down(scene, State::read_rows_up(scene.width, scene.height));
}

std::vector<std::array<float, 3>> GlRunner::evaluate(const Model& model, const std::vector<double>& values,
                                                     const std::vector<Directions>& directions) {
  constexpr std::size_t width = 256;
  const std::size_t height = std::max<std::size_t>(1, (directions.size() + width - 1) / width);
  std::vector<float> light(width * height * 3), viewer(width * height * 3);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Directions& d = directions[i];
    const double l[] = {d.lx, d.ly, d.lz}, v[] = {d.vx, d.vy, d.vz};
    for (std::size_t j = 0; j < 3; ++j) {
      light[3 * i + j] = static_cast<float>(l[j]);
      viewer[3 * i + j] = static_cast<float>(v[j]);
    }
  }
  const int w = static_cast<int>(width), h = static_cast<int>(height);
  state_->context.make_current();
  const Target target(GL_RGBA32F, w, h);
  const Program& program = state_->use(glsl_evaluation_text(model, values));
  const FloatTexture to_light(0, w, h, light), to_viewer(1, w, h, viewer);
  program.set_sampler("to_light", 0);
  program.set_sampler("to_viewer", 1);
  State::draw();
  const std::vector<float> rgba = State::read_rows_up(w, h);
  glActiveTexture(GL_TEXTURE0);
  std::vector<std::array<float, 3>> out;
  for (std::size_t i = 0; i < directions.size(); ++i)
    out.push_back({rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]});
  return out;
}

float GlRunner::evaluate(std::string_view expression) {
  state_->context.make_current();
  const Target target(GL_RGBA32F, 1, 1);
  state_->use(glsl_expression_text(expression));
  State::draw();
  return State::read_rows_up(1, 1)[0];
}

GlRunner::FrameTime GlRunner::frame_time(const Scene& scene, const Environment* environment, int frames) {
  state_->context.make_current();
  const Target target(GL_RGBA8, scene.width, scene.height);
  FrameTime out;
  const auto start = Clock::now();
  const Prepared prepared(*state_, scene, environment);
  State::draw(prepared.corners());
  glFinish();
  out.compile_ms = milliseconds_since(start);
  const GpuClock clock;
  std::vector<double> times, gpu_times;
  for (int i = 0; i < frames; ++i) {
    const auto begin = Clock::now();
    clock.start();
    State::draw(prepared.corners());
    clock.stop();
    glFinish();
    times.push_back(milliseconds_since(begin));
    if (const auto ms = clock.milliseconds()) gpu_times.push_back(*ms);
  }
  std::sort(times.begin(), times.end());
  out.least_ms = times.front();
  out.median_ms = times[times.size() / 2];
  if (gpu_times.empty()) return out;
  std::sort(gpu_times.begin(), gpu_times.end());
  out.gpu_least_ms = gpu_times.front();
  out.gpu_median_ms = gpu_times[gpu_times.size() / 2];
  return out;
}

}  // namespace etak
