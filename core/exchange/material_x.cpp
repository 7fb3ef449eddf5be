// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/material_x.h"

#include <algorithm>
#include <set>

#include "core/base/ascii.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/exchange/engine_values.h"

namespace etak {
namespace {

constexpr int digits = 7;

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

// MaterialX takes letters, digits and '_', no digit first.
std::string node_name(const std::string& id, std::set<std::string>& taken) {
  std::string out;
  for (const char c : id) {
    out += is_letter(c) || is_digit(c) ? c : '_';
  }
  if (out.empty() || is_digit(out[0]) || out[0] == '_') out.insert(0, "m");
  const std::string first = out;
  for (int i = 2; !taken.insert(out).second; ++i) out = first + "_" + std::to_string(i);
  return out;
}

// XML comments may not hold "--".
std::string comment(const std::string& text) {
  std::string out = "  <!-- " + escape_html(text);
  for (std::size_t at = 0; (at = out.find("--", at == 0 ? 6 : at)) != out.npos;) out.insert(at + 1, " ");
  return out + " -->\n";
}

class Node {
 public:
  Node(std::string& out, std::string space) : out_(out), space_(std::move(space)) {}
  void input(const char* name, double value) const {
    append(out_, "    <input name=\"", name, "\" type=\"float\" value=\"", number(value, digits), "\" />\n");
  }
  void input(const char* name, const LinearRgb& c) const {
    append(out_, "    <input name=\"", name, "\" type=\"color3\" value=\"", number(c.r, digits), ", ",
           number(c.g, digits), ", ", number(c.b, digits), "\" colorspace=\"", space_, "\" />\n");
  }

 private:
  std::string& out_;
  std::string space_;
};

void append_surface(std::string& out, const ExportSurface& s, Fit fit, const std::string& name,
                    Changes& changes) {
  const OpenPbrValues v = open_pbr_values(s, fit, changes);
  out += comment(s.name + (s.source.empty() ? "" : ": " + s.source));
  for (const std::string& note : s.notes) out += comment(note);
  for (const Change& change : changes) out += comment(one_line(change));
  append(out, "  <open_pbr_surface name=\"", name,
         "_surface\" type=\"surfaceshader\" nodedef=\"ND_open_pbr_surface_surfaceshader\">\n");
  const Node node(out, color_space(s.space));
  node.input("base_color", v.base_color);
  node.input("base_metalness", v.base_metalness);
  node.input("specular_color", v.specular_color);
  node.input("specular_roughness", v.specular_roughness);
  if (s.kind == SurfaceKind::dielectric) node.input("specular_ior", v.specular_ior);
  if (v.transmission_weight > 0) {
    node.input("transmission_weight", v.transmission_weight);
    node.input("transmission_color", v.transmission_color);
    node.input("transmission_depth", v.transmission_depth);
  }
  if (v.geometry_opacity < 1) node.input("geometry_opacity", v.geometry_opacity);
  append(out, "  </open_pbr_surface>\n  <surfacematerial name=\"", name,
         "\" type=\"material\">\n    <input name=\"surfaceshader\" type=\"surfaceshader\" nodename=\"", name,
         "_surface\" />\n  </surfacematerial>\n");
}

}  // namespace

std::string material_x(std::span<const ExportSurface> surfaces, Fit fit, std::vector<Changes>& changes) {
  changes.assign(surfaces.size(), {});
  if (surfaces.empty()) throw Error::at("MaterialX", "no material", "one or more");
  std::string out = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<materialx version=\"1.39\" colorspace=\"" +
                    color_space(surfaces.front().space) + "\">\n";
  std::set<std::string> taken;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    validate(surfaces[i]);
    // The shader's name must be free too.
    std::string name = node_name(surfaces[i].id, taken);
    while (!taken.insert(name + "_surface").second) name = node_name(surfaces[i].id, taken);
    append_surface(out, surfaces[i], fit, name, changes[i]);
  }
  return out + "</materialx>\n";
}

}  // namespace etak
