// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/render/scene.h"

namespace etak {

/// The languages in which a model can be written. All of them come from the same formula texts (core/brdf/*.glsl).
enum class ShaderLanguage { glsl, hlsl, msl, wgsl };
std::span<const std::string_view>
shader_language_names();  // "glsl", "hlsl", "msl", "wgsl", in the order of the enum
std::string_view name(ShaderLanguage language);

/// The BRDF of the scene's models alone, with what it uses and nothing else:
///   vec3 etak_brdf(vec3 l, vec3 v)
///   l, v      unit vectors to the light and to the viewer, in the frame of the surface: normal +z, tangent +x
///   returns   f_r in 1/sr for linear red, green and blue; 0 unless both directions are above the surface
/// The parameters of the models are constants with the values of the scene, under the names that the uniforms of
/// glsl_text() have. Diffuse colours are multiplied by the opacity. Throws Error for a scene without a model.
std::string shader_function(const Scene& scene, ShaderLanguage language);

/// `text`, which is in the language of the formula texts after real_literals(), in HLSL (shader model 5), in the Metal
/// Shading Language or in WGSL. WGSL has no overloads: of functions with one name, those after the first get a name of
/// their own, such as f_schlick_rgb.
std::string to_hlsl(std::string_view text);
std::string to_msl(std::string_view text);
std::string to_wgsl(std::string_view text);

}  // namespace etak
