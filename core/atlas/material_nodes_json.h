// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the readers of manifests and of projects have in common; for manifest_json.cpp and project_json.cpp
// only.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/base/files/links.h"
#include "core/base/json/node_json.h"
#include "core/base/system.h"
#include "core/material/limits.h"
#include "core/scene/gltf.h"

namespace etak {
namespace {

constexpr std::size_t most_materials = 100000;

/// The materials of a list, each by `read`; refuses too many and two of one name.
template <class Material, class Read>
std::vector<Material> read_materials(const JsonNode& list, Read read) {
  if (list.size() > most_materials)
    list.fail(std::to_string(list.size()) + " materials", "at most " + std::to_string(most_materials));
  std::vector<Material> out;
  std::set<std::string> names;
  for (std::size_t i = 0; i < list.size(); ++i) {
    out.push_back(read(list.at(i)));
    if (!names.insert(out.back().name).second)
      list.at(i).fail("a second material " + in_quotes(out.back().name), "each name once");
  }
  return out;
}

std::string read_name(const JsonNode& material) {
  std::string out = material.at("name").text();
  if (out.empty()) material.at("name").fail("an empty name", "a name");
  if (out.size() > most_name_bytes)
    material.at("name").fail("a name of " + std::to_string(out.size()) + " bytes",
                             "at most " + std::to_string(most_name_bytes));
  return out;
}

AlphaMode read_alpha_mode(const JsonNode& node) {
  return node.word(alpha_mode_named, alpha_mode_names);
}

/// The member "channels" of an image: letters, three for a colour; empty where there is none.
std::string read_channels(const JsonNode& image, bool color) {
  std::string out = image.text_or_empty("channels");
  const bool known = out.find_first_not_of("rgba") == out.npos;
  if (!out.empty() && (!known || out.size() != (color ? 3u : 1u)))
    image.at("channels")
        .fail_type(color ? "three of the letters r, g, b, a" : "one of the letters r, g, b, a");
  return out;
}

/// A path that is relative to `folder`, as one relative to the working folder.
std::string read_path(const JsonNode& node, const std::filesystem::path& folder) {
  const std::string text = node.text();
  if (text.empty() || text.find('\0') != text.npos) node.fail_type("a file name");
  return path_beside(sys::path_text(folder), text);
}

}  // namespace
}  // namespace etak
