// SPDX-License-Identifier: Apache-2.0
// Based on: OASIS, "Static Analysis Results Interchange Format (SARIF) Version 2.1.0", 2020.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/findings/output/formats.h"
#include "core/findings/shards/report_shard.h"
#include "core/judge/rules.h"
#include "core/scene/uri.h"

namespace etak {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view schema_address =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/os/schemas/sarif-schema-2.1.0.json";

std::string_view level(Severity severity) {
  if (severity == Severity::error) return "error";
  return severity == Severity::warning ? "warning" : "note";
}

Json artifact(const std::string& path) {
  return {{"uri", uri_of_file(path)}, {"uriBaseId", "%SRCROOT%"}};
}

// Without helpUri, and the driver without informationUri: services make links of them, and there is no server
// that they could lead to. The help is in the log, and `etak explain ETK101` prints it.
Json rule_json(const Rule& rule) {
  Json out = Json::object();
  out["id"] = rule.id;
  out["name"] = rule.slug;
  out["shortDescription"] = {{"text", rule.title}};
  out["fullDescription"] = {{"text", rule.what}};
  const std::string text = std::string(rule.what) + "\n\n" + std::string(rule.why) +
                           "\n\nExample: " + std::string(rule.example) + "\n\nFix: " + std::string(rule.fix) +
                           "\n\nMore: etak explain " + std::string(rule.id);
  std::string markdown = std::string(rule.what) + "\n\n**Why.** " + std::string(rule.why);
  markdown += "\n\n**Example.** " + std::string(rule.example) + "\n\n**Fix.** " + std::string(rule.fix);
  markdown += "\n\n**Source.** " + std::string(rule.source);
  markdown += "\n\nMore: `etak explain " + std::string(rule.id) + "`";
  out["help"] = {{"text", text}, {"markdown", markdown}};
  out["defaultConfiguration"] = {
      {"enabled", rule.severity.standard != Severity::off},
      {"level", rule.severity.standard == Severity::off ? "none" : level(rule.severity.standard)}};
  out["properties"] = {{"tags", Json::array({rule.family()})}};
  return out;
}

std::size_t rule_index(const std::string& id) {
  const auto all = rules();
  return static_cast<std::size_t>(
      std::find_if(all.begin(), all.end(), [&](const Rule* rule) { return rule->id == id; }) - all.begin());
}

Json result_json(const CheckedFile& file, const Finding& finding) {
  Json out = Json::object();
  out["ruleId"] = finding.rule;
  if (const std::size_t index = rule_index(finding.rule); index < rules().size()) out["ruleIndex"] = index;
  out["level"] = level(finding.severity);
  std::string message = sentence_of(finding) + '.';
  if (!finding.fix.empty()) message += " Fix: " + finding.fix;
  out["message"] = {{"text", message}};
  // A picture has no lines; code scanners ask for a region all the same.
  Json location = {
      {"physicalLocation", {{"artifactLocation", artifact(finding.file)}, {"region", {{"startLine", 1}}}}}};
  Json logical = Json::array();
  if (!finding.tile.empty()) logical.push_back({{"name", finding.tile}, {"kind", "tile"}});
  if (!finding.material.empty()) logical.push_back({{"name", finding.material}, {"kind", "material"}});
  if (!finding.pointer.empty())
    logical.push_back({{"fullyQualifiedName", finding.pointer}, {"kind", "JSON pointer"}});
  if (!logical.empty()) location["logicalLocations"] = std::move(logical);
  out["locations"] = Json::array({std::move(location)});
  if (finding.box) {
    const PixelBox& box = *finding.box;
    const Json rectangle = {
        {"top", box.y}, {"left", box.x}, {"bottom", box.y + box.height}, {"right", box.x + box.width}};
    out["attachments"] = Json::array(
        {{{"artifactLocation", artifact(finding.file)}, {"rectangles", Json::array({rectangle})}}});
  }
  out["partialFingerprints"] = {{"etakRegion/v1", region_fingerprint(finding, file.width, file.height)}};
  if (finding.suppressed)
    out["suppressions"] =
        Json::array({{{"kind", "external"}, {"status", "accepted"}, {"justification", finding.suppression}}});
  else if (finding.baseline)
    out["suppressions"] = Json::array(
        {{{"kind", "external"}, {"status", "accepted"}, {"justification", "known from the baseline"}}});
  Json properties = {{"areaPx", finding.area_px}};
  if (finding.luminance) properties["Y"] = *finding.luminance;
  out["properties"] = std::move(properties);
  return out;
}

}  // namespace

std::string validation_sarif(const ValidationReport& report, const OutputOptions& options) {
  Json results = Json::array();
  std::size_t left_out = 0;
  // Findings that count come first, so that suppressed ones are the first to be left out.
  for (const bool counting : {true, false})
    for (const CheckedFile& file : report.files)
      for (const Finding& finding : file.findings) {
        if (counts(finding) != counting) continue;
        if (results.size() < most_sarif_results)
          results.push_back(result_json(file, finding));
        else
          ++left_out;
      }
  Json notifications = Json::array();
  if (left_out > 0) {
    const std::string text = grouped(left_out) + " results more than " + grouped(most_sarif_results) +
                             " were left out; the JSON form has them all";
    notifications.push_back({{"level", "warning"}, {"message", {{"text", text}}}});
  }
  for (const CheckedFile& file : report.files) {
    if (!file.unreadable || notifications.size() >= most_sarif_results) continue;
    notifications.push_back(
        {{"level", "error"},
         {"message", {{"text", "could not be checked"}}},
         {"locations", Json::array({{{"physicalLocation", {{"artifactLocation", artifact(file.path)}}}}})}});
  }
  Json rule_rows = Json::array();
  for (const Rule* rule : rules()) rule_rows.push_back(rule_json(*rule));
  Json run = Json::object();
  run["tool"] = {
      {"driver", {{"name", "etak"}, {"version", options.version}, {"rules", std::move(rule_rows)}}}};
  run["invocations"] = Json::array({{{"executionSuccessful", !report.incomplete},
                                     {"toolExecutionNotifications", std::move(notifications)}}});
  run["columnKind"] = "utf16CodeUnits";
  run["results"] = std::move(results);
  if (report.shard) run["properties"] = {{"shard", report.shard->shard.text()}};
  Json out = Json::object();
  out["$schema"] = schema_address;
  out["version"] = "2.1.0";
  out["runs"] = Json::array({std::move(run)});
  return quiet_json(out.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n';
}

}  // namespace etak
