// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace etak {

/// An input of a function: a finite number in a range, or one of a few words.
struct FunctionInput {
  std::string_view name;
  std::string_view meaning;
  std::string_view unit;  // "" for pure numbers
  double min, max;
  bool above_min = false;                        // whether min itself is refused
  std::span<const std::string_view> words = {};  // the words, in place of a number; the value is the index
  std::optional<double> otherwise = {};          // default value; none: the input must be given
};

/// A function of `etak eval`, under the name that its source gives it. It is computed in double.
struct Function {
  std::string_view id;
  std::string_view returns;
  std::string_view source;
  std::span<const FunctionInput> inputs;
  bool directions;  // has the inputs theta_l, theta_v and phi_v; with l=-v instead of them its value is 0

  /// Computes the value from those of all inputs, in order and inside their ranges. Throws Error where the
  /// function has no value for this combination.
  double (*value)(const double* inputs);
};
std::span<const Function> functions();
const Function* find_function(std::string_view id);

/// An input as it is typed: its name and its text, "theta_l" and "30".
using NamedText = std::pair<std::string, std::string>;

/// Checks the inputs and evaluates the function. Where an input is Schueler's gloss g, a perceptual
/// "roughness" may be given instead. Throws Error for unknown, missing, repeated or unreadable inputs and for
/// values outside of the domain.
///   place   file and line, in front of messages; empty: none
double evaluate(const Function& function, std::span<const NamedText> inputs, std::string_view place);

/// Splits "name=value". Throws Error, with `place` in front, for other texts.
NamedText split_input(std::string_view text, std::string_view place);

}  // namespace etak
