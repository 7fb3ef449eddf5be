// SPDX-License-Identifier: Apache-2.0
// ambient_errors [--quick] [--samples N] [--side N] [--threads N] [--json FILE] [--table FILE] [MODEL...]: how far the moving
// and the refined picture of a ball in etak's environments are off from the integral of their own model, in CIEDE2000 with the
// brightest pixel white: mean, 99th percentile and largest of the pixels that the ball covers whole, for each cell of
// material, model, gloss and environment. All pictures take the middle of each pixel, so that the filter of a pixel, which is
// no part of the term, is in none. An integral takes --samples directions for each pixel, and four times as many as long as
// its own standard error is above 0.2. Without --quick: 3 materials with every specular model and 12 materials with the six most used,
// glosses 0.2, 0.5, 0.8 and 1, five environments.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/light/studio.h"
#include "core/render/ambient/accuracy.h"
#include "core/render/ambient/ambient.h"
#include "core/render/cpu_renderer.h"
#include "core/study/ambient_pictures.h"
#include "core/study/sphere_pictures.h"

namespace {

using namespace etak;

// The mean of a moving picture, and the 99th percentile of a refined one, that an isotropic lobe should have at most.
constexpr double aim = 1.5;
// The standard error, in dE, that an integral may have, and the most directions that are taken for it.
constexpr double most_noise = 0.2;
constexpr std::size_t most_samples = 1 << 19;
// The materials that every model is measured with.
const std::set<std::string> every_model = {"gold", "osmium", "water"};

struct Options {
  bool quick = false;
  std::size_t samples = 2048;
  int side = 64;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::string json, table;
  std::set<std::string> models;
};

struct Cell {
  std::string material, model, environment;
  double gloss = 0;
  bool round = true;
  std::array<AmbientDifference, 2> off;  // of the moving and of the refined picture
};

std::vector<std::pair<std::string, const Model*>> pairs_of(const Options& options) {
  const std::vector<std::string> most = {"aluminum", "copper",  "chromium", "iron", "silver", "titanium",
                                         "silicon",  "diamond", "bk7",      "gold", "osmium", "water"};
  const std::vector<std::string> used = {
      "schueler-optimized-bounded", "ggx-schlick", "ggx-f82", "ggx-exact", "cook-torrance", "blinn-phong"};
  std::vector<std::pair<std::string, const Model*>> out;
  const auto add = [&](const std::string& material, const Model& model) {
    if (model.kind == ModelKind::diffuse) return;
    if (!options.models.empty() && !options.models.contains(std::string(model.id))) return;
    for (const auto& [known, of] : out)
      if (known == material && of == &model) return;
    out.emplace_back(material, &model);
  };
  for (const std::string& material : every_model)
    for (const Model& model : models())
      if (!options.quick || !options.models.empty() ||
          std::set<std::string>{"ggx-schlick", "ggx-exact", "beckmann-smith", "schueler-ksk", "phong",
                                "ggx-schlick-v-groove"}
              .contains(std::string(model.id)))
        add(material, model);
  if (!options.quick)
    for (const std::string& material : most)
      for (const std::string& id : used) add(material, *find_model(id));
  return out;
}

Scene scene_of(const SphereMaterial& material, const Model& model, double gloss, int side) {
  Scene scene = sphere_scene(model, material, gloss, side);
  // The models' own F: the difference between a Fresnel form and the spectrum is not that of the ambient term.
  scene.surface.optics.reset();
  scene.lights = LightSetup{};
  scene.background = {0, 0, 0};
  return scene;
}

void print_json(const std::string& file, const std::vector<Cell>& cells, double seconds) {
  std::FILE* out = std::fopen(file.c_str(), "w");
  if (out == nullptr) throw Error::at(file, "cannot be written");
  std::fprintf(out, "{\"seconds\": %.0f, \"cells\": [\n", seconds);
  for (const Cell& c : cells)
    std::fprintf(
        out,
        "{\"material\": \"%s\", \"model\": \"%s\", \"gloss\": %g, \"environment\": \"%s\", \"isotropic\": %s, \"standard_error\": %.3f, \"moving\": {\"mean\": %.3f, \"p99\": %.3f, \"largest\": %.3f}, "
        "\"refined\": {\"mean\": %.3f, \"p99\": %.3f, \"largest\": %.3f}}%s\n",
        c.material.c_str(), c.model.c_str(), c.gloss, c.environment.c_str(), c.round ? "true" : "false",
        c.off[0].noise, c.off[0].mean, c.off[0].p99, c.off[0].largest, c.off[1].mean, c.off[1].p99,
        c.off[1].largest, &c == &cells.back() ? "" : ",");
  std::fputs("]}\n", out);
  std::fclose(out);
}

// The rows of resources/ambient_errors.csv, of the three materials that every model has.
void print_accuracy(const std::string& file, const std::vector<Cell>& cells) {
  std::FILE* out = std::fopen(file.c_str(), "w");
  if (out == nullptr) throw Error::at(file, "cannot be written");
  std::fputs("model,gloss,mean,picture,p99,refined_mean,refined_picture,refined_p99\n", out);
  for (const Model& model : models())
    for (const double gloss : measured_glosses) {
      std::array<AmbientAccuracy, 2> sums{};
      double count = 0;
      for (const Cell& c : cells) {
        if (c.model != model.id || c.gloss != gloss || !every_model.contains(c.material)) continue;
        for (std::size_t form = 0; form < 2; ++form) {
          const AmbientDifference& off = c.off[form];
          AmbientAccuracy& sum = sums[form];
          sum = {sum.mean + off.mean, std::max(sum.picture, off.mean), std::max(sum.p99, off.p99)};
        }
        ++count;
      }
      if (count == 0) continue;
      std::fprintf(out, "%s,%g", std::string(model.id).c_str(), gloss);
      for (const AmbientAccuracy& sum : sums)
        std::fprintf(out, ",%.2f,%.2f,%.1f", sum.mean / count, sum.picture, sum.p99);
      std::fputs("\n", out);
    }
  std::fclose(out);
}

// The tables of one form of picture.
void print_table(const std::vector<Cell>& cells, bool refined) {
  const auto judged = [refined](const Cell& c) { return refined ? c.off[1].p99 : c.off[0].mean; };
  struct Sum {
    double mean = 0, p99 = 0, largest = 0, met = 0, count = 0;
  };
  const auto print = [&](const char* title, auto key) {
    std::map<std::string, Sum> sums;
    for (const Cell& c : cells) {
      Sum& sum = sums[key(c)];
      const AmbientDifference& off = c.off[refined];
      sum = {sum.mean + off.mean, std::max(sum.p99, off.p99), std::max(sum.largest, off.largest),
             sum.met + (judged(c) <= aim ? 1 : 0), sum.count + 1};
    }
    std::printf("\n%-44s %6s %9s %9s %9s %7s\n", title, "cells", "mean dE", "worst p99", "largest", "met");
    for (const auto& [name, s] : sums)
      std::printf("%-44s %6.0f %9.2f %9.2f %9.2f %6.1f%%\n", name.c_str(), s.count, s.mean / s.count, s.p99,
                  s.largest, 100 * s.met / s.count);
  };
  std::printf("\n%s pictures; met: %s at most 1.5\n", refined ? "refined" : "moving",
              refined ? "the 99th percentile is" : "the mean is");
  const auto gloss = [](const Cell& c) { return "gloss " + std::to_string(c.gloss).substr(0, 3); };
  print("model and gloss", [&](const Cell& c) { return c.model + ", " + gloss(c); });
  print("model", [](const Cell& c) { return c.model; });
  print("environment", [&](const Cell& c) { return c.environment + ", " + gloss(c); });
  print("material", [](const Cell& c) { return c.material; });
  print("lobe", [](const Cell& c) { return std::string(c.round ? "isotropic" : "anisotropic"); });
  std::printf("\ncells of isotropic lobes whose %s is above 1.5:\n", refined ? "99th percentile" : "mean");
  for (const Cell& c : cells)
    if (judged(c) > aim && c.round)
      std::printf("  %-14s %-28s gloss %.1f %-12s mean %5.2f p99 %6.2f largest %6.2f\n", c.material.c_str(),
                  c.model.c_str(), c.gloss, c.environment.c_str(), c.off[refined].mean, c.off[refined].p99,
                  c.off[refined].largest);
}

Options parsed(int argc, char** argv) {
  Options out;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto next = [&] { return i + 1 < argc ? argv[++i] : ""; };
    if (word == "--quick")
      out.quick = true;
    else if (word == "--samples")
      out.samples = static_cast<std::size_t>(std::max(64, std::atoi(next())));
    else if (word == "--side")
      out.side = std::clamp(std::atoi(next()), 8, 1024);
    else if (word == "--threads")
      out.threads = static_cast<unsigned>(std::clamp(std::atoi(next()), 1, 256));
    else if (word == "--json")
      out.json = next();
    else if (word == "--table")
      out.table = next();
    else if (find_model(word) != nullptr)
      out.models.insert(word);
    else
      throw Error::at(word, "no option and no model");
  }
  return out;
}

