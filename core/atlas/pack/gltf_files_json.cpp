// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "core/atlas/pack/gltf_files.h"
#include "core/base/node_json.h"
#include "core/scene/uri.h"

namespace etak {
namespace {

// Calls visit(uri) for every image and buffer of the document that lies outside of it.
template <class Visit>
void each_file(const Json& document, Visit visit) {
  for (const char* list : {"images", "buffers"}) {
    if (!document.contains(list)) continue;
    for (const Json& item : document[list])
      if (item.contains("uri"))
        if (const std::string uri = item["uri"]; !uri.starts_with("data:")) visit(uri);
  }
}

}  // namespace

std::map<std::string, std::string> names_beside(std::string_view document, std::string_view path,
                                                std::set<std::string> taken) {
  std::map<std::string, std::string> out;
  each_file(JsonDocument(Json::parse(document)), [&](const std::string& uri) {
    std::string& name = out[uri];
    if (!name.empty()) return;
    const std::string plain = std::filesystem::path(file_of_uri(uri, path)).filename().string();
    name = plain;
    for (int i = 1; !taken.insert(name).second; ++i) name = std::to_string(i) + "_" + plain;
  });
  return out;
}

std::vector<CopiedFile> files_to_copy(std::string_view written, const std::string& folder,
                                      const std::map<std::string, std::string>& names) {
  std::set<std::string> used;
  each_file(JsonDocument(Json::parse(written)), [&](const std::string& uri) { used.insert(uri); });
  std::vector<CopiedFile> out;
  for (const auto& [uri, name] : names)
    if (used.contains(uri_of_file(name)))
      out.push_back({(std::filesystem::path(folder) / file_of_uri(uri, "scene.gltf")).string(), name});
  return out;
}

}  // namespace etak
