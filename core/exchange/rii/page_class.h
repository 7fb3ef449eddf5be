// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/material/material.h"

namespace etak {

/// The class of a page's material, of which no page speaks, by n and k at 550 nm:
///   metal           F0 in or above the forbidden zone, k of at least 1, and the book is a metal's symbol
///   conductor       the same of another book, where k is above n: alloys, nitrides
///   semiconductor   F0 in or above the zone, and k of at least 0.001 (light gets less than 0.05 mm deep)
///   crystal         all others, among them those whose data do not reach 550 nm
///   book   "Au", "TiN"
std::string_view class_of_page(const OpticalConstants& optics, std::string_view book);

/// The name of a sample, by which several of one metal are told apart: "Au, Yakubovsky 2017, 25 nm".
///   page   the page's name: author, then what tells it from the author's others ("Yakubovsky-25nm")
///   year   0: not known
std::string sample_name(std::string_view book, std::string_view page, int year);

}  // namespace etak
