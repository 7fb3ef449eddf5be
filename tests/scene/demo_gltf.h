// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace etak::demo {

/// The scene that write_demo_scene describes. Pictures are referred to by name.
struct GltfText {
  std::string json, buffer;
};
GltfText demo_gltf(const std::string& buffer_name);

}  // namespace etak::demo
