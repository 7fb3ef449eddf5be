// SPDX-License-Identifier: Apache-2.0
// The JSON form, as resources/schema/validation.schema.json describes it.
#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>

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

Json names_json(const std::vector<std::string>& labels, const Reader& reader) {
  Json out = Json::array();
  for (const std::string& label : labels) out.push_back(reader.shown(label));
  return out;
}

// Writes the members of a struct as an object.
class JsonWriter {
 public:
  explicit JsonWriter(const Reader& reader) : reader_(reader) {}

  Json out = Json::object();

  template <class Value>
  void member(const char* name, const Value& value, Said said = Said::always) {
    const bool empty = value == Value();
    if (said == Said::in_shard && (!reader_.in_shard || (empty && std::is_same_v<Value, bool>))) return;
    if (said == Said::where_there && empty) return;
    out[name] = said == Said::or_null && empty ? Json(nullptr)
                : said == Said::as_label       ? label(value)
                                               : json(value);
  }
  template <class Act>
  void object(const char* name, bool there, Act act) {
    JsonWriter inner(reader_);
    if (there) act(inner);
    out[name] = there ? std::move(inner.out) : Json(nullptr);
  }

  template <class Value>
  Json json(const Value& value) const {
    if constexpr (std::is_class_v<Value> && !std::is_same_v<Value, std::string>) {
      JsonWriter inner(reader_);
      members(inner, value);
      return std::move(inner.out);
    } else {
      return value;
    }
  }
  Json json(Severity severity) const { return name(severity); }
  Json json(const PixelBox& box) const { return Json::array({box.x, box.y, box.width, box.height}); }
  // JSON has no form of infinity and NaN: they are null, and words for readers that know of them.
  Json json(double value) const {
    if (std::isfinite(value)) return value;
    if (!reader_.in_shard && reader_.typed == nullptr) return nullptr;
    return (std::signbit(value) ? "-" : "") + std::string(std::isnan(value) ? "nan" : "inf");
  }
  Json json(const std::vector<std::pair<std::string, std::int64_t>>& counts) const {
    Json all = Json::object();
    for (const auto& [name, count] : counts) all[name] = count;
    return all;
  }
  template <class Value>
  Json json(const std::optional<Value>& value) const {
    return value ? json(*value) : Json(nullptr);
  }
  template <class Value, std::size_t count>
  Json json(const std::array<Value, count>& values) const {
    return list(values);
  }
  template <class Value>
  Json json(const std::vector<Value>& values) const {
    return list(values);
  }
  // The finding with the members that only a program that has called is told.
  Json json(const Finding& finding) const {
    JsonWriter inner(reader_);
    members(inner, finding);
    if (reader_.typed != nullptr) {
      inner.out["place"] = place_of(finding, reader_.shown(finding.file));
      inner.out["sentence"] = sentence_of(finding);
    }
    return std::move(inner.out);
  }

 private:
  template <class Values>
  Json list(const Values& values) const {
    Json all = Json::array();
    for (const auto& value : values) all.push_back(json(value));
    return all;
  }
  Json label(const std::string& name) const { return reader_.shown(name); }
  Json label(const std::vector<std::string>& names) const { return names_json(names, reader_); }
  template <class Value>
  Json label(const Value& value) const {
    return json(value);
  }

  const Reader& reader_;
};

Json file_json(const CheckedFile& file, const Reader& reader) {
  return JsonWriter(reader).json(file);
}

// The member that holds the SHA-256 of a shard's document, with zeros while that is computed.
constexpr std::string_view seal = "\"sha256\": \"";
std::string no_digest() {
  return std::string(64, '0');
}

// The members that merged_report() needs besides the files. The first shard also holds what belongs to no group of files:
// folders as typed, and files that were not opened.
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
                {"minSeverity", verdict.min_severity}}}};
  out["allowances"] = JsonWriter({true}).json(shard.allowances);
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
