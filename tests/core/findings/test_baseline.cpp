// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "core/findings/baseline.h"
#include "core/findings/output/formats.h"
#include "core/findings/suppress.h"
#include "tests/core/findings/sample_report.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

ValidationReport one_finding(const Finding& finding, int width = 1024, int height = 512) {
  CheckedFile file = checked_file(finding.file, {finding});
  file.width = width;
  file.height = height;
  return report_of({file}, {});
}

bool known_in(const Finding& before, const Finding& now, int width = 1024, int height = 512) {
  ValidationReport report = one_finding(now, width, height);
  mark_known(report, baseline_of(one_finding(before)));
  return report.files[0].findings[0].baseline;
}

AllowEntry allow(const std::string& rule, const std::string& file, const std::string& expires = {}) {
  return {rule, file, "", "", "a reason", expires};
}

// The report after the entries, with the ETK903 findings' messages.
struct Applied {
  ValidationReport report;
  std::vector<std::string> unused;
};
Applied apply(ValidationReport report, const std::vector<AllowEntry>& entries,
              const std::string& today = "2026-06-01", bool whole_tree = true) {
  apply_allowances(report, entries, {today, "etak.toml", Severity::warning, whole_tree, {}});
  Applied out{report_of(report.files, {}), {}};
  for (const CheckedFile& file : out.report.files)
    for (const Finding& finding : file.findings)
      if (finding.rule == "ETK903") out.unused.push_back(finding.message);
  return out;
}

}  // namespace

TEST_CASE("a baseline reads back as it was written") {
  const auto known = baseline_of(nasty_report());
  CHECK(read_baseline(baseline_json(known), "b.json").size() == known.size());
  const auto plain =
      baseline_of(one_finding(finding("ETK101", "a.png", Severity::error, PixelBox{3, 4, 50, 60})));
  CHECK(read_baseline(baseline_json(plain), "b.json") == plain);
  CHECK(read_baseline(baseline_json({}), "b.json").empty());
  CHECK(baseline_json(plain) == baseline_json(plain));
}

TEST_CASE("a broken baseline is refused with its place") {
  CHECK(contains(error_of([] { (void)read_baseline("{", "b.json"); }), "b.json"));
  CHECK(contains(error_of([] { (void)read_baseline("{\"schema\": \"x\", \"findings\": []}", "b.json"); }),
                 "#/schema"));
  CHECK(contains(
      error_of([] {
        (void)read_baseline(
            "{\"schema\": \"etak-baseline/1\", \"findings\": [{\"rule\": \"ETK101\", \"file\": \"a\", \"region\": [1, 2]}]}",
            "b.json");
      }),
      "#/findings/0/region"));
}

TEST_CASE("a re-export that keeps the defect stays known, also at another size; a new defect is new") {
  const Finding before = finding("ETK101", "a.png", Severity::error, PixelBox{300, 100, 90, 40});
  CHECK(known_in(before, before));
  Finding softer = before;
  softer.box = PixelBox{296, 97, 97, 45};
  CHECK(known_in(before, softer));
  Finding doubled = before;
  doubled.box = PixelBox{600, 200, 180, 80};
  CHECK(known_in(before, doubled, 2048, 1024));
  Finding elsewhere = before;
  elsewhere.box = PixelBox{800, 400, 90, 40};
  CHECK_FALSE(known_in(before, elsewhere));
  // One finding covers all regions of its rule, so a second defect makes the box grow.
  Finding grown = before;
  grown.box = PixelBox{300, 100, 600, 340};
  CHECK_FALSE(known_in(before, grown));
  Finding other_rule = before;
  other_rule.rule = "ETK103";
  CHECK_FALSE(known_in(before, other_rule));
  Finding other_file = before;
  other_file.file = "b.png";
  CHECK_FALSE(known_in(before, other_file));
  Finding tile = before;
  tile.tile = "hinge";
  CHECK_FALSE(known_in(before, tile));
  // A new layout moves a tile; its defect stays known.
  Finding moved_tile = tile;
  moved_tile.box = PixelBox{10, 400, 90, 40};
  CHECK(known_in(tile, moved_tile));
}

