// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/certainty/identify.h"
#include "core/certainty/thickness.h"

namespace etak {

// What `etak identify` answers, as text for people and as JSON by resources/schema/identify.schema.json.

/// The answer to a colour. The text has its first eight candidates, JSON all.
///   input        as it was typed; of a picture its path and the colour
///   area_share   of the picture's texels
struct IdentifiedColor {
  std::string input;
  Identified answer;
  std::optional<double> area_share = {};
};
std::string identify_text(std::span<const IdentifiedColor> answers, bool color);
std::string identify_json(std::span<const IdentifiedColor> answers);

/// The films that could give a metal a colour, best first.
struct FilmOnMetal {
  std::string film, metal;
  FittedThickness fit;
};
/// The metal under a film, and the films that are tried; none: usual_films().
struct FilmQuestion {
  std::string metal;
  std::vector<std::string> films;
};
/// Films that grow on metals, or are put on them, and are seen as colours.
std::span<const std::string_view> usual_films();
/// Throws Error for a name that is no material of a film.
std::vector<FilmOnMetal> films_of_color(const FilmQuestion& question, const AskedColour& asked,
                                        const MaterialLibrary& library, const F0Solver& solver,
                                        unsigned threads);
struct IdentifiedFilm {
  std::string input;
  std::vector<FilmOnMetal> answers;
};
std::string identify_text(std::span<const IdentifiedFilm> answers);
std::string identify_json(std::span<const IdentifiedFilm> answers);

/// The thickness of a layer by a measured spectrum.
///   stack   with '?' where the thickness was looked for
struct IdentifiedThickness {
  std::string input, stack;
  SpectrumFit fit;
};
/// The thickness that a table of reflectance in a file tells. Throws Error for a stack without one unknown thickness, for
/// a file without reflectance, and as thickness_of_spectrum() does.
IdentifiedThickness identified_thickness(const std::string& file, const std::string& stack,
                                         const MaterialLibrary& library, const F0Solver& solver);
std::string identify_text(const IdentifiedThickness& answer);
std::string identify_json(const IdentifiedThickness& answer);

}  // namespace etak
