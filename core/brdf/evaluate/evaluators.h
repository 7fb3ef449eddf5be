// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/brdf/models.h"

// The interface between the registry and the sources that compile the formula texts; not for other sources.
namespace etak::evaluators {

/// A compiled model or term, for one pair of directions.
///   entry      "brdf_lambert"; "ggx_schlick_smith_ggx_height" for a model of three terms; "D_ggx" for a term
///   size       how many numbers the entry takes
///   evaluate   `numbers` are the parameters, then the derived numbers; for a D or a V all three results are
///              the same, except for a V that compensates
///   mean       of an F over a diffuse hemisphere; the directions do not matter; null for others
template <class Real>
struct One {
  const char* entry;
  int size;
  void (*evaluate)(const Directions& d, const double* numbers, Real rgb[3]);
  void (*mean)(const Directions& d, const double* numbers, Real rgb[3]) = nullptr;
};
std::span<const One<double>> all_f64();
std::span<const One<float>> all_f32();

/// The compiled form of a term, which must be one of terms().
template <class Real>
const One<Real>& compiled(const Term& term);

/// Computes the derived numbers of a term (see Model::derive()).
void derive(const Term& term, const double* values, double* out);

/// The name under which the term of an id is compiled: "smith_ggx_height" for "smith-ggx-height".
std::string compiled_name(std::string_view id);

/// A model compiled as loops over arrays.
struct Many {
  const char* entry;

  /// See Model::f32_batch().
  void (*evaluate)(std::size_t count, const float* const directions[6], const double* numbers,
                   float* const rgb[3]);

  /// See Model::f32_batch_far().
  void (*evaluate_far)(std::size_t count, float lh, const float* const turned[5], const double* numbers,
                       float* const rgb[3]);

  /// Computes the first channel alone, from arrays of nl, nv, nh and lh; for isotropic models, with the half
  /// vector in the plane of the normal and the tangent. Other programs take their angles in this way, so this
  /// is for comparing run times with theirs.
  void (*evaluate_cosines)(std::size_t count, const float* const cosines[4], const double* numbers,
                           float* out);
};

/// A table of loops and its length. It has plain pointers, because the sources that define the tables are
/// compiled for instructions that not every processor has, and must not instantiate templates that other
/// sources use.
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
