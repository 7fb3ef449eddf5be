// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/options/scene.h"
#include "app/cli/output/output.h"
#include "app/cli/output/replace.h"
#include "app/cli/pictures/pictures.h"
#include "app/cli/verbs.h"
#include "core/base/text/text.h"
#include "core/image/files/png.h"
#include "core/pages/asked_curves.h"
#include "core/plot/svg_picture.h"

namespace etak::cli {
namespace {

struct CurveArguments {
  SceneArguments scene;
  CurveRequest request;
  bool dark = false;
  OutputArguments output;
};

int run(CurveArguments& arguments) {
  check_output(arguments.output);
  CurveRequest& request = arguments.request;
  SceneArguments& scene = arguments.scene;
  request.set = scene.set;
  request.surface = surface_wishes(scene);
  auto groups = curve_groups(scene.subject);
  check(request, groups.size());
  request.options = f0_options(scene.compute, scene.library);
  if (groups.empty()) groups.emplace_back();
  SceneNotes notes;
  std::vector<CurveSubject> subjects;
  for (const auto& words : groups) {
    CurveSubject& subject = subjects.emplace_back(CurveSubject{words, nullptr, 0});
    scene.subject = words;
    if (words.empty() || is_typed(scene)) continue;
    const auto found = std::make_shared<const SubjectMaterial>(subject_material(scene, notes));
    subject.material = {found, &found->material};
    subject.dataset = found->at;
  }
  const AskedCurves curves = asked_curves(request, subjects, notes.remarks);
  for (const std::string& each : notes.remarks) remark(arguments.output, each);
  std::string out = curves.text(arguments.output.format, request.of, arguments.dark);
  if (arguments.output.format == "png")
    out = png_bytes(svg_picture(out, picture_door().text), {.srgb = true});
  write_output(arguments.output, out);
  return exit_ok;
}

}  // namespace

void add_curve(CommandLine& line) {
  const auto arguments = std::make_shared<CurveArguments>();
  Command verb = line.verb("curve", "reflectance, terms and lobes as curves, several in one plot");
  verb.option(
          "--of", arguments->request.of,
          "F over the angle of incidence; D over that of the half vector; G or V = G / (4 nl nv), and lobe, f_r nl, over that of the viewer; R over wavelength")
      .one_of({curve_kinds.begin(), curve_kinds.end()})
      .show_default();
  verb.option("--model", arguments->request.models,
              "model of the lobe, or whose term is drawn; may be given again; default of lobes " +
                  std::string(default_specular))
      .value_name("MODEL")
      .one_at_a_time();
  verb.option(
          "--term", arguments->request.terms,
          "a term that etak models lists, or spectrum: F of every wavelength, the default of materials; may be given again")
      .value_name("TERM")
      .one_at_a_time();
  verb.option("--light", arguments->request.light_deg,
              "angle of the light from the normal in degrees, for G, V and lobe")
      .range(0.0, 89.9)
      .show_default();
  verb.option("--step", arguments->request.step_deg,
              "between the angles in degrees, or the nearest that divides 90 evenly")
      .range(0.01, 45.0)
      .show_default();
  verb.option("--channel", arguments->request.channel, "of linear sRGB; rgb: all three")
      .one_of({curve_channels.begin(), curve_channels.end()})
      .show_default();
  verb.option("--scale", arguments->request.scale, "of the radius of lobes")
      .one_of({"linear", "log"})
      .show_default();
  verb.flag("--straight", arguments->request.straight,
            "lobes over a straight axis instead of around the normal");
  verb.flag("--dark", arguments->dark, "on a dark background");
  add_subject_options(verb, arguments->scene);
  add_output_options(verb, arguments->output, {"csv", "svg", "png", "json"});
  verb.footer(
      "In plots of F, Hoffman's zones are marked: it barely changes up to 45 degrees, changes up to 75, and\n"
      "rushes to white from there.\nExample:\n  etak curve gold copper water --format svg");
  verb.runs([arguments] { return run(*arguments); });
}

}  // namespace etak::cli
