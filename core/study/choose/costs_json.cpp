// SPDX-License-Identifier: Apache-2.0
// The cost table's file: resources/costs.json.
#include "core/base/json/json_text.h"
#include "core/base/json/node_json.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/study/choose/choose.h"
#include "core/study/choose/costs_file.h"

namespace etak {
namespace {

constexpr std::string_view costs_schema = "etak-costs/1";
constexpr int cost_digits = 3;

}  // namespace

CostTable parse_costs(std::string_view text, std::string_view file) {
  const JsonDocument document = parse_json_strictly(text, file, 4, "a cost table");
  const JsonNode root{document, file, ""};
  root.expect_object({"schema", "header", "ns"});
  if (root.at("schema").text() != costs_schema)
    root.at("schema").fail_type('"' + std::string(costs_schema) + '"');
  CostTable out;
  out.header = root.at("header").text();
  const JsonNode ns = root.at("ns");
  ns.expect_object();
  for (const auto& [key, value] : ns.value.items()) {
    const double cost = ns.at(key).number();
    if (!(cost > 0)) ns.at(key).fail_type("a time above 0");
    out.ns[key] = cost;
  }
  return out;
}

const CostTable& shipped_costs() {
  static const CostTable table = parse_costs(costs_file, "<built-in cost table>");
  return table;
}

std::string format_costs(const CostTable& costs) {
  std::vector<JsonMember> rows;
  for (const auto& [id, ns] : costs.ns) rows.push_back({id, number(ns, cost_digits)});
  return json_document(costs_schema, {{"header", json(costs.header)}, {"ns", json_object(rows, 2)}});
}

}  // namespace etak
