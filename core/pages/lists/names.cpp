// SPDX-License-Identifier: Apache-2.0
#include "core/base/json/json_text.h"
#include "core/base/text/csv.h"
#include "core/base/text/text_table.h"
#include "core/pages/lists/lists.h"

namespace etak {
namespace {

// The class of the material, and what its colour is: "metal, F0", "surface, diffuse colour".
std::string what_is(const Material& material) {
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

// Escapes '|', which would end a cell, and '<', which would begin HTML.
std::string markdown_cell(const std::string& text) {
  std::string out;
  for (const char c : line_text(text)) append(out, c == '|' ? "\\|" : c == '<' ? "&lt;" : std::string(1, c));
  return out;
}

std::string name_object(const NameAnswer& answer) {
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

}  // namespace

std::string names_table(std::span<const NameAnswer> answers) {
  std::vector<TextRow> rows{{{"name", "answer", "by", "what", "remark"}}};
  for (const NameAnswer& each : answers)
    rows.push_back({{each.asked, answer_text(each), each.material ? std::string(name(each.by)) : "",
                     each.material ? what_is(*each.material) : "", remark_text(each)}});
  return text_table(rows);
}

std::string names_markdown(std::span<const NameAnswer> answers) {
  std::string out = "| asked for | answer | what | remark |\n| --- | --- | --- | --- |\n";
  for (const NameAnswer& each : answers) {
    const std::string answer =
        each.material ? "`" + each.material->id + "` " + each.material->name : answer_text(each);
    append(out, "| ", markdown_cell(each.asked), " | ", markdown_cell(answer), " | ",
           each.material ? markdown_cell(what_is(*each.material)) : "");
    append(out, " | ", markdown_cell(remark_text(each)), " |\n");
  }
  return out;
}

std::string names_csv(std::span<const NameAnswer> answers) {
  std::string out = "asked,answer,by,name,class,note,near,refusal\n";
  for (const NameAnswer& each : answers) {
    const Material none;
    const Material& m = each.material ? *each.material : none;
    append_csv_row(out, {each.asked, m.id, each.material ? name(each.by) : "", m.name, m.material_class,
                         each.note, each.near, each.refusal});
  }
  return out;
}

std::string names_json(std::span<const NameAnswer> answers) {
  return json_document("etak-names/1", {{"names", json_lines_of(answers, 2, name_object)}});
}

std::string names_jsonl(std::span<const NameAnswer> answers) {
  std::string out;
  for (const NameAnswer& each : answers) append(out, name_object(each), '\n');
  return out;
}

}  // namespace etak
