// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/gltf_files.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "core/base/json_node.inc"
#include "core/scene/uri.h"

namespace etak {

std::vector<CopiedFile> files_to_copy(std::string& json, const std::string& folder,
                                      const std::vector<std::string>& own_images,
                                      const std::string& own_buffer) {
  namespace fs = std::filesystem;
  Json document = Json::parse(json);
  std::vector<CopiedFile> out;
  std::map<std::string, std::string> known;
  std::set<std::string> names(own_images.begin(), own_images.end());
  names.insert({own_buffer, "scene.gltf", "layout.json"});
  for (const char* list : {"images", "buffers"}) {
    if (!document.contains(list)) continue;
    for (Json& item : document[list]) {
      if (!item.contains("uri")) continue;
      const std::string uri = item["uri"];
      const bool ours =
          uri == own_buffer || std::find(own_images.begin(), own_images.end(), uri) != own_images.end();
      if (ours || uri.starts_with("data:")) continue;
      auto& name = known[uri];
      if (name.empty()) {
        const std::string path = (fs::path(folder) / file_of_uri(uri, "scene.gltf")).string();
        const std::string plain = fs::path(path).filename().string();
        name = plain;
        for (int i = 1; !names.insert(name).second; ++i) name = std::to_string(i) + "_" + plain;
        out.push_back({path, name});
      }
      item["uri"] = uri_of_file(name);
    }
  }
  if (!out.empty()) json = document.dump(1) + "\n";
  return out;
}

}  // namespace etak
