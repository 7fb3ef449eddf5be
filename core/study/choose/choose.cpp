// SPDX-License-Identifier: Apache-2.0
#include "core/study/choose/choose.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>

#include "core/atlas/variant.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/text.h"
#include "core/brdf/models.h"
#include "core/brdf/parameters.h"
#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/fresnel/fresnel.h"
#include "core/material/f0.h"
#include "core/study/choose/choose_pictures.h"

namespace etak {
namespace {

constexpr std::string_view full_visibility = "smith-ggx-height";
constexpr std::size_t most_f0 = 16;  // of a texture: so many colours of F0 are judged at every angle
// Costs nearer than this are the same: two runs of measure_costs() differ by as much. Of equal ones the
// closest on average is taken.
constexpr double same_cost = 1.15;

// The term of the registry that has the form's formula.
std::string_view term_of(std::string_view form) {
  if (form == "spherical_gaussian") return "spherical-gaussian";
  if (form == "f82_tint") return "f82-tint";
  if (form == "from_f0") return "from-f0";
  if (form == "by_f0") return "by-f0";
  if (form == "index" || form == "mean_index" || form == "three_wavelengths") return "exact";
  return form;
}

// What a colour alone can feed.
bool needs_f0_alone(const FresnelForm& form) {
  return form.id == "schlick" || form.id == "schueler" || form.id == "spherical_gaussian" ||
         form.id == "from_f0" || form.id == "by_f0";
}

// The form's numbers in the order of the model's parameters: three channels of each, then the width.
std::vector<double> model_numbers(const Model& model, const FresnelValues& values, double alpha) {
  std::vector<double> out;
  for (std::size_t i = 0; i + 1 < model.parameters.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) out.push_back(values[c][i]);
  out.push_back(alpha);
  return out;
}

// F over angle of a surface that is known by its F0 alone.
FresnelTruth colour_truth(const Vec3& f0) {
  FresnelTruth truth;
  constexpr int steps = 360;
  for (int i = 0; i <= steps; ++i) {
    const double angle = std::numbers::pi / 2 * i / steps;
    truth.cosine.push_back(i == steps ? 0 : std::cos(angle));
    truth.weight.push_back(std::sin(angle) * truth.cosine.back());
    truth.rgb.push_back(f_of_colour(f0, truth.cosine.back()));
  }
  const double sum = std::accumulate(truth.weight.begin(), truth.weight.end(), 0.0);
  for (double& weight : truth.weight) weight /= sum;
  truth.f0 = f0;
  truth.f82 = f_of_colour(f0, f82_cosine);
  return truth;
}

PictureDifference angle_difference(ErrorUnit unit, const FresnelTruth& truth, const FresnelForm& form,
                                   const FresnelValues& values) {
  PictureDifference out;
  for (std::size_t i = 0; i < truth.cosine.size(); ++i) {
    Vec3 rgb{};
    for (std::size_t c = 0; c < 3; ++c) rgb[c] = form.value(values[c].data(), truth.cosine[i]);
    const double miss = difference(unit, rgb, truth.rgb[i]);
    out.worst = std::max(out.worst, miss);
    out.mean += truth.weight[i] * miss;
  }
  return out;
}

template <class Candidate>
struct Ranked {
  Candidate candidate;
  double cost;
};

template <class Candidate>
void by_cost(std::vector<Ranked<Candidate>>& all) {
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
}

class Choosing {
 public:
  Choosing(const ChooseSubject& subject, const ChooseOptions& options, const CostTable& costs)
      : subject_(subject), options_(options), costs_(costs), pictures_(subject) {
    out_.material = subject.name;
    out_.library = subject.library;
    out_.budget = options.budget;
    out_.unit = options.unit;
    out_.textured = subject.textured();
    if (subject.dataset)
      truths_ = {fresnel_truth(std::get<OpticalConstants>(subject.dataset->optics), subject.library)};
    else if (subject.texture)
      for (const Vec3& f0 : subject.texture->some_f0(most_f0)) truths_.push_back(colour_truth(f0));
    else
      truths_ = {colour_truth(subject.texel.f0)};
  }

