// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pictures/render.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "app/cli/output/progress.h"
#include "app/cli/output/replace.h"
#include "app/cli/pictures/sheet.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json/json_text.h"
#include "core/base/memory.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/color/ocio.h"
#include "core/glsl/gl_runner.h"
#include "core/image/files/png.h"
#include "core/image/image_io.h"
#include "core/image/mesh_codecs.h"
#include "core/project/shown_mesh.h"
#include "core/render/ambient/accuracy.h"
#include "core/render/ambient/ambient.h"
#include "core/render/cpu_renderer.h"
#include "core/render/display.h"
#include "core/render/engines.h"
#include "core/render/ground_bounce.h"
#include "core/render/reference.h"
#include "core/render/view_moves.h"

namespace etak::cli {
namespace {

using Clock = std::chrono::steady_clock;

// Facts about a picture and its drawing, for remarks and JSON.
struct Stats {
  std::string subject, device;
  std::vector<double> frame_ms;
  std::vector<double> gpu_ms;  // measured by OpenGL's timer; empty where there is none
  bool software_gl = false;
  std::optional<double> standard_error, worst_error;
  std::optional<AmbientError> ambient;
  const Engine* engine = nullptr;
  double mean_de = 0, max_de = 0;  // of the engine
  double prepare_ms = 0;
};

double median(std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  return ms[ms.size() / 2];
}

double least(const std::vector<double>& ms) {
  return *std::min_element(ms.begin(), ms.end());
}

double ms_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

Image8 codes_of(const RenderArguments& arguments, const Scene& scene, const Image& picture) {
  const bool by_ocio = !arguments.display.empty() || !arguments.view.empty() || !arguments.ocio.empty();
  if (!by_ocio) return to_codes(picture, scene.exposure, scene.transfer, scene.tone);
  Image shown = exposed(picture, scene.exposure);
  OcioConfig::open(arguments.ocio)
      .display(arguments.display, arguments.view)
      .apply(shown.values.data(), shown.pixel_count());
  Image8 codes(shown.width, shown.height, 3);
  std::transform(shown.values.begin(), shown.values.end(), codes.values.begin(), to_code);
  return codes;
}

void write_picture(const RenderArguments& arguments, const Scene& scene, Image picture,
                   const std::string& file) {
  const bool force = arguments.stats.force;
  if (file.ends_with(".exr")) {
    if (!arguments.transparent)
      return write_exr(file, exposed(picture, scene.exposure), !arguments.half, force);
    for (std::size_t i = 0; i < picture.values.size(); ++i)
      if (i % 4 != 3) picture.values[i] *= static_cast<float>(scene.exposure);
    return write_exr(file, picture, !arguments.half, force);
  }
  if (!arguments.transparent) return write_png(file, codes_of(arguments, scene, picture), force);
  picture = unmultiplied(std::move(picture));
  write_file(file, png_bytes(with_opacity(codes_of(arguments, scene, picture), picture), {}), force);
}

Image draw_reference(const RenderArguments& arguments, const Scene& scene, const Environment* environment,
                     unsigned threads, Stats& stats) {
  const int side = static_cast<int>(std::lround(std::sqrt(arguments.samples)));
  if (side * side != arguments.samples)
    throw Error::at("--spp", std::to_string(arguments.samples), "a square number: 1, 4, 9, 16, 25, ...");
  const ReferenceOptions options{side, arguments.light_samples, threads};
  stats.device = "reference";
  const auto begin = Clock::now();
  Progress progress(arguments.stats, static_cast<std::size_t>(scene.height), "render");
  Reference reference = render_reference(scene, environment, options, [&](std::size_t rows, unsigned worker) {
    progress.advance(rows, worker);
  });
  stats.frame_ms.push_back(ms_since(begin));
  const bool sampled = (environment != nullptr || scene.lights.hemispheres) && arguments.light_samples > 0;
  if (sampled) {
    stats.standard_error = reference.standard_error;
    stats.worst_error = reference.worst_error;
    // A picture of a quarter of the size gives nearly the same error at a sixteenth of the cost.
    Scene small = scene;
    small.width = std::max(16, scene.width / 4);
    small.height = std::max(16, scene.height / 4);
    stats.ambient = ambient_error(small, environment, options);
  }
  return std::move(reference.picture);
}

Image draw_gl(const Scene& scene, const Environment* environment, int frames, Stats& stats) {
  GlRunner gl;
  stats.device = "gl: " + gl.info().renderer;
  stats.software_gl = gl.info().software;
  Image out;
  for (int i = 0; i < frames; ++i) {
    const auto begin = Clock::now();
    std::optional<double> gpu_ms;
    out = gl.render(scene, environment, &gpu_ms);
    stats.frame_ms.push_back(ms_since(begin));
    if (gpu_ms) stats.gpu_ms.push_back(*gpu_ms);
  }
  return out;
}

Image draw_cpu(const RenderArguments& arguments, const Scene& scene, const Environment* environment,
               unsigned threads, Stats& stats) {
  stats.device = "cpu: " + std::string(batch_instruction_set());
  Image out;
  for (int i = 0; i < arguments.frames; ++i) {
    Progress progress(arguments.stats, static_cast<std::size_t>(scene.height), "render");
    const auto begin = Clock::now();
    render_cpu(scene, environment, threads, Precision::f32, out,
               [&](std::size_t rows, unsigned worker) { progress.advance(rows, worker); });
    stats.frame_ms.push_back(ms_since(begin));
  }
  return out;
}

std::string numbers(const std::vector<double>& values) {
  return "[" + joined(values, ", ", [](double value) { return number(value, 9); }) + "]";
}

std::string model_json(const Model* model, const std::vector<double>& values) {
  if (model == nullptr) return "null";
  return json_object({{"id", json(model->id)}, {"values", numbers(values)}}, -1);
}

std::string times_json(const std::vector<double>& ms) {
  return json_object(
      {{"least", number(least(ms), 6)}, {"median", number(median(ms), 6)}, {"frames", json(ms.size())}}, -1);
}

std::string surface_json(const SurfaceValues& s) {
  const auto three = [](const Vec3& v) { return numbers({v[0], v[1], v[2]}); };
  std::vector<JsonMember> out{{"f0", three(s.f0)},
                              {"f82", three(s.f82)},
                              {"n", three(s.n)},
                              {"k", three(s.k)},
                              {"nk_residual", three(s.nk_residual)},
                              {"diffuse", three(s.diffuse)},
                              {"gloss", number(double{s.gloss}, 9)},
                              {"roughness", number(s.gloss.roughness(), 9)},
                              {"opacity", number(s.opacity, 9)}};
  if (s.curve)
    out.push_back({"curve", json_object({{"colors", json(s.curve->colors.size())},
                                         {"error", number(s.curve->off.de2000, 3)},
                                         {"at_deg", number(s.curve->off.at_deg, 3)}},
                                        -1)});
  if (s.emission != Vec3{}) out.push_back({"emission", three(s.emission)});
  if (s.occlusion != 1) out.push_back({"occlusion", number(s.occlusion, 9)});
  return json_object(out, -1);
}

// How the light of hemispheres and environment was drawn.
std::string ambient_json(const Scene& scene, const Stats& stats) {
  if (stats.device == "reference") return json_object({{"form", json("reference")}}, -1);
  return json_object({{"form", json(scene.refined ? "refined" : "moving")}}, -1);
}

std::string json_form(const Scene& scene, const Stats& stats, const SceneNotes& notes, unsigned threads) {
  std::vector<JsonMember> out{{"schema", json("etak-render/1")},
                              {"subject", json(stats.subject)},
                              {"size", numbers({double(scene.width), double(scene.height)})},
                              {"surface", surface_json(scene.surface)},
                              {"specular", model_json(scene.specular, scene.specular_values)},
                              {"diffuse", model_json(scene.diffuse, scene.diffuse_values)},
                              {"lights", json(scene.lights.lights.size())},
                              {"ambient", ambient_json(scene, stats)},
                              {"device", json(stats.device)},
                              {"threads", json(std::size_t{threads})},
                              {"prepare_ms", number(stats.prepare_ms, 6)},
                              {"frame_ms", times_json(stats.frame_ms)}};
  if (!stats.gpu_ms.empty()) out.push_back({"gpu_ms", times_json(stats.gpu_ms)});
  if (stats.standard_error)
    out.push_back({"standard_error", json_object({{"rms", number(*stats.standard_error, 6)},
                                                  {"worst", number(*stats.worst_error, 6)}},
                                                 -1)});
  if (stats.ambient)
    out.push_back({"real_time_ambient_error",
                   json_object({{"mean", number(stats.ambient->mean, 6)},
                                {"bias", number(stats.ambient->bias, 6)},
                                {"worst", number(stats.ambient->worst, 6)},
                                {"standard_error", number(stats.ambient->standard_error, 6)}},
                               -1)});
  if (stats.engine != nullptr) {
    out.push_back({"as", json_object({{"engine", json(stats.engine->id)},
                                      {"source", json(stats.engine->source)},
                                      {"not_drawn", json(stats.engine->not_drawn)}},
                                     -1)});
    out.push_back(
        {"delta_e", json_object({{"mean", number(stats.mean_de, 4)}, {"max", number(stats.max_de, 4)}}, -1)});
  }
  if (const auto off = scene.specular != nullptr && !scene.lights.environment.empty()
                           ? ambient_accuracy(scene.specular->id, scene.surface.gloss, scene.refined)
                           : std::nullopt)
    out.push_back({"ambient_error", json_object({{"mean", number(off->mean, 3)},
                                                 {"picture", number(off->picture, 3)},
                                                 {"p99", number(off->p99, 3)}},
                                                -1)});
  out.push_back({"remarks", json_array_of(notes.remarks)});
  return json_object(out, 0) + '\n';
}

void say(const RenderArguments& arguments, const Scene& scene, const Stats& stats, const SceneNotes& notes,
         unsigned threads) {
  for (const std::string& each : notes.remarks) remark(arguments.stats, each);
  if (arguments.stats.format == "json")
    return write_output(arguments.stats, json_form(scene, stats, notes, threads));
  if (stats.frame_ms.size() > 1)
    remark(arguments.stats, stats.device + ", " + std::to_string(threads) +
                                " threads: " + number(median(stats.frame_ms), 4) + " ms a frame (median), " +
                                number(least(stats.frame_ms), 4) + " ms (least)");
  if (stats.gpu_ms.size() > 1)
    remark(arguments.stats, "of which, by the GL's own clock, " + number(median(stats.gpu_ms), 4) +
                                " ms (median), " + number(least(stats.gpu_ms), 4) + " ms (least)" +
                                (stats.software_gl ? "; a software rasteriser draws on after that clock stops"
                                                   : "; the rest is preparing and reading back"));
  if (stats.standard_error)
    remark(arguments.stats, "standard error of a pixel's luminance " + number(*stats.standard_error, 2) +
                                " (rms), " + number(*stats.worst_error, 2) + " (worst)");
  if (stats.ambient)
    remark(arguments.stats, "the real-time hemispheres and environment are off by " +
                                number(100 * stats.ambient->mean, 2) + " % (mean), " +
                                number(100 * stats.ambient->worst, 3) + " % (worst), bias " +
                                number(100 * stats.ambient->bias, 2) + " %, of the mean luminance");
}

// Draws the scene as the engine of --as does, where there is one.
void become_engine(const RenderArguments& arguments, const Environment* light, unsigned threads, Scene& scene,
                   SceneNotes& notes, Stats& stats) {
  if (arguments.as.empty()) return;
  stats.engine = find_engine(arguments.as);
  const DifferencePicture off = engine_difference(*stats.engine, scene, light, threads);
  stats.mean_de = off.mean_de;
  stats.max_de = off.max_de;
  std::vector<ClampedValue> changed;
  scene = shown_as(*stats.engine, std::move(scene), changed);
  for (const ClampedValue& each : changed) notes.remarks.push_back(clamped_remark(each));
  std::string text = std::string(stats.engine->title) + ": dE2000 to the exact material " +
                     number(off.mean_de, 3) + " (mean), " + number(off.max_de, 3) + " (largest)";
  if (!stats.engine->not_drawn.empty()) text += "; not drawn: " + std::string(stats.engine->not_drawn);
  notes.remarks.push_back(std::move(text));
}

// The mesh of --mesh; null without that.
std::shared_ptr<const MeshShape> mesh_of(const RenderArguments& arguments, unsigned threads) {
  const std::string& name = arguments.mesh;
  if (name.empty()) return nullptr;
  const auto out = shown_mesh(name, mesh_door(), threads);
  if (arguments.scene.textures && !out->mesh().has_uvs)
    throw Error::at(name, "a mesh without UVs", "TEXCOORD_0 in each primitive, by which textures are laid");
  return out;
}

// What the objects of a sweep share.
//   environment   null until the first object is drawn
struct Shared {
  std::shared_ptr<const MeshShape> mesh;
  std::shared_ptr<const Environment> environment;
};

Image draw_one(RenderArguments& arguments, unsigned threads, Scene& scene, SceneNotes& notes, Stats& stats,
               Shared& shared) {
  scene = scene_of(arguments.scene, notes);
  if (arguments.reference && scene.textured().values())
    throw Error::at("--reference", "draws no textures of diffuse colour, F0 and gloss",
                    "no --texture and no --gloss-texture");
  scene.mesh = shared.mesh;
  tell_held_gloss(scene, notes);
  stats.subject = notes.subject;
  const auto begin = Clock::now();
  if (!shared.environment)
    shared.environment = with_memory_for(
        scene.lights.environment, [] { return "the light of its texels"; },
        [&] { return environment_of(scene, threads); });
  stats.prepare_ms = ms_since(begin);
  const Environment* light = shared.environment.get();
  become_engine(arguments, light, threads, scene, notes, stats);
  const auto drawn = [&](const Vec3& background) {
    scene.background = background;
    return arguments.reference        ? draw_reference(arguments, scene, light, threads, stats)
           : arguments.device == "gl" ? draw_gl(scene, light, arguments.frames, stats)
                                      : draw_cpu(arguments, scene, light, threads, stats);
  };
  return arguments.transparent ? cut_out(drawn, is_seen_through(scene)) : drawn(Vec3(scene.background));
}

int draw_within_memory(RenderArguments& arguments) {
  const unsigned threads = thread_count(arguments.threads);
  if (arguments.sheet) {
    Scene scene;
    const Image sheet = draw_sheet(arguments, threads, scene);
    write_picture(arguments, scene, sheet, arguments.picture);
    return exit_ok;
  }
  Stats stats;
  SceneNotes notes;
  arguments.scene.refined = arguments.ambient == "refined" && !arguments.reference;
  read_textures(arguments.scene);
  Scene scene;
  Shared shared{mesh_of(arguments, threads), nullptr};
  if (!arguments.sweep.empty()) {
    // Only the worst of the curves of layers is told.
    double worst = -1;
    std::vector<std::string> of_layers;
    const Image row = draw_sweep(arguments, [&](RenderArguments& one) {
      SceneNotes its;
      Image out = draw_one(one, threads, scene, its, stats, shared);
      const auto& curve = scene.surface.curve;
      if (curve && curve->off.de2000 > worst) {
        worst = curve->off.de2000;
        of_layers = std::move(its.remarks);
      } else if (!curve) {
        std::ranges::move(its.remarks, std::back_inserter(notes.remarks));
      }
      return out;
    });
    write_picture(arguments, scene, row, arguments.picture);
    std::ranges::move(of_layers, std::back_inserter(notes.remarks));
    std::set<std::string> told;
    for (const std::string& each : notes.remarks)
      if (told.insert(each).second) remark(arguments.stats, each);
    return exit_ok;
  }
  const View first{.turn_deg = arguments.scene.orbit};
  const std::vector<std::string> files = files_of(arguments);
  for (int number = 0; number < arguments.turntable; ++number) {
    const std::string& file = files[static_cast<std::size_t>(number)];
    if (number > 0) arguments.scene.orbit = on_turntable(first, number, arguments.turntable).turn_deg;
    SceneNotes again;  // what is said of each picture is said once
    Image picture = draw_one(arguments, threads, scene, number == 0 ? notes : again, stats, shared);
    if (!file.empty()) write_picture(arguments, scene, std::move(picture), file);
  }
  say(arguments, scene, stats, notes, threads);
  return exit_ok;
}

}  // namespace

std::shared_ptr<const Environment> environment_of(const Scene& scene, unsigned threads) {
  const std::string& name = scene.lights.environment;
  const double scale = scene.lights.environment_scale;
  if (name.empty()) return nullptr;
  std::shared_ptr<const Environment> around =
      find_studio(name) != nullptr
          ? studio_environment(name, scale, threads)
          : std::make_shared<const Environment>(read_image(name), scale, name, threads);
  return with_ground(scene.lights, std::move(around), threads);
}

int draw(RenderArguments& arguments) {
  arguments.stats.force = may_replace(arguments.stats.force);
  check_picture_name(arguments);
  return with_memory_for(
      arguments.picture.empty() ? "etak render" : arguments.picture,
      [&] { return "a picture of --size " + arguments.scene.size; },
      [&] { return draw_within_memory(arguments); });
}

}  // namespace etak::cli
