// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/math/mesh_door.h"

namespace etak {

// The only source of etak that uses meshoptimizer and Draco. It is a part of the target etak::image_io, which programs
// load when they first need it: what a scene of glTF needs beside pictures of any format.

/// The decoders of meshes.
///   meshopt   version 0 of its streams, which is what EXT_meshopt_compression has; KHR_meshopt_compression has
///             later ones too, which are refused
///   draco     meshes of bit stream 2.2, of triangles. Before memory is asked for, what the stream says of its number
///             of faces is compared with the array of indices that is asked for.
MeshDoor mesh_door();

}  // namespace etak