  Choice run() {
    all_.filter = full_filter();
    everything_.emplace(options_.unit, pictures_.draw(all_));
    out_.pixels = everything_->pixels();
    chosen_ = all_;
    limit_ = options_.budget;
    choose_fresnel();
    choose_visibility();
    choose_filter();
    if (subject_.dataset) choose_method();
    finish();
    return std::move(out_);
  }

 private:
  TextureFilter full_filter() const {
    return !subject_.textured() ? TextureFilter::constant
           : subject_.mipmaps   ? TextureFilter::trilinear
                                : TextureFilter::bilinear;
  }

  PictureDifference picture(const Look& look) const {
    return everything_->difference_of(pictures_.draw(look));
  }

  // The worst over the colours of F0 that occur.
  PictureDifference at_any_angle(const FresnelForm& form, const FresnelValues* values) const {
    PictureDifference out;
    for (const FresnelTruth& truth : truths_) {
      const PictureDifference one =
          angle_difference(options_.unit, truth, form, values != nullptr ? *values : form.fit(truth));
      out.worst = std::max(out.worst, one.worst);
      out.mean = std::max(out.mean, one.mean);
    }
    return out;
  }

  void choose_fresnel() {
    std::vector<Ranked<const FresnelForm*>> ranked;
    for (const FresnelForm& form : fresnel_forms())
      if (form.physical && (subject_.dataset || needs_f0_alone(form)))
        ranked.push_back({&form, costs_.of("fresnel/" + std::string(form.id))});
    by_cost(ranked);
    double found_cost = 0, found_error = 0, closest_error = 0, closest_picture = 0;
    const FresnelForm* closest = nullptr;
    for (const auto& [form, cost] : ranked) {
      if (out_.fresnel != nullptr && cost > found_cost * same_cost) break;
      Look look = chosen_;
      look.form = form;
      look.values = form->fit(truths_.front());
      const PictureDifference angles = at_any_angle(*form, subject_.dataset ? &look.values : nullptr);
      Candidate candidate{std::string(form->id), std::string(form->title), cost, angles.worst, false};
      double seen = 0;
      if (angles.worst <= limit_ || !subject_.dataset) {
        seen = picture(look).worst;
        candidate.error = std::max(angles.worst, seen);
        candidate.within = candidate.error <= limit_;
      }
      out_.fresnel_candidates.push_back(candidate);
      if (closest == nullptr || candidate.error < closest_error)
        closest = form, closest_error = candidate.error, closest_picture = seen;
      if (!candidate.within || (out_.fresnel != nullptr && angles.mean >= found_error)) continue;
      if (out_.fresnel == nullptr) found_cost = cost;
      found_error = angles.mean;
      out_.fresnel = form;
      out_.fresnel_error = angles.worst;
    }
    if (out_.fresnel == nullptr && closest != nullptr) {
      out_.met = false;
      out_.fresnel = closest;
      Look look = chosen_;
      look.form = closest;
      look.values = closest->fit(truths_.front());
      out_.fresnel_error = at_any_angle(*closest, subject_.dataset ? &look.values : nullptr).worst;
      if (subject_.dataset) closest_picture = std::max(out_.fresnel_error, picture(look).worst);
      // The rest is chosen within what F alone misses.
      limit_ = std::max(limit_, closest_picture);
    }
    chosen_.form = out_.fresnel;
    chosen_.values = out_.fresnel->fit(truths_.front());
  }

  // Masking that fits a GGX lobe; the full one is among them. What it changes of itself says which of equal
  // costs is the closest: beside the form that was chosen, two errors may by chance make less than one.
  void choose_visibility() {
    std::vector<Ranked<const Term*>> ranked;
    for (const Term& term : terms())
      if (term.kind == TermKind::visibility && !term.id.starts_with("smith-beckmann"))
        ranked.push_back({&term, costs_.of("visibility/" + std::string(term.id))});
    by_cost(ranked);
    double found_cost = 0, found_error = 0;
    for (const auto& [term, cost] : ranked) {
      if (!out_.visibility.empty() && cost > found_cost * same_cost) break;
      Look look = chosen_;
      look.visibility = term->id;
      const double error = picture(look).worst;
      const Candidate candidate{std::string(term->id), std::string(term->title), cost, error,
                                error <= limit_};
      out_.visibility_candidates.push_back(candidate);
      if (!candidate.within) continue;
      Look alone = all_;
      alone.visibility = term->id;
      const double own = picture(alone).worst;
      if (!out_.visibility.empty() && own >= found_error) continue;
      if (out_.visibility.empty()) found_cost = cost;
      out_.visibility = candidate.id;
      found_error = own;
    }
    chosen_.visibility = find_term(TermKind::visibility, out_.visibility)->id;
  }

