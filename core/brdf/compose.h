// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/brdf/evaluate/evaluators.h"

namespace etak {

/// How a model is evaluated: compiled as one piece, or (microfacet models that nobody named) term by term.
struct Model::Compiled {
  decltype(evaluators::One<double>::evaluate) f64 = nullptr;
  decltype(evaluators::One<float>::evaluate) f32 = nullptr;
  decltype(evaluators::Many::evaluate) many = nullptr;
  decltype(evaluators::Many::evaluate_far) far = nullptr;

  // One term of a model made of terms: where in the model's numbers (values, then derived) its own stand.
  struct Piece {
    const evaluators::One<double>* f64 = nullptr;
    const evaluators::One<float>* f32 = nullptr;
    std::vector<std::size_t> at;
  };
  Piece distribution, fresnel, visibility;
};

/// A model made of three terms with all it points to.
struct ComposedModel {
  Model model;
  Model::Compiled compiled;
  std::string id, title, source, entry, text;
  std::vector<Parameter> parameters;
  std::vector<std::string_view> files;
};

/// Fills `out` (which must not move afterwards) but for id, title and claims. The V's width is the D's where
/// both have one of that name.
void compose(const Term& distribution, const Term& fresnel, const Term& visibility, ComposedModel& out);

/// What is compiled under `name` ("brdf_lambert", "ggx_schlick_smith_ggx_height"), with null members for what
/// is not.
Model::Compiled find_compiled(std::string_view name);

}  // namespace etak
