// SPDX-License-Identifier: Apache-2.0
#include "core/study/choose/choose.h"

#include <algorithm>
#include <cmath>

#include "core/atlas/variant.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/brdf/models.h"
#include "core/brdf/parameters.h"
#include "core/fresnel/fresnel.h"
#include "core/material/f0.h"
#include "core/study/choose/choose_judge.h"
#include "core/study/choose/choose_models.h"

namespace etak {
namespace {

constexpr std::string_view full_visibility = "smith-ggx-height";

// The term of the registry that has the form's formula.
std::string_view term_of(std::string_view form) {
  if (form == "spherical_gaussian") return "spherical-gaussian";
  if (form == "f82_tint") return "f82-tint";
  if (form == "from_f0") return "from-f0";
  if (form == "by_f0") return "by-f0";
  if (form == "index" || form == "mean_index" || form == "three_wavelengths") return "exact";
  return form;
}

// Whether the form takes F0 alone, so that a colour is enough for it.
bool needs_f0_alone(const FresnelForm& form) {
  return form.id == "schlick" || form.id == "schueler" || form.id == "spherical_gaussian" ||
         form.id == "from_f0" || form.id == "by_f0";
}

// Whether the form can be fitted to what is known of F: of layers together there are no n and k of every wavelength, and a
// curve is for those whose F no other form has.
bool can_be(const FresnelForm& form, const ChooseSubject& subject) {
  if (!form.physical) return false;
  if (!subject.dataset) return needs_f0_alone(form);
  const bool of_spectrum = form.id == "mean_index" || form.id == "three_wavelengths";
  return subject.stack() ? !of_spectrum : form.id != "curve";
}

// The form's numbers in the order of the model's parameters: three channels of each, then the width.
std::vector<double> model_numbers(const Model& model, const FresnelValues& values, double alpha) {
  std::vector<double> out;
  for (std::size_t i = 0; i + 1 < model.parameters.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) out.push_back(values[c][i]);
  out.push_back(alpha);
  return out;
}

// ---- the steps in their order: each looks for the cheapest candidate within `limit`, drawn with what the
// steps before have chosen. Its own error, beside the exact rest, counts on top of the errors that those
// steps have spent, so that no choice is within the budget only because its error makes up for another.

struct FresnelStep {
  const FresnelForm* form = nullptr;
  FresnelValues values{};
  double error = 0;    // over all angles
  double picture = 0;  // of the worst pixel, beside the exact rest
  bool met = true;     // false: no form is within the limit, and the closest one was taken
  double limit = 0;    // for the steps that follow: the same, or the error of the closest form alone
  std::vector<Candidate> candidates;
};

Look with_form(Look look, const FresnelForm& form, const FresnelTruth& truth) {
  look.form = &form;
  look.values = form.fit(truth);
  return look;
}

// A form with its largest error over all angles and in the worst pixel.
struct TriedForm {
  const FresnelForm* form = nullptr;
  double angles = 0, seen = 0;
};

FresnelStep choose_fresnel(const Judge& judge, double limit) {
  const bool spectrum = judge.subject().dataset.has_value();
  std::vector<std::pair<double, TriedForm>> ranked;
  for (const FresnelForm& form : fresnel_forms())
    if (can_be(form, judge.subject())) ranked.push_back({judge.cost("fresnel/", form.id), {&form}});
  FresnelStep out;
  std::optional<Tried<TriedForm>> closest;
  auto found = cheapest_within(ranked, same_cost, out.candidates, [&](const TriedForm& item, double cost) {
    const FresnelForm& form = *item.form;
    const Look look = with_form(judge.everything(), form, judge.truth());
    const PictureDifference angles = judge.at_any_angle(form, look.values);
    Tried<TriedForm> one{{&form, angles.worst},
                         {std::string(form.id), std::string(form.title), cost, angles.worst, false},
                         std::nullopt};
    if (angles.worst <= limit || !spectrum) {
      one.item.seen = judge.picture(look).worst;
      one.candidate.error = std::max(angles.worst, one.item.seen);
      one.candidate.within = one.candidate.error <= limit;
    }
    if (one.candidate.within) one.rank = angles.mean;
    if (!closest || one.candidate.error < closest->candidate.error) closest = one;
    return one;
  });
  out.met = found.has_value();
  const TriedForm taken = found ? found->item : closest->item;
  out.form = taken.form;
  out.error = taken.angles;
  out.picture = taken.seen;
  out.limit = limit;
  if (!out.met) {
    if (spectrum)
      out.picture =
          std::max(out.error, judge.picture(with_form(judge.everything(), *out.form, judge.truth())).worst);
    out.limit = std::max(limit, out.picture);
  }
  out.values = out.form->fit(judge.truth());
  return out;
}

struct VisibilityStep {
  std::string_view term;
  double own = 0;  // the error of the worst pixel beside the exact rest
  std::vector<Candidate> candidates;
};

// Chooses among the masking terms that fit a GGX lobe, the full one included. Of terms of equal cost the one
// with the least error of its own is taken.
VisibilityStep choose_visibility(const Judge& judge, const Look& chosen, const FresnelStep& fresnel) {
  std::vector<std::pair<double, const Term*>> ranked;
  for (const Term& term : terms())
    if (masks_ggx(term)) ranked.emplace_back(judge.cost("visibility/", term.id), &term);
  VisibilityStep out;
  const auto found = cheapest_within(ranked, same_cost, out.candidates, [&](const Term* term, double cost) {
    const auto error_beside = [&judge, id = term->id](Look look) {
      look.visibility = id;
      return judge.picture(look).worst;
    };
    Tried<const Term*> one{
        term,
        {std::string(term->id), std::string(term->title), cost, error_beside(chosen), false},
        std::nullopt};
    if (one.candidate.error > fresnel.limit) return one;
    const double own = error_beside(judge.everything());
    one.candidate.error = std::max(one.candidate.error, fresnel.picture + own);
    one.candidate.within = one.candidate.error <= fresnel.limit;
    if (one.candidate.within) one.rank = own;
    return one;
  });
  if (found) {
    out.term = found->item->id;
    out.own = *found->rank;
  }
  return out;
}

struct FilterStep {
  TextureFilter filter = TextureFilter::constant;
  std::vector<Candidate> candidates;
};

//   spent   by the form of F and the masking, in the worst pixel
FilterStep choose_filter(const Judge& judge, Look look, double spent, double limit) {
  const ChooseSubject& subject = judge.subject();
  FilterStep out;
  out.filter = judge.everything().filter;
  if (!subject.textured()) return out;
  std::vector<std::pair<double, TextureFilter>> ranked;
  for (const TextureFilter filter : all_filters)
    if (subject.mipmaps || !reads_mips(filter))
      ranked.emplace_back(judge.filter_cost(filter, subject.texture->varying()), filter);
  const auto found = cheapest_within(ranked, 0, out.candidates, [&](TextureFilter filter, double cost) {
    look.filter = filter;
    double error = judge.picture(look).worst;
    if (error <= limit) {
      Look alone = judge.everything();
      alone.filter = filter;
      error = std::max(error, spent + judge.picture(alone).worst);
    }
    const bool within = error <= limit;
    const std::string id(name(filter));
    return Tried<TextureFilter>{
        filter, {id, id, cost, error, within}, within ? std::optional(error) : std::nullopt};
  });
  if (found) out.filter = found->item;
  return out;
}

struct MethodStep {
  std::string method;
  FresnelValues values{};  // numbers of the form for the F0 that the method gives
  double method_error = 0, fresnel_error = 0, cost_ns = 0;
  std::vector<Candidate> candidates;
};

// The quadrature is chosen last and may use what is left of the limit, because it is paid for once for a
// spectrum and not for every evaluation. Where F alone is over the budget (`fresnel.met` is false), the exact
// quadrature is taken even above the limit, because it differs from that by rounding only.
//   budget   for the message
MethodStep choose_method(const Judge& judge, const Look& chosen, const FresnelStep& fresnel, double budget) {
  const ChooseSubject& subject = judge.subject();
  const auto f0_by = [&](Method method) {
    F0Options options;
    options.method = method;
    return F0Solver(options).solve(subject.dataset->optics, subject.dataset->flags);
  };
  const F0Result truth = f0_by(Method::exact);
  if (truth.refused()) throw Error::at(subject.library, truth.refusal, "data with a colour");
  std::vector<std::pair<double, Method>> ranked;
  for (const Method method : all_methods)
    // Schueler's method has a power law of its own, so that its result is another quantity.
    if (method != Method::legacy_schueler)
      ranked.emplace_back(judge.cost("quadrature/", name(method)), method);
  MethodStep out;
  const auto found = cheapest_within(ranked, 0, out.candidates, [&](Method method, double cost) {
    const F0Result result = f0_by(method);
    const std::string id(name(method));
    const double own = difference(judge.unit(), vec(result.srgb_linear), vec(truth.srgb_linear));
    Tried<Method> one{method, {id, id, cost, own, false}, std::nullopt};
    FresnelTruth fed = judge.truth();
    fed.f0 = vec(result.srgb_linear);
    if (result.f82) fed.f82 = vec(*result.f82);
    const Look look = with_form(chosen, *fresnel.form, fed);
    double at_angle = 0;
    if (own <= fresnel.limit) {
      at_angle = judge.at_any_angle(*fresnel.form, look.values).worst;
      one.candidate.error = std::max({fresnel.error + own, at_angle, judge.picture(look).worst});
    }
    one.candidate.within = one.candidate.error <= fresnel.limit;
    if (!one.candidate.within && (fresnel.met || method != Method::exact)) return one;
    one.rank = own;
    out = {id, look.values, own, at_angle, cost, std::move(out.candidates)};
    return one;
  });
  if (!found)
    throw Error::at(setting("budget"), number(budget, 6), "at least what the quadratures differ by");
  return out;
}

// Fills in the texel that stands for the whole material, and the numbers of the model for it.
void describe_model(const Judge& judge, const FresnelValues& values, Choice& out) {
  const ChooseSubject& subject = judge.subject();
  out.values = values;
  out.texel = subject.texture ? subject.texture->read(TextureFilter::constant, 0, 0, 0) : subject.texel;
  if (subject.dataset)
    for (std::size_t c = 0; c < 3; ++c) out.texel.f0[c] = judge.truth().f0[c];
  else
    for (std::size_t c = 0; c < 3; ++c) out.values[c] = {out.texel.f0[c], 0, 0, 0};
  if (subject.texture) out.codes = subject.texture->mean_codes();
  out.alpha = lobe_alpha(out.texel);
  out.model = "microfacet:ggx," + std::string(term_of(out.fresnel->id)) + "," + out.visibility;
  out.model_values = model_numbers(*find_model(out.model), out.values, out.alpha);
  out.defines = shading_defines(out.model, name(out.filter));
}

// Takes a whole model in the place of the chosen form of F and masking, where one is within the limit and cheaper by
// more than two measurements differ.
void take_whole_model(const Judge& judge, Look look, const FresnelStep& fresnel, Choice& out) {
  const SurfaceTexel& mean = out.texel;
  look.f0 = mean.f0;
  const bool spectrum = judge.subject().dataset.has_value();
  if (spectrum) look.index = fresnel_form("index")->fit(judge.truth());
  const double replaced = judge.cost("fresnel/", out.fresnel->id) + judge.cost("visibility/", out.visibility);
  // A masking term is measured with a lobe of Schlick's F.
  const double frame = replaced - judge.cost("fresnel/", "schlick");
  std::vector<std::pair<double, const Model*>> ranked;
  for (const Model* model : whole_models())
    if (const double cost = judge.cost("model/", model->id);
        cost * same_cost < frame && (spectrum || !takes_index(*model)))
      ranked.emplace_back(cost, model);
  PictureDifference seen;
  const auto found = cheapest_within(ranked, 0, out.model_candidates, [&](const Model* model, double cost) {
    look.model = model;
    seen = judge.picture(look);
    double error = seen.worst;
    if (const FresnelForm* form = form_of(*model))
      error = std::max(error, judge.at_any_angle(*form, form->fit(judge.truth())).worst + out.method_error);
    const bool within = error <= fresnel.limit;
    return Tried<const Model*>{model,
                               {std::string(model->id), std::string(model->title), cost, error, within},
                               within ? std::optional(error) : std::nullopt};
  });
  if (!found) return;
  out.whole_model = true;
  out.model = found->item->id;
  out.model_values = whole_model_numbers(*found->item, mean.f0, look.index, mean);
  out.defines = shading_defines(out.model, name(out.filter));
  out.picture_error = seen.worst;
  out.picture_mean = seen.mean;
  out.fresnel_error = found->candidate.error;
  out.chosen_ns += found->candidate.cost_ns - replaced;
}

// Films as renderers have them, each by the numbers that are advised, at the angles of the truth but 90 degrees.
std::vector<Candidate> films_of(const Judge& judge, double budget) {
  std::vector<Candidate> out;
  const ChooseSubject& subject = judge.subject();
  if (!subject.stack()) return out;
  const FilmFits fits(*subject.stack(), subject.base, {});
  for (const FilmForm* form : film_forms()) {
    if (!form->has_film() || !form->has(subject.base)) continue;
    const FilmInForm& in = *fits.in(form->id);
    Candidate one{std::string(form->id),
                  std::string(form->title) + (in.use_honest() ? ", honest" : ", fitted"),
                  judge.cost("film/", form->id), 0, false};
    for (std::size_t i = 0; i < judge.truth().cosine.size(); ++i)
      if (const double cosine = judge.truth().cosine[i]; cosine > 0)
        one.error = std::max(
            one.error, difference(judge.unit(), form->seen(in.used().numbers, cosine), judge.truth().rgb[i]));
    one.within = one.error <= budget;
    out.push_back(std::move(one));
  }
  std::ranges::stable_sort(out, {}, &Candidate::cost_ns);
  return out;
}

double evaluation_cost(const Judge& judge, std::string_view form, std::string_view visibility,
                       TextureFilter filter, int textures) {
  return judge.cost("fresnel/", form) + judge.cost("visibility/", visibility) +
         (judge.subject().textured() ? judge.filter_cost(filter, textures) : 0);
}

}  // namespace

Choice choose(const ChooseSubject& subject, const ChooseOptions& options, const CostTable& costs) {
  const Judge judge(subject, options.unit, costs);
  Choice out;
  out.material = subject.name;
  out.library = subject.library;
  out.budget = options.budget;
  out.unit = options.unit;
  out.textured = subject.textured();
  out.textures = out.textured ? subject.texture->varying() : 0;
  out.pixels = judge.pixels();
  Look chosen = judge.everything();

  FresnelStep fresnel = choose_fresnel(judge, options.budget);
  chosen.form = out.fresnel = fresnel.form;
  chosen.values = fresnel.values;
  out.met = fresnel.met;
  out.fresnel_error = fresnel.error;
  out.fresnel_candidates = std::move(fresnel.candidates);

  VisibilityStep visibility = choose_visibility(judge, chosen, fresnel);
  chosen.visibility = visibility.term;
  out.visibility = visibility.term;
  out.visibility_candidates = std::move(visibility.candidates);

  FilterStep filter = choose_filter(judge, chosen, fresnel.picture + visibility.own, fresnel.limit);
  chosen.filter = out.filter = filter.filter;
  out.filter_candidates = std::move(filter.candidates);

  if (subject.dataset) {
    MethodStep method = choose_method(judge, chosen, fresnel, options.budget);
    chosen.values = method.values;
    out.method = method.method;
    out.method_error = method.method_error;
    out.fresnel_error = std::max(fresnel.error, method.fresnel_error);
    out.chosen_solve_ns = method.cost_ns;
    out.everything_solve_ns = judge.cost("quadrature/", name(Method::exact));
    out.method_candidates = std::move(method.candidates);
  }

  const PictureDifference together = judge.picture(chosen);
  // The error that can be reached is that of the form without luck: the other choices may make up for its error.
  out.picture_error = out.met ? together.worst : std::max(together.worst, fresnel.picture);
  out.picture_mean = together.mean;
  describe_model(judge, chosen.values, out);
  out.everything_ns =
      evaluation_cost(judge, judge.full_form(), full_visibility, judge.everything().filter, textures_of_pair);
  out.chosen_ns = evaluation_cost(judge, out.fresnel->id, out.visibility, out.filter, out.textures);
  if (out.met) take_whole_model(judge, chosen, fresnel, out);
  out.film_candidates = films_of(judge, options.budget);
  return out;
}

}  // namespace etak
