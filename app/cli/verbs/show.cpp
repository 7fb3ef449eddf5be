// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <memory>

#include "app/cli/inputs/inputs.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/color/srgb.h"
#include "core/material/json.h"
#include "core/material/quality.h"
#include "core/pages/f0/report.h"

namespace etak::cli {
namespace {

struct ShowArguments {
  InputArguments inputs;
  ComputeArguments compute;
  TableArguments tables;
  OutputArguments output;
  Library library;
};

std::string three(const LinearRgb& color) {
  return number(color.r, 4) + " " + number(color.g, 4) + " " + number(color.b, 4);
}

std::string three(const Srgb8& codes) {
  return std::to_string(codes.r) + " " + std::to_string(codes.g) + " " + std::to_string(codes.b);
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
  std::string out = kind + "; " + number(coverage.first_nm, 6) + "-" + number(coverage.last_nm, 6) + " nm";
  if (!coverage.is_formula)
    out += "; " + std::to_string(coverage.samples_400_700) + " samples in 400-700 nm, largest gap " +
           number(coverage.largest_gap_nm, 4) + " nm";
  return out;
}

std::string weight_line(const Coverage& coverage) {
  return number(coverage.weight[0], 6) + " " + number(coverage.weight[1], 6) + " " +
         number(coverage.weight[2], 6);
}

// ", above the forbidden zone"; nothing of a surface.
std::string zone_text(const F0Result& result) {
  if (!result.zone) return {};
  return ", " + std::string(name(*result.zone)) + " the forbidden zone" +
         (result.zone == Zone::inside ? " 0.20-0.45" : "");
}

void append_dataset(std::string& out, const Material& material, std::size_t index, const F0Result& result,
                    bool color) {
  const Dataset& dataset = material.datasets[index];
  const auto line = [&](const char* what, const std::string& text) {
    if (!text.empty()) out += "    " + padded(what, 10) + line_text(text) + '\n';
  };
  out += "\n  " + line_text(dataset.id) + (index == material.preferred ? "  (preferred)" : "") + '\n';
  if (result.refused()) {
    line("refused", result.refusal);
  } else {
    out += "    " + padded("F0", 10) + three(result.linear) + "   8 bit " + three(result.srgb8) + "   " +
           hex(result.srgb8) + (color ? " " + swatch(result.srgb8.r, result.srgb8.g, result.srgb8.b) : "") +
           '\n';
    line("Y", number(result.luminance, 5) + zone_text(result));
    if (result.f82 && result.f82_tint) line("F82", three(*result.f82) + "   tint " + three(*result.f82_tint));
  }
  line("flags", result.refused() ? "" : flags_text(result));
  line("doubtful", doubt(material, dataset));
  line("sample", sample_line(dataset));
  line("data", data_line(dataset, result.coverage));
  line("coverage", weight_line(result.coverage) + " of the X, Y, Z weight");
  line("source", one_line(dataset.citation));
  line("licence", dataset.citation.licence);
  line("via", dataset.citation.via);
  line("note", dataset.note);
}

// `inputs` name the datasets to list; one without: all. -q leaves out the policy, which is no data.
std::string text_form(const MaterialReport& report, const std::vector<Input>& inputs,
                      const F0Options& options, const OutputArguments& output) {
  const bool color = use_color(output);
  const auto listed = [&](const Dataset& dataset) {
    return std::any_of(inputs.begin(), inputs.end(), [&](const Input& input) {
      return input.dataset.empty() || input.dataset == dataset.id;
    });
  };
  const Material& material = report.material;
  std::string out = line_text(material.name + " (" + material.id + "), " + material.material_class) + '\n';
  const auto line = [&](const char* what, const std::string& text) {
    if (!text.empty()) out += "  " + padded(what, 11) + line_text(text) + '\n';
  };
  line("aliases", joined(material.aliases, ", "));
  for (const AliasNote& each : material.alias_notes) line("", each.alias + ": " + each.note);
  line("preferred", material.preferred_dataset().id + ": " + material.preferred_reason);
  if (const Spread range = spread(report); range.count > 1) {
    line("spread", "over " + std::to_string(range.count) + " datasets: linear r " + number(range.least.r, 4) +
                       "-" + number(range.most.r, 4) + ", g " + number(range.least.g, 4) + "-" +
                       number(range.most.g, 4) + ", b " + number(range.least.b, 4) + "-" +
                       number(range.most.b, 4));
    line("", "8 bit: r " + std::to_string(range.least8.r) + "-" + std::to_string(range.most8.r) + ", g " +
                 std::to_string(range.least8.g) + "-" + std::to_string(range.most8.g) + ", b " +
                 std::to_string(range.least8.b) + "-" + std::to_string(range.most8.b));
  } else {
    line("spread", std::to_string(range.count) + (range.count == 1 ? " usable dataset" : " usable datasets"));
  }
  for (std::size_t i = 0; i < report.results.size(); ++i)
    if (listed(material.datasets[i])) append_dataset(out, material, i, report.results[i], color);
  return output.quiet ? out : out + "\nF0: " + line_text(policy(options)) + '\n';
}

// A JSON document made by another function, as a member of a larger one.
std::string nested(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  std::string out;
  for (const char c : text) {
    out += c;
    if (c == '\n') out += "  ";
  }
  return out;
}

std::string json_form(const MaterialReport& report, const F0Options& options) {
  const Material& material = report.material;
  std::vector<F0Row> rows;
  for (std::size_t i = 0; i < report.results.size(); ++i) {
    const Dataset& dataset = material.datasets[i];
    rows.push_back({.path = material.id + "/" + dataset.id,
                    .name = material.name,
                    .material_class = material.material_class,
                    .dataset = dataset.id,
                    .source = one_line(dataset.citation),
                    .result = report.results[i],
                    .kind = std::string(name(dataset.origin)),
                    .doubt = doubt(material, dataset)});
  }
  const Spread range = spread(report);
  const auto linear = [](const LinearRgb& c) {
    return "[" + number(c.r, 17) + ", " + number(c.g, 17) + ", " + number(c.b, 17) + "]";
  };
  const auto codes = [](const Srgb8& c) {
    return "[" + std::to_string(c.r) + ", " + std::to_string(c.g) + ", " + std::to_string(c.b) + "]";
  };
  std::string spread_text = "{\"datasets\": " + std::to_string(range.count);
  if (range.count > 0)
    spread_text += ", \"least\": " + linear(range.least) + ", \"most\": " + linear(range.most) +
                   ", \"least_8bit\": " + codes(range.least8) + ", \"most_8bit\": " + codes(range.most8);
  return "{\n  \"schema\": \"etak-show/1\",\n  \"material\": " + nested(format_material(material)) +
         ",\n  \"spread\": " + spread_text + "},\n  \"f0\": " + nested(f0_json(rows, options)) + "\n}\n";
}

int run(ShowArguments& arguments) {
  if (arguments.inputs.names.size() != 1)
    throw Error::at("etak show", std::to_string(arguments.inputs.names.size()) + " inputs",
                    "one material or file");
  const F0Solver solver(f0_options(arguments.compute, arguments.library));
  const TableOptions tables = table_options(arguments.tables);
  const std::vector<Input> inputs = find_inputs(arguments.inputs, arguments.library, 1);
  for (const std::string& each : alias_remarks(inputs)) remark(arguments.output, each);
  // "gold/*" is one material and several of its datasets.
  const bool one = inputs.size() == 1 ||
                   (!inputs.empty() && std::all_of(inputs.begin(), inputs.end(), [&](const Input& input) {
                     return input.material && input.material == inputs.front().material;
                   }));
  if (!one || inputs.front().from_folder)
    throw Error::at(arguments.inputs.names.front(), "is a folder", "one material or file");
  MaterialReport report{read_material(inputs.front(), tables), {}};
  for (const Dataset& dataset : report.material.datasets)
    report.results.push_back(solve(solver, report.material, dataset));
  write_output(arguments.output, arguments.output.format == "json"
                                     ? json_form(report, solver.options())
                                     : text_form(report, inputs, solver.options(), arguments.output));
  return exit_ok;
}

}  // namespace

void add_show(CommandLine& line) {
  const auto arguments = std::make_shared<ShowArguments>();
  Command verb = line.verb("show", "the whole record of one material; ID/DATASET lists one dataset");
  add_input_options(verb, arguments->inputs);
  add_compute_options(verb, arguments->compute);
  add_table_options(verb, arguments->tables);
  add_library_options(verb, arguments->library);
  add_output_options(verb, arguments->output, {"text", "json"});
  verb.footer("Example:\n  etak show iron");
  verb.runs([arguments] { return run(*arguments); });
}

}  // namespace etak::cli
