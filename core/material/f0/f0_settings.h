// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/material/f0.h"
#include "core/material/f0_coat.h"
#include "core/material/library.h"

namespace etak {

/// How F0 is computed, as a person writes it: options of a command line, keywords of a call. Empty texts stand
/// for the default.
struct F0Settings {
  std::string observer, illuminant, interpolation, method, integration_bound, space, ocio, outside;
  bool allow_extrapolation = false;
  // In place of the words, where they are set.
  std::shared_ptr<const Observer> own_observer;
  std::shared_ptr<const Illuminant> own_illuminant;
  bool axis_average = false;          // crystals as random grains: solve_averaged() (quality.h)
  std::string aperture{}, scatter{};  // numbers of Instrument
  friend bool operator==(const F0Settings&, const F0Settings&) = default;
};

/// The colour spaces that need no config, for messages.
inline constexpr const char* built_in_spaces =
    "srgb (also Rec.709, linear), acescg, rec2020, display-p3 or xyz";

/// Opens a colour space of an OpenColorIO config.
///   config   its file; empty: that of $OCIO, else etak's own
using OpenSpace = std::function<CustomSpace(const std::string& config, const std::string& name)>;

/// The settings as values. Throws Error that names the setting and what it takes.
///   library      for the name of an outside medium
///   open_space   asked for what is no built-in space
F0Options f0_options(const F0Settings& settings, const LibraryWhenAsked& library,
                     const OpenSpace& open_space);

/// The coat of a text: an index above 0 or a clear material of the library, behind which a thickness may stand, over which
/// its k counts, that of another of its datasets where its own has none ("1.5", "pmma", "water:2mm"). Throws Error that names the setting.
Coat coat_setting(const std::string& text, const LibraryWhenAsked& library);

/// The coat for a text that may be empty. Throws Error beside an average over axes or an instrument too, and where the method
/// is no sum over wavelengths.
std::optional<Coat> coat_option(const std::string& text, const LibraryWhenAsked& library,
                                const F0Options& options, bool axis_average);

}  // namespace etak
