// SPDX-License-Identifier: Apache-2.0
#include "core/brdf/models.h"
#include "core/base/error.h"
#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/base/text/csv.h"
#include "core/base/text/text_table.h"
#include "core/light/rows.h"
#include "core/pages/lists/lists.h"
#include "core/render/ambient/accuracy.h"

namespace etak {
namespace {

constexpr std::string_view composed_id = "microfacet:D,F,V";
constexpr int exact_digits = 17;

std::string parameter_text(const Parameter& parameter) {
  std::string out(parameter.name);
  append(out, parameter.color ? " (rgb)" : "", " [", number(parameter.min, 6), ", ", number(parameter.max, 6),
         "]");
  if (!parameter.unit.empty()) append(out, ' ', parameter.unit);
  return out;
}

bool is_default(const Model& model) {
  return model.id == default_diffuse || model.id == default_specular;
}

// A row of the table and of the CSV: a model, a term or a kind of light.
struct ModelRow {
  std::string_view id, kind, reciprocal, conserves, note, title, source;
  std::string parameters;
  bool is_default = false;
  // Mean error of the light of an environment at the measured glosses, in the moving and in the refined picture.
  std::string moving = {}, refined = {};
};

std::string ambient_text(const Model& model, bool refined) {
  if (!ambient_accuracy(model.id, 1, refined)) return "";
  return joined(measured_glosses, " ",
                [&](double gloss) { return number(ambient_accuracy(model.id, gloss, refined)->mean, 2); });
}

std::vector<JsonMember> ambient_members(const Model& model, double gloss, bool refined) {
  const AmbientAccuracy off = *ambient_accuracy(model.id, gloss, refined);
  return {{"mean", number(off.mean, 3)}, {"picture", number(off.picture, 3)}, {"p99", number(off.p99, 3)}};
}

// The rows of a registry that have the text in id, kind or title.
template <class Row>
std::vector<Row> with_text(std::span<const Row> rows, const std::string& search) {
  std::vector<Row> out;
  for (const Row& row : rows)
    for (const std::string_view text : {row.id, name(row.kind), row.title})
      if (lower_case(text).find(lower_case(search)) != std::string::npos) {
        out.push_back(row);
        break;
      }
  return out;
}

// Throws Error where no row has the text.
std::vector<ModelRow> model_rows(const std::string& search) {
  std::vector<ModelRow> rows;
  const auto yes_no = [](bool yes) { return yes ? "yes" : "no"; };
  for (const Model& m : with_text(models(), search))
    rows.push_back({m.id, name(m.kind), yes_no(m.claims.reciprocal), yes_no(m.claims.conserves_energy),
                    m.claims.note, m.title, m.source, joined(m.parameters, ", ", parameter_text),
                    is_default(m), ambient_text(m, false), ambient_text(m, true)});
  for (const Term& t : with_text(terms(), search))
    rows.push_back(
        {t.id, name(t.kind), "", "", t.note, t.title, t.source, joined(t.parameters, ", ", parameter_text)});
  for (const LightRow& l : with_text(light_rows(), search))
    rows.push_back(
        {l.id, name(l.kind), "", "", l.note, l.title, l.source, std::string(l.parameters), l.is_default});
  if (rows.empty())
    throw Error::at(printable(search), "in no id, kind or title", "a part of what etak models lists");
  return rows;
}

std::string parameter_object(const Parameter& p) {
  return json_object({{"name", json(p.name)},
                      {"meaning", json(p.meaning)},
                      {"unit", json(p.unit)},
                      {"color", json(p.color)},
                      {"min", number(p.min, exact_digits)},
                      {"max", number(p.max, exact_digits)},
                      {"default", number(p.initial, exact_digits)}},
                     -1);
}

std::string parameter_array(std::span<const Parameter> parameters) {
  return '[' + joined(parameters, ", ", parameter_object) + ']';
}

template <class Row>
std::vector<JsonMember> first_members(const Row& row) {
  return {{"id", json(row.id)},
          {"kind", json(name(row.kind))},
          {"title", json(row.title)},
          {"source", json(row.source)}};
}

std::string with_members(std::vector<JsonMember> members, std::initializer_list<JsonMember> more) {
  members.insert(members.end(), more.begin(), more.end());
  return json_object(members, -1);
}

std::string model_object(const Model& m) {
  std::vector<JsonMember> members = first_members(m);
  members.push_back({"default", json(is_default(m))});
  members.push_back({"reciprocal", json(m.claims.reciprocal)});
  members.push_back({"conserves_energy", json(m.claims.conserves_energy)});
  members.push_back({"claim", json(m.claims.note)});
  members.push_back({"scale", json("1/sr")});
  if (ambient_accuracy(m.id, 1, false))
    members.push_back(
        {"ambient_error", '[' + joined(measured_glosses, ", ", [&](double gloss) {
                            std::vector<JsonMember> off = ambient_members(m, gloss, false);
                            off.insert(off.begin(), {"gloss", number(gloss, 3)});
                            off.push_back({"refined", json_object(ambient_members(m, gloss, true), -1)});
                            return json_object(off, -1);
                          }) + ']'});
  if (m.distribution)
    members.push_back(
        {"terms", json_array_of(std::array{m.distribution->id, m.fresnel->id, m.visibility->id})});
  return with_members(std::move(members), {{"parameters", parameter_array(m.parameters)},
                                           {"files", json_array_of(m.files)},
                                           {"entry", json(m.entry)}});
}

std::string term_object(const Term& t) {
  return with_members(first_members(t), {{"claim", json(t.note)},
                                         {"parameters", parameter_array(t.parameters)},
                                         {"files", json_array_of(t.files)},
                                         {"entry", json(t.entry)}});
}

std::string light_object(const LightRow& l) {
  return with_members(first_members(l), {{"default", json(l.is_default)},
                                         {"claim", json(l.note)},
                                         {"parameters", json(l.parameters)},
                                         {"file", json(l.file)},
                                         {"entry", json(l.entry)}});
}

}  // namespace

std::string models_table(bool legend, const std::string& search) {
  std::vector<TextRow> rows{{{"id", "kind        ", "reciprocal", "conserves", "moving dE2000    ",
                              "refined dE2000   ", "title", "claim"}}};
  for (const ModelRow& row : model_rows(search))
    rows.push_back({{std::string(row.id) + (row.is_default ? "*" : ""), std::string(row.kind),
                     std::string(row.reciprocal), std::string(row.conserves), row.moving, row.refined,
                     std::string(row.title), std::string(row.note)}});
  std::string out = text_table(rows);
  if (legend)
    append(
        out, "\n* default of its kind. D, F, V: terms; any three make a model by the name ", composed_id,
        ",\nsuch as microfacet:ggx,f82-tint,smith-height. All models give f_r in 1/sr.\n"
        "moving, refined dE2000: of the light of an environment in the picture that moves and in that at rest, at gloss 0.2, 0.5, 0.8\nand 1, mean over 15 pictures.\n");
  return out;
}

std::string models_csv(const std::string& search) {
  std::string out =
      "id,kind,reciprocal,conserves_energy,title,source,parameters,claim,ambient_error,refined_error\n";
  for (const ModelRow& row : model_rows(search))
    append_csv_row(out, {row.id, row.kind, row.reciprocal, row.conserves, row.title, row.source,
                         row.parameters, row.note, row.moving, row.refined});
  return out;
}

std::string models_json(const std::string& search) {
  (void)model_rows(search);
  return json_document("etak-models/1",
                       {{"models", json_lines_of(with_text(models(), search), 2, model_object)},
                        {"terms", json_lines_of(with_text(terms(), search), 2, term_object)},
                        {"light", json_lines_of(with_text(light_rows(), search), 2, light_object)}});
}

}  // namespace etak
