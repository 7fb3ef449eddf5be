// SPDX-License-Identifier: Apache-2.0
// Family h: whole pictures of a sphere against the spectral reference.
#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>

#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/text/text.h"
#include "core/brdf/models.h"
#include "core/glsl/gl_runner.h"
#include "core/render/cpu_renderer.h"
#include "core/render/reference.h"
#include "core/study/families/families.h"
#include "core/study/measure.h"
#include "core/study/sphere_pictures.h"

namespace etak {
namespace {

constexpr int full_side = 256, quick_side = 128, rays = 4;
constexpr const char* base_model = "schueler-full";

struct Subject {
  const char* id;
  Vec3 body;
  bool metal;  // or semiconductor
  bool quick;
};
// The dielectrics with a body stand for plastics and paints.
const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all{{"gold", {0, 0, 0}, true, true},
                                        {"chromium", {0, 0, 0}, true, true},
                                        {"silver", {0, 0, 0}, true, false},
                                        {"copper", {0, 0, 0}, true, false},
                                        {"aluminum", {0, 0, 0}, true, false},
                                        {"iron", {0, 0, 0}, true, false},
                                        {"silicon", {0, 0, 0}, true, false},
                                        {"glass_bk7", {0, 0, 0}, false, true},
                                        {"diamond", {0, 0, 0}, false, false},
                                        {"water", {0.02, 0.1, 0.2}, false, false},
                                        {"polystyrene", {0.5, 0.06, 0.04}, false, true}};
  return all;
}

// The models of one reflection, which the spectral pictures have.
std::vector<const Model*> specular_models() {
  std::vector<const Model*> out;
  for (const Model& model : models())
    if (model.kind != ModelKind::diffuse && !model.compensated()) out.push_back(&model);
  return out;
}

// Whether the width of the lobe comes from the gloss. Other lobes cannot be compared with that of Full.
bool follows_gloss(const Model& model) {
  return std::none_of(model.parameters.begin(), model.parameters.end(), [](const Parameter& parameter) {
    return parameter.role == Role::other && !parameter.color;
  });
}

struct ModelErrors {
  PictureErrors own, full;  // against the spectral reference with the model's lobe, and with Full's
};

// Judges all pictures of the grid on the CPU. Sums have one order, whatever the number of threads.
class Gallery {
 public:
  Gallery(const ReportOptions& options)
      : side_(options.full ? full_side : quick_side),
        models_(specular_models()),
        judged_(sphere_pixels(side_)),
        threads_(options.threads) {
    const MaterialLibrary library = MaterialLibrary::builtin();
    for (const Subject& subject : subjects())
      if (options.full || subject.quick) {
        materials_.push_back(sphere_material(library, subject.id, subject.body));
        metal_.push_back(subject.metal);
      }
    glosses_ = options.full ? std::vector<double>{0.25, 0.5, 0.75} : std::vector<double>{timed_gloss};
  }

  const std::vector<const Model*>& models() const { return models_; }
  int side() const { return side_; }  // of the pictures that are judged
  const SphereMaterial& first() const { return materials_.front(); }
  std::string grid() const {
    return joined(materials_, ", ", &SphereMaterial::id) + "; gloss " +
           joined(glosses_, ", ", [](double gloss) { return number(gloss, 3); });
  }

  /// errors[model][material], summed over glosses, of the pictures that `draw` makes. `draw` is called on
  /// that many threads at once.
  template <class Draw>
  std::vector<std::vector<ModelErrors>> errors(unsigned threads, Draw draw) const {
    std::vector<std::vector<ModelErrors>> out(models_.size(), std::vector<ModelErrors>(materials_.size()));
    for (std::size_t g = 0; g < glosses_.size(); ++g) {
      const double gloss = glosses_[g];
      const SphereTruth& truth = truth_of(g);
      // All models that share a lobe are compared with the same reference.
      std::vector<std::vector<std::size_t>> lobes;
      for (std::size_t m = 0; m < models_.size(); ++m) {
        const auto same = [&](const std::vector<std::size_t>& lobe) {
          return &lobe_model(*models_[lobe[0]]) == &lobe_model(*models_[m]);
        };
        const auto found = std::find_if(lobes.begin(), lobes.end(), same);
        if (found == lobes.end())
          lobes.push_back({m});
        else
          found->push_back(m);
      }
      const std::size_t tasks = materials_.size() * lobes.size();
      parallel_chunks(tasks, threads, 1, [&](std::size_t task, std::size_t, unsigned) {
        const std::size_t at = task / lobes.size();
        const SphereMaterial& material = materials_[at];
        const std::vector<std::size_t>& lobe = lobes[task % lobes.size()];
        const Full& full = full_[g][at];
        const SeenPicture own = seen(truth.picture(*models_[lobe[0]], material), full.exposure, judged_);
        for (const std::size_t m : lobe) {
          const SeenPicture test =
              seen(draw(sphere_scene(*models_[m], material, gloss, side_)), full.exposure, judged_);
          out[m][at].own.add(picture_errors(own, test, judged_));
          out[m][at].full.add(picture_errors(full.picture, test, judged_));
        }
      });
    }
    return out;
  }

