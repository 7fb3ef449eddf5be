// SPDX-License-Identifier: Apache-2.0
#include "core/report/choose.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/brdf/models.h"
#include "core/color/delta_e.h"
#include "core/material/f0.h"
#include "core/render/cpu_renderer.h"
#include "core/render/reference.h"

namespace etak {
namespace {

constexpr std::string_view full_visibility = "smith-ggx-height";
constexpr std::string_view full_fresnel = "index";
constexpr int picture_side = 128;
// Costs nearer than this are the same: times have a spread. Of equal ones the closest on average is taken.
constexpr double same_cost = 1.1;

// The term of the registry that has the form's formula.
std::string_view term_of(std::string_view form) {
  if (form == "spherical_gaussian") return "spherical-gaussian";
  if (form == "f82_tint") return "f82-tint";
  if (form == "from_f0") return "from-f0";
  if (form == "index" || form == "mean_index" || form == "three_wavelengths") return "exact";
  return form;
}

std::string model_id(std::string_view form, std::string_view visibility) {
  return "microfacet:ggx," + std::string(term_of(form)) + "," + std::string(visibility);
}

// The form's numbers in the order of the model's parameters: three channels of each, then the width.
std::vector<double> model_numbers(const Model& model, const FresnelValues& values, double alpha) {
  std::vector<double> out;
  for (std::size_t i = 0; i + 1 < model.parameters.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) out.push_back(values[c][i]);
  out.push_back(alpha);
  return out;
}

// A key, a fill and a rim light: highlights, edges and the half light between are all in the picture.
LightSetup three_lights() {
  LightSetup setup;
  const auto light = [](Vec3 direction, double intensity) {
    Light one;
    one.kind = LightKind::directional;
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    one.direction = {direction[0] / length, direction[1] / length, direction[2] / length};
    one.intensity = intensity;
    return one;
  };
  // Directions in which the light travels; the viewer looks along -z.
  setup.lights = {light({-0.5, -0.6, -0.6}, 2.0), light({0.8, -0.2, -0.5}, 0.7), light({-0.1, 0.7, 0.5}, 1.5)};
  return setup;
}

Scene scene_of(const OpticalConstants& optics, const FresnelTruth& truth, double gloss,
               const std::string& model, const FresnelValues& values) {
  Scene scene;
  scene.surface.f0 = truth.f0;
  scene.surface.f82 = truth.f82;
  scene.surface.gloss = gloss;
  scene.surface.optics = optics;
  scene.specular = find_model(model);
  scene.lights = three_lights();
  scene.width = scene.height = picture_side;
  scene.background = {0, 0, 0};
  const double alpha = std::sqrt(2 / (std::exp2(12 * gloss) + 2));
  scene.specular_values = model_numbers(*scene.specular, values, alpha);
  return scene;
}

struct PictureError {
  double worst = 0, mean = 0;
};

// Exposed so that nothing of `everything` clips: a clipped channel would hide errors, and one beside it
// overstate them.
double exposure_of(const Image& everything) {
  double most = 0;
  for (int y = 0; y < everything.height; ++y)
    for (int x = 0; x < everything.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) most = std::max(most, static_cast<double>(everything.at(x, y)[c]));
  return most > 0 ? 1 / most : 1;
}

PictureError picture_error(const Image& everything, const Image& chosen) {
  PictureError out;
  std::size_t count = 0;
  const double exposure = exposure_of(everything);
  const auto seen = [&](std::span<const float> pixel) {
    const auto value = [&](std::size_t c) { return std::max(0.0, exposure * static_cast<double>(pixel[c])); };
    return to_lab(LinearRgb{value(0), value(1), value(2)});
  };
  for (int y = 0; y < everything.height; ++y)
    for (int x = 0; x < everything.width; ++x) {
      // Pixels of the rim are half background in both: their coverage is not what is judged here.
      if (everything.at(x, y)[3] < 1 || chosen.at(x, y)[3] < 1) continue;
      const double de = delta_e2000(seen(everything.at(x, y)), seen(chosen.at(x, y)));
      out.worst = std::max(out.worst, de);
      out.mean += de;
      ++count;
    }
  if (count > 0) out.mean /= static_cast<double>(count);
  return out;
}

struct Ranked {
  const FresnelForm* form;
  double cost;
};

std::vector<Ranked> forms_by_cost(const CostTable& costs) {
  std::vector<Ranked> out;
  for (const FresnelForm& form : fresnel_forms())
    if (form.physical) out.push_back({&form, costs.of("fresnel/" + std::string(form.id))});
  std::stable_sort(out.begin(), out.end(), [](const Ranked& a, const Ranked& b) { return a.cost < b.cost; });
  return out;
}

struct RankedTerm {
  const Term* term;
  double cost;
};

// Masking that fits a GGX lobe; the full one is among them.
std::vector<RankedTerm> visibilities_by_cost(const CostTable& costs) {
  std::vector<RankedTerm> out;
  for (const Term& term : terms())
    if (term.kind == TermKind::visibility && !term.id.starts_with("smith-beckmann"))
      out.push_back({&term, costs.of("visibility/" + std::string(term.id))});
  std::stable_sort(out.begin(), out.end(),
                   [](const RankedTerm& a, const RankedTerm& b) { return a.cost < b.cost; });
  return out;
}

void choose_method(const Dataset& dataset, const CostTable& costs, Choice& choice) {
  F0Options exact;
  exact.method = Method::exact;
  const F0Result truth = F0Solver(exact).solve(dataset.optics, dataset.flags);
  if (truth.refused())
    throw Error::at(choice.material + "/" + choice.dataset, truth.refusal, "data with a colour");
  struct RankedMethod {
    Method method;
    double cost;
  };
  std::vector<RankedMethod> ranked;
  for (const Method method : all_methods)
    // Schueler's points come with a power law of their own: not the same quantity.
    if (method != Method::legacy_schueler)
      ranked.push_back({method, costs.of("quadrature/" + std::string(name(method)))});
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const RankedMethod& a, const RankedMethod& b) { return a.cost < b.cost; });
  choice.everything_solve_ns = costs.of("quadrature/exact");
  for (const auto& [method, cost] : ranked) {
    F0Options options;
    options.method = method;
    const F0Result result = F0Solver(options).solve(dataset.optics, dataset.flags);
    Candidate candidate{std::string(name(method)), std::string(name(method)), cost, 0, false};
    candidate.error = delta_e2000(to_lab(result.srgb_linear), to_lab(truth.srgb_linear));
    candidate.within = candidate.error <= choice.budget;
    choice.method_candidates.push_back(candidate);
    if (!candidate.within) continue;
    choice.method = candidate.id;
    choice.method_error = candidate.error;
    choice.chosen_solve_ns = cost;
    return;
  }
  throw Error::at("--budget", number(choice.budget, 6), "at least what the quadratures differ by");
}

}  // namespace

