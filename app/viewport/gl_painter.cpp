// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/gl_painter.h"

#include <QElapsedTimer>
#include <algorithm>
#include <deque>
#include <map>
#include <optional>

#include "app/viewport/display.h"
#include "app/viewport/gl_program.h"
#include "app/viewport/gl_textures.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/render/ambient/ambient.h"
#include "core/render/ambient/light_samples.h"
#include "core/render/surface_textures.h"

namespace etak {
namespace {

constexpr GLenum context_lost_error = 0x0507;  // GL_CONTEXT_LOST of KHR_robustness

double ms_of(const QElapsedTimer& timer) {
  return static_cast<double>(timer.nsecsElapsed()) * 1e-6;
}

}  // namespace

struct GlPainter::State {
  const bool waits;
  Gl& gl = current_gl();
  GLuint no_vertices = 0;
  std::map<std::string, std::unique_ptr<GlProgram>> programs;  // by the text of their fragment shader

  std::shared_ptr<const Environment> environment;
  std::unique_ptr<GlTexture> irradiance, levels;
  std::map<const Image*, std::unique_ptr<GlTexture>>
      maps;  // others of it; made when a backdrop or a refined picture shows them first
  std::shared_ptr<const AmbientTable> lobe;  // whose samples are in `lobe_samples`
  std::unique_ptr<GlTexture> lobe_samples;
  std::shared_ptr<const OcioShader> display;
  std::vector<std::unique_ptr<GlTexture>> tables;

  // The textures of both sides of a comparison, by their samplers; the newest come first.
  struct Laid {
    std::shared_ptr<const SurfaceTextures> of;
    std::vector<std::pair<const char*, std::unique_ptr<GlTexture>>> samplers;
  };
  std::deque<Laid> laid;

  const Laid& take_textures(const std::shared_ptr<const SurfaceTextures>& wanted) {
    for (const Laid& each : laid)
      if (each.of == wanted) return each;
    if (laid.size() >= 2) laid.pop_back();
    Laid& out = laid.emplace_front(Laid{wanted, {}});
    for (const auto& [name, texture] : samplers_of(*wanted))
      out.samplers.emplace_back(name, gl_texture(*texture, false));
    return out;
  }

  explicit State(bool waits_for_end) : waits(waits_for_end) { gl.glGenVertexArrays(1, &no_vertices); }
  ~State() { gl.glDeleteVertexArrays(1, &no_vertices); }

  // Waits for the end of the drawing by short polls, between which this thread sleeps.
  void wait() const {
    if (!waits) return;
    constexpr GLuint64 poll_ns = 1'000'000;
    const GLsync end = gl.glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    while (gl.glClientWaitSync(end, GL_SYNC_FLUSH_COMMANDS_BIT, poll_ns) == GL_TIMEOUT_EXPIRED) {
    }
    gl.glDeleteSync(end);
  }

  void take(const std::shared_ptr<const Environment>& wanted) {
    if (wanted == environment) return;
    irradiance.reset();
    levels.reset();
    maps.clear();
    environment = wanted;
    if (!environment) return;
    irradiance = gl_texture(environment->irradiance_map(), true);
    levels = gl_texture(environment->level_stack(), true);
  }

  void take(const std::shared_ptr<const OcioShader>& wanted) {
    if (wanted == display) return;
    tables.clear();
    display = wanted;
    if (display)
      for (const OcioShader::Table& table : display->tables) tables.push_back(gl_texture(table));
  }

  GlTexture& environment_texture(const Image* map) {
    std::unique_ptr<GlTexture>& out = maps[map];
    if (!out) out = gl_texture(*map, true);
    return *out;
  }

