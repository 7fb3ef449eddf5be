// SPDX-License-Identifier: Apache-2.0
#include "core/material/embedded/blob.h"

#include "core/material/embedded/material_members.h"

namespace etak {

template <class To, Like<Unmeasured> S>
void members(To& to, S& s) {
  all_members(to, s.words, s.why, s.nearest);
}
template <class To, Like<BlobEntry> S>
void members(To& to, S& s) {
  all_members(to, s.id, s.name, s.aliases, s.offset);
}
template <class To, Like<BlobIndex> S>
void members(To& to, S& s) {
  all_members(to, s.materials, s.series, s.unmeasured);
}

// Layout: size of the index, the index, the materials. Offsets in the index count from its end.
std::string encode_library(const std::vector<Material>& materials, const std::vector<Material>& series,
                           const std::vector<Unmeasured>& unmeasured) {
  BlobIndex index{{}, {}, unmeasured};
  MemberWriter body, head, whole;
  const auto add = [&](const Material& m, std::vector<BlobEntry>& entries) {
    entries.push_back({m.id, m.name, m.aliases, body.bytes.size()});
    body.member(m);
  };
  for (const Material& m : materials) add(m, index.materials);
  for (const Material& m : series) add(m, index.series);
  head.member(index);
  whole.member(head.bytes);
  return whole.bytes + body.bytes;
}

BlobIndex decode_index(std::string_view blob) {
  const std::size_t begin = sizeof(std::uint64_t), size = bytes_le::number64(blob, 0);
  BlobIndex index;
  MemberReader(blob.substr(begin, size)).member(index);
  for (std::vector<BlobEntry>* entries : {&index.materials, &index.series})
    for (BlobEntry& e : *entries) e.offset += begin + size;
  return index;
}

Material decode_material(std::string_view blob, std::size_t offset) {
  Material m;
  MemberReader(blob.substr(offset)).member(m);
  return m;
}

}  // namespace etak
