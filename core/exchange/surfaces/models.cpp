// SPDX-License-Identifier: Apache-2.0
// Based on: the node definitions of MaterialX 1.39.5 (libraries/bxdf and pbrlib: names, types and the ranges of their user
// interface; an index of refraction is 1 or more), glTF 2.0 and its material extensions, UsdPreviewSurface 2.6.
#include "core/exchange/surfaces/models.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace etak {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

// Inputs of one model, type and range.
struct InputGroup {
  std::string_view model;
  InputType type;
  double least, most;
  std::string_view names;  // with '|' between
};

// What inputs mean, with their default.
struct InputMeaning {
  std::string_view model, name;
  Meaning meaning;
  double otherwise = 0;
};

constexpr InputGroup groups[] = {
    {"open_pbr_surface", InputType::color, 0, unbounded, "subsurface_radius_scale|emission_color"},
    {"open_pbr_surface", InputType::number, 0, 1,
     "base_weight|base_diffuse_roughness|base_metalness|specular_roughness|"
     "specular_roughness_anisotropy|transmission_weight|transmission_dispersion_scale|"
     "subsurface_weight|fuzz_weight|fuzz_roughness|coat_weight|coat_roughness|"
     "coat_roughness_anisotropy|coat_darkening|thin_film_weight|geometry_opacity"},
    {"open_pbr_surface", InputType::color, 0, 1,
     "base_color|specular_color|transmission_color|transmission_scatter|subsurface_color|"
     "fuzz_color|coat_color"},
    {"open_pbr_surface", InputType::number, 0, unbounded,
     "specular_weight|transmission_depth|transmission_dispersion_abbe_number|subsurface_radius|"
     "thin_film_thickness|emission_luminance"},
    {"open_pbr_surface", InputType::number, 1, unbounded, "specular_ior|coat_ior|thin_film_ior"},
    {"open_pbr_surface", InputType::number, -1, 1,
     "transmission_scatter_anisotropy|subsurface_scatter_anisotropy"},
    {"open_pbr_surface", InputType::other, -unbounded, unbounded,
     "geometry_thin_walled|geometry_normal|geometry_coat_normal|geometry_tangent|geometry_coat_tangent"},
    {"standard_surface", InputType::color, 0, unbounded, "subsurface_radius|emission_color"},
    {"standard_surface", InputType::number, 0, 1,
     "base|diffuse_roughness|metalness|specular|specular_roughness|specular_anisotropy|"
     "specular_rotation|transmission|transmission_scatter_anisotropy|subsurface|sheen|"
     "sheen_roughness|coat|coat_roughness|coat_anisotropy|coat_rotation|coat_affect_color|"
     "coat_affect_roughness"},
    {"standard_surface", InputType::color, 0, 1,
     "base_color|specular_color|transmission_color|transmission_scatter|subsurface_color|"
     "sheen_color|coat_color|opacity"},
    {"standard_surface", InputType::number, 1, unbounded, "specular_IOR|coat_IOR|thin_film_IOR"},
    {"standard_surface", InputType::number, 0, unbounded,
     "transmission_depth|transmission_dispersion|subsurface_scale|thin_film_thickness|emission"},
    {"standard_surface", InputType::number, -1, 1, "transmission_extra_roughness|subsurface_anisotropy"},
    {"standard_surface", InputType::other, -unbounded, unbounded, "coat_normal|thin_walled|normal|tangent"},
    {"gltf_pbr", InputType::color, 0, 1, "base_color|sheen_color|emissive|attenuation_color"},
    {"gltf_pbr", InputType::number, 0, 1,
     "metallic|roughness|occlusion|transmission|specular|alpha|alpha_cutoff|iridescence|"
     "sheen_roughness|clearcoat|clearcoat_roughness|anisotropy_strength"},
    {"gltf_pbr", InputType::other, -unbounded, unbounded, "normal|tangent|clearcoat_normal"},
    {"gltf_pbr", InputType::color, 0, unbounded, "specular_color"},
    {"gltf_pbr", InputType::number, 1, unbounded, "ior|iridescence_ior"},
    {"gltf_pbr", InputType::number, -unbounded, unbounded, "alpha_mode"},
    {"gltf_pbr", InputType::number, 0, unbounded,
     "iridescence_thickness|emissive_strength|thickness|attenuation_distance|dispersion"},
    {"gltf_pbr", InputType::number, 0, 6.28318, "anisotropy_rotation"},
    {"UsdPreviewSurface", InputType::color, 0, 1, "diffuseColor|specularColor"},
    {"UsdPreviewSurface", InputType::color, 0, unbounded, "emissiveColor"},
    {"UsdPreviewSurface", InputType::number, 0, 1,
     "useSpecularWorkflow|metallic|roughness|clearcoat|clearcoatRoughness|opacity|opacityThreshold|"
     "occlusion"},
    {"UsdPreviewSurface", InputType::number, -unbounded, unbounded, "opacityMode|displacement"},
    {"UsdPreviewSurface", InputType::number, 1, unbounded, "ior"},
    {"UsdPreviewSurface", InputType::other, -unbounded, unbounded, "normal"},
    {"dielectric_bsdf", InputType::number, 0, 1, "weight"},
    {"dielectric_bsdf", InputType::color, 0, 1, "tint"},
    {"dielectric_bsdf", InputType::number, 1, unbounded, "ior|thinfilm_ior"},
    {"dielectric_bsdf", InputType::pair, 0, 1, "roughness"},
    {"dielectric_bsdf", InputType::other, -unbounded, unbounded,
     "retroreflective|normal|tangent|distribution|scatter_mode"},
    {"dielectric_bsdf", InputType::number, 0, unbounded, "thinfilm_thickness"},
    {"conductor_bsdf", InputType::number, 0, 1, "weight"},
    {"conductor_bsdf", InputType::color, 0, unbounded, "ior|extinction"},
    {"conductor_bsdf", InputType::pair, 0, 1, "roughness"},
    {"conductor_bsdf", InputType::other, -unbounded, unbounded,
     "retroreflective|normal|tangent|distribution"},
    {"conductor_bsdf", InputType::number, 0, unbounded, "thinfilm_thickness"},
    {"conductor_bsdf", InputType::number, 1, unbounded, "thinfilm_ior"},
    {"generalized_schlick_bsdf", InputType::number, 0, 1, "weight"},
    {"generalized_schlick_bsdf", InputType::color, 0, 1, "color0|color82|color90"},
    {"generalized_schlick_bsdf", InputType::number, -unbounded, unbounded, "exponent"},
    {"generalized_schlick_bsdf", InputType::pair, 0, 1, "roughness"},
    {"generalized_schlick_bsdf", InputType::other, -unbounded, unbounded,
     "retroreflective|normal|tangent|distribution|scatter_mode"},
    {"generalized_schlick_bsdf", InputType::number, 0, unbounded, "thinfilm_thickness"},
    {"generalized_schlick_bsdf", InputType::number, 1, unbounded, "thinfilm_ior"},
    {"gltf", InputType::color, 0, 1,
     "baseColorFactor|emissiveFactor|specularFactor|diffuseFactor|"
     "KHR_materials_volume.attenuationColor|KHR_materials_sheen.sheenColorFactor"},
    {"gltf", InputType::color, 0, unbounded, "KHR_materials_specular.specularColorFactor"},
    {"gltf", InputType::number, 0, 1,
     "metallicFactor|roughnessFactor|glossinessFactor|alphaCutoff|baseColorFactor alpha|"
     "diffuseFactor alpha|occlusionTexture.strength|KHR_materials_specular.specularFactor|"
     "KHR_materials_transmission.transmissionFactor|KHR_materials_iridescence.iridescenceFactor|"
     "KHR_materials_clearcoat.clearcoatFactor|KHR_materials_clearcoat.clearcoatRoughnessFactor|"
     "KHR_materials_sheen.sheenRoughnessFactor|KHR_materials_anisotropy.anisotropyStrength"},
    {"gltf", InputType::number, 0, unbounded,
     "KHR_materials_emissive_strength.emissiveStrength|KHR_materials_volume.thicknessFactor|"
     "KHR_materials_volume.attenuationDistance|KHR_materials_dispersion.dispersion|"
     "KHR_materials_iridescence.iridescenceThicknessMinimum|"
     "KHR_materials_iridescence.iridescenceThicknessMaximum"},
    {"gltf", InputType::number, 1, unbounded,
     "KHR_materials_ior.ior|KHR_materials_iridescence.iridescenceIor"},
    {"gltf", InputType::number, -unbounded, unbounded, "KHR_materials_anisotropy.anisotropyRotation"},
    {"gltf", InputType::other, -unbounded, unbounded,
     "name|extras|extensions|pbrMetallicRoughness|normalTexture|occlusionTexture|emissiveTexture|"
     "alphaMode|doubleSided|baseColorTexture|metallicRoughnessTexture|diffuseTexture|"
     "specularGlossinessTexture|KHR_materials_specular.specularTexture|"
     "KHR_materials_specular.specularColorTexture|KHR_materials_transmission.transmissionTexture|"
     "KHR_materials_volume.thicknessTexture|KHR_materials_iridescence.iridescenceTexture|"
     "KHR_materials_iridescence.iridescenceThicknessTexture|KHR_materials_clearcoat.clearcoatTexture|"
     "KHR_materials_clearcoat.clearcoatRoughnessTexture|KHR_materials_clearcoat.clearcoatNormalTexture|"
     "KHR_materials_sheen.sheenColorTexture|KHR_materials_sheen.sheenRoughnessTexture|"
     "KHR_materials_anisotropy.anisotropyTexture"},
    {"values", InputType::color, 0, 1,
     "Base Color|baseColor|Albedo|albedo_color|color|Diffuse Albedo|diffuse|F90|Specular|"
     "Specular Color|Specular Tint|Edge Tint|Coat Tint|specularColor|attenuationColor|reflectivity|"
     "edge_color|f82|F0|f0|kd|ks|kt"},
    {"values", InputType::color, 0, unbounded,
     "emission|Emissive Color|Emission|Emission Color|emissive|absorption|n|k|residual|IOR|"
     "Extinction"},
    {"values", InputType::number, 0, 1,
     "Metallic|metallic|metalness|Roughness|roughness|Smoothness|gloss|alpha|Alpha|opacity|"
     "Opacity|Coverage Weight|albedo_color alpha|reflectance|metallic_specular|IOR Level|"
     "Transmission Weight|transmission|Coat Weight|Coat Roughness|clearCoat|clearCoatRoughness|"
     "clearcoat|clearcoatRoughness|iridescence|Specular Level|uroughness|vroughness|transparency"},
    {"values", InputType::number, 1, unbounded,
     "Refraction (Index of Refraction)|Index Of Refraction|ior|interiorior|iridescenceIOR|Coat IOR"},
    {"values", InputType::number, 0, unbounded,
     "Emission intensity|Emission Intensity|Emission Strength|emission_energy_multiplier|"
     "emissiveIntensity|attenuationDistance|dispersion|iridescenceThicknessRange|eta at 550 nm|"
     "k at 550 nm"},
};

