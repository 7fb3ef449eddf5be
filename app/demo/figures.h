// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace etak::demo {

/// One line for each figure of the sources that etak draws again: NAME and the words of `etak render` behind it, with a
/// blank between. The working folder of the words is that of the demo.
std::string figure_commands();

/// The page of those figures whose picture figures/NAME.png is there; empty: none is.
std::string figures_page();

}  // namespace etak::demo
