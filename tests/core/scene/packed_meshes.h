// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace etak::test {

/// How the meshes of a made-up scene are stored.
enum class MeshCoding { plain, meshopt, draco };

/// A scene of a wavy grid of 8 x 8 squares over a part of a texture, its document and its buffer. The base colour is the
/// file "color.png" beside it. Positions, UVs and normals are floats that every coding keeps bit by bit.
///   json   one buffer, without its URI; of meshopt a second one, which has no bytes
struct MeshScene {
  nlohmann::json json;
  std::string buffer;
};
MeshScene mesh_scene(MeshCoding coding);

}  // namespace etak::test
