// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/hash/sha256.h"
#include "core/base/text/text.h"
#include "core/findings/output/formats.h"
#include "core/pages/validation_page.h"
#include "tests/core/findings/sample_report.h"
#include "tests/core/pages/json_schema.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;
using Json = nlohmann::json;

namespace {

const OutputOptions options{Severity::error, "1.2.3"};

// A reader of RFC 4180, strict: CRLF ends a row, quotes only around whole fields.
std::vector<std::vector<std::string>> csv_rows(std::string_view text) {
  std::vector<std::vector<std::string>> rows(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& field = rows.back().back();
    const char c = text[i];
    if (quoted) {
      if (c == '"' && text.substr(i).starts_with("\"\""))
        field += text[++i];
      else if (c == '"')
        quoted = false;
      else
        field += c;
    } else if (c == '"') {
      REQUIRE(field.empty());
      quoted = true;
    } else if (c == ',') {
      rows.back().emplace_back();
    } else if (c == '\r') {
      REQUIRE(text[++i] == '\n');
      rows.push_back({""});
    } else {
      REQUIRE(c != '\n');
      field += c;
    }
  }
  REQUIRE_FALSE(quoted);
  REQUIRE(rows.back() == std::vector<std::string>{""});
  rows.pop_back();
  return rows;
}

// Well-formedness of the XML that validation_junit writes: tags nest, nothing is left unescaped.
void check_xml(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t at = text.find("?>") + 2; at < text.size();) {
    const std::size_t tag = std::min(text.find('<', at), text.size());
    const std::string between = text.substr(at, tag - at);
    for (std::size_t i = 0; i < between.size(); ++i)
      if (between[i] == '&') CHECK(between.find(';', i) < i + 7);
    if (tag == text.size()) break;
    const std::size_t end = text.find('>', tag);
    REQUIRE(end != text.npos);
    const std::string inside = text.substr(tag + 1, end - tag - 1);
    CHECK(inside.find('<') == inside.npos);
    CHECK(count_of(inside, "\"") % 2 == 0);
    if (inside.starts_with('/')) {
      REQUIRE_FALSE(open.empty());
      CHECK(open.back() == inside.substr(1));
      open.pop_back();
    } else if (!inside.ends_with('/')) {
      open.push_back(inside.substr(0, inside.find(' ')));
    }
    at = end + 1;
  }
  CHECK(open.empty());
}

}  // namespace

TEST_CASE("text names place, severity, rule, message, cause and fix, and ends with a clear verdict") {
  const std::string text = validation_text(nasty_report());
  CHECK(contains(
      text,
      "props/crate_spec.png:tile \"hinge, \"left\"\" [812,64 96x40] error ETK101 f0-forbidden-zone: F0 0.22 (byte 129, grey) on 2,914 px (0.07 %); matches plastic 0.04 sRGB-encoded twice. Fix: re-export "
      "specular without the second sRGB conversion.\n"));
  CHECK(contains(text, "wood.json#/datasets/0/n info ETK010 "));
  CHECK_FALSE(contains(text, "photovoltaic"));
  CHECK_FALSE(contains(text, "old.png"));
  CHECK(text.ends_with(
      "INCOMPLETE: 1 file could not be checked; 2 errors, 1 warning, 1 info in 5 files (4 clean), 1 allowed, 1 known from the baseline.\n"));
  CHECK(contains(validation_text(nasty_report(), {true}), "\x1b[1;31merror\x1b[0m"));
}

TEST_CASE("the text tells errors first, then places; infos of one rule share a line") {
  std::vector<CheckedFile> files;
  for (const char* path : {"a.png", "b.png"})
    files.push_back(checked_file(path, {finding("ETK010", path, Severity::info),
                                        finding("ETK101", path, Severity::error, PixelBox{9, 20, 4, 4}),
                                        finding("ETK101", path, Severity::error, PixelBox{30, 2, 4, 4}),
                                        finding("ETK103", path, Severity::warning)}));
  const ValidationReport report = report_of(files, {});
  const auto lines = [](const std::string& text) {
    std::string out;
    for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
      out += text.substr(at, text.find(": ", at) - at) + "; ";
    return out;
  };
  const std::string errors =
      "a.png [30,2 4x4] error ETK101 f0-forbidden-zone; a.png [9,20 4x4] error ETK101 f0-forbidden-zone; b.png [30,2 4x4] error ETK101 f0-forbidden-zone; b.png [9,20 4x4] error ETK101 f0-forbidden-zone; ";
  const std::string warnings = "a.png warning ETK103 f0-too-low; b.png warning ETK103 f0-too-low; ";
  CHECK(lines(validation_text(report)) ==
        errors + warnings + "a.png and 1 more in 2 files info ETK010 role-guessed; FAILED; ");
  CHECK(lines(validation_text(report, {.fold_infos = false})) ==
        errors + warnings + "a.png info ETK010 role-guessed; b.png info ETK010 role-guessed; FAILED; ");
  CHECK(lines(validation_text(report, {.least = Severity::warning})) == errors + warnings + "FAILED; ");
  CHECK(lines(validation_text(report, {.least = Severity::error})) == errors + "FAILED; ");
  CHECK(validation_text(report, {.findings = false}) == verdict_of(report) + "\n");
}

