// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/brdf/models.h"
#include "core/study/choose/choose.h"

namespace etak {

/// Costs within this factor count as equal, because two runs of measure_costs() differ by as much. Of forms of equal
/// cost the one with the least mean error is taken.
inline constexpr double same_cost = 1.15;

// Whole models beside the frame of GGX, a form of F and a masking term: Schueler's techniques, and lobes of other
// distributions.

/// The specular models of models() that take F0 (or n and k) and one width, without those of GGX, which the frame has.
std::vector<const Model*> whole_models();

/// Whether a term is a masking of one reflection by facets that a lobe of GGX may have.
bool masks_ggx(const Term& term);

/// Whether the model takes n and k, which a colour does not tell.
bool takes_index(const Model& model);

/// The numbers of such a model: F0, or n and k; then gloss, alpha or exponent of the texel.
///   index   n and k of each channel, for a model that takes them
std::vector<double> whole_model_numbers(const Model& model, const Vec3& f0, const FresnelValues& index,
                                        const SurfaceTexel& texel);

/// The form of F that the model has, with which it is judged at every angle; null: one that is hidden in its lobe, so
/// that pictures alone judge it.
const FresnelForm* form_of(const Model& model);

/// The whole model that was chosen; null: none is cheaper than the frame and within the limit.
struct ModelStep {
  const Model* model = nullptr;
  double error = 0, cost_ns = 0;
  std::vector<Candidate> candidates;  // those that are cheaper than the frame
};

///   frame_ns   what an evaluation costs with the chosen form of F and masking; a model must be cheaper by more than
///              two measurements differ
///   error_of   the largest error of a model; none: the material cannot have it
ModelStep choose_model(const CostTable& costs, double frame_ns, double limit,
                       const std::function<std::optional<double>(const Model&)>& error_of);

}  // namespace etak
