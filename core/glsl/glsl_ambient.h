// SPDX-License-Identifier: Apache-2.0
// The part of a shader that adds the light from all around, by the table of the surface (core/render/ambient/ambient.h).
#pragma once

#include <memory>
#include <string>

#include "core/glsl/glsl_glue.h"
#include "core/render/ambient/ambient.h"

namespace etak {

/// Lines for the function shade() of a shader, which has normal `n` and viewer `v` and adds to `sum`. Each declares what it
/// needs when it is first asked for.
class GlslAmbient {
 public:
  ///   f0, gloss   GLSL expressions of the surface's values; empty for values that are the same everywhere, which
  ///               become uniforms
  GlslAmbient(GlslGlue& glue, const Scene& scene, const Textured& varies, std::string f0, std::string gloss);

  /// Specular light of an environment.
  ///   to_map   the GLSL expression of a direction in its map
  template <class ToMap>
  std::string environment(const ToMap& to_map) {
    if (!table_->samples.empty()) return samples("environment_sample(" + to_map("axis") + ", s.w)");
    return needs_probes() + "  sum += ambient_albedo * (" + sum_of_probes([&](const std::string& probe) {
             return "environment_specular(" + to_map("probe_axis(n, v, nv, " + probe + ".x)") + ", " + probe +
                    ".y)";
           }) +
           ");\n";
  }

  /// Specular light of the scene's hemispheres.
  std::string hemispheres();

  /// The diffuse light `light`, an expression for a body whose albedo is its colour.
  std::string diffuse(const std::string& light);

 private:
  template <class Seen>
  static std::string sum_of_probes(const Seen& seen) {
    std::string out;
    for (std::size_t k = 0; k < probe_count; ++k) {
      const std::string probe = "probe_" + std::to_string(k);
      out += (k == 0 ? "" : " +\n      ") + probe + ".z * " + seen(probe);
    }
    return out;
  }
  std::string needs_cosine();
  std::string needs_probes();
  std::string samples(const std::string& seen);

  GlslGlue& glue_;
  const Scene& scene_;
  std::shared_ptr<const AmbientTable> table_;
  std::string f0_, gloss_;
  bool has_cosine_ = false, has_probes_ = false, has_body_ = false;
};

}  // namespace etak
