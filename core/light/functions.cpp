// SPDX-License-Identifier: Apache-2.0
#include "core/light/functions.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/base/text/text.h"
#include "core/color/gloss.h"
#include "core/light/function_rows.h"

namespace etak {
namespace {

std::string range_of(const FunctionInput& input) {
  if (!input.words.empty()) return joined(input.words);
  const std::string low = (input.above_min ? "above " : "at least ") + number(input.min, 6);
  if (input.min <= -function_rows::largest && input.max >= function_rows::largest) return "a finite number";
  return input.max >= function_rows::largest ? low : low + ", at most " + number(input.max, 6);
}

double read(const FunctionInput& input, const std::string& text, const std::string& place) {
  if (!input.words.empty()) {
    const auto found = std::find(input.words.begin(), input.words.end(), text);
    if (found == input.words.end()) throw Error::at(place, printable(text), range_of(input));
    return static_cast<double>(found - input.words.begin());
  }
  double value = 0;
  if (!parse_number(text, value)) throw Error::at(place, printable(text), "a finite number");
  // A cosine that comes from a float or from a normalised vector may exceed 1 by rounding.
  if (input.max == 1 && value > 1 && value <= 1 + 1e-6) value = 1;
  if (!(value >= input.min && value <= input.max) || (input.above_min && value == input.min))
    throw Error::at(place, number(value, 9), range_of(input));
  return value;
}

// Converts an input "roughness" to the input "g", for functions that have a gloss but no roughness; nullopt
// for all other inputs. Throws Error for a roughness that no gloss in [0, 1] has, because inputs of formulas
// are never clamped.
std::optional<NamedText> as_gloss(const Function& function, const NamedText& input, const std::string& at) {
  const auto named = [&](std::string_view name) {
    return std::any_of(function.inputs.begin(), function.inputs.end(), [&](const FunctionInput& each) {
      return each.name == name && (name != "g" || each.meaning.starts_with("gloss"));
    });
  };
  if (input.first != "roughness" || named("roughness") || !named("g")) return std::nullopt;
  double roughness = 0;
  const std::string range = number(roughness_of_gloss(1), 6) + " to " + number(roughness_of_gloss(0), 6) +
                            ", which gloss 1 to 0 have";
  if (!parse_number(input.second, roughness))
    throw Error::at(at + " roughness", printable(input.second), range);
  const Gloss gloss = Gloss::of_roughness(roughness);
  if (!(roughness >= 0 && roughness <= 1) || gloss.held())
    throw Error::at(at + " roughness", number(roughness, 9), range);
  return NamedText{"g", number(double{gloss}, 17)};
}

}  // namespace

std::span<const Function> functions() {
  static const std::vector<Function> all = [] {
    std::vector<Function> out;
    for (const auto rows : {function_rows::fresnel(), function_rows::films(), function_rows::distributions(),
                            function_rows::reflectance(), function_rows::lighting()})
      out.insert(out.end(), rows.begin(), rows.end());
    return out;
  }();
  return all;
}

const Function* find_function(std::string_view id) {
  for (const Function& each : functions())
    if (each.id == id) return &each;
  return nullptr;
}

double evaluate(const Function& function, std::span<const NamedText> inputs, std::string_view place) {
  const std::string at =
      place.empty() ? std::string(function.id) : std::string(place) + ": " + std::string(function.id);
  std::vector<double> values(function.inputs.size());
  std::vector<bool> given(function.inputs.size());
  bool opposite = false;
  for (const NamedText& each : inputs) {
    const auto& [name, text] = as_gloss(function, each, at).value_or(each);
    if (function.directions && name == "l") {
      if (text != "-v") throw Error::at(at + " l", printable(text), "-v");
      opposite = true;
      continue;
    }
    const auto found =
        std::find_if(function.inputs.begin(), function.inputs.end(),
                     [&, &wanted = name](const FunctionInput& input) { return input.name == wanted; });
    if (found == function.inputs.end()) {
      const std::string known = joined(function.inputs, ", ", &FunctionInput::name);
      throw Error::at(at, "unknown input " + in_quotes(name), known.empty() ? "no inputs" : known);
    }
    const auto i = static_cast<std::size_t>(found - function.inputs.begin());
    if (given[i]) throw Error::at(at, "input \"" + name + "\" twice", "each once");
    given[i] = true;
    values[i] = read(*found, text, at + ' ' + name);
  }
  if (opposite) return 0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const FunctionInput& input = function.inputs[i];
    if (given[i]) continue;
    if (!input.otherwise) throw Error::at(at, "no " + std::string(input.name), input.meaning);
    values[i] = *input.otherwise;
  }
  double value;
  try {
    value = function.value(values.data());
  } catch (const Error& e) {
    throw Error(at + ' ' + e.what());
  }
  if (!std::isfinite(value)) throw Error::at(at, "no finite value for these inputs", "less extreme ones");
  return value;
}

NamedText split_input(std::string_view text, std::string_view place) {
  const auto equals = text.find('=');
  if (equals == text.npos || trimmed(text.substr(0, equals)).empty())
    throw Error::at(place, printable(text), "name=value");
  return {std::string(trimmed(text.substr(0, equals))), std::string(trimmed(text.substr(equals + 1)))};
}

}  // namespace etak
