// SPDX-License-Identifier: Apache-2.0
// The parts that a choice is made from, and remarks on it: costs, units of error, subjects.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"
#include "core/brdf/parameters.h"
#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/material/appearance.h"
#include "core/math/functions.h"
#include "core/study/choose/choose.h"

namespace etak {
namespace {

// `value` rounded up to three digits, so that a budget of the printed number can be met.
std::string rounded_up(double value) {
  if (!(value > 0)) return number(value, 3);
  const double step = math::pow(10, std::floor(math::log10(value)) - 2);
  return number(std::ceil(value / step) * step, 3);
}

// Why nothing cheaper than `id` was taken, of candidates in the order of cost.
std::string why_needed(std::string_view id, const std::vector<Candidate>& candidates) {
  const auto own = std::find_if(candidates.begin(), candidates.end(),
                                [&](const Candidate& each) { return each.id == id; });
  const Candidate* closest = nullptr;
  for (auto each = candidates.begin(); each != own; ++each)
    if (!each->within && (closest == nullptr || each->error < closest->error)) closest = &*each;
  std::string out(id);
  if (closest == nullptr) return out += " is the cheapest";
  append(out, " is needed, for the closest cheaper one, ", closest->id, ", is off by ",
         number(closest->error, 3));
  return out;
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
  if (std::holds_alternative<Reflectance>(dataset.optics))
    throw Error::at(what, without_constants(dataset.optics), "n and k");
  ChooseSubject out;
  out.name = material.id;
  out.dataset = dataset;
  out.library = out.stack() ? out.stack()->text : what;
  out.base = film_base(material.material_class);
  out.texel.gloss = gloss;
  return out;
}

ChooseSubject library_subject(const Material& material, const Dataset& dataset,
                              const std::optional<Gloss>& given, std::vector<std::string>& remarks) {
  if (given) {
    const double least = lobe_alpha({{}, {}, *given});
    if (given->alpha() < least)
      remarks.push_back(material.id + ": the lobe of roughness " + number(given->roughness(), 3) +
                        " is compared with a width of " + number(least, 3) +
                        ", the least that the models take");
    return library_subject(material, dataset, *given);
  }
  const DefaultGloss standard = default_gloss(material, clarity(material, dataset).clear);
  const Gloss gloss(double{standard.gloss});
  remarks.push_back(material.id + ": " + default_gloss_remark(standard) +
                    (standard.gloss.held() ? "; compared with " + roughness_text(gloss) : ""));
  return library_subject(material, dataset, gloss);
}

void validate(const ChooseOptions& options) {
  if (!(options.budget >= 0) || !std::isfinite(options.budget))
    throw Error::at(setting("budget"), number(options.budget, 6), "a finite number, 0 or above");
}

std::vector<Choice> choose_each(std::span<const ChooseSubject> subjects, const ChooseOptions& options,
                                const CostTable& costs, unsigned threads,
                                const std::function<void(unsigned worker)>& chosen) {
  std::vector<Choice> out(subjects.size());
  parallel_chunks(subjects.size(), threads, 1, [&](std::size_t i, std::size_t, unsigned worker) {
    out[i] = choose(subjects[i], options, costs);
    if (chosen) chosen(worker);
  });
  return out;
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

std::string saving_remark(const Choice& choice) {
  std::string out;
  if (choice.textures == 1) append(out, choice.material, ": one texture is read, the other is one colour");
  // A saving that rounds to "0 % less".
  if (choice.chosen_ns < 0.995 * choice.everything_ns) return out;
  append(out, out.empty() ? choice.material + ": " : "; ", "nothing is saved within ",
         number(choice.budget, 6), " ", name(choice.unit), ": ",
         why_needed(choice.fresnel->id, choice.fresnel_candidates), "; ",
         why_needed(choice.visibility, choice.visibility_candidates));
  if (choice.textured) append(out, "; ", why_needed(name(choice.filter), choice.filter_candidates));
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
