// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <type_traits>

#include "core/base/json/node_json.h"
#include "core/findings/output/formats.h"
#include "core/findings/shards/report_shard.h"
#include "core/judge/engine.h"
#include "core/judge/rules.h"

namespace etak {
namespace {

constexpr int most_side = 1 << 24;  // of pictures and boxes; sums of some of them are still whole numbers

std::size_t whole(const JsonNode& node) {
  if (!node.value.is_number_unsigned()) node.fail_type("a whole number");
  return node.value.get<std::size_t>();
}

int side(const JsonNode& node) {
  return node.integer(0, most_side);
}

std::optional<Severity> least_severity_named(std::string_view text) {
  const auto severity = severity_named(text);
  return severity == Severity::off ? std::nullopt : severity;
}

Severity severity_at(const JsonNode& node) {
  return node.word(least_severity_named, "info, warning or error");
}

std::string digest(const JsonNode& node, std::size_t digits) {
  const std::string out = node.text();
  if (out.size() != digits || out.find_first_not_of("0123456789abcdef") != out.npos)
    node.fail_type(std::to_string(digits) + " hexadecimal digits");
  return out;
}

// A number that JSON may have no form of.
double exact_number(const JsonNode& node) {
  constexpr double inf = std::numeric_limits<double>::infinity(),
                   nan = std::numeric_limits<double>::quiet_NaN();
  if (!node.value.is_string()) return node.number();
  for (const auto& [text, value] : {std::pair{"inf", inf}, {"-inf", -inf}, {"nan", nan}, {"-nan", -nan}})
    if (node.text() == text) return text[0] == '-' ? std::copysign(value, -1.0) : value;
  node.fail_type("a number, inf, -inf, nan or -nan");
}

// Reads what output/json.cpp writes in a shard.
class JsonReader {
 public:
  explicit JsonReader(const JsonNode& node) : node_(node) {}

  template <class Value>
  void member(const char* name, Value& value, Said said = Said::always) {
    const bool may_miss =
        said == Said::where_there || (said == Said::in_shard && std::is_same_v<Value, bool>);
    if (may_miss && !node_.has(name)) return;
    if (said != Said::or_null || !node_.at(name).value.is_null()) read(node_.at(name), value);
  }
  template <class Act>
  void object(const char* name, bool, Act act) {
    const JsonNode at = node_.at(name);
    JsonReader inner(at);
    if (!at.value.is_null()) act(inner);
  }

  template <class Value>
  static void read(const JsonNode& node, Value& value) {
    JsonReader reader(node);
    members(reader, value);
    check(node, value);
  }
  static void read(const JsonNode& node, std::string& text) { text = node.text(); }
  static void read(const JsonNode& node, bool& value) { value = node.boolean(); }
  static void read(const JsonNode& node, int& value) { value = side(node); }
  static void read(const JsonNode& node, std::size_t& value) { value = whole(node); }
  static void read(const JsonNode& node, double& value) { value = exact_number(node); }
  static void read(const JsonNode& node, Severity& value) { value = severity_at(node); }
  static void read(const JsonNode& node, PixelBox& box) {
    std::array<int, 4> sides{};
    read(node, sides);
    box = {sides[0], sides[1], sides[2], sides[3]};
  }
  static void read(const JsonNode& node, std::vector<std::pair<std::string, std::int64_t>>& counts) {
    for (const std::string_view name : count_names)
      if (node.has(name)) counts.emplace_back(name, static_cast<std::int64_t>(whole(node.at(name))));
  }
  template <class Value>
  static void read(const JsonNode& node, std::optional<Value>& value) {
    if (!node.value.is_null()) read(node, value.emplace());
  }
  template <class Value, std::size_t count>
  static void read(const JsonNode& node, std::array<Value, count>& values) {
    values = node.each_of<count>(&read_one<Value>, std::to_string(count) + " values");
  }
  template <class Value>
  static void read(const JsonNode& node, std::vector<Value>& values) {
    values = node.each(&read_one<Value>);
  }
  template <class Value>
  static Value read_one(const JsonNode& node) {
    Value out{};
    read(node, out);
    return out;
  }

 private:
  // What the types of members do not say.
  template <class Value>
  static void check(const JsonNode&, const Value&) {}
  static void check(const JsonNode& node, const NearestMaterial&) { (void)node.at("bytes").number(); }
  static void check(const JsonNode& node, const FindingIsland& island) {
    if (island.uv) (void)node.at("uv").each(&JsonNode::number);
  }
  static void check(const JsonNode& node, const Finding& finding) {
    const Rule* const rule = find_rule(finding.rule);
    if (rule == nullptr) node.at("id").fail_type("the id of a rule");
    if (finding.slug != rule->slug) node.at("slug").fail_type(in_quotes(rule->slug));
    (void)node.at("areaShare").number();
    if (finding.uv) (void)node.at("uv").each(&JsonNode::number);
  }
  static void check(const JsonNode& node, const RoleOfFile& of) {
    if (of.role != "config" && !role_named(of.role) && !picture_role_named(of.role))
      node.at("role").fail_type("a role of a file");
  }
  static void check(const JsonNode& node, const CheckedFile& file) {
    if (!file.sha256.empty()) (void)digest(node.at("sha256"), 64);
  }

