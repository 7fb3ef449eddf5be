// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/brdf/models.h"

// Between the registry and the files that compile the formula texts; not for others.
namespace etak::evaluators {

/// A compiled model ("brdf_lambert", or "ggx_schlick_smith_ggx_height" for fused terms) or term ("D_ggx": for
/// D and V all three results are the same). `numbers`: the `size` numbers its entry takes, parameters then
/// derived ones.
template <class Real>
struct One {
  const char* entry;
  int size;
  void (*evaluate)(const Directions& d, const double* numbers, Real rgb[3]);
};
std::span<const One<double>> all_f64();
std::span<const One<float>> all_f32();

/// What is compiled of a term of terms().
template <class Real>
const One<Real>& compiled(const Term& term);

/// Writes the term's derived numbers (see Model::derive).
void derive(const Term& term, const double* values, double* out);

/// An id as the name of compiled things: "smith-ggx-height" is smith_ggx_height.
std::string compiled_name(std::string_view id);

/// A compiled model as a loop over arrays; see Model::f32_batch.
struct Many {
  const char* entry;
  void (*evaluate)(std::size_t count, const float* const directions[6], const double* numbers,
                   float* const rgb[3]);

  /// See Model::f32_batch_far.
  void (*evaluate_far)(std::size_t count, float lh, const float* const turned[5], const double* numbers,
                       float* const rgb[3]);

  /// The first channel alone, from arrays of nl, nv, nh and lh (isotropic models; half vector along the
  /// tangent): as other people's loops take their angles, for comparing run times.
  void (*evaluate_cosines)(std::size_t count, const float* const cosines[4], const double* numbers,
                           float* out);
};

/// A table of loops with its length: plain pointers, because the files behind it are compiled for
/// instructions that not every processor has and must not instantiate what others use.
struct ManyTable {
  const Many* rows;
  std::size_t count;
};
ManyTable many_generic();
ManyTable many_v3();
ManyTable many_v4();

/// The best table for this processor, and the name of its instruction set: "x86-64-v4", "x86-64-v3" or
/// "generic".
ManyTable many();
const char* instruction_set();

}  // namespace etak::evaluators
