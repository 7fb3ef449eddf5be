// SPDX-License-Identifier: Apache-2.0
#include "core/validate/rules.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>

#include "core/base/edit_distance.h"
#include "core/validate/rules/rows.h"

namespace etak {

namespace {

// In the order of ids; a rule is added by its file, its line in rules/rows.h and its line here.
constexpr const Rule* rows[] = {
    &etk001_unreadable,
    &etk002_missing_companion,
    &etk003_size_mismatch,
    &etk004_channel_layout,
    &etk005_lossy_format,
    &etk006_colourspace_metadata,
    &etk007_nan_inf,
    &etk008_negative,
    &etk009_npot,
    &etk010_role_guessed,
    &etk101_f0_forbidden_zone,
    &etk102_f0_transition,
    &etk103_f0_too_low,
    &etk104_f0_zero,
    &etk105_f0_gem_range,
    &etk106_dielectric_coloured,
    &etk107_f0_above_one,
    &etk108_metal_has_diffuse,
    &etk109_dielectric_black_diffuse,
    &etk110_f0_varies,
    &etk111_f0_not_in_database,
    &etk112_f0_wrong_material,
    &etk113_half_metal,
    &etk114_metal_too_dark,
    &etk201_energy_sum,
    &etk202_albedo_too_dark,
    &etk203_albedo_too_bright,
    &etk204_albedo_single_channel,
    &etk205_albedo_preset,
    &etk206_model_gains_energy,
    &etk301_gloss_constant,
    &etk302_gloss_clipped,
    &etk303_gloss_is_roughness,
    &etk304_gloss_steps,
    &etk401_specular_stored_linear,
    &etk402_specular_double_encoded,
    &etk403_transfer_unstated,
    &etk404_linear8_comb,
    &etk405_linear8_f0,
    &etk406_posterised,
    &etk407_albedo_stored_linear,
    &etk501_premultiplied,
    &etk502_alpha_fringe,
    &etk503_alpha_constant,
    &etk504_mip_bleed,
    &etk505_gutter_not_replicated,
    &etk506_tile_overlap,
    &etk507_duplicate_tile,
    &etk601_coverage,
    &etk602_sparse,
    &etk603_wavelength_order,
    &etk604_nk_range,
    &etk605_unit_suspect,
    &etk606_f0_recompute,
    &etk607_reference_missing,
    &etk608_dataset_spread,
    &etk609_class_mismatch,
    &etk610_flat_spectrum_grey,
    &etk611_schema,
    &etk901_internal_error,
    &etk902_rule_skipped,
    &etk903_unused_suppression,
    &etk904_unknown_rule,
};

std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out;
}

}  // namespace

std::span<const Rule* const> rules() {
  return rows;
}

std::string_view Rule::family() const {
  constexpr std::string_view families[] = {"Input",
                                           "Specular and F0",
                                           "Diffuse and energy",
                                           "Gloss",
                                           "Encoding and precision",
                                           "Alpha, mips and atlas",
                                           "Material and spectral data",
                                           "",
                                           "",
                                           "Tool"};
  return families[static_cast<std::size_t>(id[3] - '0')];
}

const Rule* find_rule(std::string_view id_or_slug) {
  const std::string id = upper(id_or_slug);
  for (const Rule* rule : rows)
    if (rule->id == id || rule->slug == id_or_slug) return rule;
  return nullptr;
}

std::vector<const Rule*> rules_with_prefix(std::string_view prefix) {
  if (const Rule* rule = find_rule(prefix)) return {rule};
  std::vector<const Rule*> found;
  const std::string id = upper(prefix);
  if (!id.starts_with("ETK")) return found;
  for (const Rule* rule : rows)
    if (rule->id.starts_with(id)) found.push_back(rule);
  return found;
}

std::vector<std::string_view> nearest_rules(std::string_view id, std::size_t count) {
  std::vector<const Rule*> sorted(std::begin(rows), std::end(rows));
  const auto distance = [&](const Rule* rule) {
    return std::min(edit_distance(id, rule->id), edit_distance(id, rule->slug));
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const Rule* a, const Rule* b) { return distance(a) < distance(b); });
  std::vector<std::string_view> nearest;
  for (std::size_t i = 0; i < std::min(count, sorted.size()); ++i) nearest.push_back(sorted[i]->id);
  return nearest;
}

}  // namespace etak
