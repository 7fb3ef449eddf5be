// SPDX-License-Identifier: Apache-2.0
#include "core/judge/pixels/plan.h"

#include <algorithm>
#include <cmath>

#include "core/judge/nearest.h"
#include "core/judge/rules.h"

namespace etak {

namespace {

bool is_on(std::string_view id, const Settings& settings) {
  return severity_of(*find_rule(id), settings) != Severity::off;
}

double value_of(std::string_view id, std::string_view parameter, const Settings& settings) {
  return parameter_of(*find_rule(id), parameter, settings);
}

// A parameter of a rule, in codes, as a limit of the byte tests.
std::uint8_t byte_of(double code, int least = 0) {
  return static_cast<std::uint8_t>(std::clamp(code, static_cast<double>(least), 254.0));
}

std::uint8_t level_of(const CodeTables& tables, std::uint32_t y) {
  return static_cast<std::uint8_t>(std::clamp(tables.first_code_at_least(y), 1, 255));
}

std::uint32_t grey(const CodeTables& tables, int code) {
  const auto c = static_cast<std::uint8_t>(std::clamp(code, 0, 255));
  return tables.red[c] + tables.green[c] + tables.blue[c];
}

std::uint64_t of_one(double value) {
  return static_cast<std::uint64_t>(std::llround(value * linear_one));
}

bool named_in_library(const CheckTarget& target, const Settings& settings) {
  const KnownMaterials& materials = known_materials(settings);
  const auto known = [&](const std::string& material) { return !materials.f0_of(material).empty(); };
  if (known(target.manifest.material)) return true;
  return std::ranges::any_of(target.manifest.tiles,
                             [&](const CheckTile& tile) { return known(tile.material); });
}

// Chooses the kinds of regions that some rule needs and that can be found in the pictures that are there.
void choose_kinds(const CheckTarget& target, const Settings& settings, PassPlan& plan) {
  // The encoding rules (401, 402) get their second look only where low, gem or zone regions make them likely.
  const bool encoding = is_on("ETK401", settings) || is_on("ETK402", settings);
  const bool named = named_in_library(target, settings);
  const auto want = [&](RegionKind kind, bool wanted) {
    if (wanted) plan.kinds.push_back(kind);
  };
  if (plan.has_b) {
    want(RegionKind::zone, is_on("ETK101", settings) || is_on("ETK102", settings) || encoding);
    want(RegionKind::f0_low, is_on("ETK103", settings) || encoding);
    want(RegionKind::f0_zero, is_on("ETK104", settings));
    want(RegionKind::gem, is_on("ETK105", settings) || encoding);
    want(RegionKind::coloured, is_on("ETK106", settings));
    want(RegionKind::blue_metal, is_on("ETK115", settings));
    want(RegionKind::any_f0,
         is_on("ETK111", settings) || (named && (is_on("ETK112", settings) || is_on("ETK403", settings))));
  }
  if (plan.has_a && plan.has_b) {
    // Diffuse under metal in a metal-rough set comes from metallic values below 1, which ETK113 judges.
    want(RegionKind::metal_with_diffuse, is_on("ETK108", settings) && !plan.has_metallic);
    want(RegionKind::black_diffuse, is_on("ETK109", settings) && !plan.transparency);
  }
  if (plan.has_metallic && plan.has_b) {
    want(RegionKind::half_metal, is_on("ETK113", settings));
    want(RegionKind::dark_metal, is_on("ETK114", settings));
  }
  if (plan.has_a) {
    want(RegionKind::albedo_dark, is_on("ETK202", settings));
    want(RegionKind::albedo_bright, is_on("ETK203", settings));
    want(RegionKind::albedo_single, is_on("ETK204", settings));
    plan.fringe = is_on("ETK502", settings);
  }
}

// The condition of ETK406 on a sample of rows, with wider limits, because the sample may lack codes.
bool seems_posterised(const Detail& detail, bool diffuse) {
  const std::uint64_t smooth = diffuse ? detail.smooth_a : detail.smooth_b;
  if (4 * smooth <= 3 * detail.texels) return false;
  const CodeSteps steps = code_steps((diffuse ? detail.a : detail.b)[1]);
  return steps.used >= 8 && 3 * steps.used < steps.last - steps.first + 1 &&
         steps.widest_step <= 4 * steps.median_step;
}

}  // namespace

PassPlan first_plan(const CheckTarget& target, const Settings& settings, bool has_a, bool has_b,
                    bool has_metallic, unsigned workers) {
  PassPlan plan;
  const CodeTables& tables = code_tables(settings.transfer);
  plan.tables = &tables;
  plan.zone = settings.zone;
  plan.zone.erode = settings.zone.erode <= 1 ? 1 : settings.zone.erode <= 3 ? 3 : 5;
  plan.has_a = has_a;
  plan.has_b = has_b;
  plan.has_metallic = has_metallic;
  plan.workers = std::clamp(workers, 1u, 8u);
  plan.transparency = settings.alpha_is_transparency || target.manifest.transparent;
  plan.specular_weighs = target.manifest.specular_weighs_diffuse;

  plan.b_y = {first_at_least(value_of("ETK103", "max_luminance", settings)),
              first_above(value_of("ETK105", "min_luminance", settings)),
              first_above(tables.moved(settings.zone.low, half_a_code)),
              first_at_least(tables.moved(settings.zone.high, -half_a_code))};
  plan.a_y = {grey(tables, byte_of(value_of("ETK202", "min_byte", settings), 1)),
              grey(tables, byte_of(value_of("ETK203", "max_byte", settings)) + 1)};
  ByteLimits& limits = plan.limits;
  for (std::size_t i = 0; i < ByteLimits::b_levels; ++i) limits.b_level[i] = level_of(tables, plan.b_y[i]);
  for (std::size_t i = 0; i < ByteLimits::a_levels; ++i) limits.a_level[i] = level_of(tables, plan.a_y[i]);
  limits.zone_first = limits.b_level[b_zone];
  limits.zone_last = static_cast<std::uint8_t>(std::max<int>(limits.zone_first, limits.b_level[b_metal] - 1));
  limits.spread = byte_of(value_of("ETK106", "spread_warning", settings));
  limits.bluish = byte_of(value_of("ETK115", "apart", settings));
  limits.metal_diffuse = byte_of(value_of("ETK108", "warning_byte", settings));
  limits.single_bright = static_cast<std::uint8_t>(level_of(tables, first_above(0.2)) - 1);
  plan.energy_limit = of_one(value_of("ETK201", "limit", settings));
  plan.energy_far_limit = of_one(value_of("ETK201", "far_limit", settings));

  choose_kinds(target, settings, plan);
  if (!target.manifest.tiles.empty()) {
    plan.check_gutter = is_on("ETK505", settings);
    plan.check_mips = is_on("ETK504", settings);
    plan.gutter = target.manifest.gutter;
    plan.mips =
        target.manifest.mips ? *target.manifest.mips : static_cast<int>(value_of("ETK504", "mips", settings));
    plan.hashes = is_on("ETK507", settings) && target.manifest.tiles.size() > 1;
    plan.frames = plan.check_gutter || plan.check_mips || plan.hashes;
  }
  return plan;
}

bool wants_every_row(const CheckTile& tile, const Settings& settings) {
  return (!tile.material.empty() && is_on("ETK110", settings)) ||
         (!tile.surface_class.empty() && is_on("ETK205", settings));
}

bool needs_second_look(const TileEvidence& tile, const PassPlan& plan, const Settings& settings,
                       bool has_gloss) {
  const ByteCounts& counts = tile.counts;
  const Detail& detail = tile.detail;
  const auto masked = [&](RegionKind kind) -> double {
    const PlateauSummary* found = tile.region(kind);
    return found == nullptr ? 0 : static_cast<double>(found->masked);
  };
  if (plan.has_b && tile.region(RegionKind::any_f0) == nullptr) {
    const double not_metal = static_cast<double>(counts.opaque - counts.metals);
    if (is_on("ETK401", settings) &&
        masked(RegionKind::f0_low) > 0.5 * (not_metal - masked(RegionKind::zone) - masked(RegionKind::gem)))
      return true;
    if (not_metal > 0 && is_on("ETK402", settings) &&
        masked(RegionKind::gem) + masked(RegionKind::zone) > 0.5 * not_metal)
      return true;
  }
  if (detail.every_row) return false;
  if (has_gloss && detail.opaque != 0 && is_on("ETK304", settings) &&
      counts.gloss_most - counts.gloss_least > 32 &&
      std::ranges::count_if(detail.b[3], [](std::uint32_t n) { return n != 0; }) <= 8)
    return true;
  if (is_on("ETK406", settings))
    for (const bool diffuse : {true, false})
      if ((diffuse ? plan.has_a : plan.has_b && !plan.has_metallic) && seems_posterised(detail, diffuse))
        return true;
  if (is_on("ETK404", settings))
    for (const bool diffuse : {true, false}) {
      if (diffuse ? !plan.has_a : (!plan.has_b || plan.has_metallic)) continue;
      const DarkValues dark = dark_values(diffuse ? detail.a : detail.b);
      if (dark.count >= 128 && dark.codes >= 8 && 100 * (dark.count - dark.in_comb) < dark.count) return true;
    }
  return false;
}

PassPlan second_plan(const PassPlan& first) {
  PassPlan plan = first;
  plan.kinds.clear();
  if (plan.has_b) plan.kinds.push_back(RegionKind::any_f0);
  plan.fringe = plan.hashes = plan.frames = false;
  plan.recorder = nullptr;
  return plan;
}

}  // namespace etak
