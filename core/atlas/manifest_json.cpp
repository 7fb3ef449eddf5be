// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>

#include "core/atlas/manifest.h"
#include "core/atlas/material_nodes_json.h"
#include "core/color/srgb.h"
#include "core/image/image.h"

namespace etak {
namespace {

constexpr int manifest_depth = 8;
constexpr const char* source_forms =
    "a file name, the name of a library material, a number, [r, g, b], \"#rrggbb\", or an object with \"image\" "
    "or \"material\"";

// A colour or a grey quantity: what its constants may be and how its channels are called.
struct Role {
  const char* key;
  bool color;
};

class ManifestReader {
 public:
  ManifestReader(const Json& document, std::string_view file)
      : root_{document, file, {}}, folder_(std::filesystem::path(file).parent_path()) {}

  AtlasManifest read() {
    root_.expect_object({"schema", "gloss", "materials"});
    AtlasManifest out;
    if (root_.has("schema")) root_.at("schema").expect_text("etak-atlas-manifest/1");
    if (root_.has("gloss"))
      out.gloss = root_.at("gloss").word(gloss_form_named, "schueler, one_minus_roughness or roughness");
    const JsonNode list = root_.at("materials");
    list.expect_array();
    if (list.size() == 0) list.fail("no material", "at least one");
    out.materials =
        read_materials<ManifestMaterial>(list, [&](const JsonNode& node) { return material(node); });
    return out;
  }

 private:
  ManifestMaterial material(const JsonNode& node) {
    node.expect_object({"name", "diffuse", "specular", "gloss", "roughness", "alpha", "basecolor", "metallic",
                        "normal", "alpha_mode", "alpha_cutoff", "width", "height", "mask"});
    ManifestMaterial out;
    out.place = std::string(node.file) + '#' + node.pointer;
    out.name = read_name(node);
    out.diffuse = source(node, {"diffuse", true});
    out.specular = source(node, {"specular", true});
    out.base_color = source(node, {"basecolor", true});
    out.metallic = source(node, {"metallic", false});
    out.gloss = source(node, {"gloss", false});
    out.roughness = source(node, {"roughness", false});
    out.alpha = source(node, {"alpha", false});
    out.normal = node.has("normal") ? path_of(node.at("normal")) : "";
    if (node.has("width")) out.width = node.at("width").integer(1, max_image_side);
    if (node.has("height")) out.height = node.at("height").integer(1, max_image_side);
    if (node.has("alpha_mode")) out.alpha_mode = read_alpha_mode(node.at("alpha_mode"));
    if (node.has("alpha_cutoff")) out.alpha_cutoff = unit_number(node.at("alpha_cutoff"));
    if (node.has("mask")) out.mask = read_mask(node.at("mask"));
    check_roles(node, out);
    return out;
  }

  MaterialMask read_mask(const JsonNode& node) const {
    node.expect_object({"image", "channels", "materials", "write"});
    MaterialMask out;
    const JsonNode list = node.at("materials");
    list.expect_array();
    if (list.size() < MaterialMask::least_parts || list.size() > MaterialMask::most_parts)
      list.fail(std::to_string(list.size()) + " materials", "two to four");
    out.colors = list.at(0).at("at").value.is_string();
    for (std::size_t i = 0; i < list.size(); ++i) out.parts.push_back(read_part(list.at(i), out.colors));
    out.image = {path_of(node.at("image")), read_channels(node, out.colors), ""};
    if (!node.has("write")) return out;
    for (const std::string& word : node.at("write").texts()) {
      if (word != "specular_gloss" && word != "metal_rough")
        node.at("write").fail(in_quotes(word), "specular_gloss or metal_rough");
      (word == "metal_rough" ? out.metal_rough : out.specular_gloss) = true;
    }
    return out;
  }

