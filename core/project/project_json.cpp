// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <set>

#include "core/atlas/material_nodes_json.h"
#include "core/base/json/json_text.h"
#include "core/base/system.h"
#include "core/image/image.h"
#include "core/judge/settings.h"
#include "core/light/studio.h"
#include "core/material/json.h"
#include "core/material/material_node_json.h"
#include "core/project/project.h"
#include "core/render/display.h"
#include "core/render/mesh/mesh_shape.h"

namespace etak {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view schema_name = "etak-project/1";
constexpr int most_depth = 24;
constexpr double largest_color = 1e4;

// ---- reading

class Reader {
 public:
  Reader(const Json& document, std::string_view file)
      : root_{document, file, {}}, folder_(fs::path(file).parent_path()) {}

  Project read() {
    root_.expect_object({"schema", "view", "spectra", "materials"});
    root_.at("schema").expect_text(schema_name);
    Project out;
    if (root_.has("view")) out.view = view(root_.at("view"));
    if (root_.has("spectra")) {
      const JsonNode list = root_.at("spectra");
      list.expect_array();
      std::set<std::string> ids;
      for (std::size_t i = 0; i < list.size(); ++i) {
        out.spectra.push_back(read_material(list.at(i)));
        if (!ids.insert(out.spectra.back().id).second)
          list.at(i).fail("a second \"" + out.spectra.back().id + "\"", "each id once");
      }
    }
    const JsonNode list = root_.at("materials");
    list.expect_array();
    out.materials =
        read_materials<ProjectMaterial>(list, [&](const JsonNode& node) { return material(node); });
    return out;
  }

 private:
  ProjectView view(const JsonNode& node) const {
    node.expect_object({"shape", "mesh", "lights", "environment_turn_deg", "exposure", "ocio", "tone",
                        "backdrop", "compare", "wedge"});
    ProjectView out;
    if (node.has("shape")) {
      const std::string shape = node.at("shape").text();
      if (shape != "sphere" && shape != "quad") node.at("shape").fail_type("sphere or quad");
      out.shape = shape == "quad" ? Shape::quad : Shape::sphere;
    }
    out.mesh = node.text_or_empty("mesh");
    if (!out.mesh.empty() && out.mesh != shader_ball_name)
      out.mesh = path_beside(sys::path_text(folder_), out.mesh);
    if (node.has("lights")) {
      const JsonNode lights = node.at("lights");
      out.lights = parse_lights(lights.value.dump(), std::string(node.file) + '#' + lights.pointer);
      if (!out.lights.environment.empty() && find_studio(out.lights.environment) == nullptr)
        out.lights.environment = path_beside(sys::path_text(folder_), out.lights.environment);
    }
    if (node.has("environment_turn_deg"))
      out.environment_turn_deg = ranged(node.at("environment_turn_deg"), -360, 360);
    if (node.has("exposure")) out.exposure = ranged(node.at("exposure"), 0, 1e6);
    if (node.has("ocio")) {
      const JsonNode ocio = node.at("ocio");
      ocio.expect_object({"config", "display", "view"});
      out.config = ocio.text_or_empty("config");
      out.display = ocio.text_or_empty("display");
      out.view = ocio.text_or_empty("view");
    }
    if (node.has("tone"))
      out.tone = node.at("tone").word(tone_named, "plain, neutral, agx-like or false-color");
    if (node.has("backdrop")) backdrop(node.at("backdrop"), out);
    if (node.has("compare")) out.compare = comparison(node.at("compare"));
    if (node.has("wedge")) out.wedge = wedge(node.at("wedge"));
    return out;
  }

  static void backdrop(const JsonNode& node, ProjectView& out) {
    node.expect_object({"color", "environment", "blur", "ground"});
    if (node.has("color")) {
      out.background = color(node.at("color"));
      const LinearRgb& c = out.background;
      if (std::min({c.r, c.g, c.b}) < 0) node.at("color").fail_type("numbers of at least 0");
    }
    if (node.has("environment")) out.backdrop.environment = node.at("environment").boolean();
    if (node.has("blur")) out.backdrop.blur = ranged(node.at("blur"), 0, 1);
    if (node.has("ground")) out.backdrop.ground = node.at("ground").boolean();
  }

