// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "core/validate/files/result_cache.h"

namespace etak {
namespace {

using Json = nlohmann::json;

template <class Value>
Json optional_json(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

template <class Value>
void read_optional(const Json& json, std::optional<Value>& value) {
  if (!json.is_null()) value = json.get<Value>();
}

Json box_json(const std::optional<PixelBox>& box) {
  return box ? Json::array({box->x, box->y, box->width, box->height}) : Json(nullptr);
}

std::optional<PixelBox> read_box(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return PixelBox{json.at(0).get<int>(), json.at(1).get<int>(), json.at(2).get<int>(), json.at(3).get<int>()};
}

Json finding_json(const Finding& f) {
  Json nearest = Json::array();
  for (const NearestMaterial& near : f.nearest) nearest.push_back({near.id, near.dataset, near.bytes});
  Json islands = Json::array();
  for (const FindingIsland& island : f.islands)
    islands.push_back({island.tile, box_json(island.box), island.area_px});
  return Json::array({f.rule,
                      f.slug,
                      static_cast<int>(f.severity),
                      f.file,
                      f.tile,
                      f.material,
                      f.pointer,
                      box_json(f.box),
                      f.area_px,
                      f.area_share,
                      optional_json(f.linear),
                      optional_json(f.byte),
                      optional_json(f.luminance),
                      f.value,
                      f.limit,
                      nearest,
                      f.message,
                      f.cause,
                      f.fix,
                      f.source,
                      islands,
                      optional_json(f.uv)});
}

Finding read_finding(const Json& json) {
  Finding f;
  std::size_t at = 0;
  const auto next = [&]() -> const Json& { return json.at(at++); };
  f.rule = next();
  f.slug = next();
  const int severity = next();
  if (severity < static_cast<int>(Severity::off) || severity > static_cast<int>(Severity::error))
    throw Json::other_error::create(500, "severity", &json);
  f.severity = static_cast<Severity>(severity);
  f.file = next();
  f.tile = next();
  f.material = next();
  f.pointer = next();
  f.box = read_box(next());
  f.area_px = next();
  f.area_share = next();
  read_optional(next(), f.linear);
  read_optional(next(), f.byte);
  read_optional(next(), f.luminance);
  f.value = next();
  f.limit = next();
  for (const Json& near : next())
    f.nearest.push_back(
        {near.at(0).get<std::string>(), near.at(1).get<std::string>(), near.at(2).get<double>()});
  f.message = next();
  f.cause = next();
  f.fix = next();
  f.source = next();
  for (const Json& island : next())
    f.islands.push_back(
        {island.at(0).get<std::string>(), read_box(island.at(1)), island.at(2).get<std::size_t>()});
  read_optional(next(), f.uv);
  return f;
}

}  // namespace

std::string cache_text(const CheckedFile& file) {
  Json findings = Json::array();
  for (const Finding& finding : file.findings) findings.push_back(finding_json(finding));
  const Json out = {{"path", file.path},          {"companions", file.companions},
                    {"sha256", file.sha256},      {"size", {file.width, file.height}},
                    {"roles", file.roles},        {"findings", std::move(findings)},
                    {"plateau", file.plateau_px}, {"transition", file.transition_px},
                    {"counts", file.counts}};
  try {
    return out.dump();
  } catch (const Json::exception&) {
    return {};
  }
}

std::optional<CheckedFile> read_cache_text(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    CheckedFile out;
    out.path = json.at("path");
    json.at("companions").get_to(out.companions);
    out.sha256 = json.at("sha256");
    out.width = json.at("size").at(0);
    out.height = json.at("size").at(1);
    json.at("roles").get_to(out.roles);
    for (const Json& finding : json.at("findings")) out.findings.push_back(read_finding(finding));
    out.plateau_px = json.at("plateau");
    out.transition_px = json.at("transition");
    json.at("counts").get_to(out.counts);
    return out;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace etak
