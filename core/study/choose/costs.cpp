// SPDX-License-Identifier: Apache-2.0
// Measures the cost table on this machine: every Fresnel form, visibility term, quadrature, filter and PNG
// level. Other programs may make a row three times as slow for a while, and never faster. Each row is
// therefore timed in many short repeats, mixed with those of all other rows over the whole run, and the
// shortest counts.
#include <algorithm>
#include <cmath>
#include <memory>

#include "core/brdf/models.h"
#include "core/glsl/gl_runner.h"
#include "core/image/files/png.h"
#include "core/material/f0.h"
#include "core/material/library.h"
#include "core/math/functions.h"
#include "core/study/choose/choose_models.h"
#include "core/study/error_time.h"
#include "core/study/made_pages.h"
#include "core/study/measure.h"
#include "core/study/sphere_pictures.h"

namespace etak {
namespace {

constexpr std::size_t count = 4096;
constexpr std::size_t rounds = 200;
constexpr int png_side = 128;
constexpr double timed_film_nm = 100;
// 2 ms for each repeat: bursts of other programs last longer, so that some repeats lie between them.
constexpr double seconds_a_case = 0.4;

// Directions of light and viewer over the whole hemisphere, the same for all models.
struct Batch {
  std::array<std::vector<float>, 6> directions;
  std::array<std::vector<float>, 3> rgb;

  Batch() {
    Random random(3);
    for (auto& each : directions) each.resize(count);
    for (auto& each : rgb) each.resize(count);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t d = 0; d < 6; d += 3) {
        const double z = random.uniform(0.05, 1), phi = random.uniform(0, 6.283185307179586),
                     s = std::sqrt(1 - z * z);
        directions[d][i] = static_cast<float>(s * math::cos(phi));
        directions[d + 1][i] = static_cast<float>(s * math::sin(phi));
        directions[d + 2][i] = static_cast<float>(z);
      }
  }
  void run(const Model& model, const std::vector<double>& values) {
    const float* in[6];
    float* out[3];
    for (std::size_t i = 0; i < 6; ++i) in[i] = directions[i].data();
    for (std::size_t i = 0; i < 3; ++i) out[i] = rgb[i].data();
    model.f32_batch(count, in, values.data(), out);
  }
};

// A texture without flat areas: slopes and grain, as in photographs of surfaces.
std::shared_ptr<const Image8> some_texture(int width, int height) {
  const auto picture = std::make_shared<Image8>(width, height, 4);
  Random random(5);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (std::size_t c = 0; c < 4; ++c)
        picture->at(x, y)[c] = static_cast<std::uint8_t>(120 + 50 * math::sin(x / 9.0) * math::cos(y / 7.0) +
                                                         random.uniform(-8, 8));
  return picture;
}

void add_textures(std::vector<TimedCase>& cases) {
  // Small enough for the caches of one core, because other programs take more or less of a shared cache, and
  // for short repeats.
  constexpr int side = 64;
  const auto texture = some_texture(side, side);
  const auto chain = std::make_shared<const TexelChain>(view(*texture), view(*texture),
                                                        PixelBox{0, 0, side, side}, GlossForm::schueler);
  const auto places = random_floats(2 * count, 0, side);
  for (const TextureFilter filter : all_filters)
    cases.push_back({"filter/" + std::string(name(filter)), count, [chain, places, filter] {
                       for (std::size_t i = 0; i < count; ++i) {
                         const SurfaceTexel texel =
                             chain->read(filter, static_cast<double>((*places)[2 * i]),
                                         static_cast<double>((*places)[2 * i + 1]), 0.4);
                         keep(&texel);
                       }
                     }});
  // These pages are larger than the window of deflate.
  const auto pages = std::make_shared<const std::vector<MadePage>>(made_pages(png_side));
  for (const auto& [level, id] :
       {std::pair{PngLevel::fast, "png/fast"}, std::pair{PngLevel::small, "png/small"},
        std::pair{PngLevel::smallest, "png/smallest"}})
    cases.push_back({id, pages->size() * png_side * png_side, [pages, level = level] {
                       PngOptions options;
                       options.level = level;
                       std::size_t bytes = 0;
                       for (const MadePage& page : *pages)
                         write_png(page.pixels, options,
                                   [&](std::string_view part) { bytes += part.size(); });
                       keep(&bytes);
                     }});
}

// Frames on a graphics card by OpenGL's own clock, in ns a pixel; or why there are none.
std::string add_gpu_frames(CostTable& costs) {
  constexpr int frames = 100;
  std::string why;
  auto gl = GlRunner::open(why);
  if (!gl) return "not measured on a GPU: no OpenGL";
  const std::string& renderer = gl->info().renderer;
  if (gl->info().software) return "not measured on a GPU: " + renderer + " draws on the CPU";
  const SphereMaterial gold = sphere_material(MaterialLibrary::builtin(), "gold", {0, 0, 0});
  std::map<std::string, double> ns;
  for (const Model* model : whole_models()) {
    const auto time = gl->frame_time(timed_scene(*model, gold), nullptr, frames);
    if (!time.gpu_median_ms) return "not measured on a GPU: " + renderer + " has no clock for queries";
    ns["gpu/" + std::string(model->id)] = 1e6 * *time.gpu_median_ms / (timed_side * timed_side);
  }
  costs.ns.insert(ns.begin(), ns.end());
  return "gpu/ is ns a pixel of " + std::to_string(timed_side) + " x " + std::to_string(timed_side) +
         " under " + std::to_string(timed_lights) + " lights on " + renderer +
         ", GL_TIME_ELAPSED, median of " + std::to_string(frames) + " frames";
}

}  // namespace

