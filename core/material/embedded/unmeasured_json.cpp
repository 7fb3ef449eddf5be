// SPDX-License-Identifier: Apache-2.0
#include <set>

#include "core/base/json/node_json.h"
#include "core/material/embedded/unmeasured.h"
#include "core/material/names.h"

namespace etak {

std::vector<Unmeasured> parse_unmeasured(std::string_view text, std::string_view file) {
  constexpr int most_depth = 8;
  const JsonDocument document =
      parse_json_strictly(text, file, most_depth, "a list of things without a measurement");
  const JsonNode node{document, file, ""};
  node.expect_object({"schema", "things"});
  if (node.at("schema").text() != "etak-unmeasured/1") node.at("schema").fail_type("\"etak-unmeasured/1\"");
  const JsonNode things = node.at("things");
  things.expect_array();
  std::vector<Unmeasured> out;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < things.size(); ++i) {
    const JsonNode entry = things.at(i);
    entry.expect_object({"words", "why", "nearest"});
    Unmeasured each{entry.at("words").texts(), entry.at("why").text(), entry.at("nearest").texts()};
    if (each.words.empty()) entry.at("words").fail_type("at least one word");
    if (each.why.empty()) entry.at("why").fail_type("a reason");
    for (const std::string& word : each.words)
      if (!seen.insert(folded_name(word)).second)
        entry.at("words").fail(in_quotes(word) + " again", "each word once");
    out.push_back(std::move(each));
  }
  return out;
}

}  // namespace etak
