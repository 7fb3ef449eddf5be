// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: what the validator reads of texts is an answer or an Error. The first byte picks the reader: what
// a scene's images are read as, the evidence of a material file (whose refusal is evidence and no Error), of a page, of
// a table.
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/scene/image_roles.h"
#include "core/validate/files/material_evidence.h"

using namespace etak;

namespace {

void check(const MaterialEvidence& evidence) {
  if (!evidence.computed_f0) return;
  for (const double f0 : *evidence.computed_f0) assert(std::isfinite(f0));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::vector<char> bytes(data + 1, data + size);
  const std::string_view text(bytes.data(), bytes.size());
  const unsigned reader = data[0] % 4;
  if (reader == 1) {
    check(evidence_of_material(text, "a.json"));
    return 0;
  }
  try {
    if (reader == 0) {
      for (const ImageRole& each : image_roles(text, "folder/a.gltf")) {
        assert(!each.role.empty());
        assert(!each.material || !each.is_unused());
      }
    } else {
      const std::string name = reader == 2 ? "a.yml" : "a.csv";
      check(evidence_of_spectrum(text, name, name));
    }
  } catch (const Error&) {
  }
  return 0;
}
