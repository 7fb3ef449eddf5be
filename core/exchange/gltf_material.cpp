// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/gltf_material.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>

#include "core/base/bytes/base64.h"
#include "core/base/bytes/bytes_le.h"
#include "core/base/error.h"
#include "core/base/json/json_text.h"
#include "core/base/text/text.h"
#include "core/exchange/engine_values.h"
#include "core/math/functions.h"
#include "core/math/sphere_mesh.h"

namespace etak {
namespace {

// ---- the sphere

constexpr int slices = 48, stacks = 24;
constexpr double spacing = 2.4;

// The buffer: indices, normals (as positions too), UVs, then pictures; each begins at a multiple of four.
struct Geometry {
  std::string buffer;
  std::vector<std::string> views, accessors;  // JSON
};

// What a glTF file calls the types of components and the uses of a buffer view.
constexpr std::size_t unsigned_short = 5123, single_float = 5126;
constexpr std::size_t vertices = 34962, indices = 34963;

std::string line_object(std::initializer_list<JsonMember> members) {
  return json_object(members, -1);
}

//   tangents   as the fourth attribute, along u: normal maps need them
Geometry geometry(bool tangents) {
  const SphereMesh mesh = sphere_mesh(slices, stacks);
  Geometry out;
  std::size_t begin = 0;
  const auto end_view = [&](std::size_t target) {
    out.views.push_back(line_object({{"buffer", "0"},
                                     {"byteOffset", json(begin)},
                                     {"byteLength", json(out.buffer.size() - begin)},
                                     {"target", json(target)}}));
    while (out.buffer.size() % 4 != 0) out.buffer.push_back('\0');
    begin = out.buffer.size();
  };
  for (const std::uint16_t index : mesh.triangles) bytes_le::append(out.buffer, index, 2);
  end_view(indices);
  std::array<float, 3> least{}, most{};
  for (const auto& point : mesh.points)
    for (std::size_t c = 0; c < 3; ++c) {
      bytes_le::append_float(out.buffer, point[c]);
      least[c] = std::min(least[c], point[c]);
      most[c] = std::max(most[c], point[c]);
    }
  end_view(vertices);
  for (const auto& uv : mesh.uvs)
    for (const float c : uv) bytes_le::append_float(out.buffer, c);
  end_view(vertices);
  out.accessors = {line_object({{"bufferView", "0"},
                                {"componentType", json(unsigned_short)},
                                {"count", json(mesh.triangles.size())},
                                {"type", json("SCALAR")}}),
                   line_object({{"bufferView", "1"},
                                {"componentType", json(single_float)},
                                {"count", json(mesh.points.size())},
                                {"type", json("VEC3")},
                                {"min", json_array_of(least)},
                                {"max", json_array_of(most)}}),
                   line_object({{"bufferView", "2"},
                                {"componentType", json(single_float)},
                                {"count", json(mesh.points.size())},
                                {"type", json("VEC2")}})};
  if (!tangents) return out;
  for (const auto& uv : mesh.uvs) {
    const double turn = 2 * std::numbers::pi * double{uv[0]};
    for (const double c : {-math::sin(turn), 0.0, -math::cos(turn), 1.0})
      bytes_le::append_float(out.buffer, static_cast<float>(c));
  }
  end_view(vertices);
  out.accessors.push_back(line_object({{"bufferView", "3"},
                                       {"componentType", json(single_float)},
                                       {"count", json(mesh.points.size())},
                                       {"type", json("VEC4")}}));
  return out;
}

// ---- the materials

std::string three(const LinearRgb& c) {
  return json_array_of(std::array{c.r, c.g, c.b});
}

std::string four(const LinearRgb& c, double alpha) {
  return json_array_of(std::array{c.r, c.g, c.b, alpha});
}

// Numbers that a picture replaces are left out.
std::string extras_of(const ExportSurface& s, const GltfPictures& pictures, const Changes& changes) {
  std::vector<std::string> lines;
  for (const Change& change : changes) lines.push_back(one_line(change));
  std::vector<JsonMember> members;
  if (pictures.specular_color.empty()) members.push_back({"f0_linear_srgb", three(s.f0)});
  if (!s.gloss.held() && pictures.metallic_roughness.empty())
    members.push_back({"schueler_gloss", json(double{s.gloss})});
  if (s.f82) members.push_back({"f82_linear_srgb", three(*s.f82)});
  if (s.coat)
    members.push_back({"coat", line_object({{"n", json(s.coat->n)},
                                            {"f0_under", three(s.coat->under.linear)},
                                            {"f0", three(s.coat->whole.linear)},
                                            {"f82", three(*s.coat->whole.f82)}})});
  if (!s.source.empty()) members.push_back({"source", json(s.source)});
  if (!s.band.empty()) members.push_back({"band", json(s.band)});
  if (!s.notes.empty()) members.push_back({"notes", json_array_of(s.notes)});
  if (!changes.empty()) members.push_back({"changes", json_array_of(lines)});
  return json_object(members, 6);
}

// A body with absorption is as thick as the depth for which its colour is stated, so that it shows that
// colour; otherwise it is as thick as the sphere and only bends the light.
std::vector<JsonMember> volume_of(const ClearBody& body) {
  constexpr double diameter = 2;
  if (body.depth_m <= 0) return {{"thicknessFactor", json(diameter)}};
  return {{"thicknessFactor", json(body.depth_m)},
          {"attenuationColor", three(body.color)},
          {"attenuationDistance", json(body.depth_m)}};
}

// The pictures of a document, in the order of its textures and images.
class Pictures {
 public:
  /// The texture of a picture, as a member of a material.
  std::string texture(const std::string& png, const std::string& name) {
    names_.push_back(name);
    files_.push_back(&png);
    std::vector<JsonMember> members{{"index", json(files_.size() - 1)}};
    if (scale_ != std::array{1.0, 1.0}) {
      transformed_ = true;
      members.push_back({"extensions", line_object({{"KHR_texture_transform",
                                                     line_object({{"scale", json_array_of(scale_)}})}})});
    }
    return json_object(members, -1);
  }
  /// How often the pictures of the next material repeat.
  void set_scale(const std::array<double, 2>& scale) { scale_ = scale; }
  bool transformed() const { return transformed_; }  // whether any repeats
  bool empty() const { return files_.empty(); }

