// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/validate/rule_check.h"

namespace etak {

/// The rows of the rule table, one per file of this folder.
extern const Rule etk001_unreadable;
extern const Rule etk002_missing_companion;
extern const Rule etk003_size_mismatch;
extern const Rule etk004_channel_layout;
extern const Rule etk005_lossy_format;
extern const Rule etk006_colourspace_metadata;
extern const Rule etk007_nan_inf;
extern const Rule etk008_negative;
extern const Rule etk009_npot;
extern const Rule etk010_role_guessed;
extern const Rule etk101_f0_forbidden_zone;
extern const Rule etk102_f0_transition;
extern const Rule etk103_f0_too_low;
extern const Rule etk104_f0_zero;
extern const Rule etk105_f0_gem_range;
extern const Rule etk106_dielectric_coloured;
extern const Rule etk107_f0_above_one;
extern const Rule etk108_metal_has_diffuse;
extern const Rule etk109_dielectric_black_diffuse;
extern const Rule etk110_f0_varies;
extern const Rule etk111_f0_not_in_database;
extern const Rule etk112_f0_wrong_material;
extern const Rule etk113_half_metal;
extern const Rule etk114_metal_too_dark;
extern const Rule etk201_energy_sum;
extern const Rule etk202_albedo_too_dark;
extern const Rule etk203_albedo_too_bright;
extern const Rule etk204_albedo_single_channel;
extern const Rule etk205_albedo_preset;
extern const Rule etk206_model_gains_energy;
extern const Rule etk301_gloss_constant;
extern const Rule etk302_gloss_clipped;
extern const Rule etk303_gloss_is_roughness;
extern const Rule etk304_gloss_steps;
extern const Rule etk401_specular_stored_linear;
extern const Rule etk402_specular_double_encoded;
extern const Rule etk403_transfer_unstated;
extern const Rule etk404_linear8_comb;
extern const Rule etk405_linear8_f0;
extern const Rule etk406_posterised;
extern const Rule etk407_albedo_stored_linear;
extern const Rule etk501_premultiplied;
extern const Rule etk502_alpha_fringe;
extern const Rule etk503_alpha_constant;
extern const Rule etk504_mip_bleed;
extern const Rule etk505_gutter_not_replicated;
extern const Rule etk506_tile_overlap;
extern const Rule etk507_duplicate_tile;
extern const Rule etk601_coverage;
extern const Rule etk602_sparse;
extern const Rule etk603_wavelength_order;
extern const Rule etk604_nk_range;
extern const Rule etk605_unit_suspect;
extern const Rule etk606_f0_recompute;
extern const Rule etk607_reference_missing;
extern const Rule etk608_dataset_spread;
extern const Rule etk609_class_mismatch;
extern const Rule etk610_flat_spectrum_grey;
extern const Rule etk611_schema;
extern const Rule etk901_internal_error;
extern const Rule etk902_rule_skipped;
extern const Rule etk903_unused_suppression;
extern const Rule etk904_unknown_rule;

}  // namespace etak