TEST_CASE("files are named as the user typed them") {
  TypedFolders typed{{"../../art/set", "/show/set"}, {"props", "game/props"}, {"here", ""}, {"tree", "t/"}};
  for (const auto& [label, shown] : {std::pair("../../art/set/a.png", "/show/set/a.png"),
                                     {"../../art/set/deep/a.png", "/show/set/deep/a.png"},
                                     {"props/a.png", "game/props/a.png"},
                                     {"here/a.png", "a.png"},
                                     {"tree/a.png", "t/a.png"},
                                     {"etak.toml", "etak.toml"},
                                     {"", ""},
                                     {"../elsewhere/a.png", "../elsewhere/a.png"}})
    CHECK(shown_path(label, typed) == shown);
  typed["."] = "game";
  CHECK(shown_path("etak.toml", typed) == "game/etak.toml");
  CHECK(shown_path("other/a.png", typed) == "game/other/a.png");
  CHECK(shown_path("../a.png", typed) == "../a.png");
}

TEST_CASE("what was not recognised is told in the verdict and in JSON") {
  ValidationReport report = report_of({checked_file("a.png")}, {});
  report.unknown = {"band.png", "odd\n.png"};
  CHECK(verdict_of(report) == "PASSED: 1 file, 0 findings, 2 pictures not recognised.");
  const Json json = Json::parse(validation_json(report, options));
  CHECK(JsonSchema(Json::parse(slurp(source_folder() + "/resources/schema/validation.schema.json")))
            .problem(json) == "");
  CHECK(json["summary"]["notRecognised"] == 2);
  CHECK(json["notRecognised"][0] == "band.png");
}

TEST_CASE("a message is one line of text whatever a file is called") {
  const std::string text = validation_text(nasty_report());
  CHECK(count_of(text, "\n") == 5);
}

TEST_CASE("the verdict of a clean run is yes") {
  CHECK(validation_text(report_of({checked_file("a.png"), checked_file("b.png")}, {})) ==
        "PASSED: 2 files, 0 findings.\n");
  Settings strict;
  strict.fail_on = Severity::warning;
  const std::vector<CheckedFile> warned{
      checked_file("a.png", {finding("ETK202", "a.png", Severity::warning)})};
  CHECK(verdict_of(report_of(warned, {})) == "PASSED: 1 warning in 1 file (0 clean).");
  CHECK(verdict_of(report_of(warned, strict)) == "FAILED: 1 warning in 1 file (0 clean).");
}

TEST_CASE("JSON is valid against its schema and says what is suppressed and why") {
  const JsonSchema schema(Json::parse(slurp(source_folder() + "/resources/schema/validation.schema.json")));
  for (const ValidationReport& report : {nasty_report(), report_of({}, {})}) {
    const Json json = Json::parse(validation_json(report, options));
    CHECK(schema.problem(json) == "");
  }
  const Json json = Json::parse(validation_json(nasty_report(), options));
  CHECK(json["summary"]["errors"] == 2);
  CHECK(json["summary"]["suppressed"] == 1);
  CHECK(json["summary"]["passed"] == false);
  std::map<std::string, Json> by_path;
  for (const Json& file : json["files"]) by_path[file["path"]] = file;
  CHECK(by_path["solar.png"]["findings"][0]["suppression"] == "photovoltaic panel");
  CHECK(by_path["props/crate_spec.png"]["findings"][0]["bbox"] == Json::array({812, 64, 96, 40}));
  CHECK(by_path["props/crate_spec.png"]["findings"][0]["value"]["byte"] == Json::array({129, 129, 129}));
  CHECK(by_path["broken.png"]["unreadable"] == true);
}

TEST_CASE("equal reports give equal bytes in every form") {
  for (int run = 0; run < 2; ++run) {
    CHECK(validation_text(nasty_report()) == validation_text(nasty_report()));
    CHECK(validation_json(nasty_report(), options) == validation_json(nasty_report(), options));
    CHECK(validation_sarif(nasty_report(), options) == validation_sarif(nasty_report(), options));
    CHECK(validation_csv(nasty_report()) == validation_csv(nasty_report()));
  }
}

