// SPDX-License-Identifier: Apache-2.0
#include "core/pages/asked_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"
#include "core/math/functions.h"
#include "core/render/typed.h"

namespace etak {
namespace {

using NamedNumbers = std::vector<std::pair<std::string, double>>;

constexpr std::string_view of_spectrum = "spectrum";
constexpr std::array<std::string_view, 2> radial_scales{"linear", "log"};  // as RadialScale has them
constexpr double radian = std::numbers::pi / 180;

// The place of a setting's word in `words`. Throws Error.
std::size_t place_of(std::string_view name, const std::string& word,
                     std::span<const std::string_view> words) {
  const auto found = std::ranges::find(words, word);
  if (found == words.end()) throw Error::at(setting(name), printable(word), joined(words));
  return static_cast<std::size_t>(found - words.begin());
}

std::string name_of(const CurveSubject& subject) {
  return subject.material == nullptr
             ? joined(subject.words, " ")
             : subject.material->id + "/" + subject.material->datasets[subject.dataset].id;
}

CurveKind kind_of(const CurveRequest& request) {
  return static_cast<CurveKind>(place_of("of", request.of, curve_kinds));
}

// The terms that are named and those of the models, each once; null stands for the spectrum. Throws Error.
std::vector<const Term*> terms_of(const CurveRequest& request, CurveKind kind) {
  const TermKind wanted = kind == CurveKind::fresnel        ? TermKind::fresnel
                          : kind == CurveKind::distribution ? TermKind::distribution
                                                            : TermKind::visibility;
  std::vector<const Term*> out;
  for (const std::string& id : request.terms) {
    out.push_back(find_term(wanted, id));
    if (out.back() != nullptr || (wanted == TermKind::fresnel && id == of_spectrum)) continue;
    std::string known(wanted == TermKind::fresnel ? of_spectrum : "");
    for (const Term& each : terms())
      if (each.kind == wanted) append(known, known.empty() ? "" : ", ", each.id);
    throw Error::at(setting("term"), printable(id) + " with " + setting("of") + " " + request.of, known);
  }
  for (const std::string& id : request.models) {
    const Model* model = model_named(setting("model"), id, {});
    const Term* term = model == nullptr                   ? nullptr
                       : wanted == TermKind::fresnel      ? model->fresnel
                       : wanted == TermKind::distribution ? model->distribution
                                                          : model->visibility;
    if (term == nullptr)
      throw Error::at(setting("model"), id + " has no term " + std::string(name(wanted)),
                      "a model of three terms, such as ggx-schlick, or " + setting("term"));
    out.push_back(term);
  }
  std::vector<const Term*> once;
  for (const Term* each : out)
    if (std::ranges::find(once, each) == once.end()) once.push_back(each);
  return once;
}

// ", alpha 0.2": the numbers that tell two curves of one model or term apart, and those that no material tells.
std::string numbers_text(std::span<const Parameter> parameters, const std::vector<double>& values) {
  std::string out;
  std::size_t at = 0;
  for (const Parameter& each : parameters) {
    if (!each.color || each.role == Role::other) append(out, ", ", each.name, " ", number(values[at], 4));
    at += each.color ? 3 : 1;
  }
  return out;
}

// The curves of one run, subject after subject.
class Curves {
 public:
  Curves(const CurveRequest& request, CurveKind kind, std::vector<std::string>& remarks)
      : request_(request), kind_(kind), remarks_(remarks) {}

  // R over wavelength, or F at all angles, of a material's data. Throws Error where they do not tell it.
  void add_spectrum(const CurveSubject& subject) {
    const std::string name = name_of(subject);
    if (subject.material == nullptr) throw Error::at(name, "has no spectrum", "a material");
    if (request_.surface.compute.axis_average)
      throw Error::at(setting("axis-average"), "with the curve of one dataset",
                      setting("dataset") + " of an axis, or " + setting("term"));
    const Optics& optics = subject.material->datasets[subject.dataset].optics;
    if (kind_ == CurveKind::reflectance) {
      const OpticsCurves all = etak::curves_of(optics, request_.options);
      if (all.r0.empty()) throw Error::at(name, "holds no data", "data within 360 to 830 nm");
      ColorCurve& curve = curves.emplace_back(ColorCurve{name, all.r_nm, {}});
      for (const double value : all.r0) curve.rgb.push_back({value, value, value});
      return;
    }
    if (std::holds_alternative<Reflectance>(optics))
      throw Error::at(name, "holds reflectance at normal incidence alone",
                      "data of n and k, or " + setting("term"));
    const SeenStack seen(optics, request_.options, Method::nm1, name);
    ColorCurve& curve = curves.emplace_back(ColorCurve{name, {}, {}});
    const auto steps = static_cast<int>(std::lround(90 / request_.step_deg));
    for (int i = 0; i <= steps; ++i) {
      curve.x.push_back(90.0 * i / steps);
      curve.rgb.push_back(seen(i == steps ? 0 : math::cos(curve.x.back() * radian)));
    }
  }

