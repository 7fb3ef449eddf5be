// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/image/picture.h"
#include "core/judge/pixels/evidence.h"
#include "core/scene/gltf.h"

namespace etak {

/// Whether a target is a set of normal, height, occlusion and emissive maps.
bool is_map_set(const CheckTarget& target);

/// Reads the maps of such a target, each in step with the pictures of its size that it is held against. Throws
/// Error for a file that cannot be read.
std::vector<MapEvidence> maps_of(const CheckTarget& target, const PictureDoor& door);

/// What textures in blocks have lost against the pictures of their names and sizes, where one of the two is of the target. A
/// file that cannot be read is left to the check that it belongs to.
std::vector<BlockLoss> losses_of(const CheckTarget& target, const PictureDoor& door);

/// The evidence of the normal maps that a scene's used materials read, each image once.
///   label_of   of an image, for reports
std::vector<MapEvidence> normal_maps_of(const GltfScene& scene, const PictureDoor& door,
                                        const std::function<std::string(int image)>& label_of);

}  // namespace etak
