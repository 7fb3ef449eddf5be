// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/certainty/bands.h"
#include "core/material/f0.h"
#include "core/material/library.h"
#include "core/material/material.h"

namespace etak {

/// A dataset of a material as a witness of its F0.
///   left_out   why it is none: "computed", "12 K", "another axis", "the same publication as ID"; empty: it is one
struct Publication {
  const Dataset* dataset = nullptr;
  std::string left_out;
};

/// All datasets but `stated`, one of each publication that says the same as `stated` measures: on the same axis, at room
/// temperature (283 K to 308 K, or not said), not computed and not doubtful.
std::vector<Publication> publications_beside(const Material& material, const Dataset& stated);

/// The band of a material's stated F0, or why it has none.
///   publications   views into the material
struct MaterialBand {
  std::optional<Band> band;
  std::string reason;                     // why there is none
  std::vector<Publication> publications;  // beside the stated one
};

/// Why F0 of a dataset of the material has no band, whatever it is; empty: it has one.
std::string why_no_band(const Material& material, const Dataset& dataset);

/// The band of a dataset of the material. Surfaces, stacks, gases, doubtful and refused datasets have none.
///   solver   computes the other publications, as `stated` was
///   stated   F0 of `dataset` by `solver`
MaterialBand material_band(const F0Solver& solver, const Material& material, const Dataset& dataset,
                           const F0Result& stated);
/// The band of a dataset where F0 of the other datasets is known.
MaterialBand material_band(const std::function<F0Result(const Dataset&)>& f0_of, const Material& material,
                           const Dataset& dataset, const F0Result& stated);

/// Index of the colour that is nearest to the others together by CIEDE2000; there is at least one.
std::size_t nearest_together(std::span<const LinearRgb> colors);

/// The material as it would be if a publication were not known: without all of its datasets. Where the preferred one is
/// among them, the dataset that is nearest to the others together is preferred.
///   returns   nothing where no dataset is left
std::optional<Material> without_publication(Material material, const Dataset& dataset);

/// What is left of materials without publications, by id; none where no dataset is left.
using MaterialsWithout = std::map<std::string, std::optional<Material>>;
/// The materials without the datasets named, such as "gold/mcpeak-2015". Throws Error (naming the setting "without") for a
/// name that is no dataset of the library.
MaterialsWithout materials_without(const MaterialLibrary& library, const std::vector<std::string>& names);
/// Puts what is left of a material in its place. Throws Error where nothing is.
void leave_out(const MaterialsWithout& without, std::shared_ptr<const Material>& material);

/// The class by which a material's publications are compared: conductors below the forbidden zone, such as indium tin
/// oxide, are clear.
BandClass band_class(const Material& material, const F0Result& stated);

}  // namespace etak