  void bind_textures(GlProgram& program, const Scene& scene) {
    std::optional<Environment::Blurred> behind;
    if (environment && scene.backdrop.environment) {
      behind = environment->blurred(scene.backdrop.blur);
      for (const Image* map : {behind->sharp, behind->dull}) (void)environment_texture(map);
    }
    const LightSamples* light = nullptr;
    if (scene.refined) {
      if (environment) light = &environment->samples(scene.bright_apart, thread_count(0));
      if (light != nullptr)
        for (const Image* map : {&light->irradiance, &light->stack}) (void)environment_texture(map);
      const auto table = ambient_table(scene, held_by_textures(scene));
      if (table != lobe && !table->samples.empty()) lobe_samples = gl_texture(table->samples.picture, false);
      lobe = table;
    }
    // Textures are made before any is bound for drawing, because making a texture binds it to unit 0.
    const Laid* surface = scene.textures ? &take_textures(scene.textures) : nullptr;
    int unit = 0;
    const auto bind = [&](GlTexture& texture, const std::string& sampler) {
      texture.bind(static_cast<GLuint>(unit));
      program.set_sampler(sampler, unit++);
    };
    if (environment) {
      bind(light != nullptr ? environment_texture(&light->irradiance) : *irradiance,
           "environment_irradiance");
      bind(*levels, "environment_levels");
    }
    if (light != nullptr) bind(environment_texture(&light->stack), "environment_samples");
    if (scene.refined && !lobe->samples.empty()) bind(*lobe_samples, "ambient_samples");
    if (behind) {
      bind(environment_texture(behind->sharp), "backdrop_sharp");
      bind(environment_texture(behind->dull), "backdrop_dull");
      program.set({"backdrop_share", 1, 1, false, {static_cast<float>(behind->share)}});
    }
    if (surface != nullptr)
      for (const auto& [name, texture] : surface->samplers) bind(*texture, name);
    for (std::size_t i = 0; i < tables.size(); ++i) bind(*tables[i], display->tables[i].sampler);
  }

  // Milliseconds of compiling in this frame, and of compiling the tile's program, in whichever frame that
  // was.
  struct Compiled {
    double now_ms = 0, ms = 0;
  };
  Compiled draw_tile(ViewTile tile, int height) {
    tile.scene = with_bright_lights(tile.scene, environment.get(), thread_count(0));
    GlslDisplay shown;
    if (display) shown = {display->text, display->function, "OpenColorIO"};
    const GlslParts parts = glsl_parts(tile.scene, display ? &shown : nullptr);
    Compiled out;
    if (parts.beside) out = draw_text(*parts.beside, tile, height);
    const Compiled object = draw_text(parts.object, tile, height);
    return {out.now_ms + object.now_ms, out.ms + object.ms};
  }

  Compiled draw_text(const GlslText& text, const ViewTile& tile, int height) {
    QElapsedTimer timer;
    timer.start();
    // Limits the memory of a session in which very many programs are used.
    if (programs.size() > 200 && !programs.contains(text.fragment)) programs.clear();
    std::unique_ptr<GlProgram>& program = programs[text.fragment];
    if (!program) program = std::make_unique<GlProgram>(text);
    const double now_ms = draw_with(*program, text, tile, height, timer);
    return {now_ms, program->compile_ms};
  }

  // Draws a tile. Returns the milliseconds of compiling, where the program draws for the first time; else 0.
  double draw_with(GlProgram& program, const GlslText& text, const ViewTile& tile, int height,
                   const QElapsedTimer& timer) {
    const int bottom = height - tile.y - tile.scene.height;
    program.use();
    for (const GlslUniform& uniform : text.uniforms) program.set(uniform);
    program.set({"picture_origin", 2, 1, false, {static_cast<float>(tile.x), static_cast<float>(bottom)}});
    bind_textures(program, tile.scene);
    gl.glViewport(tile.x, bottom, tile.scene.width, tile.scene.height);
    const int first = std::max(bottom, rows.first),
              last = std::min(bottom + tile.scene.height, rows.first + rows.count);
    gl.glScissor(tile.clip_first, first, tile.clip_last - tile.clip_first, std::max(0, last - first));
    gl.glDrawArrays(text.ring ? GL_TRIANGLE_STRIP : GL_TRIANGLE_FAN, 0, text.corners);
    if (program.drawn) return 0;
    // Drivers put off part of the compiling until the first drawing.
    wait();
    program.drawn = true;
    program.compile_ms = ms_of(timer);
    return program.compile_ms;
  }

