// SPDX-License-Identifier: Apache-2.0
#include "core/material/stack_text.h"

#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/base/text/text.h"

namespace etak {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 3> units{{{"nm", 1}, {"um", 1e3}, {"mm", 1e6}}};
constexpr std::string_view thickness_form = "a thickness such as 40nm, 1.5um or 2mm";

// The factor to nanometres of the unit at the end of a text, which is taken off; 0: there is none.
double take_unit(std::string_view& text) {
  for (const auto& [unit, factor] : units)
    if (text.ends_with(unit)) {
      text.remove_suffix(unit.size());
      return factor;
    }
  return 0;
}

// "nan" and "inf", maybe with a unit: no thickness that a layer can have, and no part of a name either.
bool is_no_number(std::string_view text) {
  (void)take_unit(text);
  const std::string word = lower_case(text);
  return word == "nan" || word == "inf" || word == "infinity";
}

// Where the ':' before a thickness is in a part between two '/'; npos: there is none.
//   last   no '/' follows, so that a fraction ends the name of the base
std::size_t thickness_at(std::string_view part, bool last) {
  for (std::size_t colon = part.find(':'); colon != part.npos; colon = part.find(':', colon + 1)) {
    const std::string_view after = part.substr(colon + 1);
    const std::string_view first = after.substr(0, after.find(':'));
    if (first.empty() || (is_fraction(first) && (last || first.size() < after.size()))) continue;
    constexpr std::string_view begins = "0123456789.+-?";
    if (begins.find(after.front()) != begins.npos || is_no_number(first)) return colon;
  }
  return part.npos;
}

std::optional<double> thickness(std::string_view text, const std::string& place) {
  double nm = 0;
  if (read_thickness(text, nm)) return nm;
  std::string_view digits = text;
  if (take_unit(digits) == 0)
    throw Error::at(place, "thickness " + printable(text) + " has no unit", thickness_form);
  if (digits == "?") return std::nullopt;
  const bool is_number = is_no_number(text) || parse_number(digits, nm);
  throw Error::at(place, "thickness " + printable(text),
                  is_number ? "a finite one of at least 0" : thickness_form);
}

// The next thickness behind `from`: where its ':' is, and the end of its part; npos: there is none.
std::pair<std::size_t, std::size_t> next_thickness(std::string_view text, std::size_t from) {
  for (std::size_t to = 0; from <= text.size(); from = to + 1) {
    to = std::min(text.find('/', from), text.size());
    const std::size_t colon = thickness_at(text.substr(from, to - from), to == text.size());
    if (colon != text.npos) return {from + colon, to};
  }
  return {text.npos, text.npos};
}

// `rest` is what a layer has behind its name.
StackText::Layer layer(std::string name, std::string_view rest, const std::string& place) {
  StackText::Layer out;
  if (name.empty()) throw Error::at(place, "has no material", "a name before its thickness");
  out.name = std::move(name);
  out.rest = rest;
  const std::string_view said = rest.substr(1);
  const std::size_t colon = said.find(':');
  out.thickness_nm = thickness(said.substr(0, colon), place);
  out.coherent = !(out.thickness_nm >= incoherent_from_nm);
  if (colon == said.npos) return out;
  const std::string_view word = said.substr(colon + 1);
  if (word != "coherent" && word != "incoherent")
    throw Error::at(place, printable(word), "coherent or incoherent behind the thickness");
  out.coherent = word == "coherent";
  return out;
}

}  // namespace

bool is_fraction(std::string_view text) {
  double value = 0;
  return !text.starts_with('+') && parse_number(text, value) && value >= 0 && value <= 1;
}

bool read_thickness(std::string_view text, double& nm) {
  const double factor = take_unit(text);
  if (factor == 0 || !parse_number(text, nm)) return false;
  nm *= factor;
  return nm >= 0 && std::isfinite(nm);
}

bool is_stack_text(std::string_view text) {
  return next_thickness(text, 0).first != text.npos;
}

std::string format_stack(const StackText& stack) {
  std::string out;
  for (const StackText::Layer& each : stack.layers) append(out, each.name, each.rest, '/');
  return out + stack.base;
}

void set_thickness(StackText::Layer& layer, double nm) {
  layer.thickness_nm = nm;
  layer.rest = ":" + number(nm, 9) + "nm";
  if (layer.coherent != (nm < incoherent_from_nm)) layer.rest += layer.coherent ? ":coherent" : ":incoherent";
}

std::string layer_place(std::string_view place, std::size_t index) {
  return std::string(place) + " layer " + std::to_string(index + 1);
}

StackText parse_stack(std::string_view text, std::string_view place) {
  StackText out;
  std::size_t begin = 0;  // of what belongs to no layer yet
  for (auto [rest, to] = next_thickness(text, 0); rest != text.npos;
       std::tie(rest, to) = next_thickness(text, begin)) {
    if (out.layers.size() == most_layers)
      throw Error::at(place, "more than " + std::to_string(most_layers) + " layers",
                      "at most " + std::to_string(most_layers));
    out.layers.push_back(layer(std::string(text.substr(begin, rest - begin)), text.substr(rest, to - rest),
                               layer_place(place, out.layers.size())));
    begin = to + 1;
  }
  out.base = begin < text.size() ? text.substr(begin) : "";
  if (out.layers.empty()) throw Error::at(place, "a stack without layers", thickness_form);
  if (out.base.empty())
    throw Error::at(place, "a stack without a base", "the material below the last layer, such as /titanium");
  return out;
}

}  // namespace etak