  /// The error of the reference itself when it takes one ray for each pixel, as renderers do.
  PictureErrors one_ray(bool metals) const {
    PictureErrors sum;
    const Model& model = *find_model(base_model);
    ReferenceOptions options;
    options.samples_per_side = 1;
    options.light_samples = 0;
    options.threads = threads_;
    for (std::size_t g = 0; g < glosses_.size(); ++g)
      for (std::size_t at = 0; at < materials_.size(); ++at) {
        if (metal_[at] != metals) continue;
        const Scene scene = sphere_scene(model, materials_[at], glosses_[g], side_);
        const Full& full = full_[g][at];
        sum.add(picture_errors(
            full.picture, seen(render_reference(scene, nullptr, options).picture, full.exposure, judged_),
            judged_));
      }
    return sum;
  }

  template <class Use>
  PictureErrors pooled(const std::vector<ModelErrors>& errors, PictureErrors ModelErrors::*which,
                       Use use) const {
    PictureErrors sum;
    for (std::size_t at = 0; at < errors.size(); ++at)
      if (use(metal_[at])) sum.add(errors[at].*which);
    return sum;
  }

 private:
  // The spectral picture with Full's lobe, at an exposure at which nothing of it clips. All pictures of the
  // material have this exposure.
  struct Full {
    double exposure = 1;
    SeenPicture picture;
  };

  const SphereTruth& truth_of(std::size_t g) const {
    if (truths_.size() == g) {
      truths_.push_back(std::make_unique<SphereTruth>(models_, glosses_[g], side_, rays, threads_));
      std::vector<Full>& all = full_.emplace_back(materials_.size());
      parallel_chunks(all.size(), threads_, 1, [&](std::size_t at, std::size_t, unsigned) {
        const Image picture = truths_[g]->picture(*find_model(base_model), materials_[at]);
        all[at].exposure = 1 / brightest(picture, judged_);
        all[at].picture = seen(picture, all[at].exposure, judged_);
      });
    }
    return *truths_[g];
  }

