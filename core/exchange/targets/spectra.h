// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text/text.h"
#include "core/exchange/targets/target.h"

namespace etak {

/// The samples of n (or of k) of a surface as a text, each formed by `sample`, with `between` them.
inline std::string spectrum_text(const ExportSurface& s, bool of_k, const char* within, const char* between) {
  return joined(s.spectrum, between, [&](const IndexSample& each) {
    return number(each.nm, 6) + within + number(of_k ? each.k : each.n, 6);
  });
}

/// The fields of a target that takes spectra: n and k at 550 nm, which stand for the whole, and the width of the lobe.
inline void write_spectral(const TargetJob& j) {
  if (j.s.spectrum.empty()) {
    const LinearRgb f0 = j.fit_f0("F0", "a colour of reflectance ends at 1");
    j.add("F0", f0, plain_text);
    const std::string used = j.metal() ? "the colour of all angles is F0" : "the index is that of F0";
    j.note((j.s.film ? "layers are not written: " : "there are no spectra of n and k: ") + used +
           (j.s.film ? " of the whole" : ""));
  } else {
    for (const IndexSample& each : j.s.spectrum)
      if (each.nm == 550) {
        j.add("eta at 550 nm", each.n);
        j.add("k at 550 nm", each.k);
      }
  }
  if (!j.black_body()) j.add("diffuse", j.s.diffuse, plain_text);
  j.add("alpha", j.s.gloss.alpha());
}

/// The index of a dielectric that has no spectrum, or a target with one index: that of the luminance of F0.
inline double one_index(const ExportSurface& s) {
  return ior_of_f0(std::clamp(luminance(s.f0, s.space), 0.0, largest_dielectric_f0));
}

inline constexpr std::string_view spectral = "takes n and k of each wavelength themselves";

}  // namespace etak