  // The surface of the subject, of which the next curves are.
  void take_surface(const CurveSubject& subject) {
    SurfaceWishes wishes = request_.surface;
    if (kind_ == CurveKind::fresnel) {
      // F depends neither on the roughness nor on the body, of which there is nothing to remark.
      wishes.gloss = 1;
      wishes.opacity = 1;
    }
    surface_ = subject.material != nullptr
                   ? surface_of(*subject.material, subject.material->datasets[subject.dataset], wishes,
                                request_.options, remarks_)
                   : typed_surface(
                         subject.words.empty() ? std::vector<std::string>{"f0=0.04"} : subject.words, wishes);
    label_ = name_of(subject);
    if (!label_.empty()) label_ += ", ";
  }

  void add(const Term& term, const NamedNumbers& set) {
    Model parameters;  // of the term alone
    parameters.id = term.id;
    parameters.parameters = term.parameters;
    const std::vector<double> values = values_of(parameters, set);
    add(term_curve(term, values, request_.light_deg, request_.step_deg), parameters, values);
    if (kind_ == CurveKind::masking)
      times(
          [&](double deg) { return std::abs(deg) == 90 ? 0 : 4 * light_cosine() * math::cos(deg * radian); });
  }

  void add(const Model& model, const NamedNumbers& set) {
    const std::vector<double> values = values_of(model, set);
    add(lobe_curve(model, values, request_.light_deg, request_.step_deg), model, values);
    times([&](double) { return light_cosine(); });
  }

  std::vector<ColorCurve> curves;

 private:
  double light_cosine() const { return math::cos(request_.light_deg * radian); }

  std::vector<double> values_of(const Model& model, const NamedNumbers& set) {
    std::vector<ClampedValue> clamped;
    std::vector<double> out = model_values(model, surface_, set, &clamped);
    for (const ClampedValue& each : clamped) remarks_.push_back(clamped_remark(each));
    return out;
  }

  void add(LobeCurve curve, const Model& model, const std::vector<double>& values) {
    curves.push_back({label_ + std::string(model.id) + numbers_text(model.parameters, values),
                      std::move(curve.angle_deg), std::move(curve.rgb)});
  }

  template <class Factor>
  void times(Factor factor) {
    ColorCurve& curve = curves.back();
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      for (double& each : curve.rgb[i]) each *= factor(curve.x[i]);
  }

