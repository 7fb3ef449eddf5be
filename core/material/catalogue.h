// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/color/rgb.h"
#include "core/material/f0.h"
#include "core/material/library.h"

namespace etak {

// Lists of the library: its materials with their F0, and the answers to names.

/// A library material with the F0 of its preferred dataset.
struct CatalogueEntry {
  Material material;
  F0Result result;
};

/// All materials of the library in the order of their ids, solved on `threads` threads.
///   axis_average   crystals as random grains: solve_averaged() (quality.h)
std::vector<CatalogueEntry> catalogue(const MaterialLibrary& library, const F0Solver& solver,
                                      unsigned threads, bool axis_average = false);

/// quality_text() of the preferred dataset: its kind, and what makes it doubtful.
std::string quality_text(const CatalogueEntry& entry);

/// Throws Error (naming the setting "class") for a class that no material can have.
void check_classes(std::span<const std::string> classes);

/// Which entries are wanted: all of what is given must hold.
///   classes   one of these; empty: any
///   search    a part of id, name, group or an alias, in any case
///   zone      where the luminance of F0 lies, which refused entries and surfaces have not
struct CatalogueFilter {
  std::vector<std::string> classes;
  std::string search;
  std::optional<Zone> zone;
};
bool fits(const CatalogueEntry& entry, const CatalogueFilter& filter);

/// An entry and the CIEDE2000 distance of its F0 from a colour.
struct NearMaterial {
  const CatalogueEntry* entry = nullptr;
  double delta_e = 0;
};

/// The 8-bit colour that three numbers are. Throws Error (with `place`) where one is no whole number from 0 to 255.
Srgb8 codes_of(const std::array<double, 3>& values, std::string_view place);

/// The entries whose F0 is nearest to `color`, nearest first, at most `count`. An 8-bit colour is compared
/// with the 8-bit colours of the library, so that a texture's own rounding and clipping cost nothing; a
/// linear one (sRGB) with the unclipped values.
///   classes   only these; empty: all that give F0. The colour of a surface is diffuse and no F0: it is
///             offered only where its class is asked for
std::vector<NearMaterial> nearest_materials(std::span<const CatalogueEntry> entries,
                                            const std::variant<LinearRgb, Srgb8>& color,
                                            std::span<const std::string> classes, std::size_t count);

/// The answer to a name.
struct NameAnswer {
  std::string asked;
  std::optional<Material> material;  // none: the name is not answered
  NameKind by = NameKind::id;        // of the material's names
  std::string note;                  // what must be said of the name; of one not answered: why
  std::string near;         // names that come near, or what is measured and near; of one not answered
  bool unmeasured = false;  // known as a thing without a measurement
  std::string refusal;      // why the material has no F0; empty: it has
};
NameAnswer answer_name(const MaterialLibrary& library, const F0Solver& solver, const std::string& name);

}  // namespace etak
