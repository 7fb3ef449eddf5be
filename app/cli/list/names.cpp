// SPDX-License-Identifier: Apache-2.0
#include "app/cli/list/names.h"

#include <algorithm>

#include "app/cli/output/output.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/material/names.h"

namespace etak::cli {
namespace {

// What the number behind the name is: "metal, F0", "surface, diffuse colour".
std::string what(const Material& material) {
  const bool body = !gives_f0(material.material_class);
  return material.material_class + (body ? ", diffuse colour" : ", F0");
}

std::string answer_text(const NameAnswer& answer) {
  if (answer.material) return answer.material->id;
  return answer.unmeasured ? "no open measurement known" : "not known";
}

std::string remark_text(const NameAnswer& answer) {
  std::string out = answer.note;
  if (!answer.refusal.empty()) append(out, out.empty() ? "" : "; ", "refused: ", answer.refusal);
  if (!answer.near.empty())
    append(out, out.empty() ? "" : "; ", answer.unmeasured ? "measured and near: " : "near: ", answer.near);
  return out;
}

std::string names_table(std::span<const NameAnswer> answers) {
  std::size_t asked = 4, answered = 6, by = 2, kind = 4;
  for (const NameAnswer& each : answers) {
    asked = std::max(asked, cell_width(each.asked));
    answered = std::max(answered, cell_width(answer_text(each)));
    if (!each.material) continue;
    by = std::max(by, name(each.by).size());
    kind = std::max(kind, cell_width(what(*each.material)));
  }
  const auto line = [&](const std::string& a, const std::string& b, const std::string& c,
                        const std::string& d, const std::string& e) {
    std::string text = padded(a, asked) + "  " + padded(b, answered) + "  " + padded(c, by) + "  " +
                       padded(d, kind) + "  " + line_text(e);
    text.erase(text.find_last_not_of(' ') + 1);
    return text + '\n';
  };
  std::string out = line("name", "answer", "by", "what", "remark");
  for (const NameAnswer& each : answers)
    out += line(each.asked, answer_text(each), each.material ? std::string(name(each.by)) : "",
                each.material ? what(*each.material) : "", remark_text(each));
  return out;
}

// '|' would end a cell, and '<' begin HTML.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : line_text(text)) append(out, c == '|' ? "\\|" : c == '<' ? "&lt;" : std::string(1, c));
  return out;
}

std::string names_markdown(std::span<const NameAnswer> answers) {
  std::string out = "| asked for | answer | what | remark |\n| --- | --- | --- | --- |\n";
  for (const NameAnswer& each : answers) {
    const std::string answer =
        each.material ? "`" + each.material->id + "` " + each.material->name : answer_text(each);
    append(out, "| ", cell(each.asked), " | ", cell(answer), " | ",
           each.material ? cell(what(*each.material)) : "");
    append(out, " | ", cell(remark_text(each)), " |\n");
  }
  return out;
}

std::string names_csv(std::span<const NameAnswer> answers) {
  std::string out = "asked,answer,by,name,class,note,near,refusal\n";
  for (const NameAnswer& each : answers) {
    const Material* const m = each.material ? &*each.material : nullptr;
    append(out, csv_field(each.asked), ",", m ? csv_field(m->id) : "", ",", m ? name(each.by) : "", ",");
    append(out, m ? csv_field(m->name) : "", ",", m ? csv_field(m->material_class) : "", ",");
    append(out, csv_field(each.note), ",");
    append(out, csv_field(each.near), ",", csv_field(each.refusal), "\n");
  }
  return out;
}

std::string json_object_of(const NameAnswer& answer) {
  const Material* const m = answer.material ? &*answer.material : nullptr;
  std::vector<JsonMember> members{{"asked", json(valid_utf8(answer.asked))},
                                  {"answer", m ? json(m->id) : "null"},
                                  {"unmeasured", json(answer.unmeasured)}};
  if (m) {
    members.push_back({"by", json(name(answer.by))});
    members.push_back({"name", json(m->name)});
    members.push_back({"class", json(m->material_class)});
    if (!answer.refusal.empty()) members.push_back({"refusal", json(answer.refusal)});
  }
  if (!answer.note.empty()) members.push_back({"note", json(answer.note)});
  if (!answer.near.empty()) members.push_back({"near", json(answer.near)});
  return json_object(members, -1);
}

std::string names_json(std::span<const NameAnswer> answers) {
  std::string out = "{\n  \"schema\": \"etak-names/1\",\n  \"names\": [";
  for (const NameAnswer& each : answers)
    append(out, &each == answers.data() ? "\n    " : ",\n    ", json_object_of(each));
  return out + "\n  ]\n}\n";
}

}  // namespace

NameAnswer answer_name(const MaterialLibrary& library, const F0Solver& solver, const std::string& name) {
  NameAnswer out;
  out.asked = name;
  if (const auto found = library.look_up(name)) {
    out.material = library.at(found->index);
    out.by = found->kind;
    out.note = alias_note(*out.material, name);
    const Dataset& dataset = out.material->preferred_dataset();
    out.refusal = solver.solve(dataset.optics, dataset.flags).refusal;
    return out;
  }
  if (const Unmeasured* thing = library.unmeasured(name)) {
    out.unmeasured = true;
    out.note = thing->why;
    out.near = joined(thing->nearest);
    return out;
  }
  out.near = joined(library.suggest(name), ", ", &Suggestion::text);
  return out;
}

std::string names_text(std::span<const NameAnswer> answers, const std::string& format) {
  if (format == "csv") return names_csv(answers);
  if (format == "json") return names_json(answers);
  if (format == "markdown") return names_markdown(answers);
  if (format == "table") return names_table(answers);
  std::string out;
  for (const NameAnswer& each : answers) append(out, json_object_of(each), "\n");
  return out;
}

}  // namespace etak::cli