  /// Adds the bytes to the buffer, each picture as a view of it.
  void append(Geometry& to) {
    for (const std::string* png : files_) {
      images_.push_back(line_object({{"name", json(names_[images_.size()])},
                                     {"mimeType", json("image/png")},
                                     {"bufferView", json(to.views.size())}}));
      to.views.push_back(line_object(
          {{"buffer", "0"}, {"byteOffset", json(to.buffer.size())}, {"byteLength", json(png->size())}}));
      to.buffer += *png;
      while (to.buffer.size() % 4 != 0) to.buffer.push_back('\0');
    }
  }

  /// After append(): the members of the document. The pictures repeat and are filtered with mips.
  void append_members(std::vector<JsonMember>& members) const {
    std::vector<std::string> textures;
    for (std::size_t i = 0; i < images_.size(); ++i)
      textures.push_back(line_object({{"sampler", "0"}, {"source", json(i)}}));
    members.push_back({"textures", json_lines(textures, 2)});
    members.push_back({"samplers", '[' +
                                       line_object({{"magFilter", json(linear)},
                                                    {"minFilter", json(linear_mipmap_linear)},
                                                    {"wrapS", json(repeat)},
                                                    {"wrapT", json(repeat)}}) +
                                       ']'});
    members.push_back({"images", json_lines(images_, 2)});
  }

