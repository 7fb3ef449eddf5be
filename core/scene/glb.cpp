// SPDX-License-Identifier: Apache-2.0
#include "core/scene/glb.h"

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/base/bytes/bytes_le.h"
#include "core/base/error.h"

namespace etak {
namespace {

constexpr std::uint32_t glb_magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

void add_number(std::string& to, std::size_t number) {
  for (int shift = 0; shift < 32; shift += 8)
    to += static_cast<char>(number >> static_cast<unsigned>(shift) & 255);
}

void add_chunk(std::string& to, std::uint32_t type, const std::string& data) {
  add_number(to, data.size());
  add_number(to, type);
  to += data;
}

}  // namespace

std::string joined_glb(std::string json, std::string binary, std::string_view file) {
  while (json.size() % 4 != 0) json += ' ';
  while (binary.size() % 4 != 0) binary += '\0';
  const std::size_t size = 12 + 8 + json.size() + (binary.empty() ? 0 : 8 + binary.size());
  if (size > 0xFFFFFFFF)
    throw Error::at(file, std::to_string(size) + " bytes",
                    "less than 4 GiB, which is all that a .glb can have");
  std::string out;
  out.reserve(size);
  add_number(out, glb_magic);
  add_number(out, 2);
  add_number(out, size);
  add_chunk(out, json_chunk, json);
  if (!binary.empty()) add_chunk(out, binary_chunk, binary);
  return out;
}

bool is_glb(std::string_view bytes) {
  return bytes.size() >= 4 && bytes_le::number32(bytes, 0) == glb_magic;
}

GlbParts split_glb(std::string_view bytes, std::string_view file) {
  const auto fail = [&](const std::string& found, std::string_view expected) {
    throw Error::at(file, found, expected);
  };
  if (bytes.size() < 12 || !is_glb(bytes)) fail("no header of 12 bytes", "a binary glTF");
  if (bytes_le::number32(bytes, 4) != 2)
    fail("container version " + std::to_string(bytes_le::number32(bytes, 4)), "version 2");
  const std::size_t length = bytes_le::number32(bytes, 8);
  if (length > bytes.size())
    fail("a header that says " + std::to_string(length) + " bytes in a file of " +
             std::to_string(bytes.size()),
         "the whole file");
  GlbParts parts;
  std::size_t at = 12;
  for (int chunk = 0; at < length; ++chunk) {
    const std::string name = "chunk " + std::to_string(chunk);
    if (length - at < 8) fail(name + " cut off", "a length and a type");
    const std::size_t size = bytes_le::number32(bytes, at);
    const std::uint32_t type = bytes_le::number32(bytes, at + 4);
    at += 8;
    if (size > length - at)
      fail(name + " of " + std::to_string(size) + " bytes with " + std::to_string(length - at) + " left",
           "a chunk inside the file");
    const std::string_view data = bytes.substr(at, size);
    if (chunk == 0 && type != json_chunk) fail("chunk 0 is not JSON", "the JSON chunk first");
    if (chunk == 0) parts.json = data;
    if (chunk == 1 && type == binary_chunk) parts.binary = data;
    at += size;
  }
  if (parts.json.empty()) fail("no JSON chunk", "a binary glTF");
  return parts;
}

}  // namespace etak
