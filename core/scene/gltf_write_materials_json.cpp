// SPDX-License-Identifier: Apache-2.0
// The material forms of gltf.h. Based on: Khronos Group, glTF 2.0 specification, appendix B;
// KHR_materials_specular and KHR_materials_ior (with ior 0 the F0 of the dielectric is min(specularColor, 1)
// times specular).
#include <algorithm>
#include <cmath>

#include "core/math/functions.h"
#include "core/scene/gltf_write_json.h"
#include "core/scene/uri.h"

namespace etak {
namespace {

Json sampler_json(const GltfSampler& sampler) {
  const auto wrap = [](Wrap w) { return w == Wrap::repeat ? 10497 : w == Wrap::mirrored ? 33648 : 33071; };
  const int mag = sampler.nearest ? 9728 : 9729;
  const int with_mips = sampler.nearest ? 9984 : 9987;
  return {{"magFilter", mag},
          {"minFilter", sampler.mipmaps ? with_mips : mag},
          {"wrapS", wrap(sampler.wrap_u)},
          {"wrapT", wrap(sampler.wrap_v)}};
}

/// Writes the texture infos and factors of one material.
class Writer {
 public:
  Writer(GltfRewrite& rewrite, const AtlasMaterial& material, int uv_set, const UvTransform& transform)
      : rewrite_(rewrite), material_(material), uv_set_(uv_set), transform_(transform) {
    if (material.sampler) {
      sampler_ = *material.sampler;
    } else {
      const GltfTexture* texture = leading_texture(scene_material());
      if (texture) sampler_ = texture->sampler;
      sampler_.wrap_u = sampler_.wrap_v = Wrap::clamp;
    }
  }

  void write(Json& json) {
    const bool unlit = extension(json, "KHR_materials_unlit") != nullptr;
    for (const char* name : atlas_extensions) remove_extension(json, name);
    own_ = json.value("pbrMetallicRoughness", Json::object());
    json.erase("pbrMetallicRoughness");
    place(json, "normalTexture", material_.normal_image);
    place(json, "occlusionTexture", material_.occlusion_image);
    place(json, "emissiveTexture", material_.emissive_image);
    const GltfOutput& output = rewrite_.output;
    if (has_form(output.forms, GltfForm::metal_rough)) {
      core(json, material_.base_color_image, material_.base_color, material_.metallic_roughness_image,
           material_.metallic);
    } else if (has_form(output.forms, GltfForm::specular_ior) || unlit) {
      core(json, material_.diffuse_alpha_image, material_.diffuse, material_.roughness_image, 0);
    }
    // An unlit material has no highlights, and KHR_materials_unlit excludes the other extensions.
    if (unlit) return;
    if (has_form(output.forms, GltfForm::specular_ior)) specular_ior(json);
    if (has_form(output.forms, GltfForm::specular_glossiness)) specular_glossiness(json);
  }

 private:
  const GltfMaterial& scene_material() const {
    return rewrite_.scene.materials[static_cast<std::size_t>(material_.material)];
  }

  /// Another texture of the material, now on a page; its scale or strength stays.
  void place(Json& json, const char* key, const std::optional<int>& image) {
    if (!image || !json.contains(key)) return;
    Json& to = json[key];
    remove_extension(to, "KHR_texture_transform");
    to.erase("texCoord");
    Json placed = info(*image);
    if (placed.contains("extensions")) {
      to["extensions"]["KHR_texture_transform"] = std::move(placed["extensions"]["KHR_texture_transform"]);
      placed.erase("extensions");
    }
    to.update(placed);
  }

  void core(Json& json, const std::optional<int>& color, const std::array<double, 4>& color_factor,
            const std::optional<int>& roughness, double metallic) {
    Json& out = json["pbrMetallicRoughness"] = Json::object();
    const bool factors = material_.own_factors;
    if (color)
      out["baseColorTexture"] = info(*color);
    else if (factors && !material_.base_color_in_factors && own_.contains("baseColorTexture"))
      out["baseColorTexture"] = own_["baseColorTexture"];
    if ((!color || factors) && color_factor != std::array<double, 4>{1, 1, 1, 1})
      out["baseColorFactor"] = color_factor;
    // A roughness texture carries metal in blue: it counts where metal is asked for, and is 0 elsewhere
    // anyway.
    const bool metal_texture = roughness && has_form(rewrite_.output.forms, GltfForm::metal_rough);
    if (!metal_texture || (factors && metallic != 1)) out["metallicFactor"] = metallic;
    if (roughness)
      out["metallicRoughnessTexture"] = info(*roughness);
    else if (factors && !material_.metal_rough_in_factors && own_.contains("metallicRoughnessTexture"))
      out["metallicRoughnessTexture"] = own_["metallicRoughnessTexture"];
    if ((!roughness || factors) && material_.roughness != 1) out["roughnessFactor"] = material_.roughness;
  }

  void specular_ior(Json& json) {
    // Light that passes through is bent by the index, so there it must stay.
    double scale = 1;
    const double ior = scene_material().ior;
    const bool passes =
        extension(json, "KHR_materials_transmission") || extension(json, "KHR_materials_volume");
    Json& extensions = json["extensions"];
    if (passes && ior > 1) {
      extensions["KHR_materials_ior"] = {{"ior", ior}};
      scale = math::pow((ior + 1) / (ior - 1), 2);
    } else {
      extensions["KHR_materials_ior"] = {{"ior", 0.0}};
    }
    Json& specular = extensions["KHR_materials_specular"] = Json::object();
    std::array<double, 3> factor{scale, scale, scale};
    if (material_.specular_gloss_image)
      specular["specularColorTexture"] = info(*material_.specular_gloss_image);
    else
      for (std::size_t i = 0; i < 3; ++i) factor[i] *= material_.specular[i];
    if (factor != std::array<double, 3>{1, 1, 1}) specular["specularColorFactor"] = factor;
  }