  // The background of a scene in the codes of the display.
  QColor background(const Scene& scene, const ViewDisplay& shows) {
    Image pixel(1, 1, 4);
    for (std::size_t c = 0; c < 3; ++c)
      pixel.values[c] = static_cast<float>(scene.background[c] * scene.exposure);
    return shown(pixel, shows, 1).pixelColor(0, 0);
  }

  Rows rows;  // the rows that are drawn

  Drawn draw(const std::vector<ViewTile>& tiles, const ViewDisplay& shows, const GlTarget& target) {
    Drawn out;
    double compile_ms = 0;
    const QSize size = target.size();
    QElapsedTimer timer;
    timer.start();
    gl.glBindFramebuffer(GL_FRAMEBUFFER, target.handle());
    gl.glBindVertexArray(no_vertices);
    gl.glDisable(GL_DITHER);
    gl.glDisable(GL_BLEND);
    gl.glDisable(GL_DEPTH_TEST);
    gl.glDisable(GL_CULL_FACE);
    gl.glDisable(GL_SCISSOR_TEST);
    gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.glViewport(0, 0, size.width(), size.height());
    out.background = tiles.empty() ? QColor(51, 51, 51) : background(tiles.front().scene, shows);
    gl.glClearColor(out.background.redF(), out.background.greenF(), out.background.blueF(), 1);
    if (rows.first == 0) gl.glClear(GL_COLOR_BUFFER_BIT);
    // Shaders write the coverage of the object into the fourth channel, which in a window would be opacity.
    gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    gl.glEnable(GL_SCISSOR_TEST);
    for (const ViewTile& tile : tiles) {
      const Compiled compiled = draw_tile(tile, size.height());
      compile_ms += compiled.now_ms;
      if (&tile == &tiles.front()) out.compile_ms = compiled.ms;
    }
    gl.glDisable(GL_SCISSOR_TEST);
    gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.glActiveTexture(GL_TEXTURE0);
    wait();
    for (GLenum error = gl.glGetError(); error != GL_NO_ERROR && !out.context_lost; error = gl.glGetError())
      out.context_lost = error == context_lost_error;
    out.frame_ms = ms_of(timer) - compile_ms;
    return out;
  }
};

GlPainter::GlPainter(bool waits) : state_(std::make_unique<State>(waits)) {}
GlPainter::~GlPainter() = default;

GlPainter::Drawn GlPainter::draw(const std::vector<ViewTile>& tiles,
                                 const std::shared_ptr<const Environment>& environment,
                                 const ViewDisplay& display, const GlTarget& target, const Rows& rows) {
  state_->rows = rows;
  state_->take(environment);
  state_->take(display.gpu);
  return state_->draw(tiles, display, target);
}

double GlPainter::enlarge(const GlTarget& small, const GlTarget& target) {
  Gl& gl = state_->gl;
  QElapsedTimer timer;
  timer.start();
  gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, small.handle());
  gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.handle());
  gl.glBlitFramebuffer(0, 0, small.size().width(), small.size().height(), 0, 0, target.size().width(),
                       target.size().height(), GL_COLOR_BUFFER_BIT, GL_LINEAR);
  state_->wait();
  return ms_of(timer);
}

QImage GlPainter::picture(const std::vector<ViewTile>& tiles,
                          const std::shared_ptr<const Environment>& environment, const ViewDisplay& display,
                          const QSize& size) {
  Gl& gl = state_->gl;
  const auto target = gl_target(size);
  draw(tiles, environment, display, *target, {});
  QImage out(size, QImage::Format_RGBX8888);
  gl.glPixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.glReadPixels(0, 0, size.width(), size.height(), GL_RGBA, GL_UNSIGNED_BYTE, out.bits());
  return out.mirrored();
}

}  // namespace etak