  int side_;
  std::vector<const Model*> models_;
  std::vector<bool> judged_;
  unsigned threads_;
  std::vector<SphereMaterial> materials_;
  std::vector<bool> metal_;
  std::vector<double> glosses_;
  // Made when they are first needed, and used again for the pictures of GL.
  mutable std::vector<std::unique_ptr<SphereTruth>> truths_;
  mutable std::vector<std::vector<Full>> full_;
};

std::vector<double> metrics_of(const PictureErrors& errors) {
  return {errors.rms_codes(), errors.psnr_db(), errors.mean_de(), errors.worst_de, errors.mean_flip()};
}

ErrorTimeTable empty_table(const char* id, std::string title) {
  ErrorTimeTable table;
  table.id = id;
  table.title = std::move(title);
  table.metrics = {{"rms_codes", "root mean square error of sRGB", "codes"},
                   {"psnr", "PSNR of sRGB codes", "dB"},
                   {"mean_de", "mean \u0394E", "\u0394E2000"},
                   {"max_de", "largest \u0394E", "\u0394E2000"},
                   {"mean_flip", "mean FLIP", ""}};
  table.time_unit = "ms per frame of " + std::to_string(timed_side) + " x " + std::to_string(timed_side) +
                    " under " + std::to_string(timed_lights) + " lights";
  table.base = base_model;
  return table;
}

ErrorTimeRow row_of(const Model& model, const PictureErrors& errors) {
  ErrorTimeRow row;
  row.id = model.id;
  row.title = model.title;
  // The usual masking is left out of the title, which has to fit into a plot.
  constexpr std::string_view usual = ", Smith height-correlated";
  if (row.title.ends_with(usual)) row.title.resize(row.title.size() - usual.size());
  row.errors = metrics_of(errors);
  if (model.id == "ashikhmin-shirley") row.note = "with a body of its own; the reference has Lambert's";
  return row;
}

// The row of a model among others, each against the picture with its own lobe.
ErrorTimeRow own_lobe_row(const Model& model, const PictureErrors& errors) {
  ErrorTimeRow row = row_of(model, errors);
  row.truth = lobe_model(model).id;
  return row;
}

// Frames of all models, on one thread.
std::vector<TimedCase> timed_frames(const Gallery& gallery) {
  std::vector<TimedCase> cases;
  for (const Model* model : gallery.models())
    cases.push_back({std::string(model->id), 1,
                     [scene = timed_scene(*model, gallery.first()), codes = std::make_shared<Image8>()] {
                       render_cpu_codes(scene, nullptr, 1, *codes);
                       keep(codes->values.data());
                     }});
  return cases;
}

const ErrorTimeRow& row(const ErrorTimeTable& table, std::string_view id) {
  return *std::find_if(table.rows.begin(), table.rows.end(),
                       [&](const ErrorTimeRow& each) { return each.id == id; });
}

void add_cpu_tables(const Gallery& gallery, const ReportOptions& options, ErrorTimeFamily& family) {
  const auto errors = gallery.errors(options.threads, [](const Scene& scene) {
    Image picture;
    render_cpu(scene, nullptr, 1, Precision::f32, picture);
    return picture;
  });
  const std::size_t count = gallery.models().size();
  for (const bool metals : {true, false}) {
    ErrorTimeTable table = metals ? empty_table("metals", "Metals and semiconductors, same lobe, CPU")
                                  : empty_table("dielectrics", "Dielectrics, same lobe, CPU");
    const auto use = [metals](bool metal) { return metal == metals; };
    for (std::size_t m = 0; m < count; ++m)
      table.rows.push_back(
          own_lobe_row(*gallery.models()[m], gallery.pooled(errors[m], &ModelErrors::own, use)));
    ErrorTimeRow floor;
    floor.id = "one_ray";
    floor.title = "the reference with one ray";
    floor.errors = metrics_of(gallery.one_ray(metals));
    floor.note = "what 4 x 4 rays alone change";
    table.rows.push_back(floor);
    family.tables.push_back(table);
  }

  ErrorTimeTable table = empty_table("lobes", "Lobes against CookTorranceFull's, CPU");
  std::set<const Model*> seen_lobes;
  for (std::size_t m = 0; m < count; ++m) {
    const Model& model = *gallery.models()[m];
    if (!follows_gloss(model)) continue;
    // Only the first of the models that differ in F alone is shown.
    if (model.distribution != nullptr && !seen_lobes.insert(&lobe_model(model)).second) continue;
    table.rows.push_back(
        row_of(model, gallery.pooled(errors[m], &ModelErrors::full, [](bool) { return true; })));
  }
  family.tables.push_back(table);

  TimedSet timed{{}, timed_frames(gallery), ms_of_ns};
  for (const ErrorTimeTable& each : family.tables) timed.tables.push_back(each.id);
  family.timed = {std::move(timed)};
}

// GL frames are timed in rounds over all models, a few frames of each in a round. The time is that of GL's
// own clock, except for software rasterisers, whose clock stops before they have drawn (llvmpipe: 0.13 ms of
// 1.9).
void add_gl_table(const Gallery& gallery, const ReportOptions& options, ErrorTimeFamily& family) {
  std::string why;
  auto gl = GlRunner::open(why);
  if (!gl) {
    family.notes.push_back("No OpenGL here: " + why + ". Not measured on a GPU.");
    return;
  }
  const GlRunner::Info& info = gl->info();
  ErrorTimeTable table =
      empty_table("gl", "All materials, same lobe, OpenGL on " + info.renderer +
                            (info.software ? " (a software rasteriser: no graphics card)" : ""));
  const auto errors = gallery.errors(1, [&](const Scene& scene) { return gl->render(scene); });
  const std::size_t count = gallery.models().size();
  // A graphics card is so fast that only many frames tell models apart: at least 100 of each.
  const int rounds = options.full ? 15 : 5, frames = !info.software ? 20 : options.full ? 9 : 3;
  std::vector<std::vector<double>> ms(count);
  bool by_queries = !info.software;
  for (int round = 0; round < rounds; ++round)
    for (std::size_t m = 0; m < count; ++m) {
      const auto time = gl->frame_time(timed_scene(*gallery.models()[m], gallery.first()), nullptr, frames);
      by_queries = by_queries && time.gpu_median_ms.has_value();
      ms[m].push_back(by_queries ? *time.gpu_median_ms : time.median_ms);
    }
  const auto quantile = [](std::vector<double> values, std::size_t quarter) {
    std::sort(values.begin(), values.end());
    return values[(values.size() - 1) * quarter / 4];
  };
  for (std::size_t m = 0; m < count; ++m) {
    RunTime time{quantile(ms[m], 2), quantile(ms[m], 1), quantile(ms[m], 3), 1, quantile(ms[m], 0), ms[m]};
    table.rows.push_back(own_lobe_row(
        *gallery.models()[m], gallery.pooled(errors[m], &ModelErrors::own, [](bool) { return true; })));
    table.rows.back().time = time;
  }
  set_ratios(table);
  set_verdicts(table);
  family.tables.push_back(table);
  family.notes.push_back(
      std::string("OpenGL frames are timed ") +
      (by_queries ? "by timer queries"
       : info.software
           ? "from call to finish, for the timer queries of a software rasteriser end before it has drawn"
           : "from call to finish: there are no timer queries here") +
      "; medians of " + std::to_string(frames) + " frames in " + std::to_string(rounds) + " rounds." +
      (info.software ? " Not measured on a GPU: " + info.renderer + " draws on the CPU." : ""));
}

std::string advice_of(const ErrorTimeFamily& family) {
  const auto rms = [&](std::size_t table, std::string_view id) {
    return number(row(family.tables[table], id).errors[0], 2);
  };
  return "Decide on the lobe first, for GGX in place of Beckmann changes " + rms(2, "ggx-schlick") +
         " codes where Schlick's Fresnel is off by " + rms(1, "ggx-schlick") +
         " at most; then draw dielectrics with exact Fresnel from F0 (off by " + rms(1, "ggx-from-f0") +
         " codes) and metals with F82 (" + rms(0, "ggx-f82") + ", Schlick " + rms(0, "ggx-schlick") + ").";
}

}  // namespace

