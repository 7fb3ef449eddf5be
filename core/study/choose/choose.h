// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/iridescence/parameters.h"
#include "core/material/material.h"
#include "core/study/choose/texture_filter.h"
#include "core/study/fresnel_forms.h"

namespace etak {

// Finds the cheapest way to draw a material within a budget of error. The errors are measured for the
// material itself. The costs come from a table, so that the choice is the same on every machine.

/// The costs of Fresnel forms, visibility terms, quadratures, texture filters and compression levels: ns per
/// evaluation (per texel read or written), measured by measure_costs() on the machine that the header names.
struct CostTable {
  std::string header;
  // "fresnel/f82", "visibility/smith-ggx-height", "quadrature/1nm", "filter/bilinear", "png/fast"
  std::map<std::string, double, std::less<>> ns;
  double of(std::string_view id) const;  // in ns; throws Error for an id that the table lacks
};

/// The table in resources/costs.json, which is built into the program.
const CostTable& shipped_costs();
/// Reads a table as JSON (etak-costs/1), and writes one. Throws Error with `file` and JSON pointer.
CostTable parse_costs(std::string_view text, std::string_view file);
std::string format_costs(const CostTable& costs);

/// Measures all costs on this machine, in about a minute: for each the shortest of 200 repeats that are
/// spread over the whole run, because that repeat was disturbed least by other programs. Two runs on a calm
/// machine agree within 15 % in nearly all rows. In target etak::study_run.
CostTable measure_costs(std::string_view header,
                        const std::function<void(std::size_t done, std::size_t all)>& progress = {});

/// The unit of errors: CIEDE2000 (D65), or 8-bit sRGB codes of the worst channel.
enum class ErrorUnit { delta_e, codes };
std::string_view name(ErrorUnit unit);  // "ΔE2000", "codes"
/// The difference of two colours in linear sRGB.
double difference(ErrorUnit unit, const Vec3& linear_a, const Vec3& linear_b);

/// A material to choose for: a surface of one texel, or of a texture pair.
struct ChooseSubject {
  std::string name;     // of the material, in its scene or in the library
  std::string library;  // "gold/johnson_1972", or layers: its spectrum is known; empty: only F0's colour
  std::optional<Dataset> dataset;   // that `library` names: n and k, or a stack of layers
  FilmBase base = FilmBase::metal;  // of a stack
  SurfaceTexel texel;               // where there is no texture; with a `dataset` its f0 is ignored
  std::shared_ptr<const TexelChain> texture;
  bool mipmaps = true;  // the texture's sampler reads mips

