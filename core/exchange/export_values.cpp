// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/export_values.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/setting.h"
#include "core/base/text/csv.h"
#include "core/base/text/edit_distance.h"
#include "core/base/text/text.h"
#include "core/exchange/material_x.h"

namespace etak {
namespace {

std::string json_color(const LinearRgb& c) {
  return json_array_of(vec(c));
}

std::string json_field(const EngineField& field) {
  return json_object(
      {{"name", json(field.name)}, {"values", json_array_of(field.values)}, {"text", json(field.text)}}, -1);
}

std::string json_change(const Change& change) {
  return json_object({{"field", json(change.field)},
                      {"wanted", json_array_of(change.wanted)},
                      {"used", json_array_of(change.used)},
                      {"action", json(change.action)},
                      {"amount", json(change.amount())},
                      {"reason", json(change.reason)}},
                     -1);
}

std::string json_film_side(const EngineFilm::Side& side) {
  return json_object({{"fields", json_lines_of(side.fields, 13, json_field)},
                      {"mean", json(side.error.mean)},
                      {"max", json(side.error.largest)},
                      {"normal", json(side.error.normal)}},
                     11);
}

std::string json_film(const EngineFilm& film) {
  return json_object({{"honest", film.honest ? json_film_side(*film.honest) : "null"},
                      {"fitted", json_film_side(film.fitted)},
                      {"use", json(film.use_honest ? "honest" : "fitted")},
                      {"why", json(film.advice)}},
                     9);
}

std::string json_error(const std::optional<FilmError>& error) {
  if (!error) return "null";
  return json_object(
      {{"mean", json(error->mean)}, {"max", json(error->largest)}, {"normal", json(error->normal)}}, -1);
}

std::string json_target(const EngineValues& values) {
  const EngineTarget& target = *engine_target(values.target);
  std::vector<JsonMember> error{{"error", json_error(values.error)}};
  if (!values.error) error.push_back({"error_reason", json(values.error_reason)});
  std::vector<JsonMember> last{{"notes", json_array_of(values.notes)}, {"copy", json(copy_text(values))}};
  if (values.film) last.insert(last.begin(), {"film", json_film(*values.film)});
  return json_rows({{{"id", json(values.target)},
                     {"title", json(target.title)},
                     {"version", json(target.version)},
                     {"formula", target.formula.empty() ? "null" : json(target.formula)}},
                    error,
                    {{"fields", json_lines_of(values.fields, 9, json_field)}},
                    {{"changes", json_lines_of(values.changes, 9, json_change)}},
                    last},
                   9);
}

std::string json_material(const ExportedValues& each) {
  const ExportSurface& s = each.surface;
  std::vector<JsonMember> out{{"id", json(s.id)},
                              {"name", json(s.name)},
                              {"dataset", json(each.dataset)},
                              {"source", json(s.source)},
                              {"band", s.band.empty() ? "null" : json(s.band)},
                              {"kind", json(name(s.kind))},
                              {"f0", json_color(s.f0)},
                              {"f82", s.f82 ? json_color(*s.f82) : "null"},
                              {"diffuse", json_color(s.diffuse)},
                              {"total", s.total ? json_color(*s.total) : "null"},
                              {"clear", json_clear(s.clear, json_color)},
                              {"gloss", s.gloss.held() ? "null" : json(double{s.gloss})},
                              {"alpha", json(s.gloss.alpha())},
                              {"roughness", json(s.gloss.roughness())},
                              {"opacity", json(s.opacity)},
                              {"notes", json_array_of(s.notes)},
                              {"targets", json_lines_of(each.targets, 6, json_target)}};
  if (s.emission != LinearRgb{}) out.insert(out.end() - 2, {"emission", json_color(s.emission)});
  if (s.coat) {
    std::vector<JsonMember> coat = coat_members(*s.coat, json_color);
    coat.insert(coat.begin(), {"label", json(s.coat->label)});
    out.insert(out.end() - 2, {"coat", json_object(coat, -1)});
  }
  return json_object(out, 4);
}

}  // namespace

std::string json_clear(const std::optional<ClearBody>& body, std::string (*color)(const LinearRgb&)) {
  if (!body) return "null";
  return json_object({{"n_d", json(body->n_d.value_or(NAN))},
                      {"v_d", json(body->v_d.value_or(NAN))},
                      {"color", color(body->color)},
                      {"depth_m", json(body->depth_m)}},
                     -1);
}

std::vector<JsonMember> coat_members(const CoatedF0& coat, std::string (*color)(const LinearRgb&)) {
  return {{"n", json(coat.n)},
          {"f0_under", color(coat.under.linear)},
          {"f82_under", color(coat.under.f82.value())},
          {"f0", color(coat.whole.linear)},
          {"f82", color(coat.whole.f82.value())}};
}

std::vector<const EngineTarget*> engine_targets_named(const std::vector<std::string>& ids) {
  std::vector<const EngineTarget*> out;
  std::vector<std::string> known;
  for (const EngineTarget& each : engine_targets()) {
    known.emplace_back(each.id);
    if (ids.empty()) out.push_back(&each);
  }
  for (const std::string& id : ids) {
    out.push_back(engine_target(id));
    if (out.back() == nullptr)
      throw Error::at(setting("target"), printable(id), joined(known) + did_you_mean(id, known));
  }
  return out;
}

void require_export_space(std::string_view to, const F0Options& options) {
  const bool mtlx = to == "mtlx";
  const RgbSpace space = options.space;
  if (!options.custom_space &&
      (space == RgbSpace::srgb || (mtlx && (space == RgbSpace::acescg || space == RgbSpace::display_p3))))
    return;
  throw Error::at(setting("space"), space_name(options) + " with " + setting("to") + " " + std::string(to),
                  mtlx ? "srgb, acescg or display-p3" : "srgb, which its values are in");
}

std::vector<ExportedValues> exported_values(std::vector<ExportSurface> surfaces,
                                            const std::vector<std::string>& datasets,
                                            const std::vector<const EngineTarget*>& targets, Fit fit,
                                            unsigned threads) {
  std::vector<ExportedValues> out(surfaces.size());
  std::set<std::string> taken;  // names in documents
  for (ExportSurface& surface : surfaces) {
    const std::string first = identifier(surface.id);
    surface.node = first;
    // The shader of a material takes a name too, which may be that of another material.
    for (int i = 2; taken.contains(surface.node) || taken.contains(surface.node + "_surface"); ++i)
      surface.node = first + '_' + std::to_string(i);
    taken.insert({surface.node, surface.node + "_surface"});
  }
  parallel_chunks(out.size(), threads, 8, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      out[i] = {std::move(surfaces[i]), datasets[i], {}};
      for (const EngineTarget* target : targets)
        out[i].targets.push_back(engine_values(*target, out[i].surface, fit));
    }
  });
  return out;
}

