// SPDX-License-Identifier: Apache-2.0
// Materials, textures and samplers of glTF 2.0 (specification, sections 3.8 and 3.9) and the extensions of
// gltf.h.
#include <algorithm>
#include <limits>

#include "core/scene/gltf_json.h"

namespace etak {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

Wrap wrap_at(const JsonNode& sampler, std::string_view key) {
  if (!sampler.has(key)) return Wrap::repeat;
  const JsonNode node = sampler.at(key);
  switch (node.integer()) {
    case 10497:
      return Wrap::repeat;
    case 33648:
      return Wrap::mirrored;
    case 33071:
      return Wrap::clamp;
    default:
      node.fail_type("10497 (repeat), 33648 (mirrored) or 33071 (clamp)");
  }
}

GltfSampler sampler_of(const JsonNode& node) {
  GltfSampler out{wrap_at(node, "wrapS"), wrap_at(node, "wrapT")};
  const auto filter = [&](std::string_view key, int most) {
    const int value = node.at(key).integer();
    if ((value < 9984 || value > most) && value != 9728 && value != 9729)
      node.at(key).fail_type("a filter of the specification");
    return value;
  };
  if (node.has("magFilter")) out.nearest = filter("magFilter", 0) == 9728;
  if (node.has("minFilter")) out.mipmaps = filter("minFilter", 9987) >= 9984;
  return out;
}

std::optional<GltfTexture> texture_at(const GltfDocument& document, const JsonNode& material,
                                      std::string_view key) {
  if (!material.has(key)) return std::nullopt;
  const JsonNode info = material.at(key);
  info.expect_object();
  const int index = document.index(info.at("index"), "textures");
  const JsonNode texture = document.element("textures", index);
  GltfTexture out;
  out.image = image_of_texture(document, index);
  if (out.image < 0) texture.fail("a texture without a picture", "\"source\"");
  if (texture.has("sampler"))
    out.sampler = sampler_of(document.element("samplers", document.index(texture.at("sampler"), "samplers")));
  if (info.has("texCoord")) out.uv_set = info.at("texCoord").integer(0);
  if (extension(info.value, "KHR_texture_transform")) {
    const JsonNode transform = info.at("extensions").at("KHR_texture_transform");
    numbers_at(transform, "offset", out.transform.offset, -1e6, 1e6);
    numbers_at(transform, "scale", out.transform.scale, -1e6, 1e6);
    out.transform.rotation = number_at(transform, "rotation", 0, -1e6, 1e6);
    if (transform.has("texCoord")) out.uv_set = transform.at("texCoord").integer(0);
  }
  return out;
}

void read_metal_rough(const GltfDocument& document, const JsonNode& node, GltfMaterial& out) {
  node.expect_object();
  numbers_at(node, "baseColorFactor", out.base_color, 0, 1);
  out.base_color_texture = texture_at(document, node, "baseColorTexture");
  out.metallic = number_at(node, "metallicFactor", 1, 0, 1);
  out.roughness = number_at(node, "roughnessFactor", 1, 0, 1);
  out.metallic_roughness_texture = texture_at(document, node, "metallicRoughnessTexture");
}

void read_extensions(const GltfDocument& document, const JsonNode& extensions, GltfMaterial& out) {
  const auto has = [&](std::string_view name) {
    if (!extensions.has(name)) return false;
    extensions.at(name).expect_object();
    return true;
  };
  if (has("KHR_materials_ior")) {
    const JsonNode node = extensions.at("KHR_materials_ior");
    out.ior = number_at(node, "ior", 1.5, 0, unbounded);
    if (out.ior > 0 && out.ior < 1) node.at("ior").fail_type("0, or 1 and above");
  }
  if (has("KHR_materials_specular")) {
    const JsonNode node = extensions.at("KHR_materials_specular");
    out.specular = number_at(node, "specularFactor", 1, 0, 1);
    out.specular_texture = texture_at(document, node, "specularTexture");
    numbers_at(node, "specularColorFactor", out.specular_color, 0, unbounded);
    out.specular_color_texture = texture_at(document, node, "specularColorTexture");
  }
  if (has("KHR_materials_pbrSpecularGlossiness")) {
    const JsonNode node = extensions.at("KHR_materials_pbrSpecularGlossiness");
    out.specular_glossiness = true;
    numbers_at(node, "diffuseFactor", out.diffuse, 0, 1);
    out.diffuse_texture = texture_at(document, node, "diffuseTexture");
    numbers_at(node, "specularFactor", out.specular_f0, 0, 1);
    out.glossiness = number_at(node, "glossinessFactor", 1, 0, 1);
    out.specular_glossiness_texture = texture_at(document, node, "specularGlossinessTexture");
  }
}

// Whether extensions stand there that neither read_extensions() reads nor the writer takes away.
bool has_further_extensions(const Json& extensions) {
  for (const auto& [name, ignored] : extensions.items())
    if (name != "KHR_materials_ior" && name != "KHR_materials_specular" &&
        name != "KHR_materials_pbrSpecularGlossiness" && name != "KHR_materials_unlit")
      return true;
  return false;
}

// Leaves base colour and alpha: without light there is neither metal nor roughness nor F0.
void make_unlit(GltfMaterial& m) {
  m.unlit = true;
  m.metallic = 0;
  m.ior = 1.5;
  m.specular = 1;
  m.specular_color = {1, 1, 1};
  m.specular_glossiness = false;
  m.metallic_roughness_texture = m.specular_texture = m.specular_color_texture = std::nullopt;
}

GltfMaterial material_of(const GltfDocument& document, int index) {
  const JsonNode node = document.element("materials", index);
  GltfMaterial out;
  out.index = index;
  out.name = node.text_or_empty("name");
  if (node.has("pbrMetallicRoughness")) read_metal_rough(document, node.at("pbrMetallicRoughness"), out);
  if (node.has("extensions")) {
    node.at("extensions").expect_object();
    read_extensions(document, node.at("extensions"), out);
    out.further_extensions = has_further_extensions(node.at("extensions").value);
    if (extension(node.value, "KHR_materials_unlit")) make_unlit(out);
  }
  out.normal_texture = texture_at(document, node, "normalTexture");
  if (out.normal_texture)
    out.normal_scale = number_at(node.at("normalTexture"), "scale", 1, -unbounded, unbounded);
  out.occlusion_texture = texture_at(document, node, "occlusionTexture");
  out.emissive_texture = texture_at(document, node, "emissiveTexture");
  if (node.has("alphaMode")) {
    const std::string mode = node.at("alphaMode").text();
    if (mode == "MASK")
      out.alpha_mode = AlphaMode::mask;
    else if (mode == "BLEND")
      out.alpha_mode = AlphaMode::blend;
    else if (mode != "OPAQUE")
      node.at("alphaMode").fail_type("OPAQUE, MASK or BLEND");
  }
  out.alpha_cutoff = number_at(node, "alphaCutoff", 0.5, 0, unbounded);
  out.double_sided = node.has("doubleSided") && node.at("doubleSided").boolean();
  return out;
}

constexpr const char* basisu = "KHR_texture_basisu";

// Textures that name a PNG or JPEG beside the compressed picture are read by that.
[[noreturn]] void refuse_basis(const GltfDocument& document, const JsonNode& source, int image) {
  const JsonNode picture = document.element("images", image);
  const std::string name = picture.text_or_empty("uri");
  source.fail("the picture " +
                  (name.empty() || name.starts_with("data:") ? picture.pointer : in_quotes(name, 80)) +
                  ", compressed by Basis Universal, which etak does not read",
              "the PNG or JPEG that it was made of (\"source\"), or what ktx extract makes of it");
}

}  // namespace

