// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/material/material.h"
#include "core/study/choose/texture_filter.h"
#include "core/study/fresnel_forms.h"

namespace etak {

// The cheapest way to draw a material that stays within a budget of error, found by measuring, not by a table
// of materials: only what things cost comes from a table, so that the choice is the same on every machine.

/// What a Fresnel form, a visibility term, a quadrature, a texture filter or a compression level costs: ns
/// per evaluation (per texel read or written), from `etak report` on the machine that the header names.
struct CostTable {
  std::string header;
  // "fresnel/f82", "visibility/smith-ggx-height", "quadrature/1nm", "filter/bilinear", "png/fast"
  std::map<std::string, double, std::less<>> ns;
  double of(std::string_view id) const;  // Throws Error where it is missing
};

/// The table in resources/costs.json, kept in the program.
const CostTable& shipped_costs();
CostTable parse_costs(std::string_view text, std::string_view file);
std::string format_costs(const CostTable& costs);

/// Times everything here and now, in a minute: of each row the least time of 200 repeats that are spread
/// over the whole run, which is the time without what else the machine does. Two runs on a calm machine agree
/// within 15 % in nearly all rows. In target etak::study_run.
CostTable measure_costs(std::string_view header,
                        const std::function<void(std::size_t done, std::size_t all)>& progress = {});

/// What differences are measured in: CIEDE2000 (D65), or 8-bit sRGB codes of the worst channel.
enum class ErrorUnit { delta_e, codes };
std::string_view name(ErrorUnit unit);  // "ΔE2000", "codes"
double difference(ErrorUnit unit, const Vec3& linear_a, const Vec3& linear_b);

/// What to choose for: a surface of one texel, or of a texture pair.
struct ChooseSubject {
  std::string name;     // of the material, in its scene or in the library
  std::string library;  // "gold/johnson_1972": its spectrum is known; empty: F0 is known as a colour alone
  std::optional<Dataset> dataset;  // of `library`
  SurfaceTexel texel;              // where there is no texture; f0 is not read where `dataset` is there
  std::shared_ptr<const TexelChain> texture;
  bool mipmaps = true;  // its sampler reads mips

  bool textured() const { return texture && !texture->constant(); }
};
ChooseSubject library_subject(const Material& material, const Dataset& dataset, const Gloss& gloss);
/// Width of the lobe of a texel: the narrowest that the models take is 1e-4.
double lobe_alpha(const SurfaceTexel& texel);

/// A candidate that was looked at, in the order of its cost.
struct Candidate {
  std::string id, title;
  double cost_ns = 0;
  double error = 0;  // largest, in the unit of the budget
  bool within = false;
};

struct Choice {
  std::string material, library;
  double budget = 0;
  ErrorUnit unit = ErrorUnit::delta_e;
  bool met = true;  // false: no form of F stays within the budget; the closest was taken
  const FresnelForm* fresnel = nullptr;
  FresnelValues values{};
  std::string visibility;  // term of the registry
  std::string method;      // spectral integration of F0; empty: no spectrum
  TextureFilter filter = TextureFilter::constant;
  std::string model;                 // "microfacet:ggx,f82,smith-ggx-height"
  std::vector<double> model_values;  // of one texel: the mean where the material has a texture
  double alpha = 0;
  SurfaceTexel texel;                               // that one
  std::array<std::uint8_t, channel_count> codes{};  // the same as a texture pair holds it
  bool textured = false;
  double fresnel_error = 0;  // over all angles, of every F0 looked at
  double picture_error = 0;  // of the worst pixel: everything against all that was chosen together
  double picture_mean = 0;
  std::size_t pixels = 0;                               // compared
  double method_error = 0;                              // of F0
  double everything_ns = 0, chosen_ns = 0;              // Fresnel, visibility, filter: per evaluation
  double everything_solve_ns = 0, chosen_solve_ns = 0;  // per spectrum
  std::vector<Candidate> fresnel_candidates, visibility_candidates, filter_candidates, method_candidates;
  std::vector<std::string> defines;  // of the specialised shader: shading_defines() in core/atlas/variant.h
};

struct ChooseOptions {
  double budget = 1;
  ErrorUnit unit = ErrorUnit::delta_e;
};

/// "Everything" is: F at every nanometre where the spectrum is known, else per channel exact from F0 below
/// the forbidden zone and Schlick's form above, because a colour says no more of a metal; a GGX lobe with
/// height-correlated Smith masking; trilinear filtering; F0 by the exact quadrature. The budget holds for F
/// at any angle and for every pixel of rendered spheres (of textures: at levels of detail from twice
/// magnified to eight mips down), for all that was chosen together.
/// Throws Error for data without a colour or without n and k. Where no form of F stays within the budget, the
/// closest one is chosen and `met` says so; the rest is then chosen within what that one misses.
Choice choose(const ChooseSubject& subject, const ChooseOptions& options, const CostTable& costs);

/// The largest error of all that was chosen together: at any angle or in any pixel. Of a choice that is not
/// `met`, the least that can be reached.
double largest_error(const Choice& choice);
/// Of a choice that is not `met`: what is the least that can be reached, and what is exact.
std::string unmet_remark(const Choice& choice);

/// Levels of compression are lossless: the cheapest in time is taken, errors are 0.
std::vector<Candidate> png_levels(const CostTable& costs);

}  // namespace etak
