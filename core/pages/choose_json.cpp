// SPDX-License-Identifier: Apache-2.0
// The JSON form of choices (resources/schema/choose.schema.json).
#include <cmath>

#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/pages/choose_report.h"

namespace etak {
namespace {

std::string candidate_json(const Candidate& each) {
  return json_object({{"id", json(each.id)},
                      {"cost_ns", json(each.cost_ns)},
                      {"error", json(each.error)},
                      {"within", json(each.within)}},
                     -1);
}

std::string candidates_json(const std::vector<Candidate>& candidates) {
  return json_lines_of(candidates, 6, candidate_json);
}

std::string one_choice_json(const Choice& each) {
  std::vector<std::string> codes;
  for (const std::uint8_t code : each.codes) codes.push_back(std::to_string(code));
  const SurfaceTexel& texel = each.texel;
  return json_object({{"material", json(each.material)},
                      {"library", json(each.library)},
                      {"met", json(each.met)},
                      {"fresnel", json(each.fresnel->id)},
                      {"visibility", json(each.visibility)},
                      {"integration", json(each.method)},
                      {"filter", json(name(each.filter))},
                      {"textured", json(each.textured)},
                      {"model", json(each.model)},
                      {"values", json_array_of(each.model_values)},
                      {"diffuse", json_array_of(texel.diffuse)},
                      {"f0", json_array_of(texel.f0)},
                      {"gloss", json(double{texel.gloss})},
                      {"roughness", json(texel.gloss.roughness())},
                      {"codes", json_array(codes)},
                      {"defines", json_array_of(each.defines)},
                      {"fresnel_error", json(each.fresnel_error)},
                      {"picture_error", json(each.picture_error)},
                      {"picture_mean", json(each.picture_mean)},
                      {"pixels", std::to_string(each.pixels)},
                      {"integration_error", json(each.method_error)},
                      {"everything_ns", json(each.everything_ns)},
                      {"chosen_ns", json(each.chosen_ns)},
                      {"everything_solve_ns", json(each.everything_solve_ns)},
                      {"chosen_solve_ns", json(each.chosen_solve_ns)},
                      {"fresnel_candidates", candidates_json(each.fresnel_candidates)},
                      {"visibility_candidates", candidates_json(each.visibility_candidates)},
                      {"filter_candidates", candidates_json(each.filter_candidates)},
                      {"integration_candidates", candidates_json(each.method_candidates)},
                      {"whole_model", json(each.whole_model)},
                      {"model_candidates", candidates_json(each.model_candidates)},
                      {"film_candidates", candidates_json(each.film_candidates)}},
                     4);
}

}  // namespace

std::string choice_json(const std::vector<Choice>& choices, const CostTable& costs, std::string_view scene) {
  const std::vector<Candidate> levels = png_levels(costs);
  return json_document("etak-choose/2",
                       {{"scene", json(scene)},
                        {"budget", json(choices.empty() ? 0.0 : choices[0].budget)},
                        {"unit", json(name(choices.empty() ? ErrorUnit::delta_e : choices[0].unit))},
                        {"costs", json(costs.header)},
                        {"png_level", json(levels.front().id)},
                        {"png_levels", candidates_json(levels)},
                        {"choices", json_lines_of(choices, 2, one_choice_json)}});
}

}  // namespace etak
