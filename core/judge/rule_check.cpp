// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rule_check.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/number.h"

namespace etak {

std::string in_thousands(std::size_t number) {
  std::string digits = std::to_string(number);
  for (auto i = static_cast<std::ptrdiff_t>(digits.size()) - 3; i > 0; i -= 3)
    digits.insert(static_cast<std::size_t>(i), ",");
  return digits;
}

std::string percent(double share) {
  return number(100 * share, 2 + (share >= 0.995)) + " %";
}

std::string area_text(std::size_t area, std::size_t of) {
  return in_thousands(area) + " px (" +
         percent(of == 0 ? 0 : static_cast<double>(area) / static_cast<double>(of)) + ")";
}

Finding finding_of(const Rule& rule, Severity severity, std::string file, std::string message) {
  Finding finding;
  finding.file = std::move(file);
  finding.message = std::move(message);
  finding.rule = rule.id;
  finding.slug = rule.slug;
  finding.severity = severity;
  finding.fix = rule.fix;
  finding.source = rule.source;
  return finding;
}

RuleCheck::RuleCheck(const Rule& rule, const CheckTarget& target_, const Settings& settings_,
                     const Evidence& evidence_, const CodeTables& tables_, std::vector<Finding>& findings)
    : target(target_),
      settings(settings_),
      evidence(evidence_),
      tables(tables_),
      rule_(rule),
      severity_(severity_of(rule, settings_)),
      findings_(findings) {
  const auto found = settings.rules.find(rule.id);
  fixed_severity_ = found != settings.rules.end() && found->second.severity.has_value();
}

double RuleCheck::parameter(std::string_view parameter_name) const {
  return parameter_of(rule_, parameter_name, settings);
}

Severity RuleCheck::at_least(Severity severity) const {
  return fixed_severity_ ? severity_ : std::max(severity, severity_);
}

Severity RuleCheck::at_most(Severity severity) const {
  return fixed_severity_ ? severity_ : std::min(severity, severity_);
}

std::span<const SpectralRows> RuleCheck::datasets() const {
  return evidence.material ? std::span<const SpectralRows>(evidence.material->datasets)
                           : std::span<const SpectralRows>();
}

std::vector<TilePlateaus> RuleCheck::regions(RegionKind kind) const {
  std::vector<TilePlateaus> out;
  for (const TileEvidence& tile : evidence.tiles)
    if (const PlateauSummary* found = tile.region(kind); found != nullptr && found->regions != 0)
      out.push_back({tile, *found});
  return out;
}

Finding& RuleCheck::report() {
  Finding& finding = findings_.emplace_back(finding_of(rule_, severity_));
  finding.file = target.own_label();
  finding.material = target.manifest.material;
  return finding;
}

Finding& RuleCheck::report(const SpectralRows& rows) {
  Finding& finding = report();
  finding.pointer = rows.pointer;
  return finding;
}

Finding& RuleCheck::report(const PictureEvidence& picture) {
  Finding& finding = report();
  finding.file = picture.label;
  return finding;
}

Finding& RuleCheck::report(const MapEvidence& map) {
  Finding& finding = report();
  finding.file = map.label;
  return finding;
}

Finding& RuleCheck::report(const TileEvidence& tile, FileRole role) {
  Finding& finding = report();
  finding.file = file_of(role);
  if (!tile.whole) {
    finding.tile = tile.tile.name;
    finding.box = tile.tile.box;
  }
  if (!tile.tile.material.empty()) finding.material = tile.tile.material;
  return finding;
}

Finding& RuleCheck::report(const TileEvidence& tile, const PlateauSummary& plateaus) {
  return report(tile, plateaus, plateaus.largest.front());
}

Finding& RuleCheck::report(const TileEvidence& tile, const PlateauSummary& plateaus, const Plateau& shown) {
  return report(tile, plateaus, shown, FileRole::specular_gloss);
}

Finding& RuleCheck::report_diffuse(const TileEvidence& tile, const PlateauSummary& plateaus) {
  return report(tile, plateaus, plateaus.largest.front(), FileRole::diffuse_alpha);
}

Finding& RuleCheck::report(const TileEvidence& tile, const PlateauSummary& plateaus, const Plateau& shown,
                           FileRole role) {
  const bool diffuse = role == FileRole::diffuse_alpha;
  Finding& finding = report(tile, role);
  finding.box = plateaus.box;
  finding.area_px = plateaus.area;
  finding.area_share = static_cast<double>(plateaus.area) /
                       static_cast<double>(std::max<std::uint64_t>(1, tile.counts.texels));
  const auto& linear = diffuse ? shown.diffuse : shown.specular;
  finding.linear = linear;
  finding.byte = bytes(linear);
  finding.luminance = luminance_of(linear);
  finding.value = (diffuse ? "albedo " : "F0 ") + colour(linear);
  finding.message = finding.value + " on " + area_text(plateaus.area, tile.counts.texels);
  if (plateaus.regions > 1) finding.message += " in " + in_thousands(plateaus.regions) + " regions";
  if (!diffuse) finding.nearest = nearest_materials(known_materials(settings), linear, settings.transfer);
  return finding;
}

std::array<int, 3> RuleCheck::bytes(const std::array<double, 3>& linear) const {
  return {tables.encode(linear[0]), tables.encode(linear[1]), tables.encode(linear[2])};
}

std::string RuleCheck::colour(const std::array<double, 3>& linear) const {
  const auto codes = bytes(linear);
  if (codes[0] == codes[1] && codes[1] == codes[2])
    return number(luminance_of(linear), 2) + " (byte " + std::to_string(codes[0]) + ", grey)";
  std::string text;
  for (const double c : linear) text += number(c, 2) + ' ';
  text += "(bytes";
  for (const int code : codes) text += ' ' + std::to_string(code);
  return text + ')';
}

std::string RuleCheck::file_of(FileRole role) const {
  const TargetFile* file =
      role == FileRole::diffuse_alpha || role == FileRole::base_color
          ? target.with_role({FileRole::diffuse_alpha, FileRole::base_color})
      : role == FileRole::specular_gloss || role == FileRole::f0_only
          ? target.with_role({FileRole::specular_gloss, FileRole::f0_only, FileRole::base_color})
          : target.with_role({role, FileRole::metallic});
  return file == nullptr ? target.own_label() : file->label;
}

bool RuleCheck::has_gloss() const {
  return evidence.b && (evidence.metal_rough || evidence.b->header.channels % 2 == 0);
}

bool RuleCheck::has_alpha() const {
  return evidence.a && evidence.a->header.channels % 2 == 0;
}

std::size_t RuleCheck::least_area(const TileEvidence& tile) const {
  return least_region(settings.zone, tile.counts.texels);
}

}  // namespace etak