  MaskPart read_part(const JsonNode& node, bool colors) const {
    node.expect_object({"at", "material", "dataset", "outside", "diffuse", "specular", "gloss", "roughness"});
    MaskPart out;
    out.place = std::string(node.file) + '#' + node.pointer;
    const JsonNode at = node.at("at");
    if (colors) {
      const Srgb8 code = color_code(at);
      out.code = {code.r, code.g, code.b};
    } else {
      out.code.fill(static_cast<std::uint8_t>(at.integer(0, 255)));
    }
    out.record = {node.text_or_empty("material"), node.text_or_empty("dataset"),
                  node.text_or_empty("outside")};
    out.diffuse = source(node, {"diffuse", true});
    out.specular = source(node, {"specular", true});
    out.gloss = source(node, {"gloss", false});
    out.roughness = source(node, {"roughness", false});
    if (out.record.material.empty() == !out.specular)
      node.fail(out.specular ? "both \"material\" and \"specular\"" : "no \"material\"",
                out.specular ? "one of the two" : "this key, or \"specular\"");
    if (out.specular && std::holds_alternative<ImageSource>(*out.specular))
      node.at("specular")
          .fail("a picture", "a library material, a number or a colour: one F0 for each material");
    if (out.gloss && out.roughness) node.fail("both \"gloss\" and \"roughness\"", "one of the two");
    if (out.specular && !out.gloss && !out.roughness) node.fail("no \"gloss\"", "this key, or \"roughness\"");
    return out;
  }

  static void check_roles(const JsonNode& node, const ManifestMaterial& m) {
    if (m.mask) {
      if (m.diffuse || m.specular || m.gloss || m.roughness || m.base_color || m.metallic)
        node.fail("a \"mask\" and a colour or gloss beside it", "these in the materials of the mask");
      return;
    }
    if (m.base_color || m.metallic) {
      if (m.diffuse || m.specular)
        node.fail("both \"basecolor\" or \"metallic\" and \"diffuse\" or \"specular\"", "one way of the two");
      if (!m.base_color) node.fail("no \"basecolor\" beside \"metallic\"", "this key");
    } else if (!m.specular) {
      node.fail("no \"specular\"", "this key, or \"basecolor\" and \"metallic\"");
    }
    if (m.gloss && m.roughness) node.fail("both \"gloss\" and \"roughness\"", "one of the two");
    if (!m.gloss && !m.roughness) node.fail("no \"gloss\"", "this key, or \"roughness\"");
  }

  static Srgb8 color_code(const JsonNode& node) {
    const std::string text = node.value.is_string() ? node.text() : std::string();
    if (text.size() != 7 || text[0] != '#' ||
        text.find_first_not_of("0123456789abcdefABCDEF", 1) != text.npos)
      node.fail_type("\"#rrggbb\"");
    return parse_hex(text);
  }

  std::optional<TextureSource> source(const JsonNode& material, const Role& role) const {
    if (!material.has(role.key)) return std::nullopt;
    const JsonNode node = material.at(role.key);
    if (node.value.is_string()) return source_text(node, role);
    if (node.value.is_number()) {
      const double v = number_of(node, role);
      return ConstantSource{{v, v, v}, {}};
    }
    if (node.value.is_array()) {
      if (!role.color) node.fail_type("a number");
      if (node.size() != 3) node.fail_type("[r, g, b]");
      return ConstantSource{
          {number_of(node.at(0), role), number_of(node.at(1), role), number_of(node.at(2), role)}, {}};
    }
    if (!node.value.is_object()) node.fail_type(source_forms);
    if (node.has("material")) {
      node.expect_object({"material", "dataset", "outside"});
      if (!role.color) node.fail("a library material", "a file or a number");
      return LibrarySource{node.at("material").text(), node.text_or_empty("dataset"),
                           node.text_or_empty("outside")};
    }
    node.expect_object({"image", "channels", "space"});
    return ImageSource{path_of(node.at("image")), read_channels(node, role.color),
                       node.text_or_empty("space")};
  }