  bool textured() const { return texture && !texture->constant(); }
  const Stack* stack() const { return dataset ? std::get_if<Stack>(&dataset->optics) : nullptr; }
};
/// A material of the library without textures. Throws Error for reflectance at normal incidence alone.
ChooseSubject library_subject(const Material& material, const Dataset& dataset, const Gloss& gloss);
/// A material of the library with the given gloss, else with the default gloss of its class.
///   remarks   gets what is to be said of the gloss
ChooseSubject library_subject(const Material& material, const Dataset& dataset,
                              const std::optional<Gloss>& given, std::vector<std::string>& remarks);
/// Width alpha of the lobe of a texel, at least 1e-4, the narrowest that the models take.
double lobe_alpha(const SurfaceTexel& texel);

/// A candidate that was tried. Lists of candidates are in the order of cost.
struct Candidate {
  std::string id, title;
  double cost_ns = 0;
  double error = 0;     // largest, in the unit of the budget
  bool within = false;  // the error is within the limit of its step
};

/// The result of choose().
struct Choice {
  std::string material, library;
  double budget = 0;
  ErrorUnit unit = ErrorUnit::delta_e;
  bool met = true;  // false: no form of F stays within the budget; the closest was taken
  const FresnelForm* fresnel = nullptr;
  FresnelValues values{};  // numbers of `fresnel`
  std::string visibility;  // term of the registry
  std::string method;      // spectral integration of F0; empty: no spectrum
  TextureFilter filter = TextureFilter::constant;
  std::string model;         // "microfacet:ggx,f82,smith-ggx-height"
  bool whole_model = false;  // `model` is one of models(), and has no part of `fresnel` and `visibility`
  std::vector<double> model_values;  // of one texel: the mean where the material has a texture
  double alpha = 0;
  SurfaceTexel texel;                               // the texel that model_values are of
  std::array<std::uint8_t, channel_count> codes{};  // that texel as a texture pair holds it
  bool textured = false;
  int textures = 0;          // of the pair, those that are not one colour: the only ones that have to be read
  double fresnel_error = 0;  // the largest over all angles and every F0 that was judged
  double picture_error = 0;  // of the worst pixel, with all choices together against "everything"
  double picture_mean = 0;
  std::size_t pixels = 0;                               // that were compared
  double method_error = 0;                              // of F0
  double everything_ns = 0, chosen_ns = 0;              // Fresnel, visibility and filter, for one evaluation
  double everything_solve_ns = 0, chosen_solve_ns = 0;  // F0, for one spectrum
  std::vector<Candidate> fresnel_candidates, visibility_candidates, filter_candidates, method_candidates;
  std::vector<Candidate>
      model_candidates;  // whole models that are cheaper than the chosen form of F and masking
  std::vector<Candidate>
      film_candidates;  // of a stack: films as renderers have them, which take the place of all this
  std::vector<std::string> defines;  // of the specialised shader: shading_defines() in core/atlas/variant.h
};

/// The budget of error.
struct ChooseOptions {
  double budget = 1;
  ErrorUnit unit = ErrorUnit::delta_e;
};
/// Throws Error that names the setting, unless the budget is a finite number of at least 0.
void validate(const ChooseOptions& options);

/// Chooses the cheapest form of F, visibility term, texture filter and quadrature. They are compared with
/// "everything": F at every nanometre where the spectrum is known, else for each channel the exact F of F0
/// below the forbidden zone and Schlick's form above it, because a colour tells no more of a metal; a GGX
/// lobe with height-correlated Smith masking; trilinear filtering; F0 by the exact quadrature. The budget
/// holds for all choices together, for F at any angle and for every pixel of rendered spheres (of textures:
/// at levels of detail from twice magnified to eight mips down). The errors that the choices have alone are
/// added, so that none is taken because it makes up for another. Everything reads both textures of a pair; a
/// texture of one colour need not be read. In the end the whole models that take F0 and one width are tried in the
/// place of GGX, F and masking: Schueler's techniques, and lobes of other distributions; their F is judged at any
/// angle too, but where it is hidden in the lobe (Optimized). Throws Error for data without a colour or
/// without n and k. Where no form of F stays within the budget, the closest one is chosen and `met` is false;
/// the other choices then stay within the error of that form.
/// Of a stack of layers F over the angle is a curve of colours, F82 or another form that F0 and F82 tell; beside them are
/// the films of renderers (core/iridescence), each with the numbers that its advice names.
Choice choose(const ChooseSubject& subject, const ChooseOptions& options, const CostTable& costs);

/// The choices for subjects, which do not depend on each other, on `threads` threads. Where several fail, the
/// error of the first in their order is thrown.
///   chosen   told of every choice, by the worker that made it
std::vector<Choice> choose_each(std::span<const ChooseSubject> subjects, const ChooseOptions& options,
                                const CostTable& costs, unsigned threads,
                                const std::function<void(unsigned worker)>& chosen = {});

/// The largest error of all choices together, at any angle or in any pixel. Where the choice is not `met`, no
/// smaller error can be reached.
double largest_error(const Choice& choice);
/// The remark on a choice that is not `met`: the smallest error that can be reached, and the way that is
/// exact.
std::string unmet_remark(const Choice& choice);

/// Where the choice saves something that costs no error, or nothing at all: what, and why. Empty otherwise.
/// "wall: one texture is read, the other is one colour"; "wall: nothing is saved within 1 dE2000: by_f0 is
/// needed, for the closest cheaper one, schlick, is off by 5.2; ..."
std::string saving_remark(const Choice& choice);

/// The levels of PNG compression, the cheapest first. They are lossless, so that their errors are 0.
std::vector<Candidate> png_levels(const CostTable& costs);

}  // namespace etak
