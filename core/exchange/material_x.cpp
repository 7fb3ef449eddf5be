// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/material_x.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/base/text/text.h"
#include "core/exchange/engine_values.h"

namespace etak {
namespace {

constexpr int xml_digits = 7;

std::string color_space(RgbSpace space) {
  switch (space) {
    case RgbSpace::srgb:
      return "lin_rec709";
    case RgbSpace::acescg:
      return "acescg";
    case RgbSpace::display_p3:
      return "lin_displayp3";
    default:
      throw Error::at("MaterialX", "colours in " + std::string(name(space)), "srgb, acescg or display-p3");
  }
}

// An identifier that is not taken yet.
std::string node_name(const std::string& id, std::set<std::string>& taken) {
  const std::string first = identifier(id);
  std::string out = first;
  for (int i = 2; !taken.insert(out).second; ++i) out = first + "_" + std::to_string(i);
  return out;
}

class Node {
 public:
  Node(std::string& out, std::string space) : out_(out), space_(std::move(space)) {}
  void input(const char* name, double value) const {
    append(out_, "    <input name=\"", name, "\" type=\"float\" value=\"", number(value, xml_digits),
           "\" />\n");
  }
  void input(const char* name, const LinearRgb& c) const {
    append(out_, "    <input name=\"", name, "\" type=\"color3\" value=\"", number(c.r, xml_digits), ", ",
           number(c.g, xml_digits), ", ", number(c.b, xml_digits), "\" colorspace=\"", space_, "\" />\n");
  }

 private:
  std::string& out_;
  std::string space_;
};

// The image nodes of a surface, which stand before it, and the inputs of the surface that they give.
class ImageNodes {
 public:
  ImageNodes(std::string& out, std::set<std::string>& taken, const std::array<double, 2>& scale)
      : out_(out), taken_(taken), scale_(scale) {}

  /// Adds the node of one input, where it has a picture.
  ///   type   "color3" of an sRGB picture, "float", or "vector3" of a normal map
  void add(const std::string& surface, const char* input, const char* type, const std::string& file) {
    if (file.empty()) return;
    std::string name = node_name(surface + "_" + input, taken_);
    const std::string_view node = scale_ == std::array{1.0, 1.0} ? "image" : "tiledimage";
    append(out_, "  <", node, " name=\"", name, "\" type=\"", type,
           "\">\n    <input name=\"file\" type=\"filename\" value=\"", escape_html(file), "\"",
           std::string_view(type) == "color3" ? " colorspace=\"srgb_texture\"" : "", " />\n");
    if (node != "image") {
      pair("uvtiling", scale_[0], scale_[1]);
      // v is 0 at the bottom there, and the pictures begin at the top.
      if (const double rest = scale_[1] - std::floor(scale_[1]); rest > 0) pair("uvoffset", 0, rest);
    }
    append(out_, "  </", node, ">\n");
    if (std::string_view(type) == "vector3") {
      const std::string picture = std::move(name);
      name = node_name(surface + "_" + input + "_space", taken_);
      append(out_, "  <normalmap name=\"", name,
             "\" type=\"vector3\">\n    <input name=\"in\" type=\"vector3\" nodename=\"", picture,
             "\" />\n  </normalmap>\n");
    }
    append(inputs_, "    <input name=\"", input, "\" type=\"", type, "\" nodename=\"", name, "\" />\n");
  }
  const std::string& inputs() const { return inputs_; }

 private:
  void pair(std::string_view name, double u, double v) {
    append(out_, "    <input name=\"", name, "\" type=\"vector2\" value=\"", number(u, xml_digits), ", ",
           number(v, xml_digits), "\" />\n");
  }

  std::string& out_;
  std::set<std::string>& taken_;
  const std::array<double, 2> scale_;
  std::string inputs_;
};

void append_surface(std::string& out, const ExportSurface& s, Fit fit, const MaterialXPictures& pictures,
                    const std::string& name, std::set<std::string>& taken, Changes& changes) {
  const OpenPbrValues v = open_pbr_values(s, fit, changes);
  out += material_x_comment(s.title());
  for (const std::string& note : s.notes) out += material_x_comment(note);
  for (const Change& change : changes) out += material_x_comment(one_line(change));
  ImageNodes images(out, taken, pictures.scale);
  images.add(name, "base_color", "color3", pictures.base_color);
  images.add(name, "base_metalness", "float", pictures.base_metalness);
  images.add(name, "specular_roughness", "float", pictures.specular_roughness);
  images.add(name, "geometry_opacity", "float", pictures.geometry_opacity);
  images.add(name, "emission_color", "color3", pictures.emission_color);
  images.add(name, "geometry_normal", "vector3", pictures.geometry_normal);
  append(out, "  <open_pbr_surface name=\"", name,
         "_surface\" type=\"surfaceshader\" nodedef=\"ND_open_pbr_surface_surfaceshader\">\n",
         images.inputs());
  const Node node(out, color_space(s.space));
  if (pictures.base_color.empty()) node.input("base_color", v.base_color);
  if (pictures.base_metalness.empty()) node.input("base_metalness", v.base_metalness);
  node.input("specular_color", v.specular_color);
  if (pictures.specular_roughness.empty()) node.input("specular_roughness", v.specular_roughness);
  if (s.kind == SurfaceKind::dielectric) node.input("specular_ior", v.specular_ior);
  open_pbr_layers(v, [&](const char* input, const auto& value) { node.input(input, value); });
  if (pictures.geometry_opacity.empty() && v.geometry_opacity < 1)
    node.input("geometry_opacity", v.geometry_opacity);
  if (s.emission != LinearRgb{}) {
    const auto [color, strength] = emission_parts(s.emission);
    node.input("emission_luminance", strength);
    if (pictures.emission_color.empty()) node.input("emission_color", color);
  }
  append(out, "  </open_pbr_surface>\n  <surfacematerial name=\"", name,
         "\" type=\"material\">\n    <input name=\"surfaceshader\" type=\"surfaceshader\" nodename=\"", name,
         "_surface\" />\n  </surfacematerial>\n");
}

}  // namespace

std::string identifier(const std::string& id) {
  std::string out;
  for (const char c : id) out += is_letter(c) || is_digit(c) ? c : '_';
  if (out.empty() || is_digit(out[0]) || out[0] == '_') out.insert(0, "m");
  return out;
}

// XML comments may not hold "--".
std::string material_x_comment(const std::string& text) {
  std::string out = "  <!-- " + escape_html(text);
  for (std::size_t at = 0; (at = out.find("--", at == 0 ? 6 : at)) != out.npos;) out.insert(at + 1, " ");
  return out + " -->\n";
}

std::string material_x(std::span<const ExportSurface> surfaces, Fit fit, std::vector<Changes>& changes,
                       std::span<const MaterialXPictures> pictures) {
  changes.assign(surfaces.size(), {});
  if (surfaces.empty()) throw Error::at("MaterialX", "no material", "one or more");
  std::string out = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<materialx version=\"1.39\" colorspace=\"" +
                    color_space(surfaces.front().space) + "\">\n";
  const MaterialXPictures none;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    validate(surfaces[i]);
    // The shader's name must be free too.
    std::string name = node_name(surfaces[i].id, taken);
    while (!taken.insert(name + "_surface").second) name = node_name(surfaces[i].id, taken);
    append_surface(out, surfaces[i], fit, pictures.empty() ? none : pictures[i], name, taken, changes[i]);
  }
  return out + "</materialx>\n";
}

}  // namespace etak