 private:
  static constexpr std::size_t linear = 9729, linear_mipmap_linear = 9987, repeat = 10497;
  std::vector<std::string> names_, images_;
  std::vector<const std::string*> files_;
  std::array<double, 2> scale_{1, 1};
  bool transformed_ = false;
};

struct Used {
  bool ior = false, specular = false, glossiness = false, transmission = false, emissive_strength = false,
       clearcoat = false, dispersion = false, iridescence = false;
  Pictures pictures;
};

// The core material. A picture of a number takes the factor 1, which changes nothing of it.
std::string metallic_roughness_of(const ExportSurface& s, const GltfMaterialValues& v,
                                  const GltfPictures& pictures, Used& used) {
  const bool colored = !pictures.base_color.empty() && !pictures.opacity_alone;
  std::vector<JsonMember> members{{"baseColorFactor", four(colored ? LinearRgb{1, 1, 1} : v.base_color,
                                                           pictures.alpha_mode.empty() ? v.opacity : 1)}};
  if (!pictures.base_color.empty()) {
    const std::string texture = used.pictures.texture(pictures.base_color, s.id + " base colour");
    members.push_back({"baseColorTexture", texture});
  }
  members.push_back({"metallicFactor", json(v.metallic)});
  if (pictures.metallic_roughness.empty()) {
    members.push_back({"roughnessFactor", json(v.roughness)});
  } else {
    const std::string texture = used.pictures.texture(pictures.metallic_roughness, s.id + " roughness");
    members.push_back({"metallicRoughnessTexture", texture});
  }
  return json_object(members, -1);
}

// The extensions of a dielectric.
std::vector<JsonMember> dielectric_extensions(const ExportSurface& s, const GltfMaterialValues& v,
                                              const GltfPictures& pictures, Used& used) {
  std::vector<JsonMember> out;
  used.ior = true;
  if (!pictures.specular_color.empty()) {
    used.specular = true;
    const std::string texture = used.pictures.texture(pictures.specular_color, s.id + " F0");
    out.push_back({"KHR_materials_ior", line_object({{"ior", "0"}})});
    out.push_back({"KHR_materials_specular", line_object({{"specularColorTexture", texture}})});
  } else {
    out.push_back({"KHR_materials_ior", line_object({{"ior", json(v.ior)}})});
    if (v.specular_color != LinearRgb{1, 1, 1}) {
      used.specular = true;
      out.push_back(
          {"KHR_materials_specular", line_object({{"specularColorFactor", three(v.specular_color)}})});
    }
  }
  if (v.transmission > 0) {
    used.transmission = true;
    out.push_back(
        {"KHR_materials_transmission", line_object({{"transmissionFactor", json(v.transmission)}})});
    out.push_back({"KHR_materials_volume", json_object(volume_of(*v.volume), -1)});
    if (v.dispersion > 0) {
      used.dispersion = true;
      out.push_back({"KHR_materials_dispersion", line_object({{"dispersion", json(v.dispersion)}})});
    }
  }
  return out;
}

std::string material_of(const ExportSurface& s, GltfMaterialForm form, Fit fit, const GltfPictures& pictures,
                        Used& used, Changes& changes) {
  const bool glossiness = form == GltfMaterialForm::specular_glossiness;
  if (glossiness && !pictures.empty())
    throw Error::at(s.id, "pictures in the form specular-glossiness", "the form metal-rough");
  const GltfMaterialValues v = gltf_values(s, glossiness, fit, changes);
  std::vector<JsonMember> members{{"name", json(s.name.empty() ? s.id : s.name)}};
  std::vector<JsonMember> extensions;
  if (v.specular_glossiness) {
    used.glossiness = true;
    extensions.push_back(
        {"KHR_materials_pbrSpecularGlossiness", line_object({{"diffuseFactor", four(v.base_color, v.opacity)},
                                                             {"specularFactor", three(v.specular_color)},
                                                             {"glossinessFactor", json(v.glossiness)}})});
  } else {
    members.push_back({"pbrMetallicRoughness", metallic_roughness_of(s, v, pictures, used)});
    if (v.metallic == 0) extensions = dielectric_extensions(s, v, pictures, used);
    if (v.iridescence > 0) {
      used.iridescence = true;
      extensions.push_back({"KHR_materials_iridescence",
                            line_object({{"iridescenceFactor", json(v.iridescence)},
                                         {"iridescenceIor", json(v.iridescence_ior)},
                                         {"iridescenceThicknessMinimum", json(v.iridescence_nm)},
                                         {"iridescenceThicknessMaximum", json(v.iridescence_nm)}})});
    }
    if (v.clearcoat > 0) {
      used.clearcoat = true;
      extensions.push_back({"KHR_materials_clearcoat", line_object({{"clearcoatFactor", json(v.clearcoat)},
                                                                    {"clearcoatRoughnessFactor", "0"}})});
    }
  }
  if (!pictures.normal.empty())
    members.push_back({"normalTexture", used.pictures.texture(pictures.normal, s.id + " normal")});
  if (!pictures.occlusion.empty())
    members.push_back({"occlusionTexture", used.pictures.texture(pictures.occlusion, s.id + " occlusion")});
  if (s.emission != LinearRgb{}) {
    const auto [color, strength] = emission_parts(s.emission);
    members.push_back({"emissiveFactor", three(color)});
    if (!pictures.emissive.empty())
      members.push_back({"emissiveTexture", used.pictures.texture(pictures.emissive, s.id + " emission")});
    if (strength > 1) {
      used.emissive_strength = true;
      extensions.push_back(
          {"KHR_materials_emissive_strength", line_object({{"emissiveStrength", json(strength)}})});
    }
  }
  const std::string mode = !pictures.alpha_mode.empty() ? pictures.alpha_mode : s.opacity < 1 ? "BLEND" : "";
  if (!mode.empty() && mode != "OPAQUE") members.push_back({"alphaMode", json(mode)});
  if (mode == "MASK") members.push_back({"alphaCutoff", json(pictures.alpha_cutoff)});
  if (!extensions.empty()) members.push_back({"extensions", json_object(extensions, 6)});
  members.push_back({"extras", extras_of(s, pictures, changes)});
  return json_object(members, 4);
}

// ---- the file

// The unit sphere of surface i.
std::string mesh_of(const ExportSurface& s, std::size_t i, bool tangents) {
  std::vector<JsonMember> attributes{{"POSITION", "1"}, {"NORMAL", "1"}, {"TEXCOORD_0", "2"}};
  if (tangents) attributes.push_back({"TANGENT", "3"});
  const std::string primitive =
      line_object({{"attributes", json_object(attributes, -1)}, {"indices", "0"}, {"material", json(i)}});
  return line_object({{"name", json(s.id)}, {"primitives", '[' + primitive + ']'}});
}

std::string node_of(const ExportSurface& s, std::size_t i) {
  std::vector<JsonMember> members{{"name", json(s.id)}, {"mesh", json(i)}};
  const std::array<double, 3> place{spacing * static_cast<double>(i), 0, 0};
  if (i > 0) members.push_back({"translation", json_array_of(place)});
  return json_object(members, -1);
}

std::string buffer_of(const Geometry& sphere, GltfContainer container) {
  std::vector<JsonMember> members;
  if (container == GltfContainer::gltf)
    members.push_back({"uri", json("data:application/octet-stream;base64," + base64(sphere.buffer))});
  members.push_back({"byteLength", json(sphere.buffer.size())});
  return json_object(members, -1);
}

std::vector<std::string> extensions_of(const Used& used) {
  std::vector<std::string> names;
  if (used.clearcoat) names.push_back("KHR_materials_clearcoat");
  if (used.dispersion) names.push_back("KHR_materials_dispersion");
  if (used.emissive_strength) names.push_back("KHR_materials_emissive_strength");
  if (used.ior) names.push_back("KHR_materials_ior");
  if (used.iridescence) names.push_back("KHR_materials_iridescence");
  if (used.specular) names.push_back("KHR_materials_specular");
  if (used.transmission) names.insert(names.end(), {"KHR_materials_transmission", "KHR_materials_volume"});
  if (used.glossiness) names.push_back("KHR_materials_pbrSpecularGlossiness");
  if (used.pictures.transformed()) names.push_back("KHR_texture_transform");
  return names;
}

std::string glb(std::string json_chunk, std::string_view binary) {
  while (json_chunk.size() % 4 != 0) json_chunk.push_back(' ');
  std::string out = "glTF";
  bytes_le::append32(out, 2);
  bytes_le::append32(out, 12 + 8 + json_chunk.size() + 8 + binary.size());
  bytes_le::append32(out, json_chunk.size());
  out += "JSON";
  out += json_chunk;
  bytes_le::append32(out, binary.size());
  out.append("BIN\0", 4);
  return out.append(binary);
}

}  // namespace

std::optional<GltfMaterialForm> gltf_material_form_named(std::string_view text) {
  if (text == "specular-ior" || text == "metal-rough") return GltfMaterialForm::metal_rough;
  if (text == "specular-glossiness") return GltfMaterialForm::specular_glossiness;
  return std::nullopt;
}

std::string gltf_document(std::span<const ExportSurface> surfaces, GltfMaterialForm form,
                          GltfContainer container, Fit fit, std::vector<Changes>& changes,
                          std::span<const GltfPictures> pictures) {
  if (surfaces.empty()) throw Error::at("glTF", "no material", "one or more");
  changes.assign(surfaces.size(), {});
  const GltfPictures no_pictures;
  Used used;
  std::vector<std::string> materials, meshes, nodes;
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const ExportSurface& s = surfaces[i];
    validate(s);
    if (s.space != RgbSpace::srgb)
      throw Error::at(s.id, "colours in " + std::string(name(s.space)), "linear sRGB");
    const GltfPictures& own = pictures.empty() ? no_pictures : pictures[i];
    used.pictures.set_scale(own.scale);
    materials.push_back(material_of(s, form, fit, own, used, changes[i]));
    meshes.push_back(mesh_of(s, i, !own.normal.empty()));
    nodes.push_back(node_of(s, i));
    roots.push_back(i);
  }

  Geometry sphere =
      geometry(std::ranges::any_of(pictures, [](const GltfPictures& each) { return !each.normal.empty(); }));
  used.pictures.append(sphere);
  std::vector<JsonMember> members{
      {"asset", line_object({{"version", json("2.0")}, {"generator", json("etak")}})}};
  const std::vector<std::string> extensions = extensions_of(used);
  if (!extensions.empty()) members.push_back({"extensionsUsed", json_array_of(extensions)});
  members.insert(members.end(), {{"scene", "0"},
                                 {"scenes", '[' + line_object({{"nodes", json_array_of(roots)}}) + ']'},
                                 {"nodes", json_lines(nodes, 2)},
                                 {"meshes", json_lines(meshes, 2)},
                                 {"materials", json_lines(materials, 2)}});
  if (!used.pictures.empty()) used.pictures.append_members(members);
  members.insert(members.end(), {{"accessors", json_lines(sphere.accessors, 2)},
                                 {"bufferViews", json_lines(sphere.views, 2)},
                                 {"buffers", '[' + buffer_of(sphere, container) + ']'}});
  std::string out = json_object(members, 0) + '\n';
  return container == GltfContainer::gltf ? out : glb(std::move(out), sphere.buffer);
}

}  // namespace etak
