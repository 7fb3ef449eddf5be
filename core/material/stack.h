// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/material/find.h"
#include "core/material/material.h"

namespace etak {

/// What a name in the text of a stack stands for.
///   named     the name says which dataset, so that no other one is tried in its place
///   written   the name that says so: "titanium/palm-2018", or a file's path
///   body      of a base, where it is clear: open_stacks() computes it once for each dataset, whatever the layers are
struct StackPart {
  FoundDataset found;
  bool named = false;
  std::string written;
  std::optional<ClearBody> body = {};
};

/// Finds what a name of a stack stands for. Throws Error (naming `place`) where there is none.
using FindStackPart = std::function<StackPart(std::string_view name, const std::string& place)>;

/// A name of the library, "titanium" or "titanium/palm-2018".
StackPart library_part(const MaterialLibrary& library, std::string_view name, const std::string& place);

/// Looks up the media of all stacks of a material that are not open. A material of no stated class gets that of the
/// base. Behind the datasets come those in which one medium, of which the text names no dataset, has another one;
/// their ids are those of the media with '+' between. Throws Error (naming `place`) for an unknown thickness, for
/// names that are not known, and for media without n.
void open_stacks(Material& material, std::string_view place, const FindStackPart& find);

/// A text as a material of the class of its base, with open stacks. Throws Error as parse_stack() and open_stacks() do.
Material stack_material(std::string_view text, const FindStackPart& find);

/// `stack` with another thickness of a layer, which keeps its coherence, in its text too. Throws Error for a layer that is not there.
///   layer   its number, the outermost being 1
Stack with_thickness(Stack stack, std::size_t layer, double thickness_nm);

}  // namespace etak
