// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/validate/finding.h"
#include "core/validate/settings.h"

namespace etak {

class MaterialLibrary;

/// F0 of one dataset of the built-in library.
struct KnownF0 {
  std::string id, name, dataset;  // material id and name
  bool preferred = false;
  bool conductor = false;          // metals, alloys, conductors
  std::array<double, 3> linear{};  // linear sRGB, not clipped
  double luminance = 0;
};

/// Puts `library`, which must live on, in the place of the built-in one for everything below. Called before
/// the first question.
void use_library(const MaterialLibrary& library);

/// A fingerprint of that library's materials, as results depend on them; empty for the built-in one.
const std::string& library_hash();

/// F0 of every dataset of that library that gives one, without doubtful datasets that are not preferred:
/// computed once per process, when first asked for.
std::span<const KnownF0> known_f0();

/// The entries of one material, by id, alias or name; empty: not in the library.
std::vector<const KnownF0*> known_f0_of(std::string_view material);

/// Largest channel difference in codes between a linear colour and an entry clipped to [0, 1].
double code_distance(const std::array<double, 3>& linear, const KnownF0& entry, TextureTransfer transfer);

/// The `count` nearest materials (best dataset of each), nearest first.
std::vector<NearestMaterial> nearest_materials(const std::array<double, 3>& linear, TextureTransfer transfer,
                                               std::size_t count = 3);

/// How an F0 may have come about, for dielectrics only: the value does not tell it of metals.
///   as_is     a dielectric of the library is within `distance` codes
///   doubled   the value was encoded twice
///   missing   the value was never encoded
struct Explanation {
  enum class Cause { none, as_is, doubled, missing } cause = Cause::none;
  double original = 0;  // F0 it would have been
  double distance = 0;  // codes from the nearest dielectric under that cause
  std::string material;
};

/// Only a grey is explained; the cause is `none` unless some dielectric of the library is within 4 codes.
Explanation explain_f0(const std::array<double, 3>& linear, TextureTransfer transfer);

}  // namespace etak
