// SPDX-License-Identifier: Apache-2.0
// Accessors, buffer views and indices of glTF 2.0 (specification, sections 3.6 and 3.7.2).
#include <cmath>
#include <cstring>

#include "core/base/number.h"
#include "core/scene/gltf_json.h"

namespace etak {
namespace {

std::size_t component_size(int type) {
  switch (type) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    default:
      return 4;
  }
}

int component_type(const JsonNode& node) {
  const int type = node.integer();
  for (const int known : {5120, 5121, 5122, 5123, 5125, 5126})
    if (type == known) return type;
  node.fail(std::to_string(type), "a component type: 5120 to 5123, 5125 or 5126");
}

std::size_t components_of(const JsonNode& node) {
  const std::string type = node.text();
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  if (type == "VEC4") return 4;
  node.fail(in_quotes(type), "SCALAR, VEC2, VEC3 or VEC4");
}

/// A buffer view's bytes and stride (0: tight).
struct View {
  std::string_view bytes;
  std::size_t stride = 0;
};

View open_view(const GltfDocument& document, int index) {
  const JsonNode node = document.element("bufferViews", index);
  node.expect_object();
  const int buffer = document.index(node.at("buffer"), "buffers");
  const std::string_view bytes = document.buffers[static_cast<std::size_t>(buffer)];
  const std::size_t offset = size_at(node, "byteOffset", 0), length = size_at(node.at("byteLength"), "", 0);
  if (offset > bytes.size() || length > bytes.size() - offset)
    node.fail(std::to_string(length) + " bytes from " + std::to_string(offset) + " in a buffer of " +
                  std::to_string(bytes.size()),
              "bytes inside the buffer");
  View view{bytes.substr(offset, length), 0};
  if (node.has("byteStride")) view.stride = static_cast<std::size_t>(node.at("byteStride").integer(4, 252));
  return view;
}

/// `count` elements of `size` bytes from `offset` in a view. Throws Error when the last one leaves it.
const char* elements_in(const View& view, std::size_t offset, std::size_t count, std::size_t size,
                        std::size_t stride, const JsonNode& node) {
  // count and stride are below 2^40 and 2^8: no overflow.
  const std::size_t needed = count == 0 ? 0 : (count - 1) * stride + size;
  if (offset > view.bytes.size() || needed > view.bytes.size() - offset)
    node.fail(std::to_string(count) + " elements need " + std::to_string(needed) + " bytes from " +
                  std::to_string(offset) + " in a view of " + std::to_string(view.bytes.size()),
              "elements inside the view");
  return view.bytes.data() + offset;
}

template <class Number>
Number load(const char* from) {
  Number out;
  std::memcpy(&out, from, sizeof out);
  return out;
}

std::uint32_t load_integer(const char* from, int type) {
  switch (type) {
    case 5121:
      return load<std::uint8_t>(from);
    case 5123:
      return load<std::uint16_t>(from);
    default:
      return load<std::uint32_t>(from);
  }
}

void put_sparse(const GltfDocument& document, const JsonNode& sparse, GltfElements& elements) {
  const std::size_t count = size_at(sparse.at("count"), "", 0);
  if (count > elements.count)
    sparse.at("count").fail(std::to_string(count), "at most " + std::to_string(elements.count));
  const JsonNode indices = sparse.at("indices"), values = sparse.at("values");
  const int type = component_type(indices.at("componentType"));
  if (type != 5121 && type != 5123 && type != 5125)
    indices.at("componentType").fail(std::to_string(type), "5121, 5123 or 5125");
  const View index_view = open_view(document, document.index(indices.at("bufferView"), "bufferViews"));
  const View value_view = open_view(document, document.index(values.at("bufferView"), "bufferViews"));
  const std::size_t step = component_size(type);
  const char* at = elements_in(index_view, size_at(indices, "byteOffset", 0), count, step, step, indices);
  const char* from =
      elements_in(value_view, size_at(values, "byteOffset", 0), count, elements.size, elements.size, values);
  for (std::size_t i = 0, next = 0; i < count; ++i) {
    const std::size_t index = load_integer(at + i * step, type);
    if (index < next || index >= elements.count)
      indices.fail("index " + std::to_string(index),
                   "rising indices below " + std::to_string(elements.count));
    std::memcpy(elements.owned.data() + index * elements.size, from + i * elements.size, elements.size);
    next = index + 1;
  }
}

}  // namespace

