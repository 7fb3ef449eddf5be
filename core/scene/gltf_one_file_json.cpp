// SPDX-License-Identifier: Apache-2.0
// Based on: Khronos Group, glTF 2.0 specification, 4 (GLB) and 3.11.
#include "core/base/error.h"
#include "core/image/picture_bytes.h"
#include "core/scene/glb.h"
#include "core/scene/gltf_json.h"
#include "core/scene/uri.h"

namespace etak {

std::string one_file(const WrittenGltf& written, const std::map<std::string, std::string>& pictures,
                     const std::string& file) {
  JsonDocument read = parse_json_strictly(written.json, file, 64, "a glTF document");
  Json root = std::move(read).take();
  std::string binary = written.buffer;
  std::map<std::string, const std::pair<const std::string, std::string>*> by_uri;
  for (const auto& picture : pictures) by_uri.emplace(uri_of_file(picture.first), &picture);
  if (root.contains("images"))
    for (Json& image : root["images"]) {
      const auto found = image.contains("uri") ? by_uri.find(image["uri"].get<std::string>()) : by_uri.end();
      if (found == by_uri.end()) continue;
      const auto& [name, bytes] = *found->second;
      binary.resize((binary.size() + 7) / 8 * 8);
      const int view = append_element(
          root, "bufferViews", {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
      binary += bytes;
      image.erase("uri");
      image["bufferView"] = view;
      image["mimeType"] = "image/" + picture_format(std::string_view(bytes).substr(0, 32), name);
    }
  if (!binary.empty()) {
    root["buffers"] = Json::array();
    root["buffers"].push_back({{"byteLength", binary.size()}});
  }
  std::string json = root.dump();
  take_apart(root);
  return joined_glb(std::move(json), std::move(binary), file);
}

}  // namespace etak
