// SPDX-License-Identifier: Apache-2.0
// Based on: Khronos Group, EXT_meshopt_compression and KHR_draco_mesh_compression; the Draco bit stream specification 2.2.
#include "core/image/mesh_codecs.h"

#include <draco/compression/decode.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
#include <meshoptimizer.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <type_traits>
#include <utility>

#include "core/base/error.h"

namespace etak {
namespace {

// Every block of 16 bytes takes two bits of its head at least, and every triangle a byte.
constexpr std::size_t most_growth = 64;
// The greatest number of triangles for each byte of a stream. Draco itself spends a bit on most of them.
constexpr std::size_t most_faces_of_byte = 1024;

// Throws Error for what the decoders take for granted.
void check_stride(const MeshoptElements& e, const std::string& place) {
  const bool wide = e.stride % 4 == 0 && e.stride > 0 && e.stride <= 256;
  const bool fits = e.mode == "ATTRIBUTES" ? wide : e.stride == 2 || e.stride == 4;
  const bool of_filter = e.filter == "OCTAHEDRAL"   ? e.stride == 4 || e.stride == 8
                         : e.filter == "QUATERNION" ? e.stride == 8
                                                    : true;
  if (!fits || !of_filter || (e.filter != "NONE" && e.mode != "ATTRIBUTES"))
    throw Error::at(
        place, std::to_string(e.stride) + " bytes an element of " + e.mode + " with the filter " + e.filter,
        "a byteStride that the extension allows");
  if (e.mode == "TRIANGLES" && e.count % 3 != 0)
    throw Error::at(place, std::to_string(e.count) + " indices of triangles", "a multiple of 3");
}

// The beginning of a stream in its first byte: what it holds, and the version.
void check_version(const MeshoptElements& e, const std::string& place) {
  const int first = e.bytes.empty() ? 0 : static_cast<unsigned char>(e.bytes[0]);
  const int kind = e.mode == "ATTRIBUTES" ? 0xA0 : e.mode == "TRIANGLES" ? 0xE0 : 0xD0;
  const int known = e.mode == "ATTRIBUTES" ? 0 : 1;
  if ((first & 0xF0) != kind)
    throw Error::at(place, "bytes that are no " + e.mode + " of meshopt", "a stream of its mode");
  if ((first & 0x0F) > known)
    throw Error::at(place, "version " + std::to_string(first & 0x0F) + " of meshopt's " + e.mode,
                    "at most version " + std::to_string(known));
}

std::string meshopt_elements(const MeshoptElements& e, const std::string& place) {
  check_stride(e, place);
  check_version(e, place);
  if (e.count > most_growth * e.bytes.size() / e.stride)
    throw Error::at(place,
                    std::to_string(e.count) + " elements in " + std::to_string(e.bytes.size()) + " bytes",
                    "no more than so many bytes can hold");
  std::string out(e.count * e.stride, '\0');
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes
  const auto* const from = reinterpret_cast<const unsigned char*>(e.bytes.data());
  using Decode = int(void*, std::size_t, std::size_t, const unsigned char*, std::size_t);
  Decode* decode = meshopt_decodeVertexBuffer;
  if (e.mode == "TRIANGLES") decode = meshopt_decodeIndexBuffer;
  if (e.mode == "INDICES") decode = meshopt_decodeIndexSequence;
  if (e.count > 0 && decode(out.data(), e.count, e.stride, from, e.bytes.size()) != 0)
    throw Error::at(place, "a broken stream of meshopt", "whole " + e.mode);
  if (e.filter == "OCTAHEDRAL")
    meshopt_decodeFilterOct(out.data(), e.count, e.stride);
  else if (e.filter == "QUATERNION")
    meshopt_decodeFilterQuat(out.data(), e.count, e.stride);
  else if (e.filter == "EXPONENTIAL")
    meshopt_decodeFilterExp(out.data(), e.count, e.stride);
  return out;
}

[[noreturn]] void fail_draco(const std::string& place, const std::string& why) {
  throw Error::at(place, "cannot be read by Draco: " + why, "a mesh of its bit stream 2.2");
}

// Compares what the head of a stream says of its faces with what is asked for, before the decoder asks for memory.
void check_faces(std::string_view bytes, std::size_t faces, const std::string& place) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  buffer.set_bitstream_version(DRACO_BITSTREAM_VERSION(2, 2));
  constexpr std::uint16_t has_metadata = 0x8000;
  std::array<char, 5> magic{};
  std::uint8_t major = 0, minor = 0, kind = 0, method = 0, traversal = 0;
  std::uint16_t flags = 0;
  if (!buffer.Decode(&magic) || !buffer.Decode(&major) || !buffer.Decode(&minor) || !buffer.Decode(&kind) ||
      !buffer.Decode(&method) || !buffer.Decode(&flags) || std::string_view(magic.data(), 5) != "DRACO")
    fail_draco(place, "no head of a stream");
  if (major != 2 || minor != 2)
    fail_draco(place, "bit stream " + std::to_string(major) + '.' + std::to_string(minor));
  if (kind != draco::TRIANGULAR_MESH) fail_draco(place, "points without triangles");
  draco::GeometryMetadata metadata;
  bool whole =
      (flags & has_metadata) == 0 || draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata);
  std::uint32_t vertices = 0, there = 0;
  if (method == draco::MESH_EDGEBREAKER_ENCODING)
    whole = whole && buffer.Decode(&traversal) && draco::DecodeVarint(&vertices, &buffer) &&
            draco::DecodeVarint(&there, &buffer);
  else
    whole = whole && draco::DecodeVarint(&there, &buffer);
  if (!whole) fail_draco(place, "its head is cut off");
  if (there != faces || there > most_faces_of_byte * bytes.size())
    throw Error::at(place, std::to_string(there) + " triangles in " + std::to_string(bytes.size()) + " bytes",
                    std::to_string(faces) + ", as its indices say");
}

