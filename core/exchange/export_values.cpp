// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/export_values.h"

#include <algorithm>
#include <array>

#include "core/base/csv.h"
#include "core/base/json_text.h"
#include "core/base/number.h"
#include "core/base/text.h"

namespace etak {
namespace {

std::string json_color(const LinearRgb& c) {
  return json_array_of(vec(c));
}

std::string json_clear(const std::optional<ClearBody>& body) {
  if (!body) return "null";
  return json_object(
      std::array{JsonMember{"color", json_color(body->color)}, JsonMember{"depth_m", json(body->depth_m)}},
      -1);
}

// Objects, one a line, as the value of a member whose brace closes at `indent`.
std::string json_lines(const std::vector<std::string>& items, std::size_t indent) {
  if (items.empty()) return "[]";
  const std::string line = "\n" + std::string(indent + 2, ' ');
  std::string out = "[";
  for (const std::string& item : items) out += (&item == items.data() ? "" : ",") + line + item;
  return out + "\n" + std::string(indent, ' ') + "]";
}

std::string json_target(const EngineValues& values) {
  std::vector<std::string> fields, changes;
  for (const EngineField& f : values.fields)
    fields.push_back("{\"name\": " + json(f.name) + ", \"values\": " + json_array_of(f.values) +
                     ", \"text\": " + json(f.text) + "}");
  for (const Change& c : values.changes)
    changes.push_back("{\"field\": " + json(c.field) + ", \"wanted\": " + json_array_of(c.wanted) +
                      ", \"used\": " + json_array_of(c.used) + ", \"action\": " + json(c.action) +
                      ", \"amount\": " + json(c.amount()) + ", \"reason\": " + json(c.reason) + "}");
  return "{\"id\": " + json(values.target) + ", \"title\": " + json(engine_target(values.target)->title) +
         ",\n         \"fields\": " + json_lines(fields, 9) +
         ",\n         \"changes\": " + json_lines(changes, 9) +
         ",\n         \"notes\": " + json_array_of(values.notes) + ", \"copy\": " + json(copy_text(values)) +
         "}";
}

}  // namespace

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
           ", alpha " + number(s.gloss.alpha(), 4) + ", roughness " + number(s.gloss.roughness(), 4) + '\n';
    for (const std::string& note : s.notes) out += "  note: " + line_text(note) + '\n';
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
    }
  }
  return out;
}

std::string export_text(const std::vector<ExportedValues>& all) {
  std::string out;
  for (const ExportedValues& each : all)
    for (const EngineValues& values : each.targets) {
      out += copy_text(values);
      if (!out.ends_with('\n')) out += '\n';
    }
  return out;
}

std::string export_csv(const std::vector<ExportedValues>& all) {
  std::string out = "id,dataset,target,field,text,value1,value2,value3,changed_from,action,amount\n";
  for (const ExportedValues& each : all)
    for (const EngineValues& values : each.targets) {
      const std::string head =
          csv_field(each.surface.id) + ',' + csv_field(each.dataset) + ',' + std::string(values.target) + ',';
      const auto row = [&](const std::string& field, const std::string& text,
                           const std::vector<double>& numbers) {
        out += head + csv_field(field) + ',' + csv_field(text);
        for (std::size_t i = 0; i < 3; ++i) out += ',' + (i < numbers.size() ? number(numbers[i], 9) : "");
      };
      std::vector<bool> written(values.changes.size(), false);
      const auto end_row = [&](const Change* change) {
        if (change == nullptr) {
          out += ",,,\n";
          return;
        }
        const auto digits_9 = [](double value) { return number(value, 9); };
        out += ',' + joined(change->wanted, " ", digits_9) + ',' + change->action + ',' +
               number(change->amount(), 6) + '\n';
      };
      for (const EngineField& f : values.fields) {
        row(f.name, f.text, f.values);
        const Change* change = nullptr;
        for (std::size_t i = 0; i < values.changes.size() && change == nullptr; ++i)
          if (!written[i] && values.changes[i].field == f.name) {
            change = &values.changes[i];
            written[i] = true;
          }
        end_row(change);
      }
      // What is no field of the target: F0 of one that fixes it, the edge.
      for (std::size_t i = 0; i < values.changes.size(); ++i)
        if (!written[i]) {
          row(values.changes[i].field, "", values.changes[i].used);
          end_row(&values.changes[i]);
        }
    }
  return out;
}

std::string export_json(const std::vector<ExportedValues>& all, Fit fit, const std::string& policy) {
  std::string out = "{\n  \"schema\": \"etak-export/1\",\n  \"fit\": " + json(name(fit)) +
                    ",\n  \"policy\": " + json(policy) + ",\n  \"materials\": [";
  for (const ExportedValues& each : all) {
    const ExportSurface& s = each.surface;
    std::vector<std::string> targets;
    for (const EngineValues& values : each.targets) targets.push_back(json_target(values));
    const std::vector<JsonMember> members{{"id", json(s.id)},
                                          {"name", json(s.name)},
                                          {"dataset", json(each.dataset)},
                                          {"source", json(s.source)},
                                          {"kind", json(name(s.kind))},
                                          {"f0", json_color(s.f0)},
                                          {"f82", s.f82 ? json_color(*s.f82) : "null"},
                                          {"diffuse", json_color(s.diffuse)},
                                          {"total", s.total ? json_color(*s.total) : "null"},
                                          {"clear", json_clear(s.clear)},
                                          {"gloss", s.gloss.held() ? "null" : json(double{s.gloss})},
                                          {"alpha", json(s.gloss.alpha())},
                                          {"roughness", json(s.gloss.roughness())},
                                          {"opacity", json(s.opacity)},
                                          {"notes", json_array_of(s.notes)},
                                          {"targets", json_lines(targets, 6)}};
    out += (&each == all.data() ? "\n    " : ",\n    ") + json_object(members, 4);
  }
  return out + "\n  ]\n}\n";
}

}  // namespace etak
