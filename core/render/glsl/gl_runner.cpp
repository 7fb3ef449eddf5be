// SPDX-License-Identifier: Apache-2.0
#include "core/render/glsl/gl_runner.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <sstream>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/render/ambient/ambient.h"
#include "core/render/ambient/light_samples.h"
#include "core/render/glsl/gl_context.h"

namespace etak {
namespace {

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

// The driver's messages, each with the line of the shader that it names ("0:12(5): error" or "0(12) : error")
// below it, so that a message can be understood without the shader.
std::string with_lines(const std::string& log, const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::string out;
  std::istringstream messages(log);
  for (std::string message; std::getline(messages, message);) {
    out += (out.empty() ? "" : "\n") + message;
    const std::size_t digits = message.find_first_of("0123456789", message.find_first_of(":(") + 1);
    if (message.find_first_of(":(") == std::string::npos || digits == std::string::npos) continue;
    const std::size_t number = std::strtoul(message.c_str() + digits, nullptr, 10);
    if (number >= 1 && number <= lines.size()) out += "\n  " + lines[number - 1];
  }
  return out;
}

// A linked program. The constructor throws Error with the driver's message.
class Program {
 public:
  Program(const std::string& vertex, const std::string& fragment) : id_(glCreateProgram()) {
    try {
      attach(GL_VERTEX_SHADER, vertex);
      attach(GL_FRAGMENT_SHADER, fragment);
      glLinkProgram(id_);
      GLint linked = 0, length = 0;
      glGetProgramiv(id_, GL_LINK_STATUS, &linked);
      if (linked) return;
      glGetProgramiv(id_, GL_INFO_LOG_LENGTH, &length);
      std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
      glGetProgramInfoLog(id_, length, nullptr, log.data());
      throw Error::at("shader", log.c_str());
    } catch (...) {
      glDeleteProgram(id_);
      throw;
    }
  }
  ~Program() { glDeleteProgram(id_); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  GLuint id() const { return id_; }

  void set(const GlslUniform& uniform) const {
    const GLint at = glGetUniformLocation(id_, uniform.name.c_str());
    if (at < 0) return;  // the driver has removed it, because nothing uses it
    const float* values = uniform.values.data();
    switch (uniform.width) {
      case 1:
        glUniform1fv(at, uniform.count, values);
        break;
      case 2:
        glUniform2fv(at, uniform.count, values);
        break;
      default:
        glUniform3fv(at, uniform.count, values);
        break;
    }
  }
  void set_sampler(const char* name, GLint unit) const { glUniform1i(glGetUniformLocation(id_, name), unit); }

 private:
  void attach(GLenum kind, const std::string& text) const {
    const GLuint shader = glCreateShader(kind);
    const char* source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint compiled = 0, length = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    if (!compiled) glGetShaderInfoLog(shader, length, nullptr, log.data());
    glAttachShader(id_, shader);
    glDeleteShader(shader);
    if (!compiled) throw Error::at("shader", with_lines(log.c_str(), text));
  }

  GLuint id_;
};

// A framebuffer with one texture, which is bound while the value lives.
class Target {
 public:
  Target(GLenum format, int width, int height) {
    glGenFramebuffers(1, &frame_);
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      remove();
      throw Error::at("OpenGL", "cannot draw into a target of " + std::to_string(width) + " x " +
                                    std::to_string(height) + " pixels");
    }
    glViewport(0, 0, width, height);
  }
  ~Target() { remove(); }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

 private:
  void remove() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &frame_);
    glDeleteTextures(1, &texture_);
  }
  GLuint frame_ = 0, texture_ = 0;
};

// A float texture of three channels on texture unit `unit`. A latitude-longitude map is filtered bilinearly;
// an array of numbers is read texel by texel.
class FloatTexture {
 public:
  FloatTexture(int unit, const Image& map)
      : FloatTexture(unit, map.width, map.height, map.values, map.channels == 4 ? GL_RGBA : GL_RGB) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  FloatTexture(int unit, int width, int height, const std::vector<float>& rgb, GLenum channels = GL_RGB) {
    glGenTextures(1, &id_);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    // Drivers read texels of four floats faster than those of three.
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, channels, GL_FLOAT, rgb.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  ~FloatTexture() { glDeleteTextures(1, &id_); }
  FloatTexture(const FloatTexture&) = delete;
  FloatTexture& operator=(const FloatTexture&) = delete;

 private:
  GLuint id_ = 0;
};

// A texture of 8-bit codes on texture unit `unit`: four channels, sRGB-encoded colours, without filtering.
class CodeTexture {
 public:
  CodeTexture(int unit, const Image8& rgba) {
    glGenTextures(1, &id_);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, rgba.width, rgba.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 rgba.values.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  ~CodeTexture() { glDeleteTextures(1, &id_); }
  CodeTexture(const CodeTexture&) = delete;
  CodeTexture& operator=(const CodeTexture&) = delete;

 private:
  GLuint id_ = 0;
};

// Measures the time of drawing between start() and stop() by OpenGL's own clock, where it has one.
class GpuClock {
 public:
  GpuClock() {
    GLint bits = 0;
    glGetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    if (bits > 0) glGenQueries(1, &query_);
  }
  ~GpuClock() {
    if (query_ != 0) glDeleteQueries(1, &query_);
  }
  GpuClock(const GpuClock&) = delete;
  GpuClock& operator=(const GpuClock&) = delete;

  void start() const {
    if (query_ != 0) glBeginQuery(GL_TIME_ELAPSED, query_);
  }
  void stop() const {
    if (query_ != 0) glEndQuery(GL_TIME_ELAPSED);
  }
  /// The time between the last start() and stop(). Waits until OpenGL has finished drawing.
  std::optional<double> milliseconds() const {
    if (query_ == 0) return std::nullopt;
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query_, GL_QUERY_RESULT, &nanoseconds);
    return static_cast<double>(nanoseconds) * 1e-6;
  }

 private:
  GLuint query_ = 0;
};

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
    if (scene.textures) throw Error::at("scene", "has textures", "one without them for this way of drawing");
    Scene drawn = with_bright_lights(scene, environment, thread_count(0));
    // The pointer alone says whether there is an environment; a file name without its picture gives no light.
    drawn.lights.environment = environment != nullptr ? "given" : "";
    const GlslText text = glsl_text(drawn);
    corners_ = text.corners;
    const Program& program = state.use(text);
    const auto add = [&](const char* name, const Image& map) {
      program.set_sampler(name, int(textures_.size()));
      textures_.emplace_back(std::make_unique<FloatTexture>(int(textures_.size()), map));
    };
    const auto lobe = drawn.refined ? ambient_table(drawn, {}) : nullptr;
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
  const CodeTexture a(0, diffuse_alpha), b(1, specular_gloss);
  program.set_sampler("diffuse_alpha", 0);
  program.set_sampler("specular_gloss", 1);
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
