// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/sources/apply_variants.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/setting.h"

namespace etak {

AtlasManifest with_methods(AtlasManifest manifest, const ShadingVariants* variants) {
  if (variants == nullptr) return manifest;
  for (ManifestMaterial& m : manifest.materials)
    if (const MaterialVariant* variant = variants->find(m.name); variant != nullptr && m.specular)
      if (auto* source = std::get_if<LibrarySource>(&*m.specular)) source->method = variant->method;
  return manifest;
}

void apply_variants(const ShadingVariants& variants, bool keep_textures, const std::string& input,
                    PackInputs& inputs) {
  std::size_t found = 0;
  for (PackInput& in : inputs.materials) {
    const MaterialVariant* variant = variants.find(in.name);
    if (variant == nullptr) {
      if (in.facts.reached)
        inputs.remarks.push_back(in.name + ": nothing was chosen for it; it stays as it is");
      continue;
    }
    ++found;
    inputs.settings += variant->method + '|' + variant->filter + '|';
    for (const std::string& each : variant->defines) inputs.settings += each + ',';
    if (!variant->flattens() || keep_textures) continue;
    // As if its texels were equal.
    in.facts.learned = true;
    in.facts.range.least = in.facts.range.most = variant->codes;
  }
  if (found == 0)
    throw Error::at(setting("choice"), "has none of the materials of " + input,
                    "what etak choose wrote for it");
}

bool mips_are_read(const ShadingVariants& variants, const PackInputs& inputs) {
  return std::any_of(inputs.materials.begin(), inputs.materials.end(), [&](const PackInput& in) {
    const MaterialVariant* variant = variants.find(in.name);
    return in.facts.reached && (variant == nullptr || variant->reads_mips());
  });
}

}  // namespace etak
