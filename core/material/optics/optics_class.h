// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/material/material.h"

namespace etak {

/// Gives a material whose class nobody states the one that the numbers of its preferred dataset tell, n and k at
/// 550 nm. Pages, tables, material files without a class and pipes are all decided here.
///   metal           F0 in or above the forbidden zone, k of at least 1, and `formula` is a metal's symbol,
///                   which states it
///   conductor       the same without such a symbol, where k is above n: alloys, nitrides
///   semiconductor   F0 in or above the zone, and k of at least 0.001 (light gets less than 0.05 mm deep)
///   solid           all others. The numbers tell a dielectric where F0 is below the zone, or k below 0.001 with
///                   F0 up to most_assumed_f0; else `class_by` becomes ClassBy::nobody: the data are
///                   reflectance, do not reach 550 nm, or give n below 1 or F0 above that without a k to judge by
///   formula   "Au", "TiN"; may be empty
void decide_class(Material& material, std::string_view formula = {});

/// The brightest F0 (Y) that is taken for a dielectric's where nobody states the class.
inline constexpr double most_assumed_f0 = 0.25;

/// The remark about a class that was not stated; empty where it was.
std::string class_remark(const Material& material);

}  // namespace etak
