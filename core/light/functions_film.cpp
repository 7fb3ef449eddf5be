// SPDX-License-Identifier: Apache-2.0
// Functions of `etak eval`: layers on a base (core/film).
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/error.h"
#include "core/film/stack.h"
#include "core/light/function_rows.h"

namespace etak::function_rows {
namespace {

using In = const double*;

constexpr std::size_t most_layers = 8, before = 1, of_layer = 3;
constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

constexpr std::string_view names[most_layers][of_layer] = {
    {"n1", "k1", "d1"}, {"n2", "k2", "d2"}, {"n3", "k3", "d3"}, {"n4", "k4", "d4"},
    {"n5", "k5", "d5"}, {"n6", "k6", "d6"}, {"n7", "k7", "d7"}, {"n8", "k8", "d8"}};

// The outside medium, the layers from there on, the base, and the light.
constexpr auto inputs = [] {
  std::array<FunctionInput, before + of_layer * most_layers + 4> out{};
  FunctionInput* next = out.data();
  *next++ = {"n0", "index of the outside medium", "", 0, 1e4, true, {}, 1.0};
  for (const auto& [n_name, k_name, d_name] : names) {
    *next++ = {n_name, "index of a layer, 1 the outermost", "", 0, 1e4, false, {}, not_given};
    *next++ = {k_name, "extinction of that layer; 0 where not given", "", 0, 1e6, false, {}, not_given};
    *next++ = {d_name, "thickness of that layer", "nm", 0, 1e12, false, {}, not_given};
  }
  *next++ = {"n", "index of the base", "", 0, 1e4};
  *next++ = {"k", "extinction of the base", "", 0, 1e6};
  *next++ = {"wavelength", "in vacuum", "nm", 0, 1e12, true};
  *next++ = {"cos", "cosine of incidence in the outside medium", "", 0, 1};
  return out;
}();

// The light that the film of these inputs reflects and lets pass. Throws Error for layers that are not whole.
FilmLight light_of(In x) {
  Film film{x[0], {}, {}};
  for (std::size_t j = 0; j < most_layers; ++j) {
    const double* layer = x + before + of_layer * j;
    const std::string number = std::to_string(j + 1);
    if (std::isnan(layer[0])) {
      if (!std::isnan(layer[1]) || !std::isnan(layer[2]))
        throw Error::at("n" + number, "missing beside k" + number + " or d" + number, "the layer's index");
      continue;
    }
    if (std::isnan(layer[2]))
      throw Error::at("d" + number, "missing beside n" + number, "the layer's thickness in nm");
    if (film.layers.size() != j)
      throw Error::at("n" + number, "a layer behind a gap",
                      "layers numbered from 1, the outermost, without gaps");
    film.layers.push_back({{layer[0], std::isnan(layer[1]) ? 0 : layer[1]}, layer[2], true});
  }
  const double* rest = x + before + of_layer * most_layers;
  film.base = {rest[0], rest[1]};
  validate(film, "stack");
  return film_light(film, rest[2], rest[3]);
}

constexpr std::string_view source = "Born and Wolf, section 1.6; Heavens 1955";

constexpr Function rows[] = {
    {"stack_reflectance", "reflectance of layers on a base, unpolarised", source, inputs, false,
     [](In x) { return light_of(x).reflected.mean(); }},
    {"stack_reflectance_s", "reflectance of light polarised across the plane of incidence", source, inputs,
     false, [](In x) { return light_of(x).reflected.s; }},
    {"stack_reflectance_p", "reflectance of light polarised along the plane of incidence", source, inputs,
     false, [](In x) { return light_of(x).reflected.p; }},
    {"stack_transmittance", "share of unpolarised light that passes into the base, which must not absorb",
     source, inputs, false,
     [](In x) {
       const double extinction = x[before + of_layer * most_layers + 1];
       if (extinction > 0)
         throw Error::at("k", "a base that absorbs", "0: what passes into such a base is lost in it");
       return light_of(x).passed.mean();
     }},
};

}  // namespace

std::span<const Function> films() {
  return rows;
}

}  // namespace etak::function_rows
