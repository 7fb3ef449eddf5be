// SPDX-License-Identifier: Apache-2.0
#include "core/project/shown_mesh.h"

#include "core/base/error.h"
#include "core/scene/gltf.h"

namespace etak {

std::shared_ptr<const MeshShape> shown_mesh(const std::string& name, const MeshDoor& door, unsigned threads) {
  if (name == shader_ball_name) return std::make_shared<const MeshShape>(shader_ball(), threads);
  if (!is_gltf_file(name))
    throw Error::at(printable(name, 200), "no glTF scene",
                    std::string(".gltf or .glb, or ") + shader_ball_name);
  GltfOptions options;
  options.mesh = true;
  options.mesh_door = door;
  return std::make_shared<const MeshShape>(in_place_of_ball(read_gltf(name, options).mesh, name), threads);
}

}  // namespace etak
