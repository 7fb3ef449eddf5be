// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/brdf/models.h"
#include "core/study/choose/choose.h"

namespace etak {

/// Costs within this factor count as equal, because two runs of measure_costs() differ by as much. Of forms of equal
/// cost the one with the least mean error is taken.
inline constexpr double same_cost = 1.15;

/// What trying a candidate gave.
///   rank   of those that cost as much as the cheapest one, the least rank is taken; none: the candidate cannot be
template <class Item>
struct Tried {
  Item item;
  Candidate candidate;
  std::optional<double> rank;
};

/// Tries candidates from the cheapest on, up to those that cost at most `same` times the cheapest one that can be
/// taken, and returns the one that is taken; none: there is none.
///   ranked    the costs in ns, and what the candidates are
///   try_one   takes an item and its cost, and gives Tried<Item>
///   tried     gets all candidates that were tried
template <class Item, class TryOne>
std::optional<Tried<Item>> cheapest_within(std::vector<std::pair<double, Item>> ranked, double same,
                                           std::vector<Candidate>& tried, const TryOne& try_one) {
  std::ranges::stable_sort(ranked, {}, [](const auto& each) { return each.first; });
  std::optional<Tried<Item>> found;
  double most = 0;
  for (const auto& [cost, item] : ranked) {
    if (found && cost > most) break;
    Tried<Item> one = try_one(item, cost);
    tried.push_back(one.candidate);
    if (!one.rank || (found && *one.rank >= *found->rank)) continue;
    if (!found) most = cost * same;
    found = std::move(one);
  }
  return found;
}

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

}  // namespace etak
