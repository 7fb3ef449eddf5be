// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/image/files/containers.h"

/// Whole KTX2 and DDS files in memory, although their writers write piece by piece.
namespace etak::test {

struct TextureLevels {
  std::span<const Image8> levels;
  bool srgb = true;
};

inline std::vector<ConstPixelsView8> views(const TextureLevels& texture) {
  std::vector<ConstPixelsView8> out;
  for (const Image8& level : texture.levels) out.push_back(view(level));
  return out;
}

inline FileSink sink_into(std::string& out) {
  return {[&out](std::string_view bytes) { out += bytes; },
          [&out](std::size_t at, std::string_view bytes) { out.replace(at, bytes.size(), bytes); }};
}

inline std::string ktx2_bytes(const TextureLevels& texture, int zstd_level) {
  std::string out;
  write_ktx2(views(texture), texture.srgb, zstd_level, sink_into(out));
  return out;
}

inline std::string dds_bytes(const TextureLevels& texture, bool custom_alpha,
                             DdsHeader header = DdsHeader::dx10) {
  std::string out;
  write_dds(views(texture), texture.srgb, custom_alpha, header, sink_into(out));
  return out;
}

}  // namespace etak::test