  void choose_filter() {
    out_.filter = full_filter();
    if (!subject_.textured()) return;
    std::vector<Ranked<TextureFilter>> ranked;
    for (const TextureFilter filter : all_filters)
      if (subject_.mipmaps || !reads_mips(filter))
        ranked.push_back({filter, costs_.of("filter/" + std::string(name(filter)))});
    by_cost(ranked);
    for (const auto& [filter, cost] : ranked) {
      Look look = chosen_;
      look.filter = filter;
      const double error = picture(look).worst;
      const std::string id(name(filter));
      out_.filter_candidates.push_back({id, id, cost, error, error <= limit_});
      if (error > limit_) continue;
      out_.filter = filter;
      break;
    }
    chosen_.filter = out_.filter;
  }

  // Last, because it costs once a spectrum and not once an evaluation: what it may miss is what is left.
  void choose_method() {
    F0Options options;
    options.method = Method::exact;
    const F0Result truth = F0Solver(options).solve(subject_.dataset->optics, subject_.dataset->flags);
    if (truth.refused()) throw Error::at(subject_.library, truth.refusal, "data with a colour");
    std::vector<Ranked<Method>> ranked;
    for (const Method method : all_methods)
      // Schueler's points come with a power law of their own: not the same quantity.
      if (method != Method::legacy_schueler)
        ranked.push_back({method, costs_.of("quadrature/" + std::string(name(method)))});
    by_cost(ranked);
    for (const auto& [method, cost] : ranked) {
      options.method = method;
      const F0Result result = F0Solver(options).solve(subject_.dataset->optics, subject_.dataset->flags);
      Candidate candidate{std::string(name(method)), std::string(name(method)), cost, 0, false};
      candidate.error = difference(options_.unit, vec(result.srgb_linear), vec(truth.srgb_linear));
      FresnelTruth fed = truths_.front();
      fed.f0 = vec(result.srgb_linear);
      if (result.f82) fed.f82 = vec(*result.f82);
      Look look = chosen_;
      look.values = out_.fresnel->fit(fed);
      double at_angle = 0;
      if (candidate.error <= limit_) {
        at_angle = at_any_angle(*out_.fresnel, &look.values).worst;
        candidate.error = std::max({candidate.error, at_angle, picture(look).worst});
      }
      candidate.within = candidate.error <= limit_;
      out_.method_candidates.push_back(candidate);
      // Where F alone is over the budget, what the exact sum differs from the limit by is rounding.
      if (!candidate.within && (out_.met || method != Method::exact)) continue;
      out_.method = candidate.id;
      out_.method_error = difference(options_.unit, vec(result.srgb_linear), vec(truth.srgb_linear));
      out_.fresnel_error = at_angle;
      out_.chosen_solve_ns = cost;
      out_.everything_solve_ns = costs_.of("quadrature/exact");
      chosen_.values = look.values;
      return;
    }
    throw Error::at(setting("budget"), number(options_.budget, 6), "at least what the quadratures differ by");
  }

  void finish() {
    const PictureDifference together = picture(chosen_);
    out_.picture_error = together.worst;
    out_.picture_mean = together.mean;
    out_.values = chosen_.values;
    out_.texel = subject_.texture ? subject_.texture->read(TextureFilter::constant, 0, 0, 0) : subject_.texel;
    if (subject_.dataset)
      for (std::size_t c = 0; c < 3; ++c) out_.texel.f0[c] = truths_.front().f0[c];
    else
      for (std::size_t c = 0; c < 3; ++c) out_.values[c] = {out_.texel.f0[c], 0, 0, 0};
    if (subject_.texture) out_.codes = subject_.texture->mean_codes();
    out_.alpha = lobe_alpha(out_.texel);
    out_.model = "microfacet:ggx," + std::string(term_of(out_.fresnel->id)) + "," + out_.visibility;
    out_.model_values = model_numbers(*find_model(out_.model), out_.values, out_.alpha);
    out_.defines = shading_defines(out_.model, name(out_.filter));

    const std::string_view full = subject_.dataset ? "index" : form_of_colours();
    const auto cost = [&](std::string_view form, std::string_view visibility, TextureFilter filter) {
      return costs_.of("fresnel/" + std::string(form)) + costs_.of("visibility/" + std::string(visibility)) +
             (subject_.textured() ? costs_.of("filter/" + std::string(name(filter))) : 0);
    };
    out_.everything_ns = cost(full, full_visibility, full_filter());
    out_.chosen_ns = cost(out_.fresnel->id, out_.visibility, out_.filter);
  }

