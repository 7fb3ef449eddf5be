// SPDX-License-Identifier: Apache-2.0
// The record of one material: its names and class, how far its datasets agree, and each dataset with its F0,
// sample and source.
#include <algorithm>
#include <variant>

#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/certainty/publications.h"
#include "core/color/srgb.h"
#include "core/exchange/f0_worker.h"
#include "core/material/appearance.h"
#include "core/material/json.h"
#include "core/material/quality.h"
#include "core/pages/f0/report.h"
#include "core/pages/swatch.h"

namespace etak {
namespace {

std::string three_numbers(const std::array<double, 3>& values, int digits) {
  return joined(values, " ", [digits](double value) { return number(value, digits); });
}

// Appends an indented line "label     text"; nothing for an empty text.
void append_labelled(std::string& out, std::size_t indent, std::size_t width, std::string_view label,
                     std::string_view text) {
  if (!text.empty()) append(out, std::string(indent, ' '), padded(label, width), line_text(text), '\n');
}

std::string sample_line(const Dataset& dataset) {
  std::vector<std::string> parts{std::string(name(dataset.origin))};
  if (!dataset.sample.empty()) parts.push_back(dataset.sample);
  if (!dataset.axis.empty()) parts.push_back(dataset.axis + " axis");
  if (dataset.temperature_kelvin) parts.push_back(number(*dataset.temperature_kelvin, 6) + " K");
  return joined(parts, "; ");
}

std::string data_line(const Dataset& dataset, const Coverage& coverage) {
  std::string kind = "reflectance table";
  if (const auto* constants = std::get_if<OpticalConstants>(&dataset.optics)) {
    if (const auto* formula = std::get_if<DispersionFormula>(&constants->n))
      kind = "n by formula " + std::to_string(formula->number);
    else
      kind = "n table of " + std::to_string(std::get<Spectrum>(constants->n).size()) + " rows";
    kind += constants->k ? ", k table of " + std::to_string(constants->k->size()) + " rows" : ", no k";
  }
  if (const auto* stack = std::get_if<Stack>(&dataset.optics)) kind = "stack " + stack->text;
  std::string out = kind + "; " + number(coverage.first_nm, 6) + "-" + number(coverage.last_nm, 6) + " nm";
  if (!coverage.is_formula)
    out += "; " + std::to_string(coverage.samples_400_700) + " samples in 400-700 nm, largest gap " +
           number(coverage.largest_gap_nm, 4) + " nm";
  return out;
}

// ", above the forbidden zone"; empty for a surface.
std::string zone_text(const F0Result& result) {
  if (!result.zone) return {};
  return ", " + std::string(name(*result.zone)) + " the forbidden zone" +
         (result.zone == Zone::inside ? " 0.20-0.45" : "");
}

void append_dataset(std::string& out, const Material& material, std::size_t index, const F0Result& result,
                    const F0Options& options, bool color) {
  const Dataset& dataset = material.datasets[index];
  const auto line = [&](std::string_view label, const std::string& text) {
    append_labelled(out, 4, 10, label, text);
  };
  append(out, "\n  ", line_text(dataset.id), index == material.preferred ? "  (preferred)" : "", '\n');
  if (result.refused()) {
    line("refused", result.refusal);
  } else {
    const Srgb8& codes = result.srgb8;
    append(out, "    ", padded("F0", 10), three_numbers(vec(result.linear), 4), "   8 bit ",
           three_numbers({double(codes.r), double(codes.g), double(codes.b)}, 3), "   ", hex(codes),
           color ? " " + swatch(codes, 2) : "", '\n');
    line("Y", number(result.luminance, 5) + zone_text(result));
    if (result.f82 && result.f82_tint)
      line("F82", three_numbers(vec(*result.f82), 4) + "   tint " + three_numbers(vec(*result.f82_tint), 4));
    line("flags", flags_text(result));
  }
  if (const auto body = clear_body(material, dataset, options.space)) line("clear", clear_body_text(*body));
  line("doubtful", doubt(material, dataset));
  line("sample", sample_line(dataset));
  line("data", data_line(dataset, result.coverage));
  line("coverage", three_numbers(result.coverage.weight, 6) + " of the X, Y, Z weight");
  line("source", source_line(dataset));
  line("licence", dataset.citation.licence);
  line("via", dataset.citation.via);
  line("note", dataset.note);
}

void append_spread(std::string& out, const Spread& range) {
  const auto line = [&](std::string_view label, const std::string& text) {
    append_labelled(out, 2, 11, label, text);
  };
  if (range.count < 2)
    return line("spread",
                std::to_string(range.count) + (range.count == 1 ? " usable dataset" : " usable datasets"));
  const auto channel = [](const char* letter, double least, double most) {
    return letter + number(least, 4) + "-" + number(most, 4);
  };
  line("spread", "over " + std::to_string(range.count) + " datasets: linear " +
                     channel("r ", range.least.r, range.most.r) + ", " +
                     channel("g ", range.least.g, range.most.g) + ", " +
                     channel("b ", range.least.b, range.most.b));
  line("", "8 bit: " + channel("r ", range.least8.r, range.most8.r) + ", " +
               channel("g ", range.least8.g, range.most8.g) + ", " +
               channel("b ", range.least8.b, range.most8.b));
}

// How far new publications would lie from the F0 of the preferred dataset, and which datasets do not count.
void append_band(std::string& out, const MaterialReport& report) {
  if (report.averaged) return;
  const MaterialBand found = band_of(report);
  const auto line = [&](std::string_view label, const std::string& text) {
    append_labelled(out, 2, 11, label, text);
  };
  line("band", found.band ? words(*found.band) : "none: " + found.reason);
  for (const Publication& each : found.publications)
    if (!each.left_out.empty()) line("", each.dataset->id + " does not count: " + each.left_out);
}

// A JSON document, indented to stand as a member of a larger one.
std::string nested(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  std::string out;
  for (const char c : text) append(out, c, c == '\n' ? "  " : "");
  return out;
}

}  // namespace

std::string record_text(const MaterialReport& report, const F0Solver& solver,
                        std::span<const std::string> datasets, bool color) {
  const Material& material = report.material;
  std::string out = line_text(material.name + " (" + material.id + "), " + material.material_class) + '\n';
  const auto line = [&](std::string_view label, const std::string& text) {
    append_labelled(out, 2, 11, label, text);
  };
  line("aliases", joined(material.aliases, ", "));
  for (const AliasNote& each : material.alias_notes) line("", each.alias + ": " + each.note);
  line("preferred", material.preferred_dataset().id + ": " + material.preferred_reason);
  append_spread(out, spread(report));
  append_band(out, report);
  for (std::size_t i = 0; i < report.results.size(); ++i)
    if (datasets.empty() ||
        std::find(datasets.begin(), datasets.end(), material.datasets[i].id) != datasets.end())
      append_dataset(out, material, i, report.results[i], solver.options(), color);
  return out;
}

std::string record_json(const MaterialReport& report, const F0Solver& solver) {
  const Material& material = report.material;
  std::vector<F0Row> rows;
  for (std::size_t i = 0; i < report.results.size(); ++i) {
    const Dataset& dataset = material.datasets[i];
    rows.push_back({.path = material.id + "/" + dataset.id,
                    .name = material.name,
                    .material_class = material.material_class,
                    .dataset = dataset.id,
                    .source = source_line(dataset),
                    .result = report.results[i],
                    .kind = std::string(name(dataset.origin)),
                    .doubt = doubt(material, dataset),
                    .clear = clear_body(material, dataset, solver.options().space)});
    if (report.averaged)
      rows.back().band_reason = "a mean over the axes of a crystal";
    else
      set_band(rows.back(), solver, material, dataset);
  }
  const auto array = [](double a, double b, double c) {
    return "[" + number(a, 17) + ", " + number(b, 17) + ", " + number(c, 17) + "]";
  };
  const Spread s = spread(report);
  std::vector<JsonMember> range{{"datasets", json(s.count)}};
  if (s.count > 0) {
    range.push_back({"least", array(s.least.r, s.least.g, s.least.b)});
    range.push_back({"most", array(s.most.r, s.most.g, s.most.b)});
    range.push_back({"least_8bit", array(s.least8.r, s.least8.g, s.least8.b)});
    range.push_back({"most_8bit", array(s.most8.r, s.most8.g, s.most8.b)});
  }
  return json_document("etak-show/1", {{"material", nested(format_material(material))},
                                       {"spread", json_object(range, -1)},
                                       {"f0", nested(f0_json(rows, solver.options()))}});
}

}  // namespace etak
