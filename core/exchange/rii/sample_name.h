// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace etak {

/// The name of a sample, by which several of one metal are told apart: "Au, Yakubovsky 2017, 25 nm".
///   page   the page's name: author, then what tells it from the author's others ("Yakubovsky-25nm")
///   year   0: not known
std::string sample_name(std::string_view book, std::string_view page, int year);

}  // namespace etak
