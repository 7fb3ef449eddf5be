// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/json/json_text.h"
#include "core/base/json/node_json.h"
#include "core/light/lights.h"
#include "core/math/functions.h"

namespace etak {
namespace {

constexpr std::string_view schema_name = "etak-lights/1";
constexpr int most_depth = 8;
constexpr std::size_t most_lights = 256;

using Node = JsonNode;

Vec3 three(const Node& node) {
  return node.each_of<3>(&Node::number, "three numbers");
}

Vec3 unit_vector(const Node& node) {
  const Vec3 v = three(node);
  const double length = math::hypot(v[0], v[1], v[2]);
  if (!(length > 1e-12) || !std::isfinite(length)) node.fail("a direction of length zero");
  // A vector of length 1 is not scaled, so that it reads back as it was written, bit by bit.
  if (std::abs(length - 1) < 1e-14) return v;
  return {v[0] / length, v[1] / length, v[2] / length};
}

Light read_light(const Node& node) {
  node.expect_object();
  Light light;
  light.kind = node.at("kind").word(light_kind_named,
                                    "\"point\", \"directional\", \"spot\", \"rectangle\" or \"disc\"");
  switch (light.kind) {
    case LightKind::point:
      node.expect_object({"kind", "position", "color", "intensity"});
      break;
    case LightKind::directional:
      node.expect_object({"kind", "direction", "color", "intensity"});
      break;
    case LightKind::spot:
      node.expect_object({"kind", "position", "direction", "color", "intensity", "inner_deg", "outer_deg"});
      light.inner_deg = node.at("inner_deg").number();
      light.outer_deg = node.at("outer_deg").number();
      break;
    case LightKind::rectangle:
    case LightKind::disc:
      node.expect_object({"kind", "position", "direction", "up", "width", "height", "color", "intensity"});
      light.width = node.at("width").number();
      light.height = node.at("height").number();
      if (node.has("up")) light.up = unit_vector(node.at("up"));
      break;
  }
  if (light.kind != LightKind::directional) light.position = three(node.at("position"));
  if (light.kind != LightKind::point) light.direction = unit_vector(node.at("direction"));
  if (node.has("color")) light.color = three(node.at("color"));
  light.intensity = node.at("intensity").number();
  return light;
}

Hemispheres read_hemispheres(const Node& node) {
  node.expect_object({"upper", "lower", "axis", "form"});
  Hemispheres out;
  out.upper = three(node.at("upper"));
  out.lower = three(node.at("lower"));
  if (node.has("axis")) out.axis = unit_vector(node.at("axis"));
  if (node.has("form"))
    out.form = node.at("form").word(hemisphere_form_named,
                                    "\"auto\", \"model\", \"corrected\", \"wide\" or \"printed\"");
  return out;
}

}  // namespace

LightSetup parse_lights(std::string_view text, std::string_view file) {
  const JsonDocument json = parse_json_strictly(text, file, most_depth, "a light setup");
  const Node root{json, file, ""};
  root.expect_object({"schema", "lights", "hemispheres", "environment", "ground", "pi_scaled"});
  root.at("schema").expect_text(schema_name);
  LightSetup setup;
  if (root.has("lights")) {
    const Node lights = root.at("lights");
    lights.expect_array();
    if (lights.value.size() > most_lights)
      lights.fail(std::to_string(lights.value.size()) + " lights", "at most " + std::to_string(most_lights));
    setup.lights = lights.each(read_light);
  }
  if (root.has("hemispheres")) setup.hemispheres = read_hemispheres(root.at("hemispheres"));
  if (root.has("environment")) {
    const Node environment = root.at("environment");
    environment.expect_object({"file", "scale"});
    setup.environment = environment.at("file").text();
    if (setup.environment.empty()) environment.at("file").fail_type("a file name");
    if (environment.has("scale")) setup.environment_scale = environment.at("scale").number();
  }
  if (root.has("ground")) {
    root.at("ground").expect_object({"albedo"});
    setup.ground = three(root.at("ground").at("albedo"));
  }
  if (root.has("pi_scaled")) setup.pi_scaled = root.at("pi_scaled").boolean();
  validate(setup, file);
  return setup;
}

std::string format_lights(const LightSetup& setup, int indent) {
  std::string lights = "[";
  for (std::size_t i = 0; i < setup.lights.size(); ++i) {
    const Light& light = setup.lights[i];
    std::vector<JsonMember> members{{"kind", json(name(light.kind))}};
    if (light.kind != LightKind::directional) members.push_back({"position", json_array_of(light.position)});
    if (light.kind != LightKind::point) members.push_back({"direction", json_array_of(light.direction)});
    members.push_back({"color", json_array_of(light.color)});
    members.push_back({"intensity", json(light.intensity)});
    if (light.kind == LightKind::spot) {
      members.push_back({"inner_deg", json(light.inner_deg)});
      members.push_back({"outer_deg", json(light.outer_deg)});
    } else if (is_area(light.kind)) {
      members.push_back({"up", json_array_of(light.up)});
      members.push_back({"width", json(light.width)});
      members.push_back({"height", json(light.height)});
    }
    lights += (i == 0 ? "\n" : ",\n") + std::string(static_cast<std::size_t>(indent) + 4, ' ') +
              json_object(members, -1);
  }
  lights += setup.lights.empty() ? "]" : "\n" + std::string(static_cast<std::size_t>(indent) + 2, ' ') + "]";
  std::vector<JsonMember> out{{"schema", json(schema_name)}, {"lights", lights}};
  if (setup.hemispheres)
    out.push_back({"hemispheres",
                   json_object(std::vector<JsonMember>{{"upper", json_array_of(setup.hemispheres->upper)},
                                                       {"lower", json_array_of(setup.hemispheres->lower)},
                                                       {"axis", json_array_of(setup.hemispheres->axis)},
                                                       {"form", json(name(setup.hemispheres->form))}},
                               -1)});
  if (!setup.environment.empty())
    out.push_back(
        {"environment", json_object(std::vector<JsonMember>{{"file", json(setup.environment)},
                                                            {"scale", json(setup.environment_scale)}},
                                    -1)});
  if (setup.ground)
    out.push_back(
        {"ground", json_object(std::vector<JsonMember>{{"albedo", json_array_of(*setup.ground)}}, -1)});
  out.push_back({"pi_scaled", json(setup.pi_scaled)});
  return json_object(out, indent);
}

}  // namespace etak