  const CurveRequest& request_;
  CurveKind kind_;
  std::vector<std::string>& remarks_;
  SurfaceValues surface_;
  std::string label_;
};

// The curves of every subject. Throws Error.
std::vector<ColorCurve> curves_of(const CurveRequest& request, CurveKind kind,
                                  std::span<const CurveSubject> subjects, std::vector<std::string>& remarks) {
  const bool fresnel = kind == CurveKind::fresnel, lobe = kind == CurveKind::lobe,
             spectrum = kind == CurveKind::reflectance;
  std::vector<const Term*> all;
  if (!lobe && !spectrum) all = terms_of(request, kind);
  if (all.empty() && !lobe && !spectrum && !fresnel)
    throw Error::at("etak curve", "no term for " + setting("of") + " " + request.of,
                    setting("term") + " or " + setting("model"));
  std::vector<const Model*> lobes;
  if (lobe) {
    if (request.models.empty()) lobes.push_back(find_model(default_specular));
    for (const std::string& id : request.models) lobes.push_back(model_named(setting("model"), id, {}));
    if (std::ranges::find(lobes, nullptr) != lobes.end())
      throw Error::at(setting("model"), "none", "a model, which has a lobe");
  }
  std::vector<NamedNumbers> sets;
  for (const auto& words : curve_groups(request.set)) sets.push_back(typed_set(words));
  if (sets.empty()) sets.emplace_back();
  Curves out(request, kind, remarks);
  for (const CurveSubject& subject : subjects) {
    const bool default_fresnel = fresnel && all.empty();
    if (spectrum || (default_fresnel && subject.material != nullptr)) {
      out.add_spectrum(subject);
      continue;
    }
    if (std::ranges::find(all, nullptr) != all.end()) out.add_spectrum(subject);
    out.take_surface(subject);
    for (const NamedNumbers& set : sets) {
      if (default_fresnel) out.add(*find_term(TermKind::fresnel, "exact"), set);
      for (const Term* each : all)
        if (each != nullptr) out.add(*each, set);
      for (const Model* each : lobes) out.add(*each, set);
    }
  }
  return std::move(out.curves);
}

}  // namespace

std::vector<std::vector<std::string>> curve_groups(const std::vector<std::string>& words) {
  std::vector<std::vector<std::string>> out;
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('=') + 1);  // "f0="; empty for materials
    const bool next =
        out.empty() || name.empty() || std::ranges::any_of(out.back(), [&](const std::string& each) {
          return each.find('=') == each.npos || each.starts_with(name);
        });
    if (next) out.emplace_back();
    out.back().push_back(word);
  }
  return out;
}

void check(const CurveRequest& request, std::size_t subjects) {
  const CurveKind kind = kind_of(request);
  const std::string of = setting("of") + " " + request.of;
  place_of("channel", request.channel, curve_channels);
  place_of("scale", request.scale, radial_scales);
  if (!(request.light_deg >= 0 && request.light_deg <= 89.9))
    throw Error::at(setting("light"), number(request.light_deg, 6), "0 to 89.9");
  if (!(request.step_deg >= 0.01 && request.step_deg <= 45))
    throw Error::at(setting("step"), number(request.step_deg, 6), "0.01 to 45");
  const bool lobe = kind == CurveKind::lobe, spectrum = kind == CurveKind::reflectance;
  if (!request.terms.empty() && (lobe || spectrum))
    throw Error::at(setting("term"), "given with " + of, lobe ? setting("model") : "a material alone");
  if (!request.models.empty() && spectrum)
    throw Error::at(setting("model"), "given with " + of, "a material alone");
  const bool of_data =
      spectrum || (kind == CurveKind::fresnel && request.terms.empty() && request.models.empty());
  if (!request.set.empty() && of_data)
    throw Error::at(setting("set"), "given without a term or model",
                    setting("term") + " or " + setting("model") + ", whose numbers it sets");
  if (request.scale != "linear" && (!lobe || request.straight))
    throw Error::at(setting("scale"), request.scale, setting("of") + " lobe without " + setting("straight"));
  if (subjects == 0 && (lobe || spectrum || kind == CurveKind::fresnel))
    throw Error::at("etak curve", "no material", "a material, or numbers such as f0=0.04");
}

AskedCurves asked_curves(const CurveRequest& request, std::span<const CurveSubject> subjects,
                         std::vector<std::string>& remarks) {
  const CurveKind kind = kind_of(request);
  std::vector<PlotChannel> channels{PlotChannel::red, PlotChannel::green, PlotChannel::blue};
  if (request.channel != "rgb")
    channels = {static_cast<PlotChannel>(place_of("channel", request.channel, plot_channels))};
  AskedCurves out{curves_plot(kind, curves_of(request, kind, subjects, remarks), channels, request.light_deg),
                  {}};
  if (kind == CurveKind::lobe && !request.straight)
    out.polar = polar_plot(out.plot, request.light_deg,
                           static_cast<RadialScale>(place_of("scale", request.scale, radial_scales)));
  return out;
}

std::string AskedCurves::text(std::string_view form, std::string_view of, bool dark) const {
  if (form == "csv") return csv(plot);
  if (form == "json") return curves_json(plot, of);
  return polar ? svg_file(*polar, dark) : svg_file(plot, dark);
}

}  // namespace etak
