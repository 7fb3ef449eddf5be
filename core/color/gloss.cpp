// SPDX-License-Identifier: Apache-2.0
#include "core/color/gloss.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/math/functions.h"

namespace etak {
namespace {

// Roughness 0 has no finite exponent; this one, e = 1e12, is far beyond the codes of any texture.
constexpr double largest_gloss = 3.32;

}  // namespace

double roughness_of_gloss(double gloss) {
  return std::sqrt(alpha_of_gloss(gloss));
}

double gloss_of_roughness(double roughness) {
  // log2 gives the promised infinities: of infinity for roughness 0, of 0 for roughness 1.
  return gloss_of_exponent(std::max(0.0, 2 / math::pow(roughness, 4) - 2));
}

Gloss Gloss::of_roughness(double roughness) {
  // NaN is passed on, so that the check of the range finds it.
  Gloss out(std::isnan(roughness) ? roughness : std::clamp(gloss_of_roughness(roughness), 0.0, 1.0));
  out.roughness_ = roughness;
  return out;
}

double Gloss::roughness() const {
  return roughness_ ? *roughness_ : roughness_of_gloss(gloss_);
}

double Gloss::alpha() const {
  return roughness_ ? *roughness_ * *roughness_ : alpha_of_gloss(gloss_);
}

double Gloss::exponent() const {
  return roughness_ ? exponent_of_alpha(alpha()) : exponent_of_gloss(gloss_);
}

bool Gloss::held() const {
  if (!roughness_) return false;
  const double wanted = gloss_of_roughness(*roughness_);
  return !(wanted >= 0 && wanted <= 1);
}

std::optional<Gloss> given_gloss(std::optional<double> gloss, std::optional<double> roughness) {
  const auto check = [](const char* name, const std::optional<double>& value) {
    if (value && !(*value >= 0 && *value <= 1)) throw Error::at(setting(name), number(*value, 6), "0 to 1");
  };
  check("gloss", gloss);
  check("roughness", roughness);
  if (gloss && roughness)
    throw Error::at(setting("roughness"), "given beside " + setting("gloss"),
                    "one of the two: they say the same thing");
  if (roughness) return Gloss::of_roughness(*roughness);
  return gloss ? std::optional<Gloss>(*gloss) : std::nullopt;
}

std::string_view name(GlossForm form) {
  return form == GlossForm::schueler              ? "schueler"
         : form == GlossForm::one_minus_roughness ? "one_minus_roughness"
                                                  : "roughness";
}

std::optional<GlossForm> gloss_form_named(std::string_view text) {
  for (const GlossForm form : {GlossForm::schueler, GlossForm::one_minus_roughness, GlossForm::roughness})
    if (text == name(form)) return form;
  return std::nullopt;
}

double converted_gloss(double value, GlossForm from, GlossForm to) {
  if (from == to) return value;
  double roughness = value;
  if (from == GlossForm::one_minus_roughness) roughness = 1 - value;
  if (from == GlossForm::schueler) roughness = roughness_of_gloss(value);
  if (to == GlossForm::roughness) return roughness;
  if (to == GlossForm::one_minus_roughness) return 1 - roughness;
  // Roughness 0 and 1 have no finite g; they are as far outside as any.
  return std::clamp(gloss_of_roughness(roughness), -largest_gloss, largest_gloss);
}

std::string roughness_text(const Gloss& gloss) {
  return "roughness " + number(gloss.roughness(), 3) +
         (gloss.held() ? "" : " (gloss " + number(double{gloss}, 3) + ")");
}

std::string held_text(const Gloss& gloss) {
  if (!gloss.held()) return "";
  return "Schueler's gloss holds roughness " + number(roughness_of_gloss(1), 3) + " to " +
         number(roughness_of_gloss(0), 3) + ": gloss " + number(double{gloss}, 3) + ", roughness " +
         number(roughness_of_gloss(gloss), 3) + ", stands for roughness " + number(gloss.roughness(), 3);
}

}  // namespace etak
