// SPDX-License-Identifier: Apache-2.0
#include "core/iridescence/parameters.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/color/channel_nm.h"
#include "core/fresnel/fresnel.h"
#include "core/material/optics/optics_at.h"
#include "core/material/seen_stack.h"

namespace etak {
namespace {

// The mean difference in dE2000 up to which honest numbers are preferred to fitted ones: nobody sees it, and numbers that mean something can be changed by hand.
constexpr double as_good = 0.5;
// The mean dE2000 up to which a form is said to show the stack.
constexpr double close_enough = 3;

constexpr double film_nm = 550;

double index_at(const StackMedium& medium, double nm) {
  return n_at(medium.constants, std::array{nm}, medium.id, {.extrapolate = true}).front();
}

double extinction_at(const StackMedium& medium, double nm) {
  return medium.constants.k ? k_at(medium.constants, std::array{nm}, medium.id, {.extrapolate = true}).front()
                            : 0;
}

LinearRgb edge_of(const SeenStack& seen) {
  return to_rgb(seen(f82_cosine));
}

// The numbers that an author knows; those of the film where there is one layer.
FilmFacts facts_of(const Stack& stack, const SeenStack& seen, const F0Options& options) {
  Stack bare = stack;
  bare.layers.clear();
  const SeenStack base(bare, options);
  FilmFacts out;
  out.base_f0 = to_rgb(base(1));
  out.base_f82 = edge_of(base);
  out.whole_f0 = to_rgb(seen(1));
  out.whole_f82 = edge_of(seen);
  const Vec3 f0 = vec(out.base_f0), f82 = vec(out.base_f82);
  for (std::size_t c = 0; c < 3; ++c) {
    const SolvedIndex index = solve_index(f0[c], f82[c]);
    out.base_n[c] = index.n;
    out.base_k[c] = index.k;
  }
  out.film_n = index_at(stack.media[stack.layers.front().medium], film_nm);
  out.thickness_nm = stack.layers.front().thickness_nm;
  return out;
}

std::string why_no_honest(const Stack& stack) {
  if (stack.layers.size() != 1)
    return "the forms have one film, and the stack has " + std::to_string(stack.layers.size()) + " layers";
  if (!stack.layers.front().coherent)
    return "the layer is too thick for colours of interference: it is a coat";
  return {};
}

// Optical thickness of the layers that interfere.
double path_of(const Stack& stack) {
  double out = 0;
  for (const StackLayer& layer : stack.layers)
    if (layer.coherent) out += layer.thickness_nm * index_at(stack.media[layer.medium], film_nm);
  return out;
}

std::vector<std::string> notes_of(const Stack& stack) {
  std::vector<std::string> out;
  for (const StackLayer& layer : stack.layers) {
    const StackMedium& medium = stack.media[layer.medium];
    const double k = std::max({extinction_at(medium, channel_nm[0]), extinction_at(medium, channel_nm[1]),
                               extinction_at(medium, channel_nm[2])});
    if (k > 1e-3)
      out.push_back(medium.id + " absorbs (k up to " + number(k, 2) + "), which no form of a film says");
  }
  return out;
}

}  // namespace

bool FilmInForm::use_honest() const {
  return honest && honest->error.mean <= fitted.error.mean + as_good;
}

std::string FilmInForm::advice() const {
  const auto of = [](const FilmValues& values) { return "dE2000 " + number(values.error.mean, 2); };
  if (use_honest())
    return "Use the honest numbers: they miss by " + of(*honest) + " on the mean, the fitted ones by " +
           of(fitted) + ".";
  const std::string honest_miss = honest ? ", the honest ones by " + of(*honest) : std::string();
  if (fitted.error.mean > close_enough)
    return "Use the fitted numbers with care: they still miss by " + of(fitted) + " on the mean" +
           honest_miss + ".";
  return "Use the fitted numbers: they miss by " + of(fitted) + " on the mean" + honest_miss + ".";
}

FilmBase film_base(std::string_view material_class) {
  return optical_kind(material_class) == "dielectric" ? FilmBase::dielectric : FilmBase::metal;
}

const FilmInForm* FilmParameters::in(std::string_view form_id) const {
  const auto found = std::find_if(forms.begin(), forms.end(),
                                  [&](const FilmInForm& each) { return each.form->id == form_id; });
  return found == forms.end() ? nullptr : &*found;
}

std::string film_refusal(const F0Options& options) {
  if (options.outside.label != "vacuum" && options.outside.label != "air")
    return "films of renderers lie in air, and the outside medium is " + options.outside.label;
  if (options.space != RgbSpace::srgb || options.custom_space)
    return "films are fitted in linear sRGB, and the space is " + space_name(options);
  return {};
}

FilmParameters film_parameters(const Stack& stack, FilmBase base, const F0Options& options,
                               std::span<const FilmForm* const> forms) {
  if (const std::string why = film_refusal(options); !why.empty())
    throw Error::at(printable(stack.text, 80), why);
  const SeenStack seen(stack, options);
  const FilmTruth truth = film_truth([&](double cosine) { return seen(cosine); });
  const FilmFacts facts = facts_of(stack, seen, options);
  FilmParameters out;
  out.base = base;
  out.no_honest = why_no_honest(stack);
  out.notes = notes_of(stack);
  for (const FilmForm* form : forms) {
    if (!form->has(base)) continue;
    const FilmNumbers known = form->honest(facts), honest = in_range(*form, known);
    FilmInForm each{form, {}, {fitted_film(*form, truth, honest, path_of(stack)), {}}, {}};
    each.fitted.error = film_error(*form, each.fitted.numbers, truth);
    if (out.no_honest.empty() || !form->has_film())
      each.honest = FilmValues{honest, film_error(*form, honest, truth)};
    if (form->has_film() && known[form->index + 1] > honest[form->index + 1] && out.no_honest.empty())
      each.note = std::string(form->title) + " is fitted up to " + number(honest[form->index + 1], 4) +
                  " nm, and the film has " + number(known[form->index + 1], 4) + " nm";
    out.forms.push_back(std::move(each));
  }
  return out;
}

FilmFits::FilmFits(const Stack& stack, FilmBase base, const F0Options& options)
    : stack_(stack), options_(options), known_(film_parameters(stack, base, options, {})) {}

const FilmInForm* FilmFits::in(std::string_view form) const {
  const FilmForm* const one = film_form(form);
  if (one == nullptr) return nullptr;
  const std::lock_guard lock(fitting_);
  auto at = fitted_.find(one->id);
  if (at == fitted_.end())
    at = fitted_.emplace(one->id, film_parameters(stack_, known_.base, options_, {&one, 1})).first;
  return at->second.in(form);
}

}  // namespace etak
