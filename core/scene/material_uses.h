// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/scene/gltf.h"

namespace etak {

/// The uses of every material of a scene, sorted once: otherwise every question for one material would go
/// through all uses. Refers to the scene, whose uses must not change meanwhile.
class MaterialUses {
 public:
  explicit MaterialUses(const GltfScene& scene);

  const GltfScene& scene() const { return scene_; }
  /// The uses of one material, in the scene's order; none for a material that the scene does not have.
  std::span<const GltfUse* const> of(int material) const;

 private:
  const GltfScene& scene_;
  std::vector<const GltfUse*> uses_;  // by material, then in the scene's order
};

}  // namespace etak
