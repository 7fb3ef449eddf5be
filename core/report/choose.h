// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/material/material.h"
#include "core/report/fresnel_forms.h"

namespace etak {

// The cheapest way to draw a material that stays within a budget of error, found by measuring, not by a table
// of materials: only what things cost comes from a table, so that the choice is the same on every machine.

/// What a Fresnel form, a visibility term or a quadrature costs: ns per evaluation, from `etak report` on the
/// machine that the header names.
struct CostTable {
  std::string header;
  std::map<std::string, double, std::less<>>
      ns;                                // "fresnel/f82", "visibility/smith-ggx-height", "quadrature/1nm"
  double of(std::string_view id) const;  // Throws Error where it is missing
};

/// The table in resources/costs.json, kept in the program.
const CostTable& shipped_costs();
CostTable parse_costs(std::string_view text, std::string_view file);
std::string format_costs(const CostTable& costs);

/// Times everything here and now. In target etak::report_run.
CostTable measure_costs(std::string_view header);

/// A candidate that was looked at, in the order of its cost.
struct Candidate {
  std::string id, title;
  double cost_ns = 0;
  double error = 0;  // ΔE2000, largest
  bool within = false;
};

struct Choice {
  std::string material, dataset;
  double budget = 0;  // ΔE2000
  const FresnelForm* fresnel = nullptr;
  FresnelValues values{};
  std::string visibility;  // term of the registry
  std::string method;      // spectral integration of F0
  std::string model;       // "microfacet:ggx,f82,smith-ggx-height"
  std::vector<double> model_values;
  double alpha = 0;
  double fresnel_error = 0;  // ΔE2000 over all angles
  double picture_error = 0;  // ΔE2000 of the worst pixel: everything against what was chosen
  double picture_mean = 0;
  double method_error = 0;                              // ΔE2000 of F0
  double everything_ns = 0, chosen_ns = 0;              // Fresnel and visibility, per evaluation
  double everything_solve_ns = 0, chosen_solve_ns = 0;  // per spectrum
  std::vector<Candidate> fresnel_candidates, visibility_candidates, method_candidates;
};

/// For a library material of known n and k. "Everything" is F at every nanometre in a GGX lobe with
/// height-correlated Smith masking, F0 by the exact quadrature.
///   budget   largest ΔE2000 (CIEDE2000, D65) of F at any angle and of any pixel of the rendered sphere,
///   above 0 gloss    of the rendered sphere
/// Throws Error for a material without n and k, and where no candidate stays within the budget.
Choice choose(const Material& material, const Dataset& dataset, double budget, double gloss,
              const CostTable& costs);

std::string choice_text(const std::vector<Choice>& choices, const CostTable& costs);
std::string choice_json(const std::vector<Choice>& choices, const CostTable& costs);

}  // namespace etak
