// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/validate/shards/carrier_json.h"

namespace etak {
namespace {

// The order of the members counts: the counts of a file keep theirs.
using Json = nlohmann::ordered_json;

// Thrown where a member has no value of its kind; read_shard() makes an Error of it.
struct BadValue {
  std::string key, expected;
};

template <class Value>
Value named(const Json& json, const char* key, std::optional<Value> (*value_of)(std::string_view),
            const char* expected) {
  const auto value = value_of(json.at(key).get_ref<const std::string&>());
  if (!value) throw BadValue{key, expected};
  return *value;
}

std::optional<FileRole> any_role_named(std::string_view text) {
  const auto role = role_named(text);
  return role ? role : picture_role_named(text);
}

std::optional<GreenAxis> green_named(std::string_view text) {
  for (const GreenAxis green : {GreenAxis::opengl, GreenAxis::directx})
    if (text == name(green)) return green;
  return std::nullopt;
}

PixelBox read_box(const Json& json) {
  return {json.at(0).get<int>(), json.at(1).get<int>(), json.at(2).get<int>(), json.at(3).get<int>()};
}

std::string text_at(const Json& json, const char* key) {
  return json.contains(key) ? json.at(key).get<std::string>() : std::string();
}

bool flag_at(const Json& json, const char* key) {
  return json.contains(key) && json.at(key).get<bool>();
}

double read_exact(const Json& json) {
  if (json.is_number()) return json.get<double>();
  const auto& text = json.get_ref<const std::string&>();
  const bool negative = text.starts_with('-');
  const double value = text.ends_with("inf")   ? std::numeric_limits<double>::infinity()
                       : text.ends_with("nan") ? std::numeric_limits<double>::quiet_NaN()
                                               : throw BadValue{"exactValue", "a number, nan or inf"};
  return std::copysign(value, negative ? -1.0 : 1.0);
}

std::array<double, 3> read_exact3(const Json& json) {
  return {read_exact(json.at(0)), read_exact(json.at(1)), read_exact(json.at(2))};
}

void read_value(const Json& json, Finding& out) {
  const Json& value = json.at("value");
  const auto exact = json.find("exactValue");
  if (!value.is_null()) {
    if (exact != json.end()) {
      if (exact->contains("linear")) out.linear = read_exact3(exact->at("linear"));
      if (exact->contains("Y")) out.luminance = read_exact(exact->at("Y"));
    } else {
      if (!value.at("linear").is_null()) out.linear = read_exact3(value.at("linear"));
      if (!value.at("Y").is_null()) out.luminance = value.at("Y").get<double>();
    }
    if (!value.at("byte").is_null()) out.byte = value.at("byte").get<std::array<int, 3>>();
  }
}

Finding read_finding(const Json& json) {
  Finding out;
  json.at("id").get_to(out.rule);
  json.at("slug").get_to(out.slug);
  out.severity = named(json, "severity", severity_named, "off, info, warning or error");
  json.at("file").get_to(out.file);
  json.at("message").get_to(out.message);
  json.at("tile").get_to(out.tile);
  json.at("material").get_to(out.material);
  json.at("pointer").get_to(out.pointer);
  if (!json.at("bbox").is_null()) out.box = read_box(json.at("bbox"));
  if (json.contains("islands"))
    for (const Json& island : json.at("islands")) {
      FindingIsland& row = out.islands.emplace_back();
      island.at("tile").get_to(row.tile);
      if (!island.at("bbox").is_null()) row.box = read_box(island.at("bbox"));
      island.at("areaPx").get_to(row.area_px);
      if (island.contains("uv")) row.uv = island.at("uv").get<UvBox>();
    }
  if (json.contains("uv")) out.uv = json.at("uv").get<UvBox>();
  json.at("areaPx").get_to(out.area_px);
  json.at("areaShare").get_to(out.area_share);
  read_value(json, out);
  json.at("found").get_to(out.value);
  json.at("limit").get_to(out.limit);
  for (const Json& near : json.at("nearest"))
    out.nearest.push_back({near.at("name").get<std::string>(), near.at("dataset").get<std::string>(),
                           near.at("bytes").get<double>()});
  json.at("cause").get_to(out.cause);
  json.at("fix").get_to(out.fix);
  json.at("source").get_to(out.source);
  json.at("suppressed").get_to(out.suppressed);
  json.at("suppression").get_to(out.suppression);
  json.at("baseline").get_to(out.baseline);
  return out;
}

std::vector<TargetFile> read_target_files(const Json& json) {
  std::vector<TargetFile> out;
  for (const Json& row : json) {
    TargetFile& file = out.emplace_back();
    file.role = named(row, "role", any_role_named, "a role");
    row.at("path").get_to(file.path);
    row.at("label").get_to(file.label);
    file.guessed = flag_at(row, "guessed");
    file.channels = text_at(row, "channels");
    if (row.contains("green")) file.green = named(row, "green", green_named, "opengl or directx");
  }
  return out;
}

CheckTile read_tile(const Json& json) {
  CheckTile out;
  json.at("name").get_to(out.name);
  out.box = read_box(json.at("box"));
  json.at("page").get_to(out.page);
  out.material = text_at(json, "material");
  out.surface_class = text_at(json, "surface");
  if (json.contains("typicalGloss")) out.typical_gloss = json.at("typicalGloss").get<double>();
  if (json.contains("gutter")) out.gutter = json.at("gutter").get<int>();
  if (json.contains("mips")) out.mips = json.at("mips").get<int>();
  for (std::size_t texture = 0; texture < 2; ++texture)
    if (const char* key = texture == 0 ? "flatA" : "flatB"; json.contains(key))
      out.flat[texture] = json.at(key).get<std::array<std::uint8_t, 4>>();
  out.island_of = text_at(json, "islandOf");
  if (json.contains("ownAround")) json.at("ownAround").get_to(out.own_around);
  return out;
}

Manifest read_manifest(const Json& json) {
  Manifest out;
  if (json.contains("tiles"))
    for (const Json& tile : json.at("tiles")) out.tiles.push_back(read_tile(tile));
  if (json.contains("gutter")) json.at("gutter").get_to(out.gutter);
  if (json.contains("mips")) out.mips = json.at("mips").get<int>();
  if (json.contains("transfer"))
    out.transfer = named(json, "transfer", texture_transfer_named, "srgb, gamma22 or linear");
  out.material = text_at(json, "material");
  out.surface_class = text_at(json, "surface");
  out.scene = text_at(json, "scene");
  out.linear8_f0 = flag_at(json, "linear8F0");
  out.transparent = flag_at(json, "transparent");
  out.one_texture = flag_at(json, "oneTexture");
  out.packed = flag_at(json, "packed");
  out.specular_weighs_diffuse = flag_at(json, "specularWeighsDiffuse");
  return out;
}

CheckTarget read_target(const Json& json) {
  CheckTarget out;
  json.at("label").get_to(out.label);
  out.files = read_target_files(json.at("files"));
  if (json.contains("manifest")) out.manifest = read_manifest(json.at("manifest"));
  out.udim = text_at(json, "udim");
  out.tile = text_at(json, "tile");
  if (json.contains("beside")) out.beside = read_target_files(json.at("beside"));
  return out;
}

CheckedFile read_file_json(const Json& json) {
  CheckedFile out;
  json.at("path").get_to(out.path);
  json.at("companions").get_to(out.companions);
  if (!json.at("sha256").is_null()) json.at("sha256").get_to(out.sha256);
  json.at("width").get_to(out.width);
  json.at("height").get_to(out.height);
  json.at("unreadable").get_to(out.unreadable);
  for (const Json& row : json.at("roles"))
    out.roles.emplace_back(row.at("file").get<std::string>(), row.at("role").get<std::string>());
  for (const Json& finding : json.at("findings")) out.findings.push_back(read_finding(finding));
  const Json& stats = json.at("stats");
  stats.at("plateauPx").get_to(out.plateau_px);
  stats.at("transitionPx").get_to(out.transition_px);
  for (const auto& [key, count] : stats.at("counts").items())
    out.counts.emplace_back(key, count.get<std::int64_t>());
  json.at("place").get_to(out.place);
  if (!json.contains("targets")) return out;
  std::vector<std::shared_ptr<const CheckTarget>> targets;
  for (const Json& target : json.at("targets"))
    targets.push_back(std::make_shared<const CheckTarget>(read_target(target)));
  if (targets.empty()) throw BadValue{"targets", "at least one"};
  out.target = targets.front();
  if (!targets.front()->udim.empty()) out.tiles = std::move(targets);
  return out;
}

Settings read_settings(const Json& common, const Json& more) {
  Settings out;
  out.profile = named(common, "profile", profile_named, "default, strict, film or custom");
  out.transfer = named(common, "transfer", texture_transfer_named, "srgb, gamma22 or linear");
  out.fail_on = named(common, "failOn", severity_named, "info, warning or error");
  more.at("transferStated").get_to(out.transfer_stated);
  more.at("transparency").get_to(out.alpha_is_transparency);
  const Json& zone = more.at("zone");
  zone.at("low").get_to(out.zone.low);
  zone.at("high").get_to(out.zone.high);
  out.zone.metric = zone.at("largestChannel").get<bool>() ? ZoneMetric::max : ZoneMetric::luminance;
  zone.at("erode").get_to(out.zone.erode);
  zone.at("leastPx").get_to(out.zone.min_area_px);
  zone.at("leastShare").get_to(out.zone.min_area_share);
  for (const auto& [id, row] : more.at("rules").items()) {
    RuleSetting& rule = out.rules[id];
    if (row.contains("severity")) rule.severity = named(row, "severity", severity_named, "a severity");
    if (row.contains("parameters"))
      for (const auto& [key, value] : row.at("parameters").items())
        rule.parameters[key] = value.get<double>();
  }
  return out;
}

ReportShard read_shard_member(const Json& json, const Json& settings) {
  ReportShard out;
  json.at("index").get_to(out.shard.index);
  json.at("count").get_to(out.shard.count);
  if (!shard_named(out.shard.text())) throw BadValue{"index", "from 1 to count"};
  json.at("list").get_to(out.list);
  json.at("options").get_to(out.options);
  json.at("groups").get_to(out.groups);
  out.shard.items.emplace(json.at("first").get<std::size_t>(), json.at("last").get<std::size_t>());
  const Json& run = json.at("run");
  run.at("files").get_to(out.run.files);
  run.at("skipped").get_to(out.run.skipped);
  run.at("failed").get_to(out.run.failed);
  run.at("checks").get_to(out.run.checks);
  const Json& verdict = json.at("verdict");
  verdict.at("never").get_to(out.verdict.never_fails);
  verdict.at("exitZero").get_to(out.verdict.exit_zero);
  if (!verdict.at("maxWarnings").is_null())
    out.verdict.max_warnings = verdict.at("maxWarnings").get<std::size_t>();
  verdict.at("minSeverity").get_to(out.verdict.min_severity);
  out.settings = read_settings(settings, json.at("settings"));
  for (const Json& row : json.at("allowances")) {
    AllowanceUse& use = out.allowances.emplace_back();
    row.at("used").get_to(use.used);
    row.at("met").get_to(use.met);
    row.at("anyhow").get_to(use.anyhow);
    if (!row.at("unused").is_null()) use.unused = read_finding(row.at("unused"));
  }
  return out;
}

ReadShard read_document(const Json& json) {
  ReadShard out;
  ValidationReport& report = out.report;
  if (!json.contains("shard")) throw BadValue{"shard", "the output of a shard, not of a whole run"};
  json.at("tool").at("version").get_to(out.version);
  const Json& settings = json.at("settings");
  settings.at("profile").get_to(report.profile);
  settings.at("transfer").get_to(report.transfer);
  settings.at("hash").get_to(report.settings_hash);
  const Json& shard = json.at("shard");
  report.shard = std::make_shared<const ReportShard>(read_shard_member(shard, settings));
  report.run = report.shard->run;
  shard.at("run").at("nothingChecked").get_to(report.nothing_checked);
  json.at("notRecognised").get_to(report.unknown);
  if (shard.contains("notOpened")) shard.at("notOpened").get_to(report.not_opened);
  if (shard.contains("folders"))
    for (const auto& [label, typed] : shard.at("folders").items())
      report.typed.emplace(label, typed.get<std::string>());
  const Json& files = json.at("files");
  report.files.reserve(files.size());
  for (const Json& file : files) report.files.push_back(read_file_json(file));
  return out;
}

}  // namespace

ReadShard read_shard(std::string_view text, const std::string& file) {
  constexpr const char* expected =
      "what etak validate --shard --format json wrote, whole and unchanged; run that shard again";
  try {
    const Json json = Json::parse(text);
    return read_document(json);
  } catch (const Json::parse_error& error) {
    throw Error::at(file, "is no whole JSON document (byte " + std::to_string(error.byte) + ")", expected);
  } catch (const Json::exception& error) {
    throw Error::at(file, "is no shard of etak validate (" + printable(error.what(), 120) + ")", expected);
  } catch (const BadValue& bad) {
    throw Error::at(file, "has no right value of \"" + bad.key + "\"", bad.expected);
  }
}

}  // namespace etak
