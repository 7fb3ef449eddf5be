// SPDX-License-Identifier: Apache-2.0
#include "core/light/rows.h"

namespace etak {
namespace {

constexpr std::string_view ambient = "light/ambient.glsl", area = "light/area.glsl",
                           clear_ball = "light/clear_ball.glsl", false_color = "light/false_color.glsl",
                           lights = "light/lights.glsl", hemispheres = "light/hemispheres.glsl",
                           tone = "light/tone.glsl", transfer = "light/transfer.glsl",
                           transparency = "light/transparency.glsl";
using Kind = LightRowKind;

constexpr LightRow rows[] = {
    {"point", "point light", "TU Graz; Schueler 2009", Kind::light, "position, color, intensity (W/sr)",
     lights, "point_irradiance", "E = I / r^2, r at least 0.001"},
    {"directional", "directional light", "TU Graz; Schueler 2009", Kind::light,
     "direction, color, intensity (W/m^2)", "", "", "E the same everywhere"},
    {"spot", "spot light", "TU Graz (named, no formula)", Kind::light,
     "position, direction, color, intensity (W/sr), inner_deg, outer_deg", lights, "spot_share",
     "smoothstep in the cosine between the cones, a step where they are equal"},
    {"rectangle", "rectangular light", "Heitz, Dupuy, Hill and Neubelt 2016; TU Graz (named)", Kind::light,
     "position, direction, up, width, height, color, intensity (W/(m^2 sr))", area, "area_specular",
     "linearly transformed cosines, set right by the model at one direction for each piece"},
    {"disc", "disc or ellipse as a light", "Heitz, Dupuy, Hill and Neubelt 2016", Kind::light,
     "position, direction, up, width, height, color, intensity (W/(m^2 sr))", area, "area_specular",
     "a polygon of 16 sides and the same area"},
    {"hemispheres-diffuse", "two hemispheres, diffuse", "Schueler 2009", Kind::hemispheres,
     "upper, lower (radiance), axis", hemispheres, "hemisphere_diffuse", "exact for Lambert"},
    {"hemispheres-specular", "two hemispheres, specular, corrected",
     "Schueler 2009, S1 to S3 of MODELS.md mended", Kind::hemispheres, "upper, lower (radiance), axis; K, g",
     hemispheres, "hemisphere_specular",
     "default of Schueler's models; uniform-field error up to 0.22 for g >= 0.25; transition of width 1 - g"},
    {"hemispheres-specular-model", "two hemispheres, specular, by the model",
     "etak: albedo and lobe of the model", Kind::hemispheres, "upper, lower (radiance), axis", ambient,
     "probe_share", "of any model: its own albedo, and the share that its lobe has of each", true},
    {"hemispheres-specular-wide", "two hemispheres, specular, wide transition",
     "etak: width min(1, 1.8 2^(-6 g))", Kind::hemispheres, "upper, lower (radiance), axis; K, g",
     hemispheres, "hemisphere_specular_wide",
     "never a step; rms error of the share 0.065 at g = 0.75 (0.13 corrected)"},
    {"hemispheres-specular-printed", "two hemispheres, specular, as printed", "Schueler 2009, as printed",
     Kind::hemispheres, "upper, lower (radiance), axis; K, g", hemispheres, "hemisphere_specular_printed",
     "negative below the horizon, F too high by up to 0.98 on rough surfaces"},
    {"environment", "lat-long image", "Schueler 2009, possible extensions", Kind::environment, "file, scale",
     "", "",
     "irradiance times the body's albedo; albedo of the model times round lobes that stand for its own: errors in ambient_error"},
    {"plain", "no tone curve", "", Kind::tone, "", "", "",
     "18 % grey is code 118; what is above 1 is clipped", true},
    {"neutral", "Khronos PBR Neutral", "Khronos 2024, PBR Neutral Tone Mapper", Kind::tone, "", tone,
     "tone_neutral",
     "18 % grey is code 105; colours below 0.76 stay, less the 0.04 of a dielectric's surface"},
    {"agx-like", "a curve like AgX", "etak, after Sobotka 2022", Kind::tone, "", tone, "tone_agx_like",
     "18 % grey is code 118; white 6.5 stops above it, bright colours fade to white"},
    {"filament", "ACES as Filament fits it", "Filament, ToneMapper.cpp, ACESLegacy", Kind::tone, "", tone,
     "tone_filament",
     "18 % grey is codes 128, 129, 129: the white point is not adapted, so that greys are warm"},
    {"false-color", "false colours of exposure", "etak", Kind::tone, "", false_color, "tone_false_color",
     "a colour for each band of stops about 18 % grey, which is green; red is above 1"},
    {"srgb", "exact sRGB curve", "IEC 61966-2-1", Kind::transfer, "", transfer, "srgb_encode",
     "all 256 codes come back", true},
    {"power-2.2", "powers 2.2 in, 1/2.2 out", "", Kind::transfer, "", transfer, "power22_encode",
     "all 256 codes come back; +8.5 codes against sRGB"},
    {"power-0.45", "powers 2.2 in, 0.45 out", "Schueler 2009", Kind::transfer, "", transfer,
     "power045_encode", "not an inverse: 179 of 256 codes move by one; +9.0 codes against sRGB"},
    {"sqrt", "square in, square root out", "Schueler 2009, 2.0", Kind::transfer, "", transfer, "root_encode",
     "-9.5 codes against sRGB"},
    {"linear", "no encoding (HDR)", "Schueler 2009", Kind::transfer, "", "", "", ""},
    {"fresnel-opacity", "transparency by Fresnel", "Schueler 2009, possible extensions", Kind::transparency,
     "alpha (opacity of the body), K", transparency, "fresnel_opacity",
     "1 - (1 - alpha)(1 - F(nv)); specular is never multiplied by alpha", true},
    {"clear-ball", "clear ball in an environment", "Snell, Fresnel, Beer", Kind::transparency,
     "n, share of light that passes a diameter", clear_ball, "through_ball",
     "bent where it enters and where it leaves; reflections inside are left out (0.2 % at n = 1.5)"},
};

}  // namespace

std::string_view name(LightRowKind kind) {
  constexpr std::string_view names[] = {"light", "hemispheres", "environment",
                                        "tone",  "transfer",    "transparency"};
  return names[static_cast<int>(kind)];
}

std::span<const LightRow> light_rows() {
  return rows;
}

}  // namespace etak