TEST_CASE("an unreadable file is never known and never allowed") {
  Finding broken = finding("ETK001", "a.png", Severity::error);
  CHECK(baseline_of(one_finding(broken)).empty());
  ValidationReport report = one_finding(broken);
  mark_known(report, std::vector<KnownDefect>{known_defect(broken, 0, 0)});
  CHECK_FALSE(report.files[0].findings[0].baseline);
  CHECK(apply(one_finding(broken), {allow("ETK", "")}).report.errors == 1);
}

TEST_CASE("globs: a star stays within a folder, two stars do not, names alone fit any folder") {
  CHECK(glob_matches("*_spec.*", "props/crate_spec.png"));
  CHECK(glob_matches("props/solar_*.png", "props/solar_1.png"));
  CHECK_FALSE(glob_matches("props/solar_*.png", "props/old/solar_1.png"));
  CHECK_FALSE(glob_matches("props/*", "props/old/solar_1.png"));
  CHECK(glob_matches("props/**", "props/old/solar_1.png"));
  CHECK(glob_matches("**/solar_?.png", "props/old/solar_1.png"));
  CHECK(glob_matches("**/solar.png", "solar.png"));
  CHECK_FALSE(glob_matches("solar.png", "solar.png2"));
  CHECK(glob_matches("a*b*c/x", "aXbYbZc/x"));
  CHECK_FALSE(glob_matches("a*b*c/x", "aXbYbZ/c/x"));
  CHECK_FALSE(glob_matches("?/x", "//x"));
  // Many stars take no more than polynomial time.
  CHECK_FALSE(glob_matches("**a**a**a**a**a**a**a**a**a**a**a**a**b/x", std::string(2000, 'a') + "/y"));
}

TEST_CASE("dates are checked") {
  CHECK(is_date("2027-01-01"));
  CHECK(is_date("2028-02-29"));
  for (const char* wrong :
       {"2027-02-29", "2027-13-01", "2027-00-01", "2027-01-32", "27-01-01", "2027/01/01", "", "tomorrow"})
    CHECK_FALSE(is_date(wrong));
}

TEST_CASE("an allow entry suppresses what it names until the day it expires, which is then told") {
  const ValidationReport report = one_finding(finding("ETK101", "props/solar_1.png", Severity::error));
  const auto entry = allow("ETK101", "props/solar_*.png", "2027-01-01");
  CHECK(apply(report, {entry}, "2026-12-31").report.passed);
  CHECK(apply(report, {entry}, "2026-12-31").unused.empty());
  const Applied late = apply(report, {entry}, "2027-01-01");
  CHECK_FALSE(late.report.passed);
  REQUIRE(late.unused.size() == 1);
  CHECK(contains(late.unused[0], "ended on 2027-01-01"));
  CHECK(apply(report, {allow("ETK1", "")}).report.files[0].findings[0].suppression == "a reason");
  CHECK_FALSE(apply(report, {allow("ETK2", "")}).report.passed);
}

TEST_CASE("an entry that suppresses nothing is told, unless its files were not looked at") {
  const ValidationReport report = one_finding(finding("ETK101", "a.png", Severity::error));
  CHECK(apply(report, {allow("ETK103", "a.png")}).unused.size() == 1);
  CHECK(apply(report, {allow("ETK103", "gone.png")}).unused.size() == 1);
  CHECK(apply(report, {allow("ETK103", "gone.png")}, "2026-06-01", false).unused.empty());
  // Two entries for one finding are both in use.
  CHECK(apply(report, {allow("ETK101", "a.png"), allow("ETK1", "")}).unused.empty());
  const Applied told = apply(report, {allow("ETK103", "a.png")});
  CHECK(told.report.warnings == 1);
  CHECK(count_files(told.report).files == count_files(report).files);
}