  // The least that gives "everything" for the colours of F0 that occur.
  std::string_view form_of_colours() const {
    bool low = false, high = false;
    for (const FresnelTruth& truth : truths_)
      for (const double f0 : truth.f0) (f0 < forbidden_zone_first ? low : high) = true;
    return low && high ? "by_f0" : low ? "from_f0" : "schlick";
  }

  const ChooseSubject& subject_;
  const ChooseOptions& options_;
  const CostTable& costs_;
  const ChoosePictures pictures_;
  std::vector<FresnelTruth> truths_;  // the spectrum's, or one a colour of F0
  std::optional<PictureJudge> everything_;
  Look all_, chosen_;
  double limit_ = 0;
  Choice out_;
};

// With three digits and not below `value`: a budget of that much is met.
std::string rounded_up(double value) {
  if (!(value > 0)) return number(value, 3);
  const double step = std::pow(10, std::floor(std::log10(value)) - 2);
  return number(std::ceil(value / step) * step, 3);
}

}  // namespace

double CostTable::of(std::string_view id) const {
  const auto found = ns.find(id);
  if (found == ns.end())
    throw Error::at("cost table", "no \"" + std::string(id) + "\"", "a cost for every form");
  return found->second;
}

std::string_view name(ErrorUnit unit) {
  return unit == ErrorUnit::codes ? "codes" : "ΔE2000";
}

double difference(ErrorUnit unit, const Vec3& a, const Vec3& b) {
  if (unit == ErrorUnit::delta_e) return delta_e2000(to_lab(to_rgb(a)), to_lab(to_rgb(b)));
  int worst = 0;
  for (std::size_t c = 0; c < 3; ++c)
    worst = std::max(
        worst, std::abs(int{srgb_u8(std::clamp(a[c], 0.0, 1.0))} - int{srgb_u8(std::clamp(b[c], 0.0, 1.0))}));
  return worst;
}

double lobe_alpha(const SurfaceTexel& texel) {
  return std::max(parameters::alpha.min, texel.gloss.alpha());
}

ChooseSubject library_subject(const Material& material, const Dataset& dataset, const Gloss& gloss) {
  const std::string what = material.id + "/" + dataset.id;
  if (!std::holds_alternative<OpticalConstants>(dataset.optics))
    throw Error::at(what, "has reflectance data only", "n and k");
  ChooseSubject out;
  out.name = material.id;
  out.library = what;
  out.dataset = dataset;
  out.texel.gloss = gloss;
  return out;
}

Choice choose(const ChooseSubject& subject, const ChooseOptions& options, const CostTable& costs) {
  return Choosing(subject, options, costs).run();
}

double largest_error(const Choice& choice) {
  return std::max({choice.fresnel_error, choice.picture_error, choice.method_error});
}

std::string unmet_remark(const Choice& choice) {
  const std::string unit(name(choice.unit));
  std::string out;
  append(out, choice.material, ": no form of F stays within ", number(choice.budget, 6), " ", unit,
         "; the least that can be reached is ", rounded_up(largest_error(choice)), " (", choice.fresnel->id,
         "), which was taken; exact is ");
  if (choice.library.empty())
    append(out, "a material of the library, whose F is known at every nanometre: a colour says no more");
  else
    append(out, "F at every nanometre: etak render ", choice.library, " --reference");
  return out;
}

std::vector<Candidate> png_levels(const CostTable& costs) {
  std::vector<Candidate> out;
  for (const char* level : {"fast", "small", "smallest"})
    out.push_back({level, level, costs.of("png/" + std::string(level)), 0, true});
  std::stable_sort(out.begin(), out.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost_ns < b.cost_ns; });
  return out;
}

}  // namespace etak