TEST_CASE("SARIF holds the rule table, and every result points into it") {
  const Json sarif = Json::parse(validation_sarif(nasty_report(), options));
  CHECK(sarif["version"] == "2.1.0");
  REQUIRE(sarif["runs"].size() == 1);
  const Json& run = sarif["runs"][0];
  const Json& rule_rows = run["tool"]["driver"]["rules"];
  // No link that opens nowhere.
  CHECK_FALSE(run["tool"]["driver"].contains("informationUri"));
  CHECK_FALSE(rule_rows[0].contains("helpUri"));
  CHECK(rule_rows.size() == rules().size());
  const std::set<std::string> levels{"error", "warning", "note", "none"};
  for (const Json& rule : rule_rows) {
    CHECK_FALSE(rule["shortDescription"]["text"].get<std::string>().empty());
    CHECK_FALSE(rule["help"]["markdown"].get<std::string>().empty());
    CHECK(levels.contains(rule["defaultConfiguration"]["level"]));
  }
  CHECK(run["results"].size() == 6);
  std::size_t suppressed = 0, with_box = 0;
  for (const Json& result : run["results"]) {
    CHECK(rule_rows[result["ruleIndex"].get<std::size_t>()]["id"] == result["ruleId"]);
    CHECK(levels.contains(result["level"]));
    const Json& location = result["locations"][0]["physicalLocation"];
    CHECK(location["region"]["startLine"] == 1);
    const std::string uri = location["artifactLocation"]["uri"];
    CHECK(uri.find_first_of(" <>\"\n") == uri.npos);
    CHECK_FALSE(uri.starts_with("/"));
    CHECK(result["partialFingerprints"]["etakRegion/v1"].get<std::string>().size() == 16);
    suppressed += result.contains("suppressions") ? 1 : 0;
    if (!result.contains("attachments")) continue;
    ++with_box;
    const Json& box = result["attachments"][0]["rectangles"][0];
    CHECK(box["right"] > box["left"]);
    CHECK(box["bottom"] > box["top"]);
  }
  CHECK(suppressed == 2);
  CHECK(with_box == 3);
  CHECK(run["invocations"][0]["executionSuccessful"] == false);
}

TEST_CASE("SARIF stops at 5,000 results and says so, and drops what is suppressed first") {
  std::vector<CheckedFile> files;
  for (int i = 0; i < 5001; ++i) {
    const std::string path = "f" + std::to_string(i) + ".png";
    files.push_back(checked_file(path, {finding("ETK101", path, Severity::error)}));
    files.back().findings[0].suppressed = i == 0;
  }
  const Json run = Json::parse(validation_sarif(report_of(files, {}), options))["runs"][0];
  CHECK(run["results"].size() == most_sarif_results);
  for (const Json& result : run["results"]) REQUIRE_FALSE(result.contains("suppressions"));
  CHECK(contains(run["invocations"][0]["toolExecutionNotifications"][0]["message"]["text"].get<std::string>(),
                 "1 results more than 5,000 were left out"));
}

TEST_CASE("CSV is RFC 4180: every row has the header's fields, whatever the names hold") {
  const auto rows = csv_rows(validation_csv(nasty_report()));
  REQUIRE(rows.size() == 7);
  for (const auto& row : rows) CHECK(row.size() == rows[0].size());
  const std::size_t message = column(rows[0], "message"), tile = column(rows[0], "tile");
  std::set<std::string> tiles, messages;
  for (const auto& row : rows) {
    tiles.insert(row[tile]);
    messages.insert(row[message]);
  }
  CHECK(tiles.contains("hinge, \"left\""));
  CHECK(messages.contains("50 % <of> it & more,\\x0asecond line"));
}

TEST_CASE("JUnit is well-formed; errors are failures, unreadable files are errors, the rest is output") {
  const std::string xml = validation_junit(nasty_report(), options);
  check_xml(xml);
  CHECK(count_of(xml, "<testsuite ") == 7);
  CHECK(count_of(xml, "<failure ") == 1);
  CHECK(count_of(xml, "<error ") == 1);
  CHECK(contains(xml, "(allowed: photovoltaic panel)"));
  CHECK(count_of(validation_junit(nasty_report(), {Severity::info, "1"}), "<failure ") == 3);
}