  TextureSource source_text(const JsonNode& node, const Role& role) const {
    const std::string text = node.text();
    if (text.starts_with('#')) {
      if (!role.color) node.fail_type("a number");
      const Srgb8 codes = color_code(node);
      return ConstantSource{srgb_decode(codes), codes};
    }
    if (text.empty()) node.fail_type(source_forms);
    if (text.find_first_of("./") != text.npos) return ImageSource{path_of(node), "", ""};
    if (!role.color)
      node.fail(in_quotes(text) + ", which is no file name (it has no ending)", "a file or a number");
    return LibrarySource{text, "", ""};
  }

  // F0 of the library is above 1 where a colour lies outside of sRGB, and may be given so.
  static double number_of(const JsonNode& node, const Role& role) {
    if (std::string_view(role.key) != "specular") return unit_number(node);
    const double v = node.number();
    if (v < 0 || v > 2) node.fail_type("a number from 0 to 2; above 1 is outside of sRGB");
    return v;
  }

  static double unit_number(const JsonNode& node) {
    const double v = node.number();
    if (v < 0 || v > 1) node.fail_type("a number from 0 to 1");
    return v;
  }

  std::string path_of(const JsonNode& node) const { return read_path(node, folder_); }

  JsonNode root_;
  std::filesystem::path folder_;
};

Json json_of(const TextureSource& source, bool color) {
  if (const auto* record = std::get_if<LibrarySource>(&source)) {
    Json out{{"material", record->material}};
    if (!record->dataset.empty()) out["dataset"] = record->dataset;
    if (!record->outside.empty()) out["outside"] = record->outside;
    return out;
  }
  const auto& constant = std::get<ConstantSource>(source);
  const LinearRgb& c = constant.linear;
  if (!color) return c.r;
  return Json::array({c.r, c.g, c.b});
}

}  // namespace

std::string format_masks(const AtlasManifest& manifest, const std::string& file) {
  const std::filesystem::path folder = folder_of_document(file);
  Json materials = Json::array();
  for (const ManifestMaterial& m : manifest.materials) {
    const MaterialMask& mask = m.mask.value();
    Json parts = Json::array();
    for (const MaskPart& part : mask.parts) {
      Json row;
      const auto [r, g, b] = part.code;
      if (mask.colors)
        row["at"] = hex({r, g, b});
      else
        row["at"] = r;
      for (const auto& [key, source] : {std::pair{"diffuse", &part.diffuse},
                                        {"specular", &part.specular},
                                        {"gloss", &part.gloss},
                                        {"roughness", &part.roughness}})
        if (*source) row[key] = json_of(**source, source == &part.diffuse || source == &part.specular);
      parts.push_back(std::move(row));
    }
    Json write = Json::array();
    if (mask.specular_gloss) write.push_back("specular_gloss");
    if (mask.metal_rough) write.push_back("metal_rough");
    Json of_mask{{"image", name_from(folder, mask.image.path)}, {"materials", parts}, {"write", write}};
    if (!mask.image.channels.empty()) of_mask["channels"] = mask.image.channels;
    materials.push_back({{"name", m.name}, {"alpha_mode", name(m.alpha_mode)}, {"mask", std::move(of_mask)}});
  }
  return Json{{"schema", "etak-atlas-manifest/1"},
              {"gloss", name(manifest.gloss)},
              {"materials", std::move(materials)}}
             .dump(2) +
         '\n';
}

AtlasManifest parse_manifest(std::string_view text, const std::string& file) {
  const JsonDocument document = parse_json_strictly(text, file, manifest_depth, "an atlas manifest");
  AtlasManifest out = ManifestReader(document, file).read();
  // By name, so that the order in the file cannot change the atlas.
  std::sort(out.materials.begin(), out.materials.end(),
            [](const ManifestMaterial& a, const ManifestMaterial& b) { return a.name < b.name; });
  return out;
}

}  // namespace etak
