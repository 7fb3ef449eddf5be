// SPDX-License-Identifier: Apache-2.0
// Family k: the light of an environment in moving and in refined pictures, against the integral of the model itself.
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/number.h"
#include "core/light/studio.h"
#include "core/material/library.h"
#include "core/render/ambient/accuracy.h"
#include "core/render/cpu_renderer.h"
#include "core/study/ambient_pictures.h"
#include "core/study/families/families.h"
#include "core/study/measure.h"
#include "core/study/sphere_pictures.h"

namespace etak {
namespace {

constexpr std::array ids{
    "schueler-optimized-bounded", "ggx-schlick", "ggx-f82", "ggx-exact", "cook-torrance", "blinn-phong"};
constexpr std::array materials{"gold", "osmium", "water"};
constexpr std::array<std::string_view, 3> environments{"studio", "sunset", "night"};

struct Errors {
  std::array<double, measured_glosses.size()> mean{};
  double p99 = 0;
  double refined = 0;  // mean of the first material's refined pictures in the first environment
};

// The scenes of all models with all materials, material by material.
std::vector<Scene> scenes_at(double gloss, int side) {
  static const MaterialLibrary library = MaterialLibrary::builtin();
  std::vector<Scene> out;
  for (const char* material : materials) {
    const SphereMaterial subject = sphere_material(library, material, {0, 0, 0});
    for (const char* id : ids) {
      out.push_back(sphere_scene(*find_model(id), subject, gloss, side));
      out.back().lights = {};
      out.back().background = {0, 0, 0};
    }
  }
  return out;
}

std::array<Errors, ids.size()> measure(const ReportOptions& options) {
  const int side = options.full ? 64 : 32;
  std::array<Errors, ids.size()> out;
  for (const std::string_view name : environments) {
    const auto environment = studio_environment(std::string(name), 1, options.threads);
    for (std::size_t g = 0; g < measured_glosses.size(); ++g) {
      std::vector<Scene> scenes = scenes_at(measured_glosses[g], side);
      const auto truths = ambient_truths(scenes, *environment, options.full ? 2048 : 1024, options.threads);
      for (std::size_t i = 0; i < scenes.size(); ++i) {
        Image shown;
        render_cpu(scenes[i], environment.get(), options.threads, Precision::f32, shown);
        const AmbientDifference off = ambient_difference(truths[i], shown);
        Errors& errors = out[i % ids.size()];
        errors.mean[g] += off.mean / (materials.size() * environments.size());
        errors.p99 = std::max(errors.p99, off.p99);
        if (name != environments.front() || i >= ids.size()) continue;
        scenes[i].refined = true;
        render_cpu(scenes[i], environment.get(), options.threads, Precision::f32, shown);
        errors.refined += ambient_difference(truths[i], shown).mean / measured_glosses.size();
      }
    }
  }
  return out;
}

TimedCase timed(std::size_t model) {
  constexpr int side = 64;
  auto scene = std::make_shared<Scene>(scenes_at(0.5, side)[model]);
  return {ids[model], std::size_t{side} * side,
          [scene, environment = studio_environment("studio", 1, 1), picture = std::make_shared<Image>()] {
            render_cpu(*scene, environment.get(), 1, Precision::f32, *picture);
            keep(picture->values.data());
          }};
}

}  // namespace

ErrorTimeFamily ambient_family(const ReportOptions& options) {
  ErrorTimeFamily family;
  family.id = "ambient";
  family.letter = "k";
  family.title = "Light of an environment";
  family.reference = "the model itself integrated over the environment at the middle of each pixel";
  family.grid =
      "balls of gold, osmium and water in etak's studio, sunset and night, at gloss 0.2, 0.5, 0.8 and 1";
  ErrorTimeTable table;
  table.id = "models";
  table.title = "Models under an environment";
  table.time_unit = "ns per pixel";
  table.base = ids[0];
  table.metrics = {{"mean", "mean over pictures and pixels", "dE2000"}};
  for (const double gloss : measured_glosses)
    table.metrics.push_back({"gloss_" + number(gloss, 3), "mean at gloss " + number(gloss, 3), "dE2000"});
  table.metrics.push_back({"p99", "largest 99th percentile of a picture", "dE2000"});
  table.metrics.push_back({"refined", "mean of refined pictures of gold in the studio", "dE2000"});
  const auto errors = measure(options);
  TimedSet timings;
  timings.tables = {table.id};
  std::size_t best = 0;
  for (std::size_t m = 0; m < ids.size(); ++m) {
    ErrorTimeRow& row = table.rows.emplace_back();
    row.id = ids[m];
    row.title = std::string(find_model(ids[m])->title);
    row.truth = ids[m];
    row.errors = {0};
    for (const double each : errors[m].mean) {
      row.errors[0] += each / measured_glosses.size();
      row.errors.push_back(each);
    }
    row.errors.push_back(errors[m].p99);
    row.errors.push_back(errors[m].refined);
    if (row.errors[0] < table.rows[best].errors[0]) best = m;
    timings.cases.push_back(timed(m));
  }
  family.advice = "Any model may be chosen under an environment: its own albedo and lobe are drawn, " +
                  number(table.rows[best].errors[0], 2) + " dE off in the mean for " + table.rows[best].id +
                  "; a rough dielectric under small bright lights is where to look twice.";
  family.notes = {
      "The albedo is right for any Fresnel form, so that a white surrounding has no error; what is left is the shape of the lobe, for which two round ones stand.",
      "Errors are of linear light shown in sRGB with the brightest pixel white, over pixels that the ball covers whole; each model is compared with its own integral, so that rows do not compete.",
      "Refined pictures, those at rest, are sampled from the lobe itself; `etak models` tells their error for every model."};
  family.tables = {std::move(table)};
  family.timed = {std::move(timings)};
  return family;
}

}  // namespace etak
