// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace etak {

/// Elements that meshopt has compressed, as EXT_meshopt_compression describes them.
///   mode     "ATTRIBUTES", "TRIANGLES" or "INDICES"
///   filter   "NONE", "OCTAHEDRAL", "QUATERNION" or "EXPONENTIAL"
struct MeshoptElements {
  std::string_view bytes;
  std::size_t count = 0, stride = 0;
  std::string mode, filter = "NONE";
};

/// An array that is asked of a mesh which Draco has compressed: the values of one attribute, or the indices of its
/// triangles.
///   id      of the attribute in the mesh; -1: the indices
///   type    of the values, as glTF numbers them: 5120 to 5123, 5125 or 5126
///   count   of elements, of `components` values each, that the mesh must have
struct DracoArray {
  int id = -1, type = 5126;
  std::size_t components = 1, count = 0;
};

/// The functions that decompress the meshes of scenes. The program chooses them: mesh_door() of
/// core/image/mesh_codecs.h, or functions that load its libraries when they are first needed. Where they are empty, such
/// meshes are refused. Both throw Error that names `place`.
struct MeshDoor {
  /// The bytes of the elements, `count` times `stride`.
  std::function<std::string(const MeshoptElements& elements, const std::string& place)> meshopt;
  /// The bytes of each array, its elements one behind the other.
  std::function<std::vector<std::string>(std::string_view bytes, const std::vector<DracoArray>& arrays,
                                         const std::string& place)>
      draco;
};

}  // namespace etak
