// SPDX-License-Identifier: Apache-2.0
// Schueler's extension: a clear surface reflects whatever its alpha. Opacity' = 1 - (1 - alpha)(1 -
// F(nv)); the specular part is never multiplied by alpha. Needs schueler.glsl of core/fresnel.
//   alpha   opacity of the body, [0, 1]
//   K       luminance of the specular colour
real fresnel_opacity(real alpha, real K, real nv) {
  return 1 - (1 - alpha) * (1 - f_schueler(K, nv));
}