  Comparison comparison(const JsonNode& node) const {
    node.expect_object({"on", "pinned", "model"});
    Comparison out;
    if (node.has("on")) out.on = node.at("on").boolean();
    if (node.has("pinned")) out.pinned = material(node.at("pinned"));
    read_model(node, "model", false, out.model);
    return out;
  }

  static Wedge wedge(const JsonNode& node) {
    node.expect_object({"on", "parameter", "steps"});
    Wedge out;
    if (node.has("on")) out.on = node.at("on").boolean();
    if (node.has("parameter")) out.parameter = node.at("parameter").text();
    if (node.has("steps")) {
      const double steps = ranged(node.at("steps"), Wedge::least_steps, Wedge::most_steps);
      out.steps = static_cast<int>(steps);
      if (out.steps != steps) node.at("steps").fail_type("a whole number");
    }
    return out;
  }

  ProjectMaterial material(const JsonNode& node) const {
    node.expect_object({"name", "diffuse", "specular", "measured", "gloss", "roughness", "alpha", "emission",
                        "occlusion", "textures", "uv_scale", "alpha_mode", "alpha_cutoff", "model",
                        "diffuse_model", "parameters"});
    ProjectMaterial out;
    out.name = read_name(node);
    if (node.has("diffuse")) out.diffuse = color(node.at("diffuse"));
    if (node.has("measured")) out.measured = measured(node.at("measured"));
    if (node.has("specular")) out.specular = color(node.at("specular"));
    if (node.has("gloss") && node.has("roughness"))
      node.fail("both \"gloss\" and \"roughness\"", "one of the two");
    if (node.has("gloss")) out.gloss = ranged(node.at("gloss"), 0, 1);
    if (node.has("roughness")) out.gloss = Gloss::of_roughness(ranged(node.at("roughness"), 0, 1));
    if (node.has("alpha")) out.alpha = ranged(node.at("alpha"), 0, 1);
    if (node.has("occlusion")) out.occlusion = ranged(node.at("occlusion"), 0, 1);
    if (node.has("textures")) textures(node.at("textures"), out);
    if (node.has("uv_scale"))
      out.uv_scale =
          node.at("uv_scale")
              .each_of<2>([](const JsonNode& each) { return ranged(each, least_uv_scale, most_uv_scale); },
                          "[u, v]");
    out.emission = node.has("emission") ? color(node.at("emission"), 0) : standard_emission(out);
    if (node.has("alpha_mode")) out.alpha_mode = read_alpha_mode(node.at("alpha_mode"));
    if (node.has("alpha_cutoff")) out.alpha_cutoff = ranged(node.at("alpha_cutoff"), 0, 1);
    models(node, out);
    return out;
  }

  static double ranged(const JsonNode& node, double least, double most) {
    const double v = node.number();
    if (v < least || v > most) node.fail_type("a number from " + json(least) + " to " + json(most));
    return v;
  }

  static LinearRgb color(const JsonNode& node, double least = -largest_color) {
    const auto part = [least](const JsonNode& each) { return ranged(each, least, largest_color); };
    return to_rgb(node.each_of<3>(part, "[r, g, b]"));
  }

  static MeasuredF0 measured(const JsonNode& node) {
    node.expect_object({"material", "dataset", "outside", "illuminant", "observer"});
    MeasuredF0 out;
    out.material = node.at("material").text();
    out.dataset = node.text_or_empty("dataset");
    out.outside = node.text_or_empty("outside");
    if (node.has("illuminant"))
      out.viewing.illuminant = node.at("illuminant").word(illuminant_named, "D65, D50, A or E");
    if (node.has("observer"))
      out.viewing.observer = node.at("observer").word(observer_named, "1931-2deg or 1964-10deg");
    return out;
  }

