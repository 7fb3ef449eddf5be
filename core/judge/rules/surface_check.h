// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/exchange/surfaces/meaning.h"
#include "core/judge/rules/rows.h"

namespace etak {

// What the rules 8xx share: they judge the numbers of material documents.

/// act(surface, values) for every surface of the target.
template <class Act>
void for_each_surface(const RuleCheck& check, Act act) {
  for (const DocumentSurface& surface : check.evidence.surfaces) act(surface, values_of(surface));
}

/// A measured material, and how far an F0 is from it.
struct Measured {
  const KnownF0* entry = nullptr;
  double delta_e = 0;
};
/// The measured material nearest to an F0: of metals one that is a metal, of dielectrics one that is none, where one is within 5;
/// else the nearest of all.
Measured nearest_measured(const KnownMaterials& known, const LinearRgb& f0, SurfaceSort sort);

/// The entries of the library's material that a name stands for, without what programs put around it ("M_Gold",
/// "gold_surface"); none where there is no such material; an empty list of one without a specular F0.
std::optional<std::vector<const KnownF0*>> named_material(const KnownMaterials& known, std::string_view name);
/// CIEDE2000 from an entry, or from the grey of its luminance where it is no metal: one index gives a grey.
double distance_of(const LinearRgb& f0, const KnownF0& entry);
/// Whether a surface has the name of a measured material and its F0, within 3. Layers, and surfaces without a specular F0 of
/// their own, count by their name: what a model without films or with a part of their reflectance shows is no mistake.
bool is_what_it_is_called(const KnownMaterials& known, const DocumentSurface& surface, const LinearRgb& f0);

/// Whether a surface has all that the measured material of its name has: F0, and a body that is clear, none, or
/// together with F0 the measured total reflectance, within 3.
bool is_as_measured(const KnownMaterials& known, const DocumentSurface& surface);

/// A surface with the measured material nearest to it.
JudgedSurface judged_surface(const KnownMaterials& known, const DocumentSurface& surface);

/// Adds a finding about a surface: with its name, F0, the nearest measured materials, and the message
/// "line 12: NAME, INPUT: WHAT", at the end of which the nearest is told where F0 is known.
///   input   null: the surface as a whole
Finding& report_surface(RuleCheck& check, const DocumentSurface& surface, const DocumentValues& values,
                        const SurfaceInput* input, const std::string& what);

/// "1.04", "1.04 0.77 0.33".
std::string numbers_text(const std::vector<double>& values);

/// Whether a colour is made of codes of 8 bits: whole numbers up to 255, of which one is above 1.
bool is_eight_bit(const ModelInput& of, const SurfaceInput& input);

/// How a colour may have come about that is no metal's F0: a measured metal is within 2 once it is decoded from sRGB, or
/// encoded. Empty: neither, or it is a metal's as it is.
std::string transfer_slip(const KnownMaterials& known, const LinearRgb& f0);

}  // namespace etak
