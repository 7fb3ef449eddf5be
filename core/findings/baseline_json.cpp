// SPDX-License-Identifier: Apache-2.0
#include "core/base/json/node_json.h"
#include "core/base/text/text.h"
#include "core/findings/baseline.h"

namespace etak {

std::string baseline_json(std::span<const KnownDefect> known) {
  using Ordered = nlohmann::ordered_json;
  std::string out = "{\n  \"schema\": \"etak-baseline/1\",\n  \"findings\": [";
  for (std::size_t i = 0; i < known.size(); ++i) {
    const KnownDefect& defect = known[i];
    Ordered entry = Ordered::object();
    entry["rule"] = defect.rule;
    entry["file"] = defect.file;
    for (const auto& [key, value] :
         {std::pair{"tile", &defect.tile}, {"material", &defect.material}, {"pointer", &defect.pointer}})
      if (!value->empty()) entry[key] = *value;
    if (defect.region) entry["region"] = *defect.region;
    append(out, i == 0 ? "\n    " : ",\n    ",
           quiet_json(entry.dump(-1, ' ', false, Ordered::error_handler_t::replace)));
  }
  return out + (known.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

std::vector<KnownDefect> read_baseline(std::string_view text, std::string_view file) {
  const JsonDocument document = parse_json_strictly(text, file, 8, "a baseline of etak validate");
  const JsonNode root{document, file, {}};
  root.expect_object({"schema", "findings"});
  root.at("schema").expect_text("etak-baseline/1");
  const JsonNode findings = root.at("findings");
  findings.expect_array();
  std::vector<KnownDefect> out;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const JsonNode entry = findings.at(i);
    entry.expect_object({"rule", "file", "tile", "material", "pointer", "region"});
    KnownDefect& defect = out.emplace_back();
    defect.rule = entry.at("rule").text();
    defect.file = entry.at("file").text();
    defect.tile = entry.text_or_empty("tile");
    defect.material = entry.text_or_empty("material");
    defect.pointer = entry.text_or_empty("pointer");
    const auto edge = [](const JsonNode& each) { return each.integer(-1000, 1000); };
    if (entry.has("region")) defect.region = entry.at("region").each_of<4>(edge, "four whole numbers");
  }
  return out;
}

}  // namespace etak