  void textures(const JsonNode& node, ProjectMaterial& out) const {
    node.expect_object({"diffuse", "specular", "gloss", "alpha", "emission", "occlusion", "base_color",
                        "metallic", "roughness", "smoothness", "normal"});
    for (const Channel channel : all_channels) {
      if (!node.has(name(channel))) continue;
      const JsonNode picture = node.at(name(channel));
      picture.expect_object({"image", "channels", "space", "green"});
      if (picture.has("green")) {
        if (channel != Channel::normal) picture.at("green").fail("of another channel than normal", "nothing");
        out.green_down = picture.at("green").word(green_named, "opengl or directx") == GreenAxis::directx;
      }
      out.texture(channel) =
          ImageSource{read_path(picture.at("image"), folder_), read_channels(picture, is_color(channel)),
                      picture.text_or_empty("space")};
    }
    for (const auto& [one, other] : {std::pair("base_color", "diffuse"), std::pair("base_color", "specular"),
                                     std::pair("metallic", "diffuse"), std::pair("metallic", "specular"),
                                     std::pair("gloss", "roughness"), std::pair("gloss", "smoothness"),
                                     std::pair("roughness", "smoothness")})
      if (node.has(one) && node.has(other))
        node.fail("both \"" + std::string(one) + "\" and \"" + other + "\"", "one of the two");
  }

  static void read_model(const JsonNode& node, const char* key, bool diffuse, std::string& id) {
    if (!node.has(key)) return;
    id = node.at(key).text();
    if (id.empty()) return;
    const Model* found = find_model(id);
    if (found == nullptr || (found->kind == ModelKind::diffuse) != diffuse)
      node.at(key).fail_type(diffuse ? "a diffuse model" : "a specular model");
  }

  static void models(const JsonNode& node, ProjectMaterial& out) {
    read_model(node, "model", false, out.specular_model);
    read_model(node, "diffuse_model", true, out.diffuse_model);
    if (!node.has("parameters")) return;
    const JsonNode values = node.at("parameters");
    values.expect_object();
    for (const auto& [key, ignored] : values.value.items())
      out.parameters.emplace_back(key, values.at(key).number());
  }

  JsonNode root_;
  fs::path folder_;
};

// ---- writing

std::string color_json(const LinearRgb& c) {
  return json_array_of(vec(c));
}

class Writer {
 public:
  explicit Writer(const std::string& file) {
    if (!file.empty()) folder_ = folder_of_document(file);
  }

  std::string text(const Project& project) const {
    std::vector<JsonMember> members{{"schema", json(schema_name)}, {"view", view(project.view)}};
    if (!project.spectra.empty()) {
      std::string spectra = "[";
      for (std::size_t i = 0; i < project.spectra.size(); ++i) {
        std::string one = format_material(project.spectra[i]);
        while (one.ends_with('\n')) one.pop_back();
        spectra += (i == 0 ? "\n" : ",\n") + one;
      }
      members.push_back({"spectra", spectra + "\n  ]"});
    }
    std::string materials = "[";
    for (std::size_t i = 0; i < project.materials.size(); ++i)
      materials += (i == 0 ? "\n    " : ",\n    ") + material(project.materials[i]);
    members.push_back({"materials", materials + (project.materials.empty() ? "]" : "\n  ]")});
    return json_object(members, 0) + '\n';
  }

 private:
  std::string path(const std::string& picture) const { return name_from(folder_, picture); }

  std::string view(const ProjectView& view) const {
    LightSetup lights = view.lights;
    if (!lights.environment.empty() && find_studio(lights.environment) == nullptr)
      lights.environment = path(lights.environment);
    std::vector<JsonMember> members{{"shape", json(view.shape == Shape::quad ? "quad" : "sphere")},
                                    {"lights", format_lights(lights, 4)},
                                    {"environment_turn_deg", json(view.environment_turn_deg)},
                                    {"exposure", json(view.exposure)}};
    if (!view.mesh.empty())
      members.push_back({"mesh", json(view.mesh == shader_ball_name ? view.mesh : path(view.mesh))});
    std::vector<JsonMember> ocio;
    for (const auto& [key, value] : {std::pair("config", &view.config), std::pair("display", &view.display),
                                     std::pair("view", &view.view)})
      if (!value->empty()) ocio.push_back({key, json(*value)});
    if (!ocio.empty()) members.push_back({"ocio", json_object(ocio, -1)});
    if (view.tone != Tone::plain) members.push_back({"tone", json(name(view.tone))});
    if (const ProjectView plain; view.background != plain.background || view.backdrop != plain.backdrop) {
      const std::vector<JsonMember> backdrop{{"color", color_json(view.background)},
                                             {"environment", json(view.backdrop.environment)},
                                             {"blur", json(view.backdrop.blur)},
                                             {"ground", json(view.backdrop.ground)}};
      members.push_back({"backdrop", json_object(backdrop, -1)});
    }
    if (view.compare != Comparison{}) members.push_back({"compare", comparison(view.compare)});
    if (view.wedge != Wedge{}) {
      const std::vector<JsonMember> wedge{{"on", json(view.wedge.on)},
                                          {"parameter", json(view.wedge.parameter)},
                                          {"steps", json(static_cast<std::size_t>(view.wedge.steps))}};
      members.push_back({"wedge", json_object(wedge, -1)});
    }
    return json_object(members, 2);
  }

