// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/iridescence/parameters.h"
#include "core/material/library.h"
#include "core/study/error_time.h"

namespace etak {

/// A way to compute F of a stack.
///   id     "exact", "sum_10nm", "curve", a form of core/iridescence with "_honest" or "_fitted", "bare"
///   within   what takes this way: ways are compared with each other where it is the same
///   seen   linear sRGB at a cosine of incidence; not for several threads at once
struct FilmWay {
  std::string id, title, within;
  std::function<Vec3(double cosine)> seen;
};

/// A stack on a metal with all its ways, the exact one first.
struct FilmWays {
  std::string text;
  FilmTruth truth;
  std::vector<FilmWay> ways;
};

/// The ways of each stack. Throws Error as stack_material() does.
///   stacks   texts, with one layer that interferes each
std::vector<FilmWays> film_ways(const MaterialLibrary& library, const std::vector<std::string>& stacks,
                                unsigned threads);

/// The texts of a film of growing thickness, 10 to 400 nm in even steps.
std::vector<std::string> thicker_films(const std::string& film, const std::string& metal, int count);

/// Strips over thicker_films(): the truth, glTF and OpenPBR, each honest and fitted, with their mean errors.
///   png   encodes a picture
ErrorTimeStrips film_strips(std::string title, const std::vector<FilmWays>& films,
                            const std::function<std::string(const Pixels<std::uint8_t>&)>& png);

}  // namespace etak
