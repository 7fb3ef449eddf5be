// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: what etak shader takes from files is read, or there is an Error. The first byte picks the reader:
// --lights (written and read again unchanged), --choice (each material once), --layout, --defines.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/atlas/layout_shader.h"
#include "core/atlas/variant.h"
#include "core/base/error.h"
#include "core/light/lights.h"

using namespace etak;

namespace {

void read_lights(std::string_view text) {
  const LightSetup setup = parse_lights(text, "lights.json");
  assert(parse_lights(format_lights(setup), "written") == setup);
}

void read_choice(std::string_view text) {
  const ShadingVariants choices = parse_choices(text, "choice.json");
  for (const MaterialVariant& each : choices.materials) assert(choices.find(each.material) == &each);
}

void read_layout(std::string_view text) {
  const AtlasLayout layout = parse_layout(text, "layout.json");
  for (const AtlasMaterialRow& row : layout.materials) {
    const LayoutShader shader = layout_shader(layout, row);
    for (const auto& colour : {shader.f0, shader.diffuse})
      if (colour) assert(colour->r >= 0 && colour->g >= 0 && colour->b >= 0);
    assert(!shader.gloss || (*shader.gloss >= 0 && *shader.gloss <= 1));
    assert(!shader.opacity || (*shader.opacity >= 0 && *shader.opacity <= 1));
  }
}

void read_defines(std::string_view text) {
  (void)texture_use(text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::vector<char> bytes(data + 1, data + size);
  constexpr void (*readers[])(std::string_view) = {read_lights, read_choice, read_layout, read_defines};
  try {
    readers[data[0] % 4]({bytes.data(), bytes.size()});
  } catch (const Error&) {
  }
  return 0;
}