constexpr InputMeaning meanings[] = {
    {"open_pbr_surface", "base_weight", Meaning::base_weight, 1},
    {"open_pbr_surface", "base_color", Meaning::base_color, 0.8},
    {"open_pbr_surface", "base_metalness", Meaning::metalness, 0},
    {"open_pbr_surface", "specular_weight", Meaning::specular_weight, 1},
    {"open_pbr_surface", "specular_color", Meaning::tint, 1},
    {"open_pbr_surface", "specular_ior", Meaning::ior, 1.5},
    {"open_pbr_surface", "thin_film_weight", Meaning::film_weight, 0},
    {"open_pbr_surface", "thin_film_thickness", Meaning::film_um, 0.5},
    {"standard_surface", "base", Meaning::base_weight, 1},
    {"standard_surface", "base_color", Meaning::base_color, 1},
    {"standard_surface", "metalness", Meaning::metalness, 0},
    {"standard_surface", "specular", Meaning::specular_weight, 1},
    {"standard_surface", "specular_color", Meaning::edge_color, 1},
    {"standard_surface", "specular_IOR", Meaning::ior, 1.5},
    {"standard_surface", "thin_film_thickness", Meaning::film_nm, 0},
    {"gltf_pbr", "base_color", Meaning::base_color, 1},
    {"gltf_pbr", "metallic", Meaning::metalness, 1},
    {"gltf_pbr", "specular", Meaning::specular_weight, 1},
    {"gltf_pbr", "specular_color", Meaning::specular_color, 1},
    {"gltf_pbr", "ior", Meaning::ior, 1.5},
    {"gltf_pbr", "iridescence", Meaning::film_weight, 0},
    {"gltf_pbr", "iridescence_thickness", Meaning::film_nm, 100},
    {"UsdPreviewSurface", "diffuseColor", Meaning::base_color, 0.18},
    {"UsdPreviewSurface", "useSpecularWorkflow", Meaning::takes_f0, 0},
    {"UsdPreviewSurface", "specularColor", Meaning::f0, 0},
    {"UsdPreviewSurface", "metallic", Meaning::metalness, 0},
    {"UsdPreviewSurface", "ior", Meaning::ior, 1.5},
    {"dielectric_bsdf", "tint", Meaning::specular_color, 1},
    {"dielectric_bsdf", "ior", Meaning::ior, 1.5},
    {"dielectric_bsdf", "thinfilm_thickness", Meaning::film_nm, 0},
    {"conductor_bsdf", "ior", Meaning::n, 0.183},
    {"conductor_bsdf", "extinction", Meaning::k, 3.424},
    {"conductor_bsdf", "thinfilm_thickness", Meaning::film_nm, 0},
    {"generalized_schlick_bsdf", "color0", Meaning::f0, 1},
    {"generalized_schlick_bsdf", "color82", Meaning::tint, 1},
    {"generalized_schlick_bsdf", "thinfilm_thickness", Meaning::film_nm, 0},
    {"gltf", "baseColorFactor", Meaning::base_color, 1},
    {"gltf", "metallicFactor", Meaning::metalness, 1},
    {"gltf", "specularFactor", Meaning::f0, 1},
    {"gltf", "diffuseFactor", Meaning::diffuse, 1},
    {"gltf", "KHR_materials_ior.ior", Meaning::ior, 1.5},
    {"gltf", "KHR_materials_specular.specularFactor", Meaning::specular_weight, 1},
    {"gltf", "KHR_materials_specular.specularColorFactor", Meaning::specular_color, 1},
    {"gltf", "KHR_materials_iridescence.iridescenceFactor", Meaning::film_weight, 0},
    {"gltf", "KHR_materials_iridescence.iridescenceThicknessMaximum", Meaning::film_nm, 400},
    {"gltf", "roughnessFactor", Meaning::roughness, 1},
    {"values", "Base Color", Meaning::base_color, 0},
    {"values", "baseColor", Meaning::base_color, 0},
    {"values", "Albedo", Meaning::base_color, 0},
    {"values", "albedo_color", Meaning::base_color, 0},
    {"values", "color", Meaning::base_color, 0},
    {"values", "reflectivity", Meaning::f0, 0},
    {"values", "Metallic", Meaning::metalness, 0},
    {"values", "metallic", Meaning::metalness, 0},
    {"values", "metalness", Meaning::metalness, 0},
    {"values", "Specular Tint", Meaning::tint, 0},
    {"values", "Edge Tint", Meaning::tint, 0},
    {"values", "edge_color", Meaning::edge_color, 0},
    {"values", "specularColor", Meaning::specular_color, 0},
    {"values", "F0", Meaning::f0, 0},
    {"values", "f0", Meaning::f0, 0},
    {"values", "Specular", Meaning::f0, 0},
    {"values", "Specular Color", Meaning::f0, 0},
    {"values", "ks", Meaning::f0, 0},
    {"values", "f82", Meaning::f82, 0},
    {"values", "n", Meaning::n, 0},
    {"values", "k", Meaning::k, 0},
    {"values", "ior", Meaning::ior, 1.5},
    {"values", "Index Of Refraction", Meaning::ior, 1.5},
    {"values", "interiorior", Meaning::ior, 1.5},
    {"values", "diffuse", Meaning::diffuse, 0},
    {"values", "Diffuse Albedo", Meaning::diffuse, 0},
    {"values", "roughness", Meaning::roughness, 0},
    {"values", "Roughness", Meaning::roughness, 0},
    {"values", "iridescence", Meaning::film_weight, 0},
    {"values", "iridescenceThicknessRange", Meaning::film_nm, 0},
    {"open_pbr_surface", "transmission_weight", Meaning::transmission, 0},
    {"standard_surface", "transmission", Meaning::transmission, 0},
    {"gltf_pbr", "transmission", Meaning::transmission, 0},
    {"gltf", "KHR_materials_transmission.transmissionFactor", Meaning::transmission, 0},
    {"values", "Transmission Weight", Meaning::transmission, 0},
    {"values", "transmission", Meaning::transmission, 0},
    {"open_pbr_surface", "specular_roughness", Meaning::roughness, 0.3},
    {"standard_surface", "specular_roughness", Meaning::roughness, 0.2},
    {"gltf_pbr", "roughness", Meaning::roughness, 1},
    {"UsdPreviewSurface", "roughness", Meaning::roughness, 0.5},
};

