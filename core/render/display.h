// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "core/image/image.h"
#include "core/render/scene.h"

namespace etak {

std::string_view name(Transfer transfer);  // "srgb", "power-2.2", "power-0.45", "sqrt", "linear"
std::optional<Transfer> transfer_named(std::string_view text);

std::string_view name(Tone tone);  // "plain", "neutral", "agx-like", "filament", "false-color"
std::optional<Tone> tone_named(std::string_view text);

/// What a display is to emit of a pixel, linear: the tone curve of exposure x value, not clamped.
///   pixel   three channels
Vec3 toned(const float* pixel, double exposure, Tone tone);

/// The 8-bit codes of the first three channels of `picture`: the transfer curve of the tone curve of exposure x
/// value, clamped to [0, 1] and rounded to nearest. For sRGB without a tone curve they are the codes of
/// srgb_u8() (core/color/srgb.h). NaN gives code 0.
Image8 to_codes(const Image& picture, double exposure, Transfer transfer, Tone tone = Tone::plain);

/// The codes of a row of pixels with four channels each.
///   codes   room for three codes for each pixel
void to_codes(std::span<const float> pixels, double exposure, Transfer transfer, Tone tone,
              std::uint8_t* codes);

/// The first three channels of `picture`, multiplied by the exposure.
Image exposed(const Image& picture, double exposure);

/// A picture without what is behind its object: linear radiance multiplied by the opacity, which is the fourth channel.
///   drawn         draws the object over an even background, with its coverage as fourth channel
///   see_through   some of the background is seen through the object, too: it is drawn over black and over white, and what
///                 differs is what goes through. Else it is drawn once
Image cut_out(const std::function<Image(const Vec3& background)>& drawn, bool see_through);

/// The picture of cut_out() as colours that are not multiplied by the opacity, as PNG files hold them.
Image unmultiplied(Image picture);

/// Codes with the fourth channel of `picture` as their fourth one, without a curve.
///   codes   three channels, of the same size
Image8 with_opacity(const Image8& codes, const Image& picture);

}  // namespace etak
