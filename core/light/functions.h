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
  bool above_min = false;                        // min itself is refused
  std::span<const std::string_view> words = {};  // instead of a number; the value is the word's index
  std::optional<double> otherwise = {};          // taken when the input is not given; without it, it must be
};

/// A function of `etak eval`, named as the sources name it. Double precision throughout.
struct Function {
  std::string_view id;
  std::string_view returns;
  std::string_view source;
  std::span<const FunctionInput> inputs;
  bool directions;  // has theta_l, theta_v, phi_v; also takes l=-v, and is then 0

  /// Takes the inputs' values in order, all inside their ranges. Throws Error where a combination has no
  /// value.
  double (*value)(const double* inputs);
};
std::span<const Function> functions();
const Function* find_function(std::string_view id);

/// A text as typed, "theta_l" with "30".
using NamedText = std::pair<std::string, std::string>;

/// Checks and evaluates. Where an input is Schueler's gloss g, perceptual "roughness" may stand for it.
/// Throws Error (`place` in front) for unknown, missing, repeated or unreadable inputs and for values outside
/// the function's domain.
double evaluate(const Function& function, std::span<const NamedText> inputs, std::string_view place);

/// Splits "name=value". Throws Error.
NamedText split_input(std::string_view text, std::string_view place);

}  // namespace etak