template <class Value>
bool put_values(const draco::PointAttribute& attribute, std::uint32_t points, std::size_t components,
                char* to) {
  std::vector<Value> values(components);
  for (std::uint32_t i = 0; i < points; ++i, to += components * sizeof(Value)) {
    if (!attribute.ConvertValue<Value>(attribute.mapped_index(draco::PointIndex(i)),
                                       static_cast<std::int8_t>(components), values.data()))
      return false;
    std::memcpy(to, values.data(), components * sizeof(Value));
  }
  return true;
}

template <class Index>
bool put_indices(const draco::Mesh& mesh, char* to) {
  for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face)
    for (const draco::PointIndex& point : mesh.face(face)) {
      const auto index = static_cast<Index>(point.value());
      if (std::uint64_t{index} != point.value() || point.value() >= mesh.num_points()) return false;
      std::memcpy(to, &index, sizeof index);
      to += sizeof index;
    }
  return true;
}

// Calls put() with a value of the type that glTF has this number for.
template <class Put>
bool with_type(int type, const Put& put) {
  switch (type) {
    case 5120:
      return put(std::int8_t{});
    case 5121:
      return put(std::uint8_t{});
    case 5122:
      return put(std::int16_t{});
    case 5123:
      return put(std::uint16_t{});
    case 5125:
      return put(std::uint32_t{});
    default:
      return put(float{});
  }
}

std::string draco_array(const draco::Mesh& mesh, const DracoArray& array, const std::string& place) {
  const draco::PointAttribute* attribute = nullptr;
  if (array.id >= 0) {
    attribute = mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(array.id));
    if (attribute == nullptr) fail_draco(place, "it has no attribute " + std::to_string(array.id));
    if (attribute->num_components() != array.components || mesh.num_points() != array.count)
      fail_draco(place, std::to_string(mesh.num_points()) + " elements of " +
                            std::to_string(attribute->num_components()) + " values in place of " +
                            std::to_string(array.count) + " of " + std::to_string(array.components));
  }
  std::string out;
  const bool whole = with_type(array.type, [&](auto value) {
    using Value = decltype(value);
    out.resize(array.count * array.components * sizeof(Value));
    if (attribute != nullptr)
      return put_values<Value>(*attribute, mesh.num_points(), array.components, out.data());
    if constexpr (std::is_unsigned_v<Value>) return put_indices<Value>(mesh, out.data());
    return false;
  });
  if (!whole) fail_draco(place, "values that do not fit the type that is asked for");
  return out;
}

std::vector<std::string> draco_arrays(std::string_view bytes, const std::vector<DracoArray>& arrays,
                                      const std::string& place) {
  std::size_t corners = 0;
  for (const DracoArray& array : arrays)
    if (array.id < 0) corners = array.count;
  check_faces(bytes, corners / 3, place);
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) fail_draco(place, printable(decoded.status().error_msg_string(), 100));
  const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
  if (std::size_t{mesh->num_faces()} * 3 != corners)
    fail_draco(place, "another number of triangles than it says");
  std::vector<std::string> out;
  for (const DracoArray& array : arrays) out.push_back(draco_array(*mesh, array, place));
  return out;
}

}  // namespace

MeshDoor mesh_door() {
  return {meshopt_elements, draco_arrays};
}

}  // namespace etak