std::string error_line(const EngineValues& values) {
  const EngineTarget& target = *engine_target(values.target);
  if (!values.error)
    return target.formula.empty() && !target.is_document() ? "" : "error not stated: " + values.error_reason;
  const FilmError& e = *values.error;
  return "error: dE2000 " + number(e.mean, 2) + " on the mean over angles, " + number(e.largest, 2) +
         " at most, " + number(e.normal, 2) + " at normal incidence";
}

std::string export_table(const std::vector<ExportedValues>& all) {
  std::size_t target_width = 6, field_width = 5;
  for (const ExportedValues& each : all)
    for (const EngineValues& values : each.targets) {
      target_width = std::max(target_width, values.target.size());
      for (const EngineField& f : values.fields) field_width = std::max(field_width, f.name.size());
    }
  std::string out;
  for (const ExportedValues& each : all) {
    const ExportSurface& s = each.surface;
    out += (out.empty() ? "" : "\n") + line_text(s.name + " (" + s.id + "/" + each.dataset + "), ") +
           std::string(name(s.kind)) + (s.gloss.held() ? "" : ", gloss " + number(double{s.gloss}, 6)) +
           ", alpha " + number(s.gloss.alpha(), 4) + ", roughness " + number(s.gloss.roughness(), 4) +
           (s.coat ? ", coat " + line_text(s.coat->label) : "") + '\n';
    if (!s.band.empty()) out += "  band: " + s.band + '\n';
    for (const std::string& note : s.notes) out += "  note: " + line_text(note) + '\n';
    if (!s.seen && !s.film) out += "  error not stated: " + line_text(s.unseen) + '\n';
    for (const EngineValues& values : each.targets) {
      bool first = true;
      for (const EngineField& f : values.fields) {
        out += "  " + padded(first ? values.target : "", target_width) + "  " + padded(f.name, field_width) +
               "  " + f.text + '\n';
        first = false;
      }
      const std::string indent = "  " + std::string(target_width, ' ') + "  ";
      for (const Change& change : values.changes) out += indent + "changed: " + one_line(change) + '\n';
      for (const std::string& note : values.notes) out += indent + "note: " + line_text(note) + '\n';
      if (std::string line = error_line(values);
          !line.empty() && (values.error || values.error_reason != s.unseen))
        out += indent + line + '\n';
    }
  }
  return out;
}

