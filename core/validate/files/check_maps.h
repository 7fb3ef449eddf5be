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

/// The evidence of the normal maps that a scene's used materials read, each image once.
///   label_of   of an image, for reports
std::vector<MapEvidence> normal_maps_of(const GltfScene& scene, const PictureDoor& door,
                                        const std::function<std::string(int image)>& label_of);

}  // namespace etak