  const JsonNode& node_;
};

ReportShard read_member(const JsonNode& node, const JsonNode& settings) {
  ReportShard out;
  out.shard = {whole(node.at("index")), whole(node.at("count"))};
  if (!shard_named(out.shard.text())) node.at("index").fail_type("from 1 to count");
  out.groups = whole(node.at("items"));
  const std::size_t first = whole(node.at("first")), last = whole(node.at("last"));
  if (first > last || last > out.groups) node.at("last").fail_type("from first to items");
  out.shard.items.emplace(first, last);
  out.list = digest(node.at("list"), 32);
  out.options = digest(node.at("options"), 32);
  const JsonNode run = node.at("run"), verdict = node.at("verdict"), least = verdict.at("minSeverity");
  out.run.files = whole(run.at("files"));
  out.run.skipped = whole(run.at("skipped"));
  out.run.failed = whole(run.at("failed"));
  out.run.checks = whole(run.at("checks"));
  out.verdict.never_fails = verdict.at("never").boolean();
  out.verdict.exit_zero = verdict.at("exitZero").boolean();
  JsonReader::read(verdict.at("maxWarnings"), out.verdict.max_warnings);
  if (!least.text().empty()) out.verdict.min_severity = name(severity_at(least));
  out.settings.profile = settings.at("profile").word(profile_named, "default, strict, film or custom");
  out.settings.transfer = settings.at("transfer").word(texture_transfer_named, "srgb, power-2.2 or linear");
  out.settings.fail_on = severity_at(settings.at("failOn"));
  out.allowances = node.at("allowances").each(&JsonReader::read_one<AllowanceUse>);
  return out;
}

ValidationReport read_document(const JsonNode& root, std::string_view version) {
  if (!root.has("tool") || !root.has("shard"))
    throw Error::at(root.file, "is not the output of a shard",
                    "what etak validate --shard I/N --format json wrote");
  if (const std::string own = root.at("tool").at("version").text(); own != version)
    throw Error::at(root.file, "was written by etak " + printable(own),
                    "all shards of etak " + std::string(version));
  const JsonNode node = root.at("shard");
  const auto shard = std::make_shared<const ReportShard>(read_member(node, root.at("settings")));
  ValidationReport out =
      report_of(root.at("files").each(&JsonReader::read_one<CheckedFile>), shard->settings);
  out.settings_hash = digest(root.at("settings").at("hash"), 32);
  out.unknown = root.at("notRecognised").texts();
  if (node.has("notOpened")) out.not_opened = node.at("notOpened").texts();
  if (node.has("folders")) {
    const JsonNode folders = node.at("folders");
    folders.expect_object();
    for (const auto& [label, typed] : folders.value.items())
      out.typed.emplace(label, folders.at(label).text());
  }
  out.run = shard->run;
  out.nothing_checked = node.at("run").at("nothingChecked").boolean();
  out.incomplete = out.incomplete || out.nothing_checked;
  const auto& most = shard->verdict.max_warnings;
  out.passed = out.passed && !out.incomplete && !(most && out.warnings > *most);
  out.shard = shard;
  return out;
}

// The document of a shard. The library's own words on what is no JSON do not reach the message.
JsonDocument parsed(std::string_view text, const std::string& file) {
  constexpr int most_depth = 20;
  try {
    return parse_json_strictly(text, file, most_depth, "the output of a shard");
  } catch (const Error&) {
    std::size_t broken = text.size();
    try {
      [[maybe_unused]] const Json whole = Json::parse(text);
      throw;
    } catch (const Json::parse_error& place) {
      broken = std::min(broken, place.byte);
    } catch (const Json::exception&) {
      // A number beyond all doubles has no place in the library's error.
    }
    const std::string_view before = text.substr(0, broken);
    throw Error::at_line(file, 1 + static_cast<std::size_t>(std::ranges::count(before, '\n')),
                         "the JSON breaks off: damaged, or no output of a shard",
                         "what etak validate --shard I/N --format json wrote; run that shard again");
  }
}

// Throws Error with the first line in which a document is not what etak writes for its values.
void check_bytes(std::string_view text, std::string_view written, const std::string& file) {
  if (text == written) return;
  constexpr std::string_view seal = "\"sha256\": \"";
  const std::size_t at = written.find(seal);
  // The digest differs in any case, so the place is that of the first other difference.
  std::string unsealed(text);
  if (unsealed.size() >= at + seal.size() + 64)
    unsealed.replace(at, seal.size() + 64, written, at, seal.size() + 64);
  if (unsealed == written)
    throw Error::at(file + "#/shard/sha256", "is not the SHA-256 of this document",
                    "a shard as etak wrote it: this one is damaged or was changed; run it again");
  const auto same = std::ranges::mismatch(unsealed, written).in1 - unsealed.begin();
  const std::string_view before = std::string_view(unsealed).substr(0, static_cast<std::size_t>(same));
  const std::size_t line = before.rfind('\n') + 1,
                    lines = static_cast<std::size_t>(std::ranges::count(before, '\n'));
  const auto line_of = [&](std::string_view all) {
    std::string_view out = all.substr(std::min(line, all.size()));
    out.remove_prefix(std::min(out.find_first_not_of(' '), out.size()));
    return out.empty() ? "the end of the document" : printable(out.substr(0, out.find('\n')), 80);
  };
  throw Error::at_line(file, lines + 1, line_of(unsealed), line_of(written));
}

}  // namespace

ReadShard read_shard(std::string_view text, const std::string& file, std::string_view version) {
  ReadShard out{file, read_document({*parsed(text, file), file, {}}, version)};
  check_bytes(text, validation_json(out.report, {out.report.shard->settings.fail_on, std::string(version)}),
              file);
  return out;
}

}  // namespace etak
