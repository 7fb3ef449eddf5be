// SPDX-License-Identifier: Apache-2.0
#include "core/project/command_line.h"

#include <algorithm>
#include <cctype>

#include "core/base/number.h"
#include "core/light/studio.h"
#include "core/render/display.h"

namespace etak {
namespace {

// A word of a POSIX shell's line.
std::string quoted(const std::string& word) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           (c != 0 && std::string_view("_-./=,+:@%").find(char(c)) != std::string_view::npos);
  };
  if (!word.empty() && std::ranges::all_of(word, plain)) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + '\'';
}

std::string color(const LinearRgb& c) {
  return number(c.r, 9) + ',' + number(c.g, 9) + ',' + number(c.b, 9);
}
std::string color(const Vec3& c) {
  return color(LinearRgb{c[0], c[1], c[2]});
}

class Line {
 public:
  Line& word(const std::string& text) {
    out += (out.empty() ? "" : " ") + quoted(text);
    return *this;
  }
  void option(const char* name, const std::string& value) { word(name).word(value); }
  void option(const char* name, double value, double standard) {
    if (value != standard) option(name, number(value, 9));
  }
  std::string out;
};

void add_material(const ProjectMaterial& m, Line& line) {
  if (m.measured) {
    line.word(m.measured->material + (m.measured->dataset.empty() ? "" : '/' + m.measured->dataset));
    if (!m.measured->outside.empty()) line.option("--outside", m.measured->outside);
    line.option("--diffuse", color(m.diffuse));
  } else {
    line.word("f0=" + color(m.specular)).word("diffuse=" + color(m.diffuse));
  }
  if (m.gloss.given_roughness())
    line.option("--roughness", number(*m.gloss.given_roughness(), 9));
  else
    line.option("--gloss", number(double{m.gloss}, 9));
  line.option("--opacity", number(m.alpha, 9));
  if (m.emission != LinearRgb{0, 0, 0}) line.option("--emission", color(m.emission));
  line.option("--occlusion", m.occlusion, 1);
}

void add_models(const ProjectMaterial& m, const std::string& engine, Line& line) {
  if (!engine.empty()) return line.option("--as", engine);
  line.option("--model", m.specular_model.empty() ? "none" : m.specular_model);
  const Model* specular = find_model(m.specular_model);
  if (specular == nullptr || specular->kind != ModelKind::combined)
    line.option("--diffuse-model", m.diffuse_model.empty() ? "none" : m.diffuse_model);
  for (const auto& [name, value] : m.parameters) line.option("--set", name + '=' + number(value, 9));
}

// Studio with its flashes, or an environment alone; other lights need a file.
void add_lights(const ProjectView& view, Line& line, std::vector<std::string>& left_out) {
  LightSetup plain = view.lights;
  plain.ground.reset();
  LightSetup alone;
  alone.environment = plain.environment;
  if (plain == alone && !plain.environment.empty())
    line.option("--env", plain.environment);
  else if (plain != studio_lights())
    left_out.emplace_back("lights of one's own");
  if (view.lights.ground) line.option("--ground", color(*view.lights.ground));
}

}  // namespace

CommandLine render_command(const Project& project, const ProjectMaterial& material, const View& camera,
                           const std::string& engine) {
  const ProjectView& view = project.view;
  CommandLine out;
  Line line;
  line.word("etak").word("render");
  add_material(material, line);
  add_models(material, engine, line);
  add_lights(view, line, out.left_out);
  if (view.shape == Shape::quad) line.word("--quad");
  if (!view.mesh.empty()) line.option("--mesh", view.mesh);
  line.option("--exposure", view.exposure, 1);
  if (view.tone != Tone::plain && engine.empty()) line.option("--tone", std::string(name(view.tone)));
  line.option("--background", color(view.background));
  line.option("--orbit", camera.turn_deg, 0);
  line.option("--tilt", camera.rise_deg, 0);
  line.option("-o", "picture.png");
  out.text = line.out;
  if (std::ranges::any_of(material.textures, [](const auto& each) { return each.has_value(); }))
    out.left_out.emplace_back("pictures");
  if (material.measured && std::ranges::any_of(project.spectra, [&](const Material& each) {
        return each.id == material.measured->material;
      }))
    out.left_out.emplace_back("the imported spectrum, whose file is to stand for its name");
  if (!view.display.empty()) out.left_out.emplace_back("the display");
  if (view.backdrop != Backdrop{}) out.left_out.emplace_back("the backdrop");
  if (view.environment_turn_deg != 0) out.left_out.emplace_back("the turn of the environment");
  if (view.wedge.on || view.compare.on) out.left_out.emplace_back("comparison and wedge");
  if (camera.zoom != 1 || camera.pan_x != 0 || camera.pan_y != 0) out.left_out.emplace_back("zoom");
  return out;
}

}  // namespace etak
