// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/material/material.h"

namespace etak {

/// What a file of a refractiveindex.info database tree is.
enum class PageKind {
  constants,  // linear n,k data: a page
  nonlinear,  // n2 data
  other       // no DATA of optical constants: about pages, catalogues
};

/// A page read into values. Wavelengths in nanometres, ascending, without duplicates.
///   flags    what was found in the numbers; Flag::computed where the comments say that theory gave them
///   optics   OpticalConstants, in the form that F0Solver takes; meaningful only when kind is constants and
///            refusal is empty
///   refusal  why no F0 can be had from the page although it is well-formed ("no n given", ...); else empty
struct RiiPage {
  PageKind kind = PageKind::other;
  Optics optics;
  Flags flags;
  std::string refusal;
  // The values of the keys for people, as they stand in the text that was read; empty: not given.
  std::string_view references, comments, conditions;

  OpticalConstants& constants() { return std::get<OpticalConstants>(optics); }
  const OpticalConstants& constants() const { return std::get<OpticalConstants>(optics); }
};

/// Reads the small subset of YAML that the database uses, and refuses what it does not understand: Error with
/// file and line, what was found and what was expected. `page` is overwritten; its vectors' capacity is
/// reused.
///   n,k rules: rows sorted; identical duplicates dropped, different ones averaged; k < 0 taken as 0; n <= 0
///   refused only where 360..830 nm uses it; each flagged. `tabulated nk` beside a formula gives k only.
void parse_rii_page(std::string_view text, std::string_view file, RiiPage& page);

/// The citation of a page whose text still exists, as far as it can be read from the text for people.
Citation citation_of_page(const RiiPage& page, std::string_view path);

/// A page of constants whose text still exists as a material with one dataset: citation, sample and axis taken
/// from text and path as far as they can be. The class is that of decide_class() (core/material/optics/optics_class.h); a conductor
/// is named as sample_name() does.
///   id      material id; empty: made from the path's book folder
Material material_of_page(RiiPage page, std::string_view path, std::string_view id);

/// The text of a page as a material. Throws Error for a page from which no F0 can be had.
Material material_from_rii_page(std::string_view text, std::string_view path, std::string_view id);

}  // namespace etak
