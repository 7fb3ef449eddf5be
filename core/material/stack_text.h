// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace etak {

/// From this thickness on a layer is taken to be incoherent unless its text says otherwise: light of 550 nm and a
/// width of some 15 nm stays in step over about 20 um, one way and back.
inline constexpr double incoherent_from_nm = 10000;

/// The most layers of a stack.
inline constexpr std::size_t most_layers = 1000;

/// A stack as it is written, from the outside to the base: "water:2mm/copper",
/// "anatase/jolivet-2023:40nm/titanium/palm-2018". A layer ends with the part between two '/' that has a thickness
/// behind a ':'; what follows the last thickness is the base, so that names of datasets and paths of files may have '/'.
/// Behind the thickness ":coherent" or ":incoherent" may say what the layer is.
struct StackText {
  /// A layer.
  ///   name           of a material, of one of its datasets, or of a file
  ///   thickness_nm   none: it is unknown, "?nm"
  ///   coherent       as the text says, else whether the layer is thinner than incoherent_from_nm
  ///   rest           what the text has behind the name: ":40nm"
  struct Layer {
    std::string name;
    std::optional<double> thickness_nm;
    bool coherent = true;
    std::string rest;
  };
  std::vector<Layer> layers;
  std::string base;
};

/// "40nm", "1.5um" or "2mm" in nanometres; false for another text, and for what no layer can have.
bool read_thickness(std::string_view text, double& nm);

/// Whether a text is a number from 0 to 1 without a unit: behind the name of a series it is a composition
/// ("silver_gold:0.35:40nm", alloy.h), and no thickness.
bool is_fraction(std::string_view text);

/// Whether a text is that of a stack: one of its parts has a thickness, right or wrong.
bool is_stack_text(std::string_view text);

/// Throws Error (naming `place` and the layer) for a text of another form.
StackText parse_stack(std::string_view text, std::string_view place);

/// The text that parse_stack() reads.
std::string format_stack(const StackText& stack);

/// Gives a layer a thickness, in its text too; it stays coherent or incoherent.
///   nm   finite, 0 and above
void set_thickness(StackText::Layer& layer, double nm);

/// "PLACE layer 2", for messages.
std::string layer_place(std::string_view place, std::size_t index);

}  // namespace etak