// The integrals of all scenes, with more samples for those that are not sharp enough yet.
std::vector<AmbientTruth> sharp_truths(const std::vector<Scene>& scenes, const Environment& environment,
                                       const Options& options) {
  std::vector<AmbientTruth> out;
  std::vector<std::size_t> open(scenes.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  for (std::size_t samples = options.samples; !open.empty(); samples *= 4) {
    std::vector<Scene> subjects;
    for (const std::size_t i : open) subjects.push_back(scenes[i]);
    auto truths = ambient_truths(subjects, environment, samples, options.threads);
    out.resize(scenes.size());
    std::vector<std::size_t> rest;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const bool sharp = ambient_difference(truths[i], truths[i].picture).noise <= most_noise;
      if (!sharp && 4 * samples <= most_samples) rest.push_back(open[i]);
      out[open[i]] = std::move(truths[i]);
    }
    open = std::move(rest);
  }
  return out;
}

void run(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  const MaterialLibrary library = MaterialLibrary::builtin();
  const auto pairs = pairs_of(options);
  std::map<std::string, SphereMaterial> materials;
  for (const auto& [id, model] : pairs)
    if (!materials.contains(id)) materials.emplace(id, sphere_material(library, id, {0, 0, 0}));
  std::vector<Cell> cells;
  for (const NamedStudio& studio : named_studios()) {
    const auto environment = studio_environment(std::string(studio.name), 1, options.threads);
    for (const double gloss : measured_glosses) {
      std::vector<Scene> scenes;
      for (const auto& [id, model] : pairs)
        scenes.push_back(scene_of(materials.at(id), *model, gloss, options.side));
      const auto truths = sharp_truths(scenes, *environment, options);
      for (std::size_t i = 0; i < scenes.size(); ++i) {
        Cell& cell = cells.emplace_back(Cell{pairs[i].first,
                                             std::string(pairs[i].second->id),
                                             std::string(studio.name),
                                             gloss,
                                             !ambient_table(scenes[i], {})->anisotropic,
                                             {}});
        for (const bool refined : {false, true}) {
          Image shown;
          scenes[i].refined = refined;
          render_cpu(scenes[i], environment.get(), options.threads, Precision::f32, shown);
          cell.off[refined] = ambient_difference(truths[i], shown);
        }
      }
      std::fprintf(stderr, "%s, gloss %g\n", std::string(studio.name).c_str(), gloss);
    }
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  double noise = 0;
  for (const Cell& c : cells) noise = std::max(noise, c.off[0].noise);
  for (const bool refined : {false, true}) print_table(cells, refined);
  std::printf("\nlargest standard error of an integral: %.3f dE (mean over its pixels)\n", noise);
  std::printf("%zu cells in %.0f s on %u threads\n", cells.size(), seconds, options.threads);
  if (!options.json.empty()) print_json(options.json, cells, seconds);
  if (!options.table.empty()) print_accuracy(options.table, cells);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(parsed(argc, argv));
    return 0;
  } catch (const etak::Error& error) {
    std::fprintf(stderr, "ambient_errors: %s\n", error.what());
    return 2;
  }
}
