// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "app/cli/options/scene.h"
#include "app/cli/output/output.h"
#include "app/cli/output/replace.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/pages/material_plots.h"

namespace etak::cli {
namespace {

struct CurveArguments {
  SceneArguments scene;
  std::vector<std::string> models, terms;
  std::string of = "F", channel = "luminance", scale = "linear";
  double light = 45, step = 0.5;
  bool straight = false, dark = false;
  OutputArguments output;
};

constexpr std::array<std::string_view, 6> kinds{"F", "D", "G", "V", "lobe", "R"};  // as CurveKind has them
constexpr std::string_view of_spectrum = "spectrum";  // the F of a material that no term approximates
constexpr double radian = std::numbers::pi / 180;

// The words of each subject, or those of --set for each curve: a material is one word. Of numbers each name
// stands once; where a name comes again, the next group begins.
std::vector<std::vector<std::string>> grouped(const std::vector<std::string>& words) {
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

// The terms of --term and of the models of --model, each once; null stands for the spectrum. Throws Error.
std::vector<const Term*> terms_of(const CurveArguments& arguments, CurveKind kind) {
  const TermKind wanted = kind == CurveKind::fresnel        ? TermKind::fresnel
                          : kind == CurveKind::distribution ? TermKind::distribution
                                                            : TermKind::visibility;
  std::vector<const Term*> out;
  for (const std::string& id : arguments.terms) {
    out.push_back(find_term(wanted, id));
    if (out.back() != nullptr || (wanted == TermKind::fresnel && id == of_spectrum)) continue;
    std::string known(wanted == TermKind::fresnel ? of_spectrum : "");
    for (const Term& each : terms())
      if (each.kind == wanted) append(known, known.empty() ? "" : ", ", each.id);
    throw Error::at("--term", printable(id) + " with --of " + arguments.of, known);
  }
  for (const std::string& id : arguments.models) {
    const Model* model = model_named("--model", id, {});
    const Term* term = model == nullptr                   ? nullptr
                       : wanted == TermKind::fresnel      ? model->fresnel
                       : wanted == TermKind::distribution ? model->distribution
                                                          : model->visibility;
    if (term == nullptr)
      throw Error::at("--model", id + " has no term " + std::string(name(wanted)),
                      "a model of three terms, such as ggx-schlick, or --term");
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
  Curves(CurveArguments& arguments, CurveKind kind) : arguments_(arguments), kind_(kind) {}

  // R over wavelength, or F at all angles, of a material's data. Throws Error where they do not tell it.
  void add_spectrum() {
    SceneArguments& scene = arguments_.scene;
    if (is_typed(scene)) throw Error::at(joined(scene.subject, " "), "has no spectrum", "a material");
    if (scene.compute.axis_average)
      throw Error::at("--axis-average", "with the curve of one dataset", "--dataset of an axis, or --term");
    const SubjectMaterial found = subject_material(scene, notes_);
    const Optics& optics = found.dataset().optics;
    const F0Options options = f0_options(scene.compute, scene.library);
    if (kind_ == CurveKind::reflectance) {
      const OpticsCurves all = curves_of(optics, options);
      if (all.r0.empty()) throw Error::at(notes_.subject, "holds no data", "data within 360 to 830 nm");
      ColorCurve& curve = curves.emplace_back(ColorCurve{notes_.subject, all.r_nm, {}});
      for (const double value : all.r0) curve.rgb.push_back({value, value, value});
      return;
    }
    const auto* constants = std::get_if<OpticalConstants>(&optics);
    if (constants == nullptr)
      throw Error::at(notes_.subject, "holds reflectance at normal incidence alone",
                      "data of n and k, or --term");
    const SeenFresnel seen(*constants, notes_.subject, options);
    ColorCurve& curve = curves.emplace_back(ColorCurve{notes_.subject, {}, {}});
    const auto steps = static_cast<int>(std::lround(90 / arguments_.step));
    for (int i = 0; i <= steps; ++i) {
      curve.x.push_back(90.0 * i / steps);
      curve.rgb.push_back(seen(i == steps ? 0 : std::cos(curve.x.back() * radian)));
    }
  }

  // The surface of the subject, of which the next curves are.
  void take_surface(bool named) {
    surface_ = subject_surface(arguments_.scene, notes_);
    label_ = named ? notes_.subject + ", " : "";
  }

  void add(const Term& term) {
    Model parameters;  // of the term alone
    parameters.id = term.id;
    parameters.parameters = term.parameters;
    const std::vector<double> values = values_of(parameters);
    add(term_curve(term, values, arguments_.light, arguments_.step), parameters, values);
    if (kind_ == CurveKind::masking)
      times(
          [&](double deg) { return std::abs(deg) == 90 ? 0 : 4 * light_cosine() * std::cos(deg * radian); });
  }

  void add(const Model& model) {
    const std::vector<double> values = values_of(model);
    add(lobe_curve(model, values, arguments_.light, arguments_.step), model, values);
    times([&](double) { return light_cosine(); });
  }

  void tell() const {
    for (const std::string& each : notes_.remarks) remark(arguments_.output, each);
  }

  std::vector<ColorCurve> curves;

 private:
  double light_cosine() const { return std::cos(arguments_.light * radian); }

  std::vector<double> values_of(const Model& model) {
    std::vector<ClampedValue> clamped;
    std::vector<double> out = model_values(model, surface_, read_set(arguments_.scene.set), &clamped);
    for (const ClampedValue& each : clamped) notes_.remarks.push_back(clamped_remark(each));
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

  CurveArguments& arguments_;
  CurveKind kind_;
  SceneNotes notes_;
  SurfaceValues surface_;
  std::string label_;
};

// Refuses what the curves of this kind do not have. Throws Error.
void check(const CurveArguments& arguments, CurveKind kind) {
  const bool lobe = kind == CurveKind::lobe, spectrum = kind == CurveKind::reflectance;
  if (!arguments.terms.empty() && (lobe || spectrum))
    throw Error::at("--term", "given with --of " + arguments.of, lobe ? "--model" : "a material alone");
  if (!arguments.models.empty() && spectrum)
    throw Error::at("--model", "given with --of R", "a material alone");
  const bool of_data =
      spectrum || (kind == CurveKind::fresnel && arguments.terms.empty() && arguments.models.empty());
  if (!arguments.scene.set.empty() && of_data)
    throw Error::at("--set", "given without a term or model", "--term or --model, whose numbers it sets");
  if (arguments.scale != "linear" && (!lobe || arguments.straight))
    throw Error::at("--scale", arguments.scale, "--of lobe without --straight");
  if (arguments.scene.subject.empty() && (lobe || spectrum || kind == CurveKind::fresnel))
    throw Error::at("etak curve", "no material", "a material, or numbers such as f0=0.04");
}

std::vector<ColorCurve> curves_of(CurveArguments& arguments, CurveKind kind) {
  std::vector<const Term*> all;
  if (kind != CurveKind::lobe && kind != CurveKind::reflectance) all = terms_of(arguments, kind);
  if (all.empty() && kind != CurveKind::lobe && kind != CurveKind::reflectance && kind != CurveKind::fresnel)
    throw Error::at("etak curve", "no term for --of " + arguments.of, "--term or --model");
  std::vector<const Model*> lobes;
  if (kind == CurveKind::lobe) {
    if (arguments.models.empty()) lobes.push_back(find_model(default_specular));
    for (const std::string& id : arguments.models) lobes.push_back(model_named("--model", id, {}));
    if (std::ranges::find(lobes, nullptr) != lobes.end())
      throw Error::at("--model", "none", "a model, which has a lobe");
  }
  auto subjects = grouped(arguments.scene.subject), sets = grouped(arguments.scene.set);
  if (sets.empty()) sets.emplace_back();
  const bool named = !subjects.empty();
  if (!named) subjects = {{"f0=0.04"}};  // D, G and V depend on the roughness alone
  if (kind == CurveKind::fresnel) {
    // F depends neither on the roughness nor on the body, of which there is nothing to remark.
    arguments.scene.rough = {.gloss = 1, .roughness = {}};
    arguments.scene.opacity = 1;
  }
  Curves out(arguments, kind);
  for (const auto& words : subjects) {
    arguments.scene.subject = words;
    const bool default_fresnel = kind == CurveKind::fresnel && all.empty();
    if (kind == CurveKind::reflectance || (default_fresnel && !is_typed(arguments.scene))) {
      out.add_spectrum();
      continue;
    }
    if (std::ranges::find(all, nullptr) != all.end()) out.add_spectrum();
    out.take_surface(named);
    for (const auto& set : sets) {
      arguments.scene.set = set;
      if (default_fresnel) out.add(*find_term(TermKind::fresnel, "exact"));
      for (const Term* each : all)
        if (each != nullptr) out.add(*each);
      for (const Model* each : lobes) out.add(*each);
    }
  }
  out.tell();
  return std::move(out.curves);
}

int run(CurveArguments& arguments) {
  check_output(arguments.output);
  const auto kind = static_cast<CurveKind>(std::ranges::find(kinds, arguments.of) - kinds.begin());
  check(arguments, kind);
  std::vector<PlotChannel> channels{PlotChannel::red, PlotChannel::green, PlotChannel::blue};
  if (arguments.channel != "rgb")
    channels = {static_cast<PlotChannel>(std::ranges::find(plot_channels, arguments.channel) -
                                         plot_channels.begin())};
  const LinePlot plot = curves_plot(kind, curves_of(arguments, kind), channels, arguments.light);
  const bool polar = kind == CurveKind::lobe && !arguments.straight;
  const auto scale = arguments.scale == "log" ? RadialScale::logarithmic : RadialScale::linear;
  write_output(arguments.output, arguments.output.format == "csv"    ? csv(plot)
                                 : arguments.output.format == "json" ? curves_json(plot, arguments.of)
                                 : polar ? svg_file(polar_plot(plot, arguments.light, scale), arguments.dark)
                                         : svg_file(plot, arguments.dark));
  return exit_ok;
}

}  // namespace

void add_curve(CommandLine& line) {
  const auto arguments = std::make_shared<CurveArguments>();
  Command verb = line.verb("curve", "reflectance, terms and lobes as curves, several in one plot");
  verb.option("--of", arguments->of,
              "F over the angle of incidence; D over that of the half vector; G or V = G / (4 nl nv), and "
              "lobe, f_r "
              "nl, over that of the viewer; R over wavelength")
      .one_of({kinds.begin(), kinds.end()})
      .show_default();
  verb.option("--model", arguments->models,
              "model of the lobe, or whose term is drawn; may be given again; default of lobes " +
                  std::string(default_specular))
      .value_name("MODEL")
      .one_at_a_time();
  verb.option("--term", arguments->terms,
              "a term that etak models lists, or spectrum: F of every wavelength, the default of materials; "
              "may be "
              "given again")
      .value_name("TERM")
      .one_at_a_time();
  verb.option("--light", arguments->light, "angle of the light from the normal in degrees, for G, V and lobe")
      .range(0.0, 89.9)
      .show_default();
  verb.option("--step", arguments->step,
              "between the angles in degrees, or the nearest that divides 90 evenly")
      .range(0.01, 45.0)
      .show_default();
  verb.option("--channel", arguments->channel, "of linear sRGB; rgb: all three")
      .one_of({"luminance", "red", "green", "blue", "rgb"})
      .show_default();
  verb.option("--scale", arguments->scale, "of the radius of lobes").one_of({"linear", "log"}).show_default();
  verb.flag("--straight", arguments->straight, "lobes over a straight axis instead of around the normal");
  verb.flag("--dark", arguments->dark, "on a dark background");
  add_subject_options(verb, arguments->scene);
  add_output_options(verb, arguments->output, {"csv", "svg", "json"});
  verb.footer(
      "In plots of F, Hoffman's zones are marked: it barely changes up to 45 degrees, changes up to 75, and\n"
      "rushes to white from there.\nExample:\n  etak curve gold copper water --format svg");
  verb.runs([arguments] { return run(*arguments); });
}

}  // namespace etak::cli
