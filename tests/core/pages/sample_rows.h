// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/color/srgb.h"
#include "core/pages/f0/report.h"

/// Rows and reports written down by hand, so that the tests of the report know every number in it.
namespace etak::test {

inline F0Result result_of(LinearRgb linear) {
  F0Result r;
  r.linear = r.srgb_linear = linear;
  r.srgb8 = srgb_u8(linear);
  r.xyz = {0.2, 0.25, 0.3};
  r.luminance = 0.2126 * linear.r + 0.7152 * linear.g + 0.0722 * linear.b;
  r.zone = zone_of(r.luminance);
  r.coverage = {{1, 0.9975, 0.9962}, 300, 900, 31, 10, false};
  return r;
}

/// A diffuse colour: no verdict.
inline F0Result surface_result(LinearRgb linear) {
  F0Result r = result_of(linear);
  r.zone.reset();
  return r;
}

inline F0Result refused_result(std::string reason) {
  F0Result r;
  r.coverage = {{0.4, 0.3, 0.9}, 300, 560, 16, 140, false};
  r.flags.set(Flag::extrapolated);
  r.refusal = std::move(reason);
  return r;
}

/// Red above 1 by 0.0428, green inside the forbidden zone, F82 present.
inline F0Result gold_result() {
  F0Result r = result_of({1.0428, 0.4, 0.3});
  r.gamut_excess = {0.0428, 0, 0};
  r.flags.set(Flag::out_of_gamut);
  r.flags.set(Flag::channel_in_zone);
  r.channel_in_zone = {false, true, true};
  r.f82 = LinearRgb{0.99, 0.9, 0.7};
  r.f82_tint = LinearRgb{1, 0.95, 0.8};
  return r;
}

inline std::vector<F0Row> sample_rows() {
  return {{"gold", "Gold", "metal", "somebody-1972", "S. Somebody, Optics of \"gold\", J. 1, 2 (1972)",
           gold_result()},
          {"böhmit/β", "Böhmit β", "mineral", "x", "", result_of({0.07, 0.07, 0.07})},
          {"a,b \"c\".yml", "", "", "", "", refused_result("data cover 0.3 of the Y weight, 0.95 needed")}};
}

inline Dataset dataset(std::string id, Optics optics) {
  Dataset d;
  d.id = std::move(id);
  d.optics = std::move(optics);
  d.sample = "evaporated <film>";
  d.temperature_kelvin = 293.15;
  d.citation = {{"A. Author", "B. & Co"},
                "Title of " + d.id,
                "J. Opt. 1, 2-3",
                1972,
                "10.1000/x",
                "",
                "CC0-1.0",
                "a collection"};
  return d;
}

/// A metal of three datasets (table, formula, single row; the last one refused), and a surface.
inline std::vector<MaterialReport> sample_reports() {
  Material metal;
  metal.id = "testium";
  metal.name = "Testium & \"friends\" <β>";
  metal.aliases = {"Tt"};
  metal.material_class = "metal";
  metal.preferred_reason = "the widest range";
  const Spectrum n{{300, 450, 500, 900}, {1.6, 1.5, 0.8, 0.2}}, k{{300, 900}, {1.9, 5}};
  metal.datasets = {
      dataset("table-1972", OpticalConstants{n, k}),
      dataset("formula-1980", OpticalConstants{DispersionFormula{1, {0, 1.2, 0.1}, 200, 2000}, std::nullopt}),
      dataset("row-1990", OpticalConstants{Spectrum{{550}, {1.4}}, std::nullopt})};
  metal.preferred = 0;
  Material surface;
  surface.id = "paper";
  surface.name = "Paper";
  surface.material_class = "surface";
  surface.datasets = {dataset("sheet", Reflectance{{{400, 550, 700}, {0.6, 0.8, 0.85}}})};
  Material lost;
  lost.id = "lost";
  lost.name = "Lost";
  lost.material_class = "gas";
  lost.datasets = {dataset("infrared", OpticalConstants{Spectrum{{2000, 3000}, {1.4, 1.5}}, std::nullopt})};
  return {{metal, {gold_result(), result_of({0.9, 0.5, 0.2}), refused_result("one row")}},
          {surface, {surface_result({0.8, 0.79, 0.7})}},
          {lost, {refused_result("no <visible> data")}}};
}

}  // namespace etak::test
