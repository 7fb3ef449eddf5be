// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace etak {

/// `text` in lines of at most `columns` columns (longer words stand alone), each after `indent` blanks. 0:
/// its own lines.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t columns);

}  // namespace etak
