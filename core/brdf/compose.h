// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/brdf/evaluate/evaluators.h"

namespace etak {

/// How a model is evaluated: by functions that are compiled for it as a whole; or term by term, for
/// microfacet models without such functions.
struct Model::Compiled {
  decltype(evaluators::One<double>::evaluate) f64 = nullptr;
  decltype(evaluators::One<float>::evaluate) f32 = nullptr;
  decltype(evaluators::Many::evaluate) many = nullptr;
  decltype(evaluators::Many::evaluate_far) far = nullptr;

  // One term of a microfacet model. `at` holds, for each number that the term takes, its index among the
  // model's numbers (the values, then the derived numbers).
  struct Piece {
    const evaluators::One<double>* f64 = nullptr;
    const evaluators::One<float>* f32 = nullptr;
    std::vector<std::size_t> at;
  };
  Piece distribution, fresnel, visibility;
  bool compensated = false;  // by the visibility
};

/// A model made of three terms, with the strings and lists that the model points to.
struct ComposedModel {
  Model model;
  Model::Compiled compiled;
  std::string id, title, source, entry, text;
  std::vector<Parameter> parameters, derived;
  std::vector<std::string_view> files;
};

/// Fills `out` except for id, title, source and claims. `out` must not move afterwards. Where the
/// distribution and the visibility have a parameter of the same name (the width), they share it.
void compose(const Term& distribution, const Term& fresnel, const Term& visibility, ComposedModel& out);

/// The functions that are compiled under `name` ("brdf_lambert", "ggx_schlick_smith_ggx_height"); null for
/// those that are not compiled.
Model::Compiled find_compiled(std::string_view name);

}  // namespace etak
