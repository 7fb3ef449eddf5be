// SPDX-License-Identifier: Apache-2.0
// The JSON form, as resources/schema/validation.schema.json describes it.
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/hash/sha256.h"
#include "core/base/text/text.h"
#include "core/findings/output/formats.h"
#include "core/findings/shards/report_shard.h"

namespace etak {
namespace {

using Json = nlohmann::ordered_json;

// Who reads the JSON. By default these are other programs, of which nothing is known.
//   in_shard   the merge of the shards, which makes the other forms of it
//   typed      where not null, the program that has called, which wants names as its user typed them
struct Reader {
  bool in_shard = false;
  const TypedFolders* typed = nullptr;

  std::string shown(const std::string& label) const {
    return typed == nullptr ? label : shown_path(label, *typed);
  }
};

// JSON has no form of infinity and NaN: they are null, and words for readers that know of them.
Json number_json(double value, const Reader& reader) {
  if (std::isfinite(value)) return value;
  if (!reader.in_shard && reader.typed == nullptr) return nullptr;
  return (std::signbit(value) ? "-" : "") + std::string(std::isnan(value) ? "nan" : "inf");
}

Json value_json(const Finding& finding, const Reader& reader) {
  if (!finding.linear && !finding.byte && !finding.luminance) return nullptr;
  Json out = {{"linear", nullptr}, {"byte", nullptr}, {"Y", nullptr}};
  if (finding.linear)
    for (const double value : *finding.linear) out["linear"].push_back(number_json(value, reader));
  if (finding.byte) out["byte"] = *finding.byte;
  if (finding.luminance) out["Y"] = number_json(*finding.luminance, reader);
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

Json finding_json(const Finding& finding, const Reader& reader) {
  Json out = Json::object();
  out["id"] = finding.rule;
  out["slug"] = finding.slug;
  out["severity"] = name(finding.severity);
  out["file"] = reader.shown(finding.file);
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
  out["value"] = value_json(finding, reader);
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
  if (reader.typed == nullptr) return out;
  out["place"] = place_of(finding, reader.shown(finding.file));
  out["sentence"] = sentence_of(finding);
  return out;
}

Json names_json(const std::vector<std::string>& labels, const Reader& reader) {
  Json out = Json::array();
  for (const std::string& label : labels) out.push_back(reader.shown(label));
  return out;
}

Json file_json(const CheckedFile& file, const Reader& reader) {
  Json out = Json::object();
  out["path"] = reader.shown(file.path);
  out["companions"] = names_json(file.companions, reader);
  out["sha256"] = file.sha256.empty() ? Json(nullptr) : Json(file.sha256);
  out["width"] = file.width;
  out["height"] = file.height;
  out["unreadable"] = file.unreadable;
  out["roles"] = Json::array();
  for (const auto& [path, role] : file.roles)
    out["roles"].push_back({{"file", reader.shown(path)}, {"role", role}});
  out["findings"] = Json::array();
  for (const Finding& finding : file.findings) out["findings"].push_back(finding_json(finding, reader));
  Json pixel_counts = Json::object();
  for (const auto& [key, count] : file.counts) pixel_counts[key] = count;
  out["stats"] = {{"plateauPx", file.plateau_px},
                  {"transitionPx", file.transition_px},
                  {"counts", std::move(pixel_counts)}};
  if (!reader.in_shard) return out;
  out["place"] = file.place;
  if (file.is_set) out["udim"] = true;
  return out;
}

// The member that holds the SHA-256 of a shard's document, with zeros while that is computed.
constexpr std::string_view seal = "\"sha256\": \"";
std::string no_digest() {
  return std::string(64, '0');
}

// What merged_report() needs besides the files. Of the first shard also what belongs to no group of files:
// folders as typed, and what was not opened.
Json shard_json(const ValidationReport& report) {
  const ReportShard& shard = *report.shard;
  const auto [first, last] = shard.shard.items.value_or(std::pair(std::size_t{0}, shard.groups));
  const RunCounts& run = shard.run;
  const VerdictOptions& verdict = shard.verdict;
  Json out = {{"index", shard.shard.index},
              {"count", shard.shard.count},
              {"items", shard.groups},
              {"first", first},
              {"last", last},
              {"list", shard.list},
              {"options", shard.options},
              {"sha256", no_digest()},
              {"run",
               {{"files", run.files},
                {"skipped", run.skipped},
                {"failed", run.failed},
                {"checks", run.checks},
                {"nothingChecked", report.nothing_checked}}},
              {"verdict",
               {{"never", verdict.never_fails},
                {"exitZero", verdict.exit_zero},
                {"maxWarnings", verdict.max_warnings ? Json(*verdict.max_warnings) : Json(nullptr)},
                {"minSeverity", verdict.min_severity}}},
              {"allowances", Json::array()}};
  for (const AllowanceUse& use : shard.allowances)
    out["allowances"].push_back({{"used", use.used},
                                 {"met", use.met},
                                 {"anyhow", use.anyhow},
                                 {"unused", use.unused ? finding_json(*use.unused, {true}) : Json(nullptr)}});
  if (shard.shard.index > 1) return out;
  out["notOpened"] = report.not_opened;
  out["folders"] = report.typed;
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

// The merge of a shard needs every byte of a name, so that names that are no UTF-8 are refused there.
std::string text_of(const Json& json, bool in_shard, const std::string& path) {
  using How = Json::error_handler_t;
  try {
    return quiet_json(json.dump(2, ' ', false, in_shard ? How::strict : How::replace));
  } catch (const Json::exception&) {
    throw Error::at(printable(path, 200), "a name that is no UTF-8, which the JSON of a shard cannot hold",
                    "another name, or a run without --shard");
  }
}

// Writes the files one after the other as elements of an array two levels deep, because a document of all of
// them would take ten times the memory of its text.
void append_files(std::string& out, const ValidationReport& report) {
  const auto& files = report.files;
  for (const CheckedFile& file : files) {
    out += &file == &files.front() ? "\n    " : ",\n    ";
    const bool in_shard = report.shard != nullptr;
    for (const char c : text_of(file_json(file, {in_shard}), in_shard, file.path)) {
      out += c;
      if (c == '\n') out += "    ";  // in strings a line's end is escaped
    }
  }
  if (!files.empty()) out += "\n  ";
}

// All of a report but its files.
Json frame_json(const ValidationReport& report, const OutputOptions& options, const Reader& reader) {
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
  out["notRecognised"] = names_json(report.unknown, reader);
  return out;
}

// Texts that are no UTF-8, such as names of files, become arrays of their bytes.
void keep_bytes(Json& json) {
  if (json.is_structured())
    for (Json& each : json) keep_bytes(each);
  else if (json.is_string())
    if (const std::string text = json.get<std::string>(); valid_utf8(text) != text)
      json = std::vector<std::uint8_t>(text.begin(), text.end());
}

std::string text_with_bytes(Json json) {
  try {
    return json.dump();
  } catch (const Json::exception&) {
    keep_bytes(json);
    return json.dump();
  }
}

}  // namespace

std::string validation_head_json(const ValidationReport& report, const OutputOptions& options) {
  return text_with_bytes(frame_json(report, options, {false, &report.typed}));
}

std::string validation_files_json(const ValidationReport& report) {
  std::string out = "[";
  for (const CheckedFile& file : report.files)
    append(out, out.size() > 1 ? "," : "", text_with_bytes(file_json(file, {false, &report.typed})));
  return out + ']';
}

std::string validation_json(const ValidationReport& report, const OutputOptions& options) {
  Json out = frame_json(report, options, {});
  if (report.shard) out["shard"] = shard_json(report);
  if (report.repairs) out["repairs"] = repairs_json(*report.repairs);
  out["files"] = Json::array();
  out["truncated"] = false;
  const std::string frame = text_of(out, report.shard != nullptr, "etak validate");
  const std::size_t end = frame.rfind(']');  // of the empty array
  std::string text = frame.substr(0, end);
  append_files(text, report);
  append(text, frame.substr(end), '\n');
  // Strings hold no quotes that are not escaped, so that the first such text is the member itself.
  if (report.shard) text.replace(text.find(seal) + seal.size(), no_digest().size(), sha256(text));
  return text;
}

}  // namespace etak