CostTable measure_costs(std::string_view header,
                        const std::function<void(std::size_t done, std::size_t all)>& progress) {
  CostTable costs;
  costs.header = std::string(header) + "; least of " + std::to_string(rounds) + " interleaved repeats";
  const auto library = MaterialLibrary::builtin();
  const Material gold = *library.find("gold"), water = *library.find("water");
  const TimingOptions timing{rounds, seconds_a_case, progress};

  std::vector<TimedCase> cases;
  const auto cosines = random_floats(count, 0, 1);
  // Each form is timed for a clear material and for a metal, and the longer time counts: some forms take a
  // shorter way for one of the two, which a shader for many materials cannot count on. The channel is green,
  // because some forms also take a shorter way for F0 above 1, as gold has in red.
  for (const Material* material : {&water, &gold}) {
    const auto& optics = std::get<OpticalConstants>(material->preferred_dataset().optics);
    const FresnelTruth truth = fresnel_truth(optics, material->id);
    for (const FresnelForm& form : fresnel_forms()) {
      const auto values = form.fit(truth);
      const auto p = single_values(values[1]);
      cases.push_back({"fresnel/" + std::string(form.id), count,
                       [&form, p, cosines, out = std::make_shared<std::vector<float>>(count)] {
                         form.many(p.data(), cosines->data(), out->data(), count);
                         keep(out->data());
                       }});
    }
  }
  // The cost of a masking term is that of a GGX lobe with Schlick's F and this term: the rest is the same for
  // all terms.
  const auto batch = std::make_shared<Batch>();
  for (const Term& term : terms()) {
    if (!masks_ggx(term)) continue;
    const Model* model = find_model("microfacet:ggx,schlick," + std::string(term.id));
    cases.push_back({"visibility/" + std::string(term.id), count, [model, batch] {
                       batch->run(*model, {0.9, 0.8, 0.4, 0.2});
                     }});
  }
  for (const Model* model : whole_models())
    cases.push_back({"model/" + std::string(model->id), count, [model, batch] {
                       constexpr FresnelValues index{{{0.2, 3, 0, 0}, {0.4, 2.4, 0, 0}, {1.4, 1.8, 0, 0}}};
                       batch->run(*model, whole_model_numbers(*model, {0.9, 0.8, 0.4}, index, {{}, {}, 0.4}));
                     }});
  // Films of renderers give three channels at once, in double: of such a time each has a third.
  for (const FilmForm* form : film_forms()) {
    if (!form->has_film()) continue;
    FilmNumbers numbers{};
    for (std::size_t i = 0; i < form->numbers.size(); ++i)
      numbers[i] = (form->numbers[i].least + form->numbers[i].most) / 2;
    numbers[form->index + 1] = timed_film_nm;
    cases.push_back({"film/" + std::string(form->id), 3 * count, [form, numbers, cosines] {
                       double sum = 0;
                       for (const float cosine : *cosines)
                         sum += form->seen(numbers, std::max(double{cosine}, 1e-3))[1];
                       keep(&sum);
                     }});
  }
  for (const Method method : all_methods) {
    F0Options options;
    options.method = method;
    const auto solver = std::make_shared<F0Solver>(options);
    cases.push_back({"quadrature/" + std::string(name(method)), 1, [solver, &gold] {
                       const F0Result result = solver->solve(gold.preferred_dataset().optics);
                       keep(&result);
                     }});
  }
  add_textures(cases);
  const auto times = time_cases(cases, timing);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    double& ns = costs.ns[cases[i].id];
    ns = std::max(ns, times[i].least_ns);
  }
  // These forms have one formula and three ways to find n and k, so that differences of their times are
  // noise.
  const double exact = std::min(
      {costs.ns["fresnel/index"], costs.ns["fresnel/mean_index"], costs.ns["fresnel/three_wavelengths"]});
  for (const char* id : {"fresnel/index", "fresnel/mean_index", "fresnel/three_wavelengths"})
    costs.ns[id] = exact;
  // by_f0 chooses one of two other forms, so that a time below theirs is noise as well.
  costs.ns["fresnel/by_f0"] =
      std::max({costs.ns["fresnel/by_f0"], costs.ns["fresnel/from_f0"], costs.ns["fresnel/schlick"]});
  costs.header += "; " + add_gpu_frames(costs);
  return costs;
}

}  // namespace etak
