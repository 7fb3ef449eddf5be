// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

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

template <class Read>
auto maybe(const JsonNode& node, Read read) -> std::optional<decltype(read(node))> {
  if (node.value.is_null()) return std::nullopt;
  return read(node);
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

PixelBox read_box(const JsonNode& node) {
  const auto sides = node.each_of<4>(side, "4 values");
  return {sides[0], sides[1], sides[2], sides[3]};
}

UvBox read_uv(const JsonNode& node) {
  return node.each_of<4>(&JsonNode::number, "4 values");
}

FindingIsland read_island(const JsonNode& node) {
  FindingIsland out{node.at("tile").text(), maybe(node.at("bbox"), read_box), whole(node.at("areaPx"))};
  if (node.has("uv")) out.uv = read_uv(node.at("uv"));
  return out;
}

Finding read_finding(const JsonNode& node) {
  const Rule* const rule = find_rule(node.at("id").text());
  if (rule == nullptr) node.at("id").fail_type("the id of a rule");
  Finding out = finding_of(*rule, severity_at(node.at("severity")));
  for (const auto& [key, text] : {std::pair{"file", &out.file},
                                  {"message", &out.message},
                                  {"tile", &out.tile},
                                  {"material", &out.material},
                                  {"pointer", &out.pointer},
                                  {"found", &out.value},
                                  {"limit", &out.limit},
                                  {"cause", &out.cause},
                                  {"fix", &out.fix},
                                  {"source", &out.source},
                                  {"suppression", &out.suppression}})
    *text = node.at(key).text();
  out.box = maybe(node.at("bbox"), read_box);
  if (node.has("islands")) out.islands = node.at("islands").each(read_island);
  if (node.has("uv")) out.uv = read_uv(node.at("uv"));
  out.area_px = whole(node.at("areaPx"));
  out.area_share = node.at("areaShare").number();
  if (const JsonNode value = node.at("value"); !value.value.is_null()) {
    out.linear = maybe(value.at("linear"),
                       [](const JsonNode& rgb) { return rgb.each_of<3>(exact_number, "3 values"); });
    out.byte = maybe(value.at("byte"), [](const JsonNode& rgb) {
      return rgb.each_of<3>([](const JsonNode& code) { return code.integer(); }, "3 values");
    });
    out.luminance = maybe(value.at("Y"), exact_number);
  }
  out.nearest = node.at("nearest").each([](const JsonNode& near) {
    return NearestMaterial{near.at("name").text(), near.at("dataset").text(), near.at("bytes").number()};
  });
  out.suppressed = node.at("suppressed").boolean();
  out.baseline = node.at("baseline").boolean();
  return out;
}

CheckedFile read_checked(const JsonNode& node) {
  CheckedFile out;
  out.path = node.at("path").text();
  out.companions = node.at("companions").texts();
  out.sha256 = maybe(node.at("sha256"), [](const JsonNode& hash) { return digest(hash, 64); }).value_or("");
  out.width = side(node.at("width"));
  out.height = side(node.at("height"));
  out.unreadable = node.at("unreadable").boolean();
  out.roles = node.at("roles").each([](const JsonNode& row) {
    const std::string role = row.at("role").text();
    if (role != "config" && !role_named(role) && !picture_role_named(role))
      row.at("role").fail_type("a role of a file");
    return std::pair(row.at("file").text(), role);
  });
  out.findings = node.at("findings").each(read_finding);
  const JsonNode stats = node.at("stats"), counts = stats.at("counts");
  out.plateau_px = whole(stats.at("plateauPx"));
  out.transition_px = whole(stats.at("transitionPx"));
  for (const std::string_view name : count_names)
    if (counts.has(name)) out.counts.emplace_back(name, static_cast<std::int64_t>(whole(counts.at(name))));
  out.place = whole(node.at("place"));
  out.is_set = node.has("udim");
  return out;
}

AllowanceUse read_allowance(const JsonNode& node) {
  return {node.at("used").boolean(), node.at("met").boolean(), node.at("anyhow").boolean(),
          maybe(node.at("unused"), read_finding)};
}

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
  out.verdict.max_warnings = maybe(verdict.at("maxWarnings"), whole);
  if (!least.text().empty()) out.verdict.min_severity = name(severity_at(least));
  out.settings.profile = settings.at("profile").word(profile_named, "default, strict, film or custom");
  out.settings.transfer = settings.at("transfer").word(texture_transfer_named, "srgb, power-2.2 or linear");
  out.settings.fail_on = severity_at(settings.at("failOn"));
  out.allowances = node.at("allowances").each(read_allowance);
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
  ValidationReport out = report_of(root.at("files").each(read_checked), shard->settings);
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
