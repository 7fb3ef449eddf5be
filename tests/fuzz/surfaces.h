// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/exchange/surfaces/meaning.h"

namespace etak::test {

/// What is asked of the reader of a material document.
template <class Read>
int read_surfaces(const std::uint8_t* data, std::size_t size, const Read& read) {
  const std::vector<char> bytes(data, data + size);
  try {
    for (const DocumentSurface& surface :
         read(std::string_view(bytes.data(), bytes.size()), std::string("document"))) {
      assert(is_surface_model(surface.model));
      for (const SurfaceInput& input : surface.inputs)
        for (const double value : input.values) assert(std::isfinite(value));
      const DocumentValues values = values_of(surface);
      if (values.f0) assert(values.f0_from != nullptr);
    }
  } catch (const Error& error) {
    assert(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}

}  // namespace etak::test
