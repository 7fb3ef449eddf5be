// SPDX-License-Identifier: Apache-2.0
#include "core/scene/material_uses.h"

#include <algorithm>

namespace etak {
namespace {

int material_of(const GltfUse* use) {
  return use->material;
}

}  // namespace

MaterialUses::MaterialUses(const GltfScene& scene) : scene_(scene) {
  uses_.reserve(scene.uses.size());
  for (const GltfUse& use : scene.uses) uses_.push_back(&use);
  std::ranges::stable_sort(uses_, {}, material_of);
}

std::span<const GltfUse* const> MaterialUses::of(int material) const {
  // Not equal_range(): clang 14 does not take libstdc++'s subrange.
  return {std::ranges::lower_bound(uses_, material, {}, material_of),
          std::ranges::upper_bound(uses_, material, {}, material_of)};
}

}  // namespace etak
