// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/error.h"
#include "core/light/lights.h"

namespace etak {
namespace {

using Json = nlohmann::json;

constexpr std::string_view schema_name = "etak-lights/1";
constexpr int most_depth = 8;
constexpr std::size_t most_lights = 256;

// Parses and refuses what nlohmann lets pass: equal keys in one object, and depth without end.
Json parse_strictly(std::string_view text, std::string_view file) {
  std::vector<std::set<std::string>> keys;
  const auto check = [&](int depth, Json::parse_event_t event, Json& parsed) {
    if (depth > most_depth)
      throw Error::at(file, "nesting deeper than " + std::to_string(most_depth), "a light setup");
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second)
      throw Error::at(file, "key \"" + printable(parsed.get<std::string>()) + "\" twice in one object",
                      "each key once");
    return true;
  };
  try {
    return Json::parse(text.begin(), text.end(), check);
  } catch (const Json::exception& e) {
    std::string_view what =
        e.what();  // "[json.exception.parse_error.101] parse error at ...": without the tag
    if (const auto tag = what.find("] "); tag != what.npos) what.remove_prefix(tag + 2);
    throw Error::at(file, printable(what, 200), "a JSON document");
  }
}

// A value and where it stands, for messages.
struct Node {
  const Json& value;
  std::string_view file;
  std::string pointer;

  [[noreturn]] void fail(std::string_view found, std::string_view expected = {}) const {
    throw Error::at(std::string(file) + '#' + (pointer.empty() ? "/" : pointer), found, expected);
  }
  [[noreturn]] void fail_type(std::string_view expected) const {
    fail(printable(value.dump(-1, ' ', false, Json::error_handler_t::replace), 60), expected);
  }
  bool has(std::string_view key) const { return value.contains(key); }
  Node at(std::string_view key) const {
    const auto found = value.find(key);
    if (found == value.end()) fail("no \"" + std::string(key) + "\"", "this key");
    return {*found, file, pointer + '/' + std::string(key)};
  }
  Node at(std::size_t index) const { return {value[index], file, pointer + '/' + std::to_string(index)}; }

  void expect_object(std::initializer_list<std::string_view> keys) const {
    if (!value.is_object()) fail_type("an object");
    for (const auto& [key, ignored] : value.items())
      if (std::find(keys.begin(), keys.end(), key) == keys.end())
        fail("unknown key \"" + printable(key) + "\"");
  }
  std::string text() const {
    if (!value.is_string()) fail_type("a string");
    return value.get<std::string>();
  }
  double number() const {
    if (!value.is_number()) fail_type("a number");
    const double number = value.get<double>();
    if (!std::isfinite(number)) fail_type("a finite number");
    return number;
  }
  Vec3 three() const {
    if (!value.is_array() || value.size() != 3) fail_type("three numbers");
    return {at(0).number(), at(1).number(), at(2).number()};
  }
  Vec3 unit_vector() const {
    const Vec3 v = three();
    const double length = std::hypot(v[0], v[1], v[2]);
    if (!(length > 1e-12) || !std::isfinite(length)) fail("a direction of length zero");
    return {v[0] / length, v[1] / length, v[2] / length};
  }
};

Light read_light(const Node& node) {
  if (!node.value.is_object()) node.fail_type("an object");
  Light light;
  const Node kind = node.at("kind");
  const auto named = light_kind_named(kind.text());
  if (!named) kind.fail_type("\"point\", \"directional\" or \"spot\"");
  light.kind = *named;
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
  }
  if (light.kind != LightKind::directional) light.position = node.at("position").three();
  if (light.kind != LightKind::point) light.direction = node.at("direction").unit_vector();
  if (node.has("color")) light.color = node.at("color").three();
  light.intensity = node.at("intensity").number();
  return light;
}

Hemispheres read_hemispheres(const Node& node) {
  node.expect_object({"upper", "lower", "axis", "form"});
  Hemispheres out;
  out.upper = node.at("upper").three();
  out.lower = node.at("lower").three();
  if (node.has("axis")) out.axis = node.at("axis").unit_vector();
  if (node.has("form")) {
    const auto form = hemisphere_form_named(node.at("form").text());
    if (!form) node.at("form").fail_type("\"corrected\", \"wide\" or \"printed\"");
    out.form = *form;
  }
  return out;
}

}  // namespace

LightSetup parse_lights(std::string_view text, std::string_view file) {
  const Json json = parse_strictly(text, file);
  const Node root{json, file, ""};
  root.expect_object({"schema", "lights", "hemispheres", "environment", "pi_scaled"});
  if (root.at("schema").text() != schema_name)
    root.at("schema").fail_type('"' + std::string(schema_name) + '"');
  LightSetup setup;
  if (root.has("lights")) {
    const Node lights = root.at("lights");
    if (!lights.value.is_array()) lights.fail_type("an array");
    if (lights.value.size() > most_lights)
      lights.fail(std::to_string(lights.value.size()) + " lights", "at most " + std::to_string(most_lights));
    for (std::size_t i = 0; i < lights.value.size(); ++i) setup.lights.push_back(read_light(lights.at(i)));
  }
  if (root.has("hemispheres")) setup.hemispheres = read_hemispheres(root.at("hemispheres"));
  if (root.has("environment")) {
    const Node environment = root.at("environment");
    environment.expect_object({"file", "scale"});
    setup.environment = environment.at("file").text();
    if (setup.environment.empty()) environment.at("file").fail_type("a file name");
    if (environment.has("scale")) setup.environment_scale = environment.at("scale").number();
  }
  if (root.has("pi_scaled")) {
    if (!root.at("pi_scaled").value.is_boolean()) root.at("pi_scaled").fail_type("true or false");
    setup.pi_scaled = root.at("pi_scaled").value.get<bool>();
  }
  validate(setup, file);
  return setup;
}

}  // namespace etak
