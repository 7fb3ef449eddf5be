// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/text/text.h"
#include "core/exchange/targets/spectra.h"

namespace etak {
namespace {

std::string pbrt_body(const ExportSurface& s, const EngineValues& values) {
  const auto spectrum = [&](const char* name, bool of_k) {
    return std::string("\n    \"spectrum ") + name + "\" [ " + spectrum_text(s, of_k, " ", "  ") + " ]";
  };
  const auto rgb = [](const char* name, const std::vector<double>& c) {
    return std::string("\n    \"rgb ") + name + "\" [ " + number(c[0], 6) + " " + number(c[1], 6) + " " +
           number(c[2], 6) + " ]";
  };
  const bool metal = s.kind == SurfaceKind::metal, bare = s.spectrum.empty();
  const EngineField& first = values.fields.front();
  std::string out = "# " + line_text(s.title()) + "\nMakeNamedMaterial \"" + identifier(s.node_name()) +
                    "\" \"string type\" ";
  const std::string one_eta = "\n    \"float eta\" " + number(one_index(s), 6);
  if (metal)
    out += "\"conductor\"" +
           (bare ? rgb("reflectance", first.values) : spectrum("eta", false) + spectrum("k", true));
  else if (s.diffuse == LinearRgb{})
    out += "\"dielectric\"" + (bare ? one_eta : spectrum("eta", false));
  else
    out +=
        "\"coateddiffuse\"" + rgb("reflectance", list(s.diffuse)) + (bare ? one_eta : spectrum("eta", false));
  return out + "\n    \"float roughness\" " + number(s.gloss.alpha(), 6) +
         "  \"bool remaproughness\" false\n";
}

void write_pbrt(const TargetJob& j) {
  write_spectral(j);
  if (j.s.spectrum.empty()) {
    Vec3 k{};  // that pbrt gives to a reflectance, with n 1
    for (std::size_t c = 0; c < 3; ++c) {
      const double r = std::clamp(vec(j.s.f0)[c], 0.0, 0.9999);
      k[c] = 2 * std::sqrt(r / (1 - r));
    }
    j.metal() ? j.shows_conductor({1, 1, 1}, to_rgb(k)) : j.shows_dielectric(one_index(j.s));
  }
  if (j.s.opacity < 1)
    j.note("no field for the opacity " + number(j.s.opacity, 4) + ": it is the alpha of a shape");
}

}  // namespace

constinit const TargetRow target_pbrt{
    {.id = "pbrt",
     .title = "pbrt",
     .version = "4",
     .formula = "where there are no spectra: Fresnel's equations, of a metal with n 1",
     .unstated = spectral,
     .opens = "# Materials of pbrt-v4\n"},
    write_pbrt,
    pbrt_body};

}  // namespace etak
