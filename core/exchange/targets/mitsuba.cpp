// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/text/text.h"
#include "core/exchange/targets/spectra.h"

namespace etak {
namespace {

std::string mitsuba_body(const ExportSurface& s, const EngineValues& values) {
  const auto spectrum = [&](const char* name, bool of_k) {
    return std::string("    <spectrum name=\"") + name + "\" value=\"" + spectrum_text(s, of_k, ":", ", ") +
           "\"/>\n";
  };
  const auto rgb = [](const char* name, const LinearRgb& c) {
    return std::string("    <rgb name=\"") + name + "\" value=\"" + plain_text(c) + "\"/>\n";
  };
  const auto real = [](const char* name, double value) {
    return std::string("    <float name=\"") + name + "\" value=\"" + number(value, 6) + "\"/>\n";
  };
  const bool metal = s.kind == SurfaceKind::metal, smooth = s.gloss.alpha() == 0, bare = s.spectrum.empty();
  const std::string type = metal ? "conductor" : s.diffuse == LinearRgb{} ? "dielectric" : "plastic";
  std::string out = material_x_comment(s.title()) + "  <bsdf type=\"" + (smooth ? "" : "rough") + type +
                    "\" id=\"" + identifier(s.node_name()) + "\">\n";
  if (metal && bare) {
    const std::vector<double>& f0 = values.fields.front().values;
    out += "    <string name=\"material\" value=\"none\"/>\n" +
           rgb("specular_reflectance", {f0[0], f0[1], f0[2]});
  } else if (metal) {
    out += spectrum("eta", false) + spectrum("k", true);
  } else {
    out += real("int_ior", one_index(s));
    if (type == "plastic") out += rgb("diffuse_reflectance", s.diffuse);
  }
  if (!smooth) out += "    <string name=\"distribution\" value=\"ggx\"/>\n" + real("alpha", s.gloss.alpha());
  out += "  </bsdf>\n";
  if (s.opacity == 1) return out;
  // A surface that is partly there stands in a mask, which then has the name.
  const std::string id = " id=\"" + identifier(s.node_name()) + "\"";
  out.erase(out.find(id), id.size());
  return "  <bsdf type=\"mask\"" + id + ">\n" + real("opacity", s.opacity) + out + "  </bsdf>\n";
}

void write_mitsuba(const TargetJob& j) {
  write_spectral(j);
  if (!j.metal())
    j.shows_dielectric(one_index(j.s));
  else if (j.s.spectrum.empty())
    j.shows([&](double) { return vec(j.s.f0); });
  j.opacity("opacity");
  if (!j.metal()) j.note("a dielectric of Mitsuba has one index: " + j.index_text());
}

}  // namespace

constinit const TargetRow target_mitsuba{
    {.id = "mitsuba",
     .title = "Mitsuba",
     .version = "3.5",
     .formula = "Fresnel's equations of a dielectric; of a metal without spectra F0",
     .unstated = spectral,
     .opens = "<scene version=\"3.0.0\">\n",
     .closes = "</scene>\n"},
    write_mitsuba,
    mitsuba_body};

}  // namespace etak
