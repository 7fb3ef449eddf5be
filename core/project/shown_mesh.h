// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "core/math/mesh_door.h"
#include "core/render/mesh/mesh_shape.h"

namespace etak {

/// The shape of that name in place of the ball, with its shadows: shader_ball(), or the triangles of a scene of glTF.
/// Throws Error for what is no such scene or has no triangles with normals.
///   threads   that cast rays; the shape is the same for any number
std::shared_ptr<const MeshShape> shown_mesh(const std::string& name, const MeshDoor& door, unsigned threads);

}  // namespace etak
