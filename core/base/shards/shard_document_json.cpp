// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.h"
#include "core/base/hash/content_hash.h"
#include "core/base/json/json_text.h"
#include "core/base/json/node_json.h"
#include "core/base/setting.h"
#include "core/base/shards/shard_document.h"

namespace etak {
namespace {

// A line's end never stands inside of a text of JSON, so that a member of the document itself can be found by
// the blanks that its line begins with.
std::string begin_of(std::string_view key) {
  return "\n  \"" + std::string(key) + "\": ";
}

std::string member_json(const ShardMember& member) {
  using Ordered = nlohmann::ordered_json;
  Ordered out = {{"index", member.says.shard.index}, {"count", member.says.shard.count},
                 {"version", member.says.version},   {"list", member.says.list},
                 {"options", member.says.options},   {"counts", Ordered::object()},
                 {"forms", Ordered::object()}};
  out["items"] = member.says.items;
  out["first"] = member.says.shard.items ? member.says.shard.items->first : 0;
  out["last"] = member.says.shard.items ? member.says.shard.items->second : member.says.items;
  for (const auto& [key, count] : member.counts) out["counts"][key] = count;
  for (const auto& [key, form] : member.forms) out["forms"][key] = {{"head", form.head}, {"rows", form.rows}};
  try {
    return quiet_json(out.dump());
  } catch (const Ordered::exception&) {
    throw Error::at(setting("shard"), "a name that is no UTF-8, which the JSON of a shard cannot hold",
                    "another name, or a run that is not cut");
  }
}

std::size_t whole_number(const JsonNode& node) {
  if (!node.value.is_number_unsigned()) node.fail_type("a whole number");
  return node.value.get<std::size_t>();
}

ShardMember read_member(const JsonNode& node) {
  node.expect_object(
      {"index", "count", "version", "list", "options", "items", "first", "last", "counts", "forms"});
  ShardMember out;
  out.says.shard = {whole_number(node.at("index")), whole_number(node.at("count"))};
  out.says.shard.items.emplace(whole_number(node.at("first")), whole_number(node.at("last")));
  out.says.items = whole_number(node.at("items"));
  if (!shard_named(out.says.shard.text())) node.at("index").fail_type("from 1 to count");
  out.says.version = node.at("version").text();
  out.says.list = node.at("list").text();
  out.says.options = node.at("options").text();
  const JsonNode counts = node.at("counts"), forms = node.at("forms");
  counts.expect_object();
  for (const auto& [key, value] : counts.value.items()) out.counts[key] = whole_number(counts.at(key));
  forms.expect_object();
  for (const auto& [key, value] : forms.value.items()) {
    const JsonNode form = forms.at(key);
    out.forms[key] = {form.at("head").text(), form.at("rows").text()};
  }
  return out;
}

}  // namespace

std::string shard_document(std::string_view text, std::string_view list, const ShardMember& member) {
  const std::size_t at = text.find(begin_of(list));
  std::string out(text.substr(0, at));
  return out.append(begin_of("shard")).append(member_json(member)).append(",").append(text.substr(at));
}

ShardDocument read_shard_document(std::string_view text, std::string_view list, const std::string& file) {
  constexpr int most_depth = 100;
  constexpr std::string_view closing = "\n  ]\n}\n", empty = "[]\n}\n";
  const auto refuse = [&](const char* found) {
    throw Error::at(file, found, "what a shard wrote as JSON, whole and unchanged");
  };
  const std::string of_shard = begin_of("shard"), of_list = begin_of(list);
  const std::size_t shard_at = text.find(of_shard);
  if (shard_at == text.npos) refuse("is not the output of a shard, or is cut off");
  const std::size_t begin = shard_at + of_shard.size(), end = text.find('\n', begin);
  if (end == text.npos || text.substr(end - 1, of_list.size() + 1) != "," + of_list) refuse("is cut off");
  const std::string_view items = text.substr(end + of_list.size());
  ShardDocument out;
  if (items.starts_with("[") && items.ends_with(closing))
    out.items = items.substr(1, items.size() - 1 - closing.size());
  else if (items != empty)
    refuse("is cut off");
  const JsonDocument member =
      parse_json_strictly(text.substr(begin, end - 1 - begin), file, most_depth, "the member of a shard");
  out.head = text.substr(0, shard_at);
  out.member = read_member({member, file, "/shard"});
  out.member.says.file = file;
  ContentHash hash;
  hash.add(text);
  out.member.says.content = hash.hex();
  return out;
}

std::string joined_document(const std::vector<ShardDocument>& shards, std::string_view list) {
  std::string out = shards.front().head + begin_of(list) + '[';
  bool any = false;
  for (const ShardDocument& each : shards) {
    if (each.items.empty()) continue;
    append(out, any ? "," : "", each.items);
    any = true;
  }
  return out + (any ? "\n  ]\n}\n" : "]\n}\n");
}

std::string joined_form(const std::vector<ShardDocument>& shards, const std::string& form) {
  std::string out = shards.front().member.forms.at(form).head;
  for (const ShardDocument& each : shards) out += each.member.forms.at(form).rows;
  return out;
}

}  // namespace etak