ErrorTimeFamily image_family(const ReportOptions& options) {
  const Gallery gallery(options);
  ErrorTimeFamily family;
  family.id = "image";
  family.letter = "h";
  family.title = "The rendered sphere";
  const std::string side = std::to_string(gallery.side());
  family.reference =
      "a sphere of " + side + " x " + side +
      " pixels with 4 x 4 rays each, F at every nanometre, with the model's own lobe, in double, so that only ways with one lobe are compared; lobes among themselves: with CookTorranceFull's";
  family.grid =
      gallery.grid() +
      "; three directional lights 50, 100 and 150 degrees from the viewer; exposed so that the brightest pixel of CookTorranceFull is white; errors over pixels that the sphere covers whole";
  if (options.cpu) {
    add_cpu_tables(gallery, options, family);
    family.advice = advice_of(family);
    family.picks = {
        {"pictures of metals", "metals", "ggx-f82", "near the spectral picture", "etak choose gold"},
        {"pictures of glass, water, plastics", "dielectrics", "ggx-from-f0",
         "exact F, and F0 is all it needs", "etak choose glass_bk7"}};
    family.notes.push_back(
        "CPU frames: single precision to sRGB codes, on one thread. Lights and viewer are far away, so that F is computed once per light and frames differ by their lobes; with " +
        std::to_string(timed_lights) +
        " lights these have most of the time. It is processor time of the thread, with quartiles over rounds.");
  }
  family.notes.push_back(
      "FLIP at 67 pixels per degree, of the sRGB codes; mean over the judged pixels, those outside black.");
  if (options.gl) add_gl_table(gallery, options, family);
  if (family.advice.empty())
    family.advice = "Measure on the CPU too: errors are those of the formulas, times those of the device.";
  return family;
}

}  // namespace etak
