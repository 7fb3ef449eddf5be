// SPDX-License-Identifier: Apache-2.0
#include "tests/gui/view_states.h"

#include <algorithm>
#include <cstdlib>

#include "core/color/delta_e.h"
#include "core/color/srgb.h"

namespace etak::test {
namespace {

Lab lab_of(QRgb code) {
  const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
  return to_lab(srgb_decode(Srgb8{byte(qRed(code)), byte(qGreen(code)), byte(qBlue(code))}));
}

}  // namespace

ViewState gold_state() {
  ViewState out;
  SurfaceValues& surface = out.a.surface;
  surface.f0 = {1.0, 0.78, 0.34};
  surface.f82 = {0.99, 0.9, 0.7};
  solve_index(surface);
  surface.gloss = 0.6;
  out.a.specular = find_model(default_specular);
  out.a.diffuse = find_model(default_diffuse);
  out.a.label = "gold";
  out.b = out.a;
  out.b.surface.gloss = 0.4;
  out.b.label = "dull gold";
  out.lights = default_lights();
  return out;
}

ViewState state_with(const Model& model) {
  ViewState out = gold_state();
  if (model.kind == ModelKind::diffuse) {
    out.a.specular = nullptr;
    out.a.diffuse = &model;
  } else {
    out.a.specular = &model;
    if (model.kind == ModelKind::combined) out.a.diffuse = nullptr;
  }
  out.a.surface.diffuse = {0.4, 0.3, 0.2};
  return out;
}

Apart apart(const QImage& a, const QImage& b, const Image& coverage) {
  Apart out;
  double sum = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      if (coverage.at(x, y)[3] < 1) continue;
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      const int most = std::max(
          {std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
      if (most > out.codes) {
        out.codes = most;
        out.x = x;
        out.y = y;
      }
      if (most > 0) sum += delta_e2000(lab_of(p), lab_of(q));
      ++out.pixels;
    }
  out.delta_e = out.pixels > 0 ? sum / out.pixels : 0;
  return out;
}

}  // namespace etak::test
