// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pictures/sheet.h"

#include <utility>

#include "app/cli/output/progress.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/render/cpu_renderer.h"
#include "core/render/environment.h"
#include "core/render/sheet.h"

namespace etak::cli {
namespace {

struct Column {
  const char* label;
  const char* material;
  Vec3 diffuse;
};
constexpr Column columns[] = {{"gold", "gold", {0, 0, 0}},
                              {"copper", "copper", {0, 0, 0}},
                              {"silver", "silver", {0, 0, 0}},
                              {"iron", "iron", {0, 0, 0}},
                              {"glass", "fused_silica", {0, 0, 0}},
                              {"water", "water", {0, 0, 0}},
                              {"plastic", "pmma", {0.5, 0.04, 0.03}},
                              {"silicon", "silicon", {0, 0, 0}}};

// The models that the others are compared with.
constexpr const char* diffuse_reference = "lambert";
constexpr const char* specular_reference = "ggx-exact";

SurfaceValues surface(const Column& column, SceneArguments& typed, const Gloss& gloss, SceneNotes& notes) {
  const auto material = typed.library.get().find(column.material);
  if (!material)
    throw Error::at("--sheet", std::string("the library has no ") + column.material, "etak's own library");
  if (column.diffuse != Vec3{})
    notes.remarks.push_back(material->id + ": the colour of the body is made up, for " + column.label);
  SurfaceWishes wishes = surface_wishes(typed);
  wishes.diffuse = column.diffuse;
  wishes.gloss = gloss;
  return surface_of(*material, material->preferred_dataset(), wishes,
                    f0_options(typed.compute, typed.library), notes.remarks);
}

// The part of the sheet that a model is in.
std::string_view part_of(const Model& model) {
  if (model.kind == ModelKind::diffuse) return "light";
  if (model.distribution == nullptr) return "own";
  return model.distribution->id == "ggx" ? "ggx" : "lobes";
}

}  // namespace

Image draw_sheet(RenderArguments& arguments, unsigned threads, Scene& scene) {
  SceneArguments& typed = arguments.scene;
  if (!typed.subject.empty())
    throw Error::at("--sheet", typed.subject.front(), "no SUBJECT: the sheet has its own");
  if (typed.size == "512") typed.size = "128";
  typed.subject = {"f0=0.04"};
  const F0Settings compute = std::exchange(typed.compute, {});  // of the columns
  SceneNotes notes;
  scene = scene_of(typed, notes);
  if (scene.textures) throw Error::at("--sheet", "given with a texture", "none: its materials are numbers");
  typed.compute = compute;
  // All columns have the same roughness, so that they can be compared: the given one, else the gloss of
  // metals.
  const Gloss gloss = given_gloss(typed.rough).value_or(Gloss(0.75));
  const auto around = environment_of(scene, threads);
  LightSetup alone;
  alone.environment = studio_lights().environment;
  const auto studio = studio_environment(alone.environment, alone.environment_scale, threads);

  Sheet sheet;
  std::vector<SurfaceValues> surfaces;
  for (const Column& column : columns) {
    sheet.columns.emplace_back(column.label);
    surfaces.push_back(surface(column, typed, gloss, notes));
  }
  for (const std::string& each : notes.remarks) remark(arguments.stats, each);
  const auto wanted = [&](std::string_view part) {
    return arguments.part == "all" || arguments.part == part;
  };
  std::size_t rows = wanted("light") ? 5 : 0;
  for (const Model& model : models()) rows += wanted(part_of(model));
  Progress progress(arguments.stats, rows * surfaces.size(), "render");
  const auto drawn = [&](const SurfaceValues& values, const std::string& specular, const std::string& diffuse,
                         const LightSetup& lights, const Environment* environment) {
    Scene one = scene;
    one.surface = values;
    one.lights = lights;
    choose_models(one, specular, diffuse, {}, notes.remarks);
    Image out;
    render_cpu(one, environment, threads, Precision::f32, out);
    return out;
  };
  const auto add_row = [&](const std::string& label, const std::string& specular, const std::string& diffuse,
                           const LightSetup& lights, const Environment* environment,
                           const std::vector<Image>* references) {
    sheet.rows.push_back(label);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      Image picture = drawn(surfaces[i], specular, diffuse, lights, environment);
      sheet.pictures.push_back(
          references == nullptr
              ? std::move(picture)
              : beside(picture, difference_picture((*references)[i], picture, scene.exposure)));
      progress.advance(1, 0);
    }
  };
  std::vector<Image> by_lambert, by_ggx_exact;
  for (const SurfaceValues& each : surfaces) {
    by_lambert.push_back(drawn(each, "", diffuse_reference, scene.lights, around.get()));
    by_ggx_exact.push_back(drawn(each, specular_reference, "", scene.lights, around.get()));
  }
  for (const Model& model : models()) {
    if (!wanted(part_of(model))) continue;
    const std::string id(model.id);
    const bool diffuse = model.kind == ModelKind::diffuse;
    add_row(id, diffuse ? "" : id, diffuse ? id : "", scene.lights, around.get(),
            diffuse ? &by_lambert : &by_ggx_exact);
  }
  if (!wanted("light")) return laid_out(sheet);
  LightSetup hemispheres;
  hemispheres.hemispheres =
      scene.lights.hemispheres ? scene.lights.hemispheres : default_lights().hemispheres;
  add_row("hemispheres alone", "", "", hemispheres, nullptr, nullptr);
  add_row("environment alone", "", "", alone, studio.get(), nullptr);
  for (const double row_gloss : {0.25, 0.5, 1.0}) {
    for (SurfaceValues& each : surfaces) each.gloss = row_gloss;
    add_row("gloss " + number(row_gloss, 3), "", "", scene.lights, around.get(), nullptr);
  }
  return laid_out(sheet);
}

}  // namespace etak::cli
