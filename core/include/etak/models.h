// SPDX-License-Identifier: Apache-2.0
#pragma once

// Shading models: Fresnel terms and BRDFs evaluated in C++, and the same formulas as GLSL. Link etak::core.
//
// ```cpp
// #include <cstdio>
// #include <etak/models.h>
//
// int main() {
//   // Exact Fresnel reflectance of n = 1.5, k = 0 at cos = 1 and cos = 1/7.
//   std::printf("%.4f %.4f\n", etak::f64::fresnel_exact(1.5, 0, 1),
//               etak::f64::fresnel_exact(1.5, 0, etak::f82_cosine));
//
//   etak::SurfaceValues surface;                // of which F0 and gloss alone are known
//   surface.f0 = {1.0, 0.77, 0.34};
//   surface.gloss = 0.75;
//   etak::complete_from_f0(surface);            // F82, n and k
//
//   etak::Scene scene;
//   scene.surface = surface;
//   scene.lights = etak::default_lights();
//   scene.specular = etak::find_model("microfacet:ggx,schlick,smith-ggx-height");
//   scene.specular_values = etak::model_values(*scene.specular, surface, {});
//
//   double rgb[3];                              // f_r in 1/sr: light and viewer straight above
//   scene.specular->f64({0, 0, 1, 0, 0, 1}, scene.specular_values.data(), rgb);
//   std::printf("%s %.4f %.4f %.4f\n", std::string(scene.specular->title).c_str(), rgb[0], rgb[1], rgb[2]);
//
//   const etak::GlslText shader = etak::glsl_text(scene);
//   std::printf("%zu bytes of fragment shader, %zu uniforms\n", shader.fragment.size(),
//               shader.uniforms.size());
// }
// ```
//
// Units and ranges
//   directions   unit vectors away from the surface, normal +z, tangent +x
//   f_r          1/sr per channel, at least 0 and finite; 0 unless both directions are above the surface
//   values       a model's parameters one after the other, three numbers for a colour; Model::parameters has
//                their names, units and ranges
//   gloss        Schueler's, [0, 1]: exponent 2^(12 gloss), alpha = sqrt(2 / (exponent + 2))
//   f64, f32     the reference in double; the text that a GPU gets, in float
//
// Errors
//   null         find_model() and find_term() of an unknown id
//   etak::Error  model_values() and glsl_text(): unknown parameters, values out of range, no model
//
// models() and terms() list what there is, with sources and with what each model claims; both live as long as
// the program. film_light() has the reflectance of layers on a base. <etak/render.h> draws a Scene.

#include "core/base/error.h"
#include "core/brdf/integrals/albedo.h"
#include "core/brdf/models.h"
#include "core/film/stack.h"
#include "core/fresnel/fresnel.h"
#include "core/glsl/glsl_text.h"
#include "core/light/lights.h"
#include "core/render/scene.h"
