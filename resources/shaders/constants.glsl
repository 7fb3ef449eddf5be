// SPDX-License-Identifier: Apache-2.0
// What the formula texts ask of single precision (core/math/glsl.h has the same for C++).
const float tiny = 1e-37;
const float power_floor = -90.0;
const float exponent_floor = -62.0;
const float largest_reflectance = 1.0 - 1e-6;
