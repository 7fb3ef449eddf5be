// SPDX-License-Identifier: Apache-2.0
#include "core/base/text/text.h"
#include "core/exchange/targets/rgb_index.h"
#include "core/math/functions.h"

namespace etak {
namespace {

// LuxCore draws in three channels: it reduces spectra in files to one n and k a channel, and has this F of a metal
// (fresneltexture.cpp, GeneralEvaluate), whose angle inside is that of a body without k.
double luxcore_f(double n, double k, double cosine) {
  const double sine2 = std::min((1 - cosine * cosine) / (n * n), 1.0), cosine2 = 1 - sine2;
  const double a = 2 * k * k * sine2, inside2 = (cosine2 + math::hypot(cosine2, a)) / 2;
  const double size = n * n + k * k, cross = 2 * cosine * std::sqrt(inside2) * n;
  const double p = size * cosine * cosine + inside2, s = size * inside2 + cosine * cosine;
  return ((p - cross) / (p + cross) + (s - cross) / (s + cross)) / 2;
}

void write_luxcore(const TargetJob& j) {
  if (j.metal()) {
    const RgbIndex index = rgb_index(j.s);
    note_residual(j, index);
    j.add("n", index.n, plain_text);
    j.add("k", index.k, plain_text);
    j.shows_conductor(index.n, index.k, luxcore_f);
    if (!j.s.spectrum.empty())
      j.note("n and k of each channel give F0 and F82; from spectra LuxCore would make n and k of its own");
  } else if (j.clear()) {
    const double ior = j.index();
    j.add("interiorior", ior);
    j.add("kt", j.s.clear->depth_m > 0 ? grey(1) : j.s.clear->color, plain_text);
    j.shows_dielectric(ior);
    j.note_absorption("a volume of type clear takes it");
  } else {
    const LinearRgb ks = j.fit_f0("ks", "colours of a material end at 1");
    j.add("kd", j.layered_body(), plain_text);
    j.add("ks", ks, plain_text);
    j.schlick_edge(ks);
    j.shows_schlick(ks);
  }
  if (!j.clear() || j.s.gloss.alpha() > 0) {
    j.add("uroughness", j.s.gloss.alpha());
    j.add("vroughness", j.s.gloss.alpha());
  }
  // LuxCore's word for the share that is there.
  j.opacity("transparency");
}

std::string luxcore_body(const ExportSurface& s, const EngineValues& values) {
  const std::string id = identifier(s.node_name()), material = "scene.materials." + id + ".",
                    fresnel = "scene.textures." + id + "_fresnel.";
  const bool metal = s.kind == SurfaceKind::metal;
  const auto line = [](const std::string& name, const std::string& value) {
    return name + " = " + value + '\n';
  };
  std::string out = "# " + line_text(s.title()) + '\n';
  if (metal) out += line(fresnel + "type", "\"fresnelconst\"");
  std::string rest = line(material + "type", metal                  ? "\"metal2\""
                                             : !s.clear             ? "\"glossy2\""
                                             : s.gloss.alpha() == 0 ? "\"glass\""
                                                                    : "\"roughglass\"");
  if (metal) rest += line(material + "fresnel", '"' + id + "_fresnel\"");
  for (const EngineField& field : values.fields) {
    const bool of_texture = metal && (field.name == "n" || field.name == "k");
    (of_texture ? out : rest) +=
        line((of_texture ? fresnel : material) + field.name,
             joined(field.values, " ", [](double value) { return number(value, 6); }));
  }
  return out + rest;
}

}  // namespace

constinit const TargetRow target_luxcore{
    {.id = "luxcore",
     .title = "LuxCore",
     .version = "2.10",
     .formula =
         "GeneralEvaluate of n and k a channel (metal2), Schlick (glossy2), Fresnel's equations (glass)",
     .opens = "# Materials of LuxCore\n"},
    write_luxcore,
    luxcore_body};

}  // namespace etak