  std::string comparison(const Comparison& compare) const {
    std::vector<JsonMember> members{{"on", json(compare.on)}};
    if (compare.pinned) members.push_back({"pinned", material(*compare.pinned)});
    if (!compare.model.empty()) members.push_back({"model", json(compare.model)});
    return json_object(members, -1);
  }

  std::string material(const ProjectMaterial& m) const {
    std::vector<JsonMember> members{{"name", json(m.name)}, {"diffuse", color_json(m.diffuse)}};
    members.push_back({"specular", color_json(m.specular)});
    if (m.measured) members.push_back({"measured", measured(*m.measured)});
    if (const auto& roughness = m.gloss.given_roughness())
      members.push_back({"roughness", json(*roughness)});
    else
      members.push_back({"gloss", json(double{m.gloss})});
    members.push_back({"alpha", json(m.alpha)});
    if (m.emission != standard_emission(m)) members.push_back({"emission", color_json(m.emission)});
    if (m.occlusion != 1) members.push_back({"occlusion", json(m.occlusion)});
    std::vector<JsonMember> textures;
    for (const Channel channel : all_channels)
      if (const auto& source = m.texture(channel)) {
        std::vector<JsonMember> parts{{"image", json(path(source->path))}};
        if (!source->channels.empty()) parts.push_back({"channels", json(source->channels)});
        if (!source->space.empty()) parts.push_back({"space", json(source->space)});
        if (channel == Channel::normal && m.green_down) parts.push_back({"green", json("directx")});
        textures.push_back({name(channel), json_object(parts, -1)});
      }
    if (!textures.empty()) members.push_back({"textures", json_object(textures, -1)});
    if (m.uv_scale != std::array{1.0, 1.0})
      members.push_back({"uv_scale", "[" + json(m.uv_scale[0]) + ", " + json(m.uv_scale[1]) + "]"});
    const ProjectMaterial standard;
    if (m.alpha_mode != standard.alpha_mode) members.push_back({"alpha_mode", json(name(m.alpha_mode))});
    if (m.alpha_cutoff != standard.alpha_cutoff) members.push_back({"alpha_cutoff", json(m.alpha_cutoff)});
    members.push_back({"model", json(m.specular_model)});
    members.push_back({"diffuse_model", json(m.diffuse_model)});
    std::vector<JsonMember> parameters;
    for (const auto& [key, value] : m.parameters) parameters.push_back({key, json(value)});
    if (!parameters.empty()) members.push_back({"parameters", json_object(parameters, -1)});
    return json_object(members, -1);
  }

  static std::string measured(const MeasuredF0& measured) {
    std::vector<JsonMember> members{{"material", json(measured.material)}};
    if (!measured.dataset.empty()) members.push_back({"dataset", json(measured.dataset)});
    if (!measured.outside.empty()) members.push_back({"outside", json(measured.outside)});
    const Viewing standard;
    if (measured.viewing.illuminant != standard.illuminant)
      members.push_back({"illuminant", json(name(measured.viewing.illuminant))});
    if (measured.viewing.observer != standard.observer)
      members.push_back({"observer", json(name(measured.viewing.observer))});
    return json_object(members, -1);
  }

  fs::path folder_;
};

}  // namespace

Project parse_project(std::string_view text, const std::string& file) {
  const JsonDocument document = parse_json_strictly(text, file, most_depth, "a project");
  return Reader(document, file).read();
}

std::string format_project(const Project& project, const std::string& file) {
  return Writer(file).text(project);
}

}  // namespace etak
