// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/findings/report.h"
#include "core/judge/rules.h"

namespace etak::test {

/// A finding of a rule of the table.
inline Finding finding(const std::string& rule, const std::string& file, Severity severity,
                       std::optional<PixelBox> box = {}) {
  Finding out = finding_of(*find_rule(rule), severity);
  out.file = file;
  out.box = box;
  if (box) {
    out.area_px = static_cast<std::size_t>(box->width) * static_cast<std::size_t>(box->height);
    out.area_share = 0.01;
  }
  out.message = "F0 0.22 (byte 129, grey) on 2,914 px (0.07 %)";
  out.value = "F0 0.22";
  out.limit = "0.20-0.45";
  out.fix = "re-export specular without the second sRGB conversion";
  return out;
}

inline CheckedFile checked_file(const std::string& path, std::vector<Finding> findings = {}) {
  CheckedFile out;
  out.path = path;
  out.width = 1024;
  out.height = 512;
  out.roles = {{path, "specular"}};
  out.findings = std::move(findings);
  return out;
}

/// Names that break careless writers, one finding of each level, one allowed, one known, and one unreadable
/// file.
inline ValidationReport nasty_report() {
  Finding tile = finding("ETK101", "props/crate_spec.png", Severity::error, PixelBox{812, 64, 96, 40});
  tile.tile = "hinge, \"left\"";
  tile.material = "plastic";
  tile.linear = {0.22, 0.22, 0.22};
  tile.byte = {129, 129, 129};
  tile.luminance = 0.22;
  tile.nearest = {{"silicon", "green-2008", 2.5}, {"gold", "johnson-1972", 40}};
  tile.cause = "matches plastic 0.04 sRGB-encoded twice";
  Finding odd = finding("ETK202", "a b%20,:\"<&>'\n\xff.png", Severity::warning);
  odd.message = "50 % <of> it & more,\nsecond line";
  Finding info = finding("ETK010", "wood.json", Severity::info);
  info.pointer = "/datasets/0/n";
  Finding allowed = finding("ETK101", "solar.png", Severity::error, PixelBox{0, 0, 8, 8});
  allowed.suppressed = true;
  allowed.suppression = "photovoltaic panel";
  Finding known = finding("ETK103", "old.png", Severity::warning, PixelBox{1, 2, 30, 40});
  known.baseline = true;
  CheckedFile broken = checked_file("broken.png", {finding("ETK001", "broken.png", Severity::error)});
  broken.unreadable = true;
  CheckedFile pair = checked_file("props/crate_spec.png", {tile});
  pair.companions = {"props/crate_diff.png"};
  return report_of(
      {checked_file("clean.png"), checked_file(odd.file, {odd}), checked_file("wood.json", {info}),
       checked_file("solar.png", {allowed}), checked_file("old.png", {known}), broken, pair},
      Settings{});
}

}  // namespace etak::test