std::size_t GltfDocument::count(const char* array) const {
  const auto found = root.find(array);
  if (found == root.end()) return 0;
  if (!found->is_array()) node().at(array).fail_type("an array");
  return found->size();
}

JsonNode GltfDocument::element(const char* array, int index) const {
  const JsonNode element = node().at(array).at(static_cast<std::size_t>(index));
  element.expect_object();
  return element;
}

int GltfDocument::index(const JsonNode& number, const char* array) const {
  const std::size_t size = count(array);
  const std::string expected = "an index into " + std::string(array) + ", which has " + std::to_string(size);
  if (!number.value.is_number_integer()) number.fail_type(expected);
  if (number.value < 0 || number.value >= size) number.fail_type(expected);
  return number.value.get<int>();
}

std::size_t size_at(const JsonNode& node, std::string_view key, std::size_t otherwise) {
  if (!key.empty()) return node.has(key) ? size_at(node.at(key), "", otherwise) : otherwise;
  constexpr std::uint64_t most = std::uint64_t{1} << 40;
  // 12.0 is a whole number to JSON, and some exporters write it so.
  if (node.value.is_number_float()) {
    const double number = node.number();
    if (number >= 0 && number <= static_cast<double>(most) && number == std::floor(number))
      return static_cast<std::size_t>(number);
  }
  if (!node.value.is_number_unsigned() || node.value.get<std::uint64_t>() > most)
    node.fail_type("a whole number from 0 to 2^40");
  return node.value.get<std::uint64_t>();
}

double number_at(const JsonNode& node, std::string_view key, double otherwise, double least, double most) {
  if (!node.has(key)) return otherwise;
  const double value = node.at(key).number();
  if (value < least || value > most)
    node.at(key).fail(number(value, 9), "a number from " + number(least, 6) + " to " + number(most, 6));
  return value;
}

void numbers_into(const JsonNode& node, double* to, std::size_t count, double least, double most) {
  if (!node.value.is_array() || node.size() != count)
    node.fail_type("an array of " + std::to_string(count) + " numbers");
  for (std::size_t i = 0; i < count; ++i) {
    to[i] = node.at(i).number();
    if (!(to[i] >= least && to[i] <= most))
      node.at(i).fail_type("a number in the range of the specification");
  }
}

const Json* extension(const Json& object, std::string_view name) {
  const auto extensions = object.find("extensions");
  if (extensions == object.end() || !extensions->is_object()) return nullptr;
  const auto found = extensions->find(name);
  return found == extensions->end() || !found->is_object() ? nullptr : &*found;
}

double GltfElements::number(std::size_t element, std::size_t component) const {
  const char* from = first + element * stride + component * component_size(type);
  const auto share = [&](double value, double most) {
    return normalized ? std::max(value / most, -1.0) : value;
  };
  switch (type) {
    case 5120:
      return share(load<std::int8_t>(from), 127);
    case 5121:
      return share(load<std::uint8_t>(from), 255);
    case 5122:
      return share(load<std::int16_t>(from), 32767);
    case 5123:
      return share(load<std::uint16_t>(from), 65535);
    case 5125:
      return load<std::uint32_t>(from);
    default:
      return static_cast<double>(load<float>(from));
  }
}

std::uint32_t GltfElements::integer(std::size_t element) const {
  return load_integer(first + element * stride, type);
}

std::optional<AccessorBytes> bytes_of_accessor(const GltfDocument& document, int index) {
  const JsonNode node = document.element("accessors", index);
  if (!node.has("bufferView") || node.has("sparse") || node.at("type").text().starts_with("MAT"))
    return std::nullopt;
  AccessorBytes out;
  out.view = document.index(node.at("bufferView"), "bufferViews");
  out.stride = size_at(document.element("bufferViews", out.view), "byteStride", 0);
  const std::size_t size =
      components_of(node.at("type")) * component_size(component_type(node.at("componentType")));
  const std::size_t count = size_at(node.at("count"), "", 0);
  out.begin = out.end = size_at(node, "byteOffset", 0);
  if (count > 0) out.end += (count - 1) * (out.stride > 0 ? out.stride : size) + size;
  return out;
}