double CostTable::of(std::string_view id) const {
  const auto found = ns.find(id);
  if (found == ns.end())
    throw Error::at("cost table", "no \"" + std::string(id) + "\"", "a cost for every form");
  return found->second;
}

Choice choose(const Material& material, const Dataset& dataset, double budget, double gloss,
              const CostTable& costs) {
  Choice choice;
  choice.material = material.id;
  choice.dataset = dataset.id;
  choice.budget = budget;
  const std::string what = material.id + "/" + dataset.id;
  const auto* optics = std::get_if<OpticalConstants>(&dataset.optics);
  if (optics == nullptr) throw Error::at(what, "has reflectance data only", "n and k");
  choose_method(dataset, costs, choice);

  const FresnelTruth truth = fresnel_truth(*optics, what);
  const auto fresnel_cost = [&](const FresnelForm& form) {
    return costs.of("fresnel/" + std::string(form.id));
  };
  const auto visibility_cost = [&](std::string_view id) { return costs.of("visibility/" + std::string(id)); };

  const FresnelForm& full = *fresnel_form(full_fresnel);
  const Scene everything_scene =
      scene_of(*optics, truth, gloss, model_id(full_fresnel, full_visibility), full.fit(truth));
  ReferenceOptions rays;
  rays.samples_per_side = 1;  // one ray through each pixel's centre, as the renderer has it
  rays.light_samples = 0;
  const Image everything = render_reference(everything_scene, nullptr, rays).picture;
  const auto drawn = [&](const FresnelForm& form, const FresnelValues& values, std::string_view visibility,
                         Scene* scene_out = nullptr) {
    const Scene scene = scene_of(*optics, truth, gloss, model_id(form.id, visibility), values);
    Image picture;
    render_cpu(scene, nullptr, 1, Precision::f64, picture);
    if (scene_out != nullptr) *scene_out = scene;
    return picture_error(everything, picture);
  };

  double found_cost = 0, found_error = 0;
  for (const auto& [form, cost] : forms_by_cost(costs)) {
    if (choice.fresnel != nullptr && cost > found_cost * same_cost) break;
    const FresnelValues values = form->fit(truth);
    Candidate candidate{std::string(form->id), std::string(form->title), cost, 0, false};
    const FresnelError angles = fresnel_error(truth, *form, values);
    const double by_angle = candidate.error = angles.max_de;
    if (by_angle <= budget) {
      const double picture = drawn(*form, values, full_visibility).worst;
      candidate.error = std::max(by_angle, picture);
      candidate.within = picture <= budget;
    }
    choice.fresnel_candidates.push_back(candidate);
    if (!candidate.within || (choice.fresnel != nullptr && angles.mean_de >= found_error)) continue;
    if (choice.fresnel == nullptr) found_cost = cost;
    found_error = angles.mean_de;
    choice.fresnel = form;
    choice.values = values;
    choice.fresnel_error = by_angle;
  }
  if (choice.fresnel == nullptr)
    throw Error::at("--budget", number(budget, 6),
                    "one that some form of Fresnel reflectance meets for " + what);

  for (const auto& [term, cost] : visibilities_by_cost(costs)) {
    if (!choice.visibility.empty() && cost > found_cost * same_cost) break;
    Scene scene;
    const PictureError error = drawn(*choice.fresnel, choice.values, term->id, &scene);
    Candidate candidate{std::string(term->id), std::string(term->title), cost, error.worst,
                        error.worst <= budget};
    choice.visibility_candidates.push_back(candidate);
    if (!candidate.within || (!choice.visibility.empty() && error.worst >= choice.picture_error)) continue;
    if (choice.visibility.empty()) found_cost = cost;
    choice.visibility = candidate.id;
    choice.model = scene.specular->id;
    choice.model_values = scene.specular_values;
    choice.alpha = scene.specular_values.back();
    choice.picture_error = error.worst;
    choice.picture_mean = error.mean;
  }
  choice.everything_ns = fresnel_cost(full) + visibility_cost(full_visibility);
  choice.chosen_ns = fresnel_cost(*choice.fresnel) + visibility_cost(choice.visibility);
  return choice;
}

}  // namespace etak