TEST_CASE("JUnit has a case for the findings of every rule") {
  for (const Rule* rule : rules()) {
    INFO(rule->id);
    const std::string id(rule->id);
    const std::string xml = validation_junit(
        report_of({checked_file("a.png", {finding(id, "a.png", Severity::error)})}, {}), options);
    CHECK(count_of(xml, "<failure ") + count_of(xml, "<error ") == 1);
    CHECK(contains(xml, id + ' '));
  }
}

TEST_CASE("GitHub gets at most 10 annotations of a level and a sum of the rest") {
  std::vector<CheckedFile> files;
  for (int i = 0; i < 25; ++i) {
    const std::string path = "f" + std::to_string(i) + ".png";
    files.push_back(checked_file(path, {finding(i % 2 == 0 ? "ETK101" : "ETK106", path, Severity::error)}));
  }
  const std::string text = validation_github(report_of(files, {}));
  CHECK(count_of(text, "::error ") == 10);
  CHECK(contains(text, "15 more errors without annotation: ETK101 x "));
  const std::string nasty = validation_github(nasty_report());
  CHECK(contains(nasty, "::warning file=a b%2520%2C%3A\"<&>'%0A"));
  CHECK(contains(nasty, "50 %25 <of> it & more,%0Asecond line"));
  for (std::size_t at = nasty.find("::"); at < nasty.size(); at = nasty.find("\n::", at + 1))
    CHECK(nasty.find("::", at + 3) < nasty.find('\n', at + 1));
}

TEST_CASE("the fingerprint of a region survives small moves and tells other places and rules apart") {
  const Finding at = finding("ETK101", "a.png", Severity::error, PixelBox{300, 100, 90, 40});
  Finding moved = at;
  moved.box = PixelBox{303, 99, 88, 41};
  Finding far = at;
  far.box = PixelBox{900, 400, 90, 40};
  Finding other = at;
  other.rule = "ETK103";
  const std::string print = region_fingerprint(at, 1024, 512);
  CHECK(print == region_fingerprint(moved, 1024, 512));
  CHECK(print != region_fingerprint(far, 1024, 512));
  CHECK(print != region_fingerprint(other, 1024, 512));
}

TEST_CASE("the page works from disk: pictures inside, explanations inside, nothing from elsewhere") {
  const ValidationReport report = nasty_report();
  std::vector<ValidationPageFile> files(report.files.size());
  files[0].pictures = {{report.files[0].path, 1024, 512, {{1, 2, 3, 4}}, "png bytes", "heat bytes"}};
  files[0].f0.emplace();
  (*files[0].f0)[56] = 1000;
  (*files[0].f0)[150] = 3;
  const std::string page = validation_page(report, files, {"1.2.3", {}});
  CHECK(contains(page, "data:image/png;base64,cG5nIGJ5dGVz\""));
  CHECK_FALSE(contains(page, "http"));
  CHECK_FALSE(contains(page, "<script"));
  // Filters without a script, files that fold, heat maps that are off.
  for (const char* list : {"show-severity", "show-rule", "show-file"})
    CHECK(contains(page, "<select id=\"" + std::string(list) + "\">"));
  CHECK(contains(page, "option[value=\"error\"]:checked"));
  CHECK(contains(page, "<details open><summary><h3>"));
  CHECK_FALSE(contains(page, " checked>"));
  CHECK(contains(page, "0.30 % of 1,003 texels inside"));
  CHECK(contains(page, "hinge, &quot;left&quot;"));
  CHECK_FALSE(contains(page, "<of>"));
  CHECK(valid_utf8(page) == page);
  // Every link on the page leads somewhere on the page.
  for (std::size_t at = page.find("href=\"#"); at != page.npos; at = page.find("href=\"#", at + 1)) {
    const std::string name = page.substr(at + 7, page.find('"', at + 7) - at - 7);
    CHECK(contains(page, "id=\"" + name + "\""));
  }
}

TEST_CASE("SHA-256 gives the digests of FIPS 180-4, however the bytes are cut") {
  const auto digest = [](std::string_view text, std::size_t piece) {
    Sha256 hash;
    for (std::size_t at = 0; at < text.size(); at += piece) hash.add(text.substr(at, piece));
    return hash.finish();
  };
  CHECK(digest("", 1) == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(digest("abc", 1) == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  const std::string million(1000000, 'a');
  for (const std::size_t piece : {std::size_t{1}, std::size_t{63}, std::size_t{64}, std::size_t{1000000}})
    CHECK(digest(million, piece) == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  for (std::size_t size = 50; size < 70; ++size)
    CHECK(digest(million.substr(0, size), 7) == digest(million.substr(0, size), 100));
}