GltfElements shape_of_accessor(const JsonNode& node) {
  GltfElements out;
  out.type = component_type(node.at("componentType"));
  out.components = components_of(node.at("type"));
  out.count = size_at(node.at("count"), "", 0);
  out.normalized = node.has("normalized") && node.at("normalized").boolean();
  out.size = out.stride = out.components * component_size(out.type);
  return out;
}

GltfElements open_accessor(const GltfDocument& document, int index) {
  const JsonNode node = document.element("accessors", index);
  GltfElements out = shape_of_accessor(node);
  if (node.has("bufferView")) {
    const View view = open_view(document, document.index(node.at("bufferView"), "bufferViews"));
    if (view.stride != 0) out.stride = view.stride;
    if (out.stride < out.size) node.fail("elements larger than the view's byteStride", "a larger byteStride");
    out.first = elements_in(view, size_at(node, "byteOffset", 0), out.count, out.size, out.stride, node);
  } else if (out.count > most_gltf_elements_without_bytes) {
    node.at("count").fail(std::to_string(out.count) + " elements without a bufferView",
                          "at most " + std::to_string(most_gltf_elements_without_bytes) + " of those");
  }
  if (!node.has("sparse") && out.first) return out;

  // Sparse, or all zeros.
  out.owned.resize(out.count * out.size);
  if (out.first)
    for (std::size_t i = 0; i < out.count; ++i)
      std::memcpy(out.owned.data() + i * out.size, out.first + i * out.stride, out.size);
  out.stride = out.size;
  if (node.has("sparse")) put_sparse(document, node.at("sparse"), out);
  out.first = out.owned.data();
  return out;
}

namespace {

constexpr int points = 0, lines = 1, line_loop = 2, line_strip = 3, triangles = 4, triangle_strip = 5,
              triangle_fan = 6;

std::size_t element_count(int mode, std::size_t corners) {
  switch (mode) {
    case points:
      return corners;
    case lines:
      return corners / 2;
    case line_loop:
      return corners < 2 ? 0 : corners;
    case line_strip:
      return corners < 2 ? 0 : corners - 1;
    case triangles:
      return corners / 3;
    default:
      return corners < 3 ? 0 : corners - 2;
  }
}

/// The places of the corners of element `i` in the row of corners.
std::array<std::size_t, 3> corners_of(int mode, std::size_t i, std::size_t corners) {
  switch (mode) {
    case points:
      return {i, i, i};
    case lines:
      return {2 * i, 2 * i + 1, 2 * i + 1};
    case line_loop:
    case line_strip:
      return {i, (i + 1) % corners, (i + 1) % corners};
    case triangle_strip:
      // Every second triangle of a strip turns the other way; which way does not matter here but to the writer.
      return {i, i + 1 + i % 2, i + 2 - i % 2};
    case triangle_fan:
      return {i + 1, i + 2, 0};
    default:
      return {3 * i, 3 * i + 1, 3 * i + 2};
  }
}

}  // namespace

DrawnCorners drawn_corners(const GltfDocument& document, const JsonNode& primitive, std::size_t vertices,
                           std::size_t most) {
  const int mode = primitive.has("mode") ? primitive.at("mode").integer(points, triangle_fan) : triangles;
  std::size_t corners = vertices;
  GltfElements indices;
  if (primitive.has("indices")) {
    indices = open_accessor(document, document.index(primitive.at("indices"), "accessors"));
    if (indices.components != 1 || (indices.type != 5121 && indices.type != 5123 && indices.type != 5125))
      primitive.at("indices").fail("an accessor of another type", "SCALAR of unsigned integers");
    corners = indices.count;
  }
  const std::size_t count = element_count(mode, corners);
  if (count > most)
    primitive.fail("triangles beyond " + std::to_string(most_gltf_triangles), "at most so many in all");
  const auto vertex = [&](std::size_t corner) {
    const std::uint32_t at = indices.first ? indices.integer(corner) : static_cast<std::uint32_t>(corner);
    if (at >= vertices)
      primitive.at("indices").fail("index " + std::to_string(at),
                                   "indices below " + std::to_string(vertices));
    return at;
  };
  DrawnCorners out{mode == points ? 1 : mode < triangles ? 2 : 3, {}};
  out.elements.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b, c] = corners_of(mode, i, corners);
    out.elements.push_back({vertex(a), vertex(b), vertex(c)});
  }
  return out;
}

}  // namespace etak
