// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/color/luminance.h"
#include "core/render/cpu_renderer.h"
#include "core/render/reference.h"

namespace etak {

AmbientError ambient_error(Scene scene, const Environment* environment, const ReferenceOptions& options) {
  scene.lights.lights.clear();
  const Reference reference = render_reference(scene, environment, options);
  Image quick;
  render_cpu(scene, environment, options.threads, Precision::f64, quick);
  AmbientError out;
  double level = 0, count = 0;
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      const auto truth = reference.picture.at(x, y);
      const auto shown = quick.at(x, y);
      if (truth[3] < 1 || shown[3] < 1) continue;
      const double right = luminance_of({truth[0], truth[1], truth[2]});
      const double off = luminance_of({shown[0], shown[1], shown[2]}) - right;
      level += right;
      out.bias += off;
      out.mean += std::abs(off);
      out.worst = std::max(out.worst, std::abs(off));
      ++count;
    }
  if (count == 0 || level <= 0) return out;
  const double mean_level = level / count;
  out.mean /= level;
  out.bias /= level;
  out.worst /= mean_level;
  out.standard_error = reference.standard_error / mean_level;
  return out;
}

}  // namespace etak
