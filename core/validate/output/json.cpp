// SPDX-License-Identifier: Apache-2.0
// The JSON form, as resources/schema/validation.schema.json describes it.
#include "core/base/error.h"
#include "core/base/text/text.h"
#include "core/validate/output/formats.h"
#include "core/validate/shards/carrier_json.h"

namespace etak {
namespace {

using Json = nlohmann::ordered_json;

Json value_json(const Finding& finding) {
  if (!finding.linear && !finding.byte && !finding.luminance) return nullptr;
  Json out = Json::object();
  out["linear"] = finding.linear ? Json(*finding.linear) : Json(nullptr);
  out["byte"] = finding.byte ? Json(*finding.byte) : Json(nullptr);
  out["Y"] = finding.luminance ? Json(*finding.luminance) : Json(nullptr);
  return out;
}

Json box_json(const std::optional<PixelBox>& box) {
  return box ? Json::array({box->x, box->y, box->width, box->height}) : Json(nullptr);
}

Json uv_json(const UvBox& uv) {
  return Json::array({uv[0], uv[1], uv[2], uv[3]});
}

Json island_json(const FindingIsland& island) {
  Json out = {{"tile", island.tile}, {"bbox", box_json(island.box)}, {"areaPx", island.area_px}};
  if (island.uv) out["uv"] = uv_json(*island.uv);
  return out;
}

}  // namespace

Json finding_json(const Finding& finding) {
  Json out = Json::object();
  out["id"] = finding.rule;
  out["slug"] = finding.slug;
  out["severity"] = name(finding.severity);
  out["file"] = finding.file;
  out["message"] = finding.message;
  out["tile"] = finding.tile;
  out["material"] = finding.material;
  out["pointer"] = finding.pointer;
  out["bbox"] = box_json(finding.box);
  if (!finding.islands.empty()) {
    out["islands"] = Json::array();
    for (const FindingIsland& island : finding.islands) out["islands"].push_back(island_json(island));
  }
  if (finding.uv) out["uv"] = uv_json(*finding.uv);
  out["areaPx"] = finding.area_px;
  out["areaShare"] = finding.area_share;
  out["value"] = value_json(finding);
  out["found"] = finding.value;
  out["limit"] = finding.limit;
  out["nearest"] = Json::array();
  for (const NearestMaterial& near : finding.nearest)
    out["nearest"].push_back({{"name", near.id}, {"dataset", near.dataset}, {"bytes", near.bytes}});
  out["cause"] = finding.cause;
  out["fix"] = finding.fix;
  out["source"] = finding.source;
  out["suppressed"] = finding.suppressed;
  out["suppression"] = finding.suppression;
  out["baseline"] = finding.baseline;
  return out;
}

namespace {

Json file_json(const CheckedFile& file) {
  Json out = Json::object();
  out["path"] = file.path;
  out["companions"] = file.companions;
  out["sha256"] = file.sha256.empty() ? Json(nullptr) : Json(file.sha256);
  out["width"] = file.width;
  out["height"] = file.height;
  out["unreadable"] = file.unreadable;
  out["roles"] = Json::array();
  for (const auto& [path, role] : file.roles) out["roles"].push_back({{"file", path}, {"role", role}});
  out["findings"] = Json::array();
  for (const Finding& finding : file.findings) out["findings"].push_back(finding_json(finding));
  Json pixel_counts = Json::object();
  for (const auto& [key, count] : file.counts) pixel_counts[key] = count;
  out["stats"] = {{"plateauPx", file.plateau_px},
                  {"transitionPx", file.transition_px},
                  {"counts", std::move(pixel_counts)}};
  return out;
}

Json repairs_json(const RepairReport& repairs) {
  Json out = {{"folder", repairs.folder}, {"files", Json::array()}, {"left", Json::array()}};
  for (const RepairedFile& file : repairs.files) {
    Json row = {{"file", file.file}, {"copy", file.copy}, {"repairs", Json::array()}};
    for (const RepairStep& step : file.steps)
      row["repairs"].push_back({{"id", step.rule},
                                {"slug", step.slug},
                                {"what", step.what},
                                {"texels", step.texels},
                                {"also", step.also}});
    row["texels"] = file.texels;
    row["notKept"] = file.not_kept;
    out["files"].push_back(std::move(row));
  }
  for (const LeftFinding& left : repairs.left)
    out["left"].push_back({{"id", left.rule}, {"slug", left.slug}, {"file", left.file}, {"why", left.why}});
  return out;
}

std::string text_of(const Json& json) {
  return quiet_json(json.dump(2, ' ', false, Json::error_handler_t::replace));
}

// The same of a shard, whose merge needs every byte of a name.
std::string exact_text_of(const Json& json, const std::string& path) {
  try {
    return quiet_json(json.dump(2, ' ', false, Json::error_handler_t::strict));
  } catch (const Json::exception&) {
    throw Error::at(printable(path, 200), "a name that is no UTF-8, which the JSON of a shard cannot hold",
                    "another name, or a run without --shard");
  }
}

// Writes the files one after the other as elements of an array two levels deep, because a document of all of
// them would take ten times the memory of its text.
void append_files(std::string& out, const ValidationReport& report) {
  const auto& files = report.files;
  std::size_t with_pictures = 0;
  for (const CheckedFile& file : files) {
    out += &file == &files.front() ? "\n    " : ",\n    ";
    Json json = file_json(file);
    if (report.shard) {
      add_exact_numbers(file, json["findings"]);
      json["place"] = file.place;
      if (may_have_pictures(file) && ++with_pictures <= most_files_with_pictures)
        json["targets"] = targets_json(file);
    }
    for (const char c : report.shard ? exact_text_of(json, file.path) : text_of(json)) {
      out += c;
      if (c == '\n') out += "    ";  // in strings a line's end is escaped
    }
  }
  if (!files.empty()) out += "\n  ";
}

}  // namespace

std::string validation_json(const ValidationReport& report, const OutputOptions& options) {
  const ReportCounts files = count_files(report);
  Json out = Json::object();
  out["schema"] = "etak-validation/1";
  out["tool"] = {{"name", "etak"}, {"version", options.version}};
  out["settings"] = {{"profile", report.profile},
                     {"transfer", report.transfer},
                     {"failOn", name(options.fail_on)},
                     {"hash", report.settings_hash}};
  out["summary"] = {{"files", files.files},
                    {"clean", files.clean},
                    {"unreadable", files.unreadable},
                    {"errors", report.errors},
                    {"warnings", report.warnings},
                    {"infos", report.infos},
                    {"suppressed", files.suppressed},
                    {"baseline", files.known},
                    {"passed", report.passed && !report.incomplete},
                    {"incomplete", report.incomplete},
                    {"notRecognised", report.unknown.size()}};
  out["notRecognised"] = report.unknown;
  if (report.shard) out["shard"] = shard_json(report);
  if (report.repairs) out["repairs"] = repairs_json(*report.repairs);
  out["files"] = Json::array();
  out["truncated"] = false;
  const std::string frame = report.shard ? exact_text_of(out, "etak validate") : text_of(out);
  const std::size_t end = frame.rfind(']');  // of the empty array
  std::string text = frame.substr(0, end);
  append_files(text, report);
  return text + frame.substr(end) + '\n';
}

}  // namespace etak