// A document stands alone with all its materials. Else a heading tells what follows, where more than one thing does.
std::string export_text(const std::vector<ExportedValues>& all) {
  std::string out;
  if (all.empty()) return out;
  const EngineTarget& first = *engine_target(all.front().targets.front().target);
  if (first.is_document() && all.front().targets.size() == 1) {
    out = first.opens;
    for (const ExportedValues& each : all) out += body_text(each.targets.front());
    return out + std::string(first.closes);
  }
  const bool many = all.size() > 1 || all.front().targets.size() > 1;
  for (const ExportedValues& each : all)
    for (const EngineValues& values : each.targets) {
      const EngineTarget& target = *engine_target(values.target);
      const std::size_t outside =
          std::min(each.surface.source.find(source_outside), each.surface.source.size());
      if (many || outside < each.surface.source.size())
        out += (out.empty() ? "" : "\n") + std::string(target.comment) +
               line_text(each.surface.name + ", " + std::string(target.title) +
                         each.surface.source.substr(outside)) +
               '\n';
      out += copy_text(values);
      if (!out.ends_with('\n')) out += '\n';
    }
  return out;
}

std::string export_csv(const std::vector<ExportedValues>& all) {
  std::string out = "id,dataset,target,field,text,value1,value2,value3,changed_from,action,amount\n";
  for (const ExportedValues& each : all)
    for (const EngineValues& values : each.targets) {
      const auto digits_9 = [](double value) { return number(value, 9); };
      const auto add = [&](const std::string& field, const std::string& text,
                           const std::vector<double>& numbers, const Change* change) {
        const auto value = [&](std::size_t i) { return i < numbers.size() ? digits_9(numbers[i]) : ""; };
        append_csv_row(out, {each.surface.id, each.dataset, values.target, field, text, value(0), value(1),
                             value(2), change ? joined(change->wanted, " ", digits_9) : "",
                             change ? change->action : "", change ? number(change->amount(), 6) : ""});
      };
      std::vector<const Change*> left;
      for (const Change& change : values.changes) left.push_back(&change);
      for (const EngineField& f : values.fields) {
        const auto found =
            std::find_if(left.begin(), left.end(), [&](const Change* c) { return c->field == f.name; });
        add(f.name, f.text, f.values, found == left.end() ? nullptr : *found);
        if (found != left.end()) left.erase(found);
      }
      if (values.error)
        add("dE2000: mean, largest, at normal incidence", "",
            {values.error->mean, values.error->largest, values.error->normal}, nullptr);
      // Changes of values that are no fields of the target, such as an F0 that the target fixes.
      for (const Change* change : left) add(change->field, "", change->used, change);
    }
  return out;
}

std::string export_json(const std::vector<ExportedValues>& all, Fit fit, const std::string& policy) {
  return json_document("etak-export/1", {{"fit", json(name(fit))},
                                         {"policy", json(policy)},
                                         {"materials", json_lines_of(all, 2, json_material)}});
}

}  // namespace etak