int image_of_texture(const GltfDocument& document, int texture) {
  const JsonNode node = document.element("textures", texture);
  if (node.has("source")) return document.index(node.at("source"), "images");
  for (const char* name : {"EXT_texture_webp", "MSFT_texture_dds", "EXT_texture_avif", basisu}) {
    const Json* const found = extension(node.value, name);
    if (!found || !found->contains("source")) continue;
    const JsonNode source = node.at("extensions").at(name).at("source");
    const int image = document.index(source, "images");
    if (name == basisu) refuse_basis(document, source, image);
    return image;
  }
  return -1;
}

std::vector<GltfMaterial> materials_of(const GltfDocument& document) {
  std::vector<GltfMaterial> out;
  const int count = static_cast<int>(document.count("materials"));
  for (int i = 0; i < count; ++i) out.push_back(material_of(document, i));
  return out;
}

std::vector<int> materials_of_primitive(const GltfDocument& document, const JsonNode& primitive,
                                        bool variants) {
  std::vector<int> out;
  const auto add = [&](const JsonNode& node) {
    const int material = document.index(node, "materials");
    if (std::find(out.begin(), out.end(), material) == out.end()) out.push_back(material);
  };
  if (primitive.has("material")) add(primitive.at("material"));
  if (variants && extension(primitive.value, "KHR_materials_variants")) {
    const JsonNode mappings = primitive.at("extensions").at("KHR_materials_variants").at("mappings");
    mappings.expect_array();
    for (std::size_t i = 0; i < mappings.size(); ++i) {
      mappings.at(i).expect_object();
      add(mappings.at(i).at("material"));
    }
  }
  for (std::size_t i = 0; i < out.size(); ++i)
    for (const int level : lower_levels(document, document.element("materials", out[i]), "materials"))
      if (std::find(out.begin(), out.end(), level) == out.end()) out.push_back(level);
  return out;
}

std::vector<int> lower_levels(const GltfDocument& document, const JsonNode& node, const char* array) {
  if (!extension(node.value, "MSFT_lod")) return {};
  const JsonNode ids = node.at("extensions").at("MSFT_lod").at("ids");
  ids.expect_array();
  std::vector<int> out;
  for (std::size_t i = 0; i < ids.size(); ++i) out.push_back(document.index(ids.at(i), array));
  return out;
}

std::vector<const GltfTexture*> replaced_textures(const GltfMaterial& m) {
  std::vector<const GltfTexture*> out;
  const auto add = [&](const std::optional<GltfTexture>& texture) {
    if (texture) out.push_back(&*texture);
  };
  if (m.specular_glossiness) {
    add(m.diffuse_texture);
    add(m.specular_glossiness_texture);
    return out;
  }
  add(m.base_color_texture);
  add(m.metallic_roughness_texture);
  add(m.specular_color_texture);
  add(m.specular_texture);
  return out;
}

const GltfTexture* leading_texture(const GltfMaterial& material) {
  const auto textures = replaced_textures(material);
  return textures.empty() ? nullptr : textures.front();
}

bool textures_agree(const GltfMaterial& material) {
  const auto textures = replaced_textures(material);
  for (const GltfTexture* texture : textures) {
    const GltfTexture& first = *textures.front();
    if (texture->uv_set != first.uv_set || texture->transform != first.transform ||
        texture->sampler.wrap_u != first.sampler.wrap_u || texture->sampler.wrap_v != first.sampler.wrap_v ||
        texture->sampler.nearest != first.sampler.nearest)
      return false;
  }
  return true;
}

}  // namespace etak