  void specular_glossiness(Json& json) {
    Json& out = json["extensions"]["KHR_materials_pbrSpecularGlossiness"] = Json::object();
    if (material_.diffuse_alpha_image)
      out["diffuseTexture"] = info(*material_.diffuse_alpha_image);
    else
      out["diffuseFactor"] = material_.diffuse;
    if (material_.specular_gloss_image) {
      out["specularGlossinessTexture"] = info(*material_.specular_gloss_image);
    } else {
      out["specularFactor"] = material_.specular;
      out["glossinessFactor"] = 1 - material_.roughness;
    }
  }

  Json info(int image) {
    Json out{{"index", texture(image)}};
    if (uv_set_ != 0) out["texCoord"] = uv_set_;
    if (transform_ == UvTransform{}) return out;
    Json& transform = out["extensions"]["KHR_texture_transform"] = Json::object();
    if (transform_.offset != std::array<double, 2>{0, 0}) transform["offset"] = transform_.offset;
    if (transform_.rotation != 0) transform["rotation"] = transform_.rotation;
    if (transform_.scale != std::array<double, 2>{1, 1}) transform["scale"] = transform_.scale;
    return out;
  }

  /// The texture of an image of the output with this material's sampler; it is made when first asked for.
  int texture(int image) {
    const std::vector<int> key{image, static_cast<int>(sampler_.wrap_u), static_cast<int>(sampler_.wrap_v),
                               sampler_.mipmaps, sampler_.nearest};
    if (const auto found = rewrite_.textures.find(key); found != rewrite_.textures.end())
      return found->second;
    const Json sampler = sampler_json(sampler_);
    const int image_index = shared("images", {{"uri", uri_of_file(name_of(image))}});
    const int sampler_index = shared("samplers", sampler);
    const int index = rewrite_.append("textures", {{"source", image_index}, {"sampler", sampler_index}});
    rewrite_.textures.emplace(key, index);
    return index;
  }
  const std::string& name_of(int image) const {
    return rewrite_.output.images[static_cast<std::size_t>(image)];
  }

  /// The first element of an array that equals this one, or a new one.
  int shared(const char* array, Json element) {
    if (rewrite_.root.contains(array)) {
      const Json& elements = rewrite_.root[array];
      const auto found = std::find(elements.begin(), elements.end(), element);
      if (found != elements.end()) return static_cast<int>(found - elements.begin());
    }
    return rewrite_.append(array, std::move(element));
  }

  GltfRewrite& rewrite_;
  const AtlasMaterial& material_;
  int uv_set_;
  UvTransform transform_;
  GltfSampler sampler_;
  Json own_;  // what the material says in metal-rough form
};

}  // namespace

void check_output(const GltfRewrite& rewrite) {
  const GltfOutput& output = rewrite.output;
  const auto fail = [&](const std::string& found, std::string_view expected) {
    throw Error::at(rewrite.scene.path, found, expected);
  };
  if (output.forms.empty())
    fail("no material form asked for", "specular_ior, specular_glossiness or metal_rough");
  if (has_form(output.forms, GltfForm::specular_ior) && output.forms.size() > 1)
    fail("the form specular_ior beside another in one file",
         "one alone: KHR_materials_specular may not be combined with them");
  std::vector<bool> seen(rewrite.scene.materials.size(), false);
  for (const AtlasMaterial& m : output.materials) {
    const auto index = static_cast<std::size_t>(m.material);
    if (m.material < 0 || index >= seen.size() || seen[index])
      fail("material " + std::to_string(m.material) + " of the atlas",
           "each material of the document at most once");
    seen[index] = true;
    const std::string place = "material " + std::to_string(m.material);
    for (const auto& image :
         {m.diffuse_alpha_image, m.specular_gloss_image, m.roughness_image, m.base_color_image,
          m.metallic_roughness_image, m.normal_image, m.occlusion_image, m.emissive_image})
      if (image && (*image < 0 || static_cast<std::size_t>(*image) >= output.images.size()))
        fail(place + " with image " + std::to_string(*image), "one of the images of the atlas");
    if (m.uv_set < 0) fail(place + " with UV set " + std::to_string(m.uv_set), "0 or more");
    if (!m.islands.empty() && (m.texture_width < 1 || m.texture_height < 1))
      fail(place + " with islands of a texture without a size", "its width and height");
    if (has_form(output.forms, GltfForm::specular_glossiness) && m.roughness_image && !m.specular_gloss_image)
      fail(place + " with varying roughness and constant F0",
           "a specular-gloss image for form specular_glossiness");
  }
}

void write_material(GltfRewrite& rewrite, const AtlasMaterial& material, int uv_set,
                    const UvTransform& transform) {
  Json& json = rewrite.root["materials"][static_cast<std::size_t>(material.material)];
  Json changed = json;
  Writer(rewrite, material, uv_set, transform).write(changed);
  rewrite.root["materials"][static_cast<std::size_t>(material.material)] = std::move(changed);
}

std::optional<UvTransform> transform_of(const GltfScene& scene, const AtlasMaterial& material) {
  if (!material.islands.empty()) return std::nullopt;
  const GltfTexture* texture = leading_texture(scene.materials[static_cast<std::size_t>(material.material)]);
  const UvTransform own = material.own ? *material.own : texture ? texture->transform : UvTransform{};
  return composed(material.region, own);
}

}  // namespace etak
