// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <filesystem>
#include <optional>

#include "app/cli/validate/targets.h"
#include "core/base/ascii.h"
#include "core/base/bytes_le.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/node_json.h"

namespace etak::cli {
namespace {

// "a%20b.png" as a path; other schemes than a relative path give nothing.
std::string path_of_uri(const std::string& uri) {
  if (uri.find(':') != std::string::npos) return {};
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 && hex_digit(uri[i + 2]) >= 0) {
      out += static_cast<char>(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2]));
      i += 2;
    } else {
      out += uri[i];
    }
  }
  return out;
}

// The JSON of a .glb stands in its first chunk, behind 20 bytes of headers.
std::string document_of(const std::string& path) {
  std::string bytes = read_file(path);
  if (!bytes.starts_with("glTF") || bytes.size() < 20) return bytes;
  return bytes.substr(20, bytes_le::number32(bytes, 12));
}

}  // namespace

GltfFiles files_of_gltf(const std::string& path) {
  GltfFiles out;
  std::optional<JsonDocument> read;
  try {
    constexpr int most_depth = 64;
    read.emplace(parse_json_strictly(document_of(path), path, most_depth, "a glTF document"));
  } catch (const Error&) {
    return out;
  }
  const Json& document = **read;
  const auto folder = std::filesystem::path(path).parent_path();
  const auto add = [&](const char* list, bool picture) {
    if (!document.is_object() || !document.contains(list) || !document[list].is_array()) return;
    for (const auto& entry : document[list]) {
      if (!entry.is_object() || !entry.contains("uri") || !entry["uri"].is_string()) continue;
      const std::string name = path_of_uri(entry["uri"].get<std::string>());
      if (name.empty()) continue;
      out.all.push_back((folder / name).lexically_normal().string());
      if (picture) out.pictures.push_back(out.all.back());
    }
  };
  add("images", true);
  add("buffers", false);
  return out;
}

}  // namespace etak::cli
