// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/picture.h"
#include "core/judge/finding.h"
#include "core/judge/pixels/evidence.h"
#include "core/judge/rule.h"
#include "core/judge/settings.h"
#include "core/judge/target.h"

namespace etak {

// The parts that checks of pictures (check_pictures.h) and of files are made of.

/// The needs of all rules that are not off, together.
Needs needs_of(const Settings& settings);

/// The needs of those rules that are not off and whose data the target may have.
Needs needs_of(const CheckTarget& target, const Settings& settings);

/// Reads the pixels, where some rule needs them. Adds tiles and the facts of float pictures to the evidence,
/// and size, counts, areas and times to `file`. evidence.a and .b are filled in from the pictures where they
/// are empty.
///   open   gives the pictures with what the rules need; called once for each pass over the pixels
void look_at_pixels(const CheckTarget& target, const std::function<PictureRows(Needs)>& open,
                    const Settings& settings, unsigned threads, Evidence& evidence, CheckedFile& file);

/// Runs the rules over the evidence and adds their findings to `file`, in the order of rules, tiles, boxes.
void judge(const CheckTarget& target, const Evidence& evidence, const Settings& settings, CheckedFile& file);

/// The names of CheckedFile::counts, in their order. Of a target without a specular picture only the first
/// `counts_without_specular` are there.
inline constexpr std::array<std::string_view, 10> count_names{"texels",
                                                              "opaque_px",
                                                              "alpha_zero_px",
                                                              "forbidden_any_channel_px",
                                                              "forbidden_all_channels_px",
                                                              "specular_black_px",
                                                              "metal_px",
                                                              "gloss_min",
                                                              "gloss_max",
                                                              "energy_over_px"};
inline constexpr std::size_t counts_without_specular = 3;

/// A CheckedFile with what is known before anything is opened: path, companions, roles.
CheckedFile checked_file_of(const CheckTarget& target);

/// The settings for one target: the transfer function that its manifest states replaces that of `settings`. For
/// pages that are judged with their scene, only the rules about layouts are on.
Settings settings_for(const CheckTarget& target, const Settings& settings);

/// Marks the texels that a rule on regions is about, in a picture of one channel: 0 the condition is not met,
/// 1 it is met, but not on a plateau (transition), 2 plateau.
Image8 region_picture(RegionKind kind, const Pictures& pictures, const CheckTarget& target,
                      const Settings& settings);

/// A colour of a picture of F0, in linear light, and the share of the texels whose plateaus have it.
struct FlatColor {
  std::array<double, 3> linear{};
  double share = 0;
};

/// The colours of a picture's plateaus (regions.h), of the largest 256; those within 3 codes of a larger one are one with it.
/// Largest first.
std::vector<FlatColor> flat_colors(std::unique_ptr<RowSource> picture, TextureTransfer transfer,
                                   unsigned threads);

}  // namespace etak
