// SPDX-License-Identifier: Apache-2.0
#include "core/validate/shards/carrier_json.h"

#include <cmath>

namespace etak {
namespace {

using Json = nlohmann::ordered_json;

Json box_json(const PixelBox& box) {
  return Json::array({box.x, box.y, box.width, box.height});
}

Json target_file_json(const TargetFile& file) {
  Json out = {{"role", name(file.role)}, {"path", file.path}, {"label", file.label}};
  if (file.guessed) out["guessed"] = true;
  if (!file.channels.empty()) out["channels"] = file.channels;
  if (file.green != GreenAxis::unsaid) out["green"] = name(file.green);
  return out;
}

Json target_files_json(const std::vector<TargetFile>& files) {
  Json out = Json::array();
  for (const TargetFile& file : files) out.push_back(target_file_json(file));
  return out;
}

Json tile_json(const CheckTile& tile) {
  Json out = {{"name", tile.name}, {"box", box_json(tile.box)}, {"page", tile.page}};
  if (!tile.material.empty()) out["material"] = tile.material;
  if (!tile.surface_class.empty()) out["surface"] = tile.surface_class;
  if (tile.typical_gloss) out["typicalGloss"] = *tile.typical_gloss;
  if (tile.gutter) out["gutter"] = *tile.gutter;
  if (tile.mips) out["mips"] = *tile.mips;
  for (std::size_t texture = 0; texture < 2; ++texture)
    if (tile.flat[texture]) out[texture == 0 ? "flatA" : "flatB"] = *tile.flat[texture];
  if (!tile.island_of.empty()) out["islandOf"] = tile.island_of;
  if (tile.own_around != 0) out["ownAround"] = tile.own_around;
  return out;
}

Json manifest_json(const Manifest& manifest) {
  Json out = Json::object();
  if (!manifest.tiles.empty()) {
    out["tiles"] = Json::array();
    for (const CheckTile& tile : manifest.tiles) out["tiles"].push_back(tile_json(tile));
  }
  if (manifest.gutter != 0) out["gutter"] = manifest.gutter;
  if (manifest.mips) out["mips"] = *manifest.mips;
  if (manifest.transfer) out["transfer"] = name(*manifest.transfer);
  for (const auto& [key, text] : {std::pair{"material", &manifest.material},
                                  {"surface", &manifest.surface_class},
                                  {"scene", &manifest.scene}})
    if (!text->empty()) out[key] = *text;
  for (const auto& [key, flag] : {std::pair{"linear8F0", manifest.linear8_f0},
                                  {"transparent", manifest.transparent},
                                  {"oneTexture", manifest.one_texture},
                                  {"packed", manifest.packed},
                                  {"specularWeighsDiffuse", manifest.specular_weighs_diffuse}})
    if (flag) out[key] = true;
  return out;
}

Json target_json(const CheckTarget& target) {
  Json out = {{"label", target.label}, {"files", target_files_json(target.files)}};
  if (Json manifest = manifest_json(target.manifest); !manifest.empty())
    out["manifest"] = std::move(manifest);
  if (!target.udim.empty()) out["udim"] = target.udim;
  if (!target.tile.empty()) out["tile"] = target.tile;
  if (!target.beside.empty()) out["beside"] = target_files_json(target.beside);
  return out;
}

// The settings that the "settings" member of every report does not hold.
Json settings_json(const Settings& settings) {
  const ZoneSettings& zone = settings.zone;
  Json out = {{"transferStated", settings.transfer_stated},
              {"transparency", settings.alpha_is_transparency},
              {"zone",
               {{"low", zone.low},
                {"high", zone.high},
                {"largestChannel", zone.metric == ZoneMetric::max},
                {"erode", zone.erode},
                {"leastPx", zone.min_area_px},
                {"leastShare", zone.min_area_share}}},
              {"rules", Json::object()}};
  for (const auto& [id, rule] : settings.rules) {
    Json row = Json::object();
    if (rule.severity) row["severity"] = name(*rule.severity);
    for (const auto& [key, value] : rule.parameters) row["parameters"][key] = value;
    out["rules"][id] = std::move(row);
  }
  return out;
}

Json allowances_json(const std::vector<AllowanceUse>& uses) {
  Json out = Json::array();
  for (const AllowanceUse& use : uses)
    out.push_back({{"used", use.used},
                   {"met", use.met},
                   {"anyhow", use.anyhow},
                   {"unused", use.unused ? finding_json(*use.unused) : Json(nullptr)}});
  return out;
}

std::string text_of_number(double value) {
  if (std::isnan(value)) return std::signbit(value) ? "-nan" : "nan";
  return value < 0 ? "-inf" : "inf";
}

Json exact(double value) {
  return std::isfinite(value) ? Json(value) : Json(text_of_number(value));
}

}  // namespace

void add_exact_numbers(const CheckedFile& file, Json& findings) {
  for (std::size_t i = 0; i < file.findings.size(); ++i) {
    const Finding& finding = file.findings[i];
    const bool odd =
        (finding.linear && !(std::isfinite((*finding.linear)[0]) && std::isfinite((*finding.linear)[1]) &&
                             std::isfinite((*finding.linear)[2]))) ||
        (finding.luminance && !std::isfinite(*finding.luminance));
    if (!odd) continue;
    Json& value = findings[i]["exactValue"] = Json::object();
    if (finding.linear)
      value["linear"] = Json::array(
          {exact((*finding.linear)[0]), exact((*finding.linear)[1]), exact((*finding.linear)[2])});
    if (finding.luminance) value["Y"] = exact(*finding.luminance);
  }
}

Json targets_json(const CheckedFile& file) {
  Json out = Json::array();
  if (file.tiles.empty())
    out.push_back(target_json(*file.target));
  else
    for (const auto& tile : file.tiles) out.push_back(target_json(*tile));
  return out;
}

Json shard_json(const ValidationReport& report) {
  const ReportShard& shard = *report.shard;
  Json out = {
      {"index", shard.shard.index},
      {"count", shard.shard.count},
      {"list", shard.list},
      {"options", shard.options},
      {"groups", shard.groups},
      {"first", shard.shard.items ? shard.shard.items->first : 0},
      {"last", shard.shard.items ? shard.shard.items->second : shard.groups},
      {"run",
       {{"files", shard.run.files},
        {"skipped", shard.run.skipped},
        {"failed", shard.run.failed},
        {"checks", shard.run.checks},
        {"nothingChecked", report.nothing_checked}}},
      {"verdict",
       {{"never", shard.verdict.never_fails},
        {"exitZero", shard.verdict.exit_zero},
        {"maxWarnings", shard.verdict.max_warnings ? Json(*shard.verdict.max_warnings) : Json(nullptr)},
        {"minSeverity", shard.verdict.min_severity}}},
      {"settings", settings_json(shard.settings)},
      {"allowances", allowances_json(shard.allowances)}};
  if (shard.shard.index > 1) return out;
  out["notOpened"] = report.not_opened;
  out["folders"] = report.typed;
  return out;
}

}  // namespace etak
