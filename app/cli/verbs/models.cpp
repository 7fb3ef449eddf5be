// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/json_text.h"
#include "core/base/number.h"
#include "core/brdf/models.h"
#include "core/light/rows.h"

namespace etak::cli {
namespace {

constexpr std::string_view composed_id = "microfacet:D,F,V";

std::string parameter_text(std::span<const Parameter> parameters) {
  std::string out;
  for (const Parameter& each : parameters) {
    out += (out.empty() ? "" : ", ") + std::string(each.name) + (each.color ? " (rgb)" : "") + " [" +
           number(each.min, 6) + ", " + number(each.max, 6) + "]";
    if (!each.unit.empty()) out += ' ' + std::string(each.unit);
  }
  return out;
}

// A row of the table and of the CSV: models, terms and light rows alike.
struct Row {
  std::string id, kind, reciprocal, conserves, note, title, source, parameters;
};

std::vector<Row> all_rows() {
  std::vector<Row> rows;
  const auto yes_no = [](bool yes) { return std::string(yes ? "yes" : "no"); };
  for (const Model& m : models()) {
    const bool is_default = m.id == default_diffuse || m.id == default_specular;
    rows.push_back({std::string(m.id) + (is_default ? "*" : ""), std::string(name(m.kind)),
                    yes_no(m.claims.reciprocal), yes_no(m.claims.conserves_energy),
                    std::string(m.claims.note), std::string(m.title), std::string(m.source),
                    parameter_text(m.parameters)});
  }
  for (const Term& t : terms())
    rows.push_back({std::string(t.id), std::string(name(t.kind)), "", "", std::string(t.note),
                    std::string(t.title), std::string(t.source), parameter_text(t.parameters)});
  for (const LightRow& l : light_rows())
    rows.push_back({std::string(l.id) + (l.is_default ? "*" : ""), std::string(name(l.kind)), "", "",
                    std::string(l.note), std::string(l.title), std::string(l.source),
                    std::string(l.parameters)});
  return rows;
}

// -q leaves out the legend, which is no data.
std::string table(bool quiet) {
  const std::vector<Row> rows = all_rows();
  std::size_t id = 2, title = 5;
  for (const Row& row : rows) {
    id = std::max(id, row.id.size());
    title = std::max(title, row.title.size());
  }
  std::string out = padded("id", id) + "  " + padded("kind", 12) + "  reciprocal  conserves  " +
                    padded("title", title) + "  claim\n";
  for (const Row& row : rows) {
    std::string line = padded(row.id, id) + "  " + padded(row.kind, 12) + "  " + padded(row.reciprocal, 10) +
                       "  " + padded(row.conserves, 9) + "  " + padded(row.title, title) + "  " + row.note;
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + '\n';
  }
  if (quiet) return out;
  return out + "\n* default of its kind. D, F, V: terms; any three make a model by the name " +
         std::string(composed_id) +
         ",\nsuch as microfacet:ggx,f82-tint,smith-height. All models give f_r in 1/sr.\n";
}

std::string csv() {
  std::string out = "id,kind,reciprocal,conserves_energy,title,source,parameters,claim\n";
  for (Row& row : all_rows()) {
    if (row.id.ends_with('*')) row.id.pop_back();
    const std::string* fields[] = {&row.id,    &row.kind,   &row.reciprocal, &row.conserves,
                                   &row.title, &row.source, &row.parameters, &row.note};
    for (const std::string* each : fields) out += csv_field(*each) + (each == &row.note ? '\n' : ',');
  }
  return out;
}

std::string json_parameters(std::span<const Parameter> parameters) {
  std::string out;
  for (const Parameter& each : parameters)
    out += (out.empty() ? "" : ", ") + ("{\"name\": " + json(each.name)) +
           ", \"meaning\": " + json(each.meaning) + ", \"unit\": " + json(each.unit) +
           ", \"color\": " + (each.color ? "true" : "false") + ", \"min\": " + number(each.min, 17) +
           ", \"max\": " + number(each.max, 17) + ", \"default\": " + number(each.initial, 17) + "}";
  return '[' + out + ']';
}

std::string json_head(std::string_view id, std::string_view title, std::string_view source,
                      std::string_view kind) {
  return "{\"id\": " + json(id) + ", \"kind\": " + json(kind) + ", \"title\": " + json(title) +
         ", \"source\": " + json(source);
}

std::string json_form() {
  std::string out = "{\n  \"schema\": \"etak-models/1\",\n  \"models\": [";
  const char* before = "\n    ";
  for (const Model& m : models()) {
    out += before + json_head(m.id, m.title, m.source, name(m.kind)) +
           ", \"default\": " + (m.id == default_diffuse || m.id == default_specular ? "true" : "false") +
           ", \"reciprocal\": " + (m.claims.reciprocal ? "true" : "false") +
           ", \"conserves_energy\": " + (m.claims.conserves_energy ? "true" : "false") +
           ", \"claim\": " + json(m.claims.note) + ", \"scale\": \"1/sr\"";
    if (m.distribution)
      out += ", \"terms\": [" + json(m.distribution->id) + ", " + json(m.fresnel->id) + ", " +
             json(m.visibility->id) + "]";
    out += ", \"parameters\": " + json_parameters(m.parameters) + ", \"files\": " + json_array_of(m.files) +
           ", \"entry\": " + json(m.entry) + "}";
    before = ",\n    ";
  }
  out += "\n  ],\n  \"terms\": [";
  before = "\n    ";
  for (const Term& t : terms()) {
    out += before + json_head(t.id, t.title, t.source, name(t.kind)) + ", \"claim\": " + json(t.note) +
           ", \"parameters\": " + json_parameters(t.parameters) + ", \"files\": " + json_array_of(t.files) +
           ", \"entry\": " + json(t.entry) + "}";
    before = ",\n    ";
  }
  out += "\n  ],\n  \"light\": [";
  before = "\n    ";
  for (const LightRow& l : light_rows()) {
    out += before + json_head(l.id, l.title, l.source, name(l.kind)) +
           ", \"default\": " + (l.is_default ? "true" : "false") + ", \"claim\": " + json(l.note) +
           ", \"parameters\": " + json(l.parameters) + ", \"file\": " + json(l.file) +
           ", \"entry\": " + json(l.entry) + "}";
    before = ",\n    ";
  }
  return out + "\n  ]\n}\n";
}

}  // namespace

void add_models(CommandLine& line) {
  const auto output = std::make_shared<OutputArguments>();
  Command verb =
      line.verb("models", "shading models, their terms and the kinds of light, with what they claim");
  add_output_options(verb, *output, {"table", "json", "csv"});
  verb.footer("Example:\n  etak models --format csv");
  verb.runs([output] {
    write_output(*output, output->format == "json"  ? json_form()
                          : output->format == "csv" ? csv()
                                                    : table(output->quiet));
    return exit_ok;
  });
}

}  // namespace etak::cli
