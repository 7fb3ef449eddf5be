// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace etak::test {

/// The part of JSON Schema 2020-12 that etak's schemas use. A keyword it does not know is an error, so that a
/// schema cannot promise what no test looks at.
class JsonSchema {
 public:
  using Json = nlohmann::json;
  explicit JsonSchema(Json root) : root_(std::move(root)) {}

  /// Empty when `value` is valid, else what is wrong and where.
  std::string problem(const Json& value) const { return check(root_, value, "#"); }

 private:
  static bool has_type(const std::string& type, const Json& v) {
    if (type == "object") return v.is_object();
    if (type == "array") return v.is_array();
    if (type == "string") return v.is_string();
    if (type == "boolean") return v.is_boolean();
    if (type == "null") return v.is_null();
    if (type == "number") return v.is_number();
    return type == "integer" &&
           (v.is_number_integer() || (v.is_number() && v == static_cast<long long>(v.get<double>())));
  }

  static bool is_hex(const std::string& text) {
    return text.size() == 7 && text[0] == '#' &&
           text.find_first_not_of("0123456789abcdef", 1) == std::string::npos;
  }

  std::size_t matches(const Json& schemas, const Json& v) const {
    std::size_t count = 0;
    for (const Json& schema : schemas) count += check(schema, v, "").empty() ? 1u : 0u;
    return count;
  }

  std::string check(const Json& schema, const Json& v, const std::string& at) const {
    for (const auto& [key, rule] : schema.items()) {
      const std::string wrong = check_keyword(schema, key, rule, v, at);
      if (!wrong.empty()) return wrong;
    }
    return {};
  }

  std::string check_keyword(const Json& schema, const std::string& key, const Json& rule, const Json& v,
                            const std::string& at) const {
    static const std::set<std::string> silent{"$schema",     "$id",  "$defs", "title",
                                              "description", "then", "else"};
    const std::string broken = at + " breaks " + key + " " + rule.dump().substr(0, 80);
    if (silent.contains(key)) return {};
    if (key == "$ref") return check(root_.at(Json::json_pointer(rule.get<std::string>().substr(1))), v, at);
    if (key == "type") {
      const Json types = rule.is_array() ? rule : Json::array({rule});
      for (const Json& type : types)
        if (has_type(type, v)) return {};
      return broken;
    }
    if (key == "const") return v == rule ? "" : broken;
    if (key == "enum") return std::find(rule.begin(), rule.end(), v) != rule.end() ? "" : broken;
    if (key == "anyOf") return matches(rule, v) > 0 ? "" : broken;
    if (key == "oneOf") return matches(rule, v) == 1 ? "" : broken;
    if (key == "not") return check(rule, v, at).empty() ? broken : "";
    if (key == "allOf") {
      for (const Json& part : rule)
        if (const std::string wrong = check(part, v, at); !wrong.empty()) return wrong;
      return {};
    }
    if (key == "if") {
      const char* branch = check(rule, v, at).empty() ? "then" : "else";
      return schema.contains(branch) ? check(schema[branch], v, at) : "";
    }
    if (key == "required") {
      for (const Json& name : rule)
        if (v.is_object() && !v.contains(name)) return at + " lacks " + name.dump();
      return {};
    }
    if (key == "properties") {
      for (const auto& [name, part] : rule.items())
        if (v.is_object() && v.contains(name))
          if (const std::string wrong = check(part, v[name], at + "/" + name); !wrong.empty()) return wrong;
      return {};
    }
    if (key == "additionalProperties") {
      if (!v.is_object()) return {};
      for (const auto& [name, ignored] : v.items())
        if (rule == false && !schema.at("properties").contains(name)) return at + " has an unknown " + name;
      return {};
    }
    if (key == "items") {
      for (std::size_t i = 0; v.is_array() && i < v.size(); ++i)
        if (const std::string wrong = check(rule, v[i], at + "/" + std::to_string(i)); !wrong.empty())
          return wrong;
      return {};
    }
    if (key == "minItems") return !v.is_array() || v.size() >= rule ? "" : broken;
    if (key == "maxItems") return !v.is_array() || v.size() <= rule ? "" : broken;
    if (key == "uniqueItems")
      return !v.is_array() || std::set<Json>(v.begin(), v.end()).size() == v.size() ? "" : broken;
    if (key == "minimum") return !v.is_number() || v >= rule ? "" : broken;
    if (key == "maximum") return !v.is_number() || v <= rule ? "" : broken;
    if (key == "minLength") return !v.is_string() || v.get<std::string>().size() >= rule ? "" : broken;
    if (key == "pattern" && rule == "^#[0-9a-f]{6}$") return !v.is_string() || is_hex(v) ? "" : broken;
    return at + ": the test knows no keyword " + key;
  }

  Json root_;
};

}  // namespace etak::test
