// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "core/color/rgb.h"

namespace etak::cli {

inline constexpr const char* color_forms =
    "a hex colour (#ffe29b), 8-bit codes (255,226,155), linear values with --linear (1.0,0.76,0.33), or a material or file (gold)";

/// A colour that a person typed: 8-bit codes, or linear sRGB.
using TypedColor = std::variant<LinearRgb, Srgb8>;

/// The colour as linear sRGB.
LinearRgb linear_of(const TypedColor& color);

/// Whether the text is a hex colour or numbers, and no name.
bool is_color(const std::string& text, Library& library);

/// Throws Error for a text that is no colour, and for linear values beside a space of a config.
///   linear   the numbers are linear values in the space of the options
TypedColor typed_color(const std::string& text, bool linear, const F0Options& options);

/// The one text of an option's values. Throws Error where the numbers of a colour were typed with blanks between.
const std::string& one_color(const std::vector<std::string>& typed);

/// The unclipped F0 of a material or file, linear sRGB. Throws Error where it is refused.
LinearRgb color_of(const std::string& name, const std::string& dataset, Library& library,
                   const F0Settings& compute, const F0Solver& solver, const OutputArguments& output);

}  // namespace etak::cli
