// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of manifests answers with an Error or with materials that keep its promises:
// sorted by name, each name once, numbers in their ranges.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/atlas/manifest.h"
#include "core/base/error.h"

using namespace etak;

namespace {

void check(const std::optional<TextureSource>& source) {
  if (!source) return;
  if (const auto* constant = std::get_if<ConstantSource>(&*source)) {
    for (const double v : {constant->linear.r, constant->linear.g, constant->linear.b})
      assert(v >= 0 && v <= 1);
  } else if (const auto* image = std::get_if<ImageSource>(&*source)) {
    assert(image->channels.find_first_not_of("rgba") == std::string::npos);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<char> bytes(data, data + size);
  AtlasManifest manifest;
  try {
    manifest = parse_manifest({bytes.data(), bytes.size()}, "folder/manifest.json");
  } catch (const Error&) {
    return 0;
  }
  const ManifestMaterial* before = nullptr;
  for (const ManifestMaterial& m : manifest.materials) {
    assert(!m.name.empty() && !m.place.empty());
    assert(before == nullptr || before->name < m.name);
    for (const auto* source :
         {&m.diffuse, &m.specular, &m.gloss, &m.roughness, &m.alpha, &m.base_color, &m.metallic})
      check(*source);
    assert(!(m.gloss && m.roughness) && !(m.base_color && m.specular));
    before = &m;
  }
  return 0;
}