std::vector<ModelInput> all_inputs() {
  std::vector<ModelInput> out;
  for (const InputGroup& group : groups)
    for (std::string_view rest = group.names; !rest.empty();) {
      const std::string_view name = rest.substr(0, rest.find('|'));
      rest.remove_prefix(std::min(name.size() + 1, rest.size()));
      ModelInput& input =
          out.emplace_back(ModelInput{group.model, name, group.type, group.least, group.most});
      for (const InputMeaning& each : meanings)
        if (each.model == group.model && each.name == name) {
          input.meaning = each.meaning;
          input.otherwise = each.otherwise;
        }
    }
  return out;
}

// All inputs, and those of each name.
struct InputTable {
  std::vector<ModelInput> inputs = all_inputs();
  std::map<std::pair<std::string_view, std::string_view>, const ModelInput*> by_name;

  InputTable() {
    for (const ModelInput& each : inputs) by_name.emplace(std::pair(each.model, each.name), &each);
  }
};

const InputTable& table() {
  static const InputTable all;
  return all;
}

}  // namespace

const ModelInput* model_input(std::string_view model, std::string_view name) {
  const auto found = table().by_name.find(std::pair(model, name));
  return found == table().by_name.end() ? nullptr : found->second;
}

const ModelInput* model_input(std::string_view model, Meaning meaning) {
  for (const ModelInput& each : table().inputs)
    if (each.model == model && each.meaning == meaning) return &each;
  return nullptr;
}

bool is_surface_model(std::string_view id) {
  return std::ranges::any_of(groups, [&](const InputGroup& each) { return each.model == id; });
}

std::vector<std::string> input_names(std::string_view model) {
  std::vector<std::string> out;
  for (const ModelInput& each : table().inputs)
    if (each.model == model) out.emplace_back(each.name);
  return out;
}

}  // namespace etak
