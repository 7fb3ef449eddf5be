// SPDX-License-Identifier: Apache-2.0
// Scenes, nodes, meshes and cameras of glTF 2.0 (specification, sections 3.5, 3.7 and 3.10).
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/math/functions.h"
#include "core/math/mat3.h"
#include "core/scene/gltf_json.h"

namespace etak {
namespace {

/// An affine transform of space: linear part and origin.
struct Placement {
  Mat3 linear = identity3;
  Vec3 origin{0, 0, 0};

  Vec3 operator()(const Vec3& p) const {
    Vec3 out = linear * p;
    for (std::size_t i = 0; i < 3; ++i) out[i] += origin[i];
    return out;
  }
};

/// First `inner`, then `outer`.
Placement within(const Placement& outer, const Placement& inner) {
  return {outer.linear * inner.linear, outer(inner.origin)};
}

constexpr double widest = 1e12;  // no scene is larger: keeps areas within what a float holds

Placement placement_of(const JsonNode& node) {
  Placement out;
  if (node.has("matrix")) {
    std::array<double, 16> m{};
    numbers_into(node.at("matrix"), m.data(), 16, -widest, widest);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) out.linear[row][column] = m[4 * column + row];
      out.origin[row] = m[12 + row];
    }
    return out;
  }
  Vec3 scale{1, 1, 1};
  std::array<double, 4> q{0, 0, 0, 1};
  numbers_at(node, "translation", out.origin, -widest, widest);
  numbers_at(node, "scale", scale, -widest, widest);
  numbers_at(node, "rotation", q, -2, 2);
  const double length = math::hypot(math::hypot(q[0], q[1]), math::hypot(q[2], q[3]));
  if (length == 0) node.at("rotation").fail("a quaternion of length 0", "a unit quaternion");
  const double x = q[0] / length, y = q[1] / length, z = q[2] / length, w = q[3] / length;
  out.linear = {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                 {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                 {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
  out.linear = out.linear * diagonal(scale);
  return out;
}

Vec3 numbers_of(const GltfElements& elements, std::size_t at) {
  return {elements.number(at, 0), elements.number(at, 1), elements.number(at, 2)};
}

// A position in the world.
Vec3 moved(const GltfElements& positions, std::size_t vertex, const JsonNode& attributes,
           const Placement& place) {
  const Vec3 out = place(numbers_of(positions, vertex));
  for (const double value : out)
    if (!(std::abs(value) <= widest))
      attributes.at("POSITION").fail("a position that is not finite or beyond 1e12", "a finite position");
  return out;
}

// What morph targets may make of the colours and UVs of a use.
void read_targets(const JsonNode& node, GltfUse& use) {
  if (!node.has("targets")) return;
  const JsonNode targets = node.at("targets");
  targets.expect_array();
  for (std::size_t i = 0; i < targets.size(); ++i) {
    targets.at(i).expect_object();
    for (const auto& [name, ignored] : targets.at(i).value.items()) {
      // Weights may lead anywhere between black and white.
      if (name == "COLOR_0") use.colors.least = {0, 0, 0};
      int set = 0;
      if (name.starts_with("TEXCOORD_") &&
          std::from_chars(name.data() + 9, name.data() + name.size(), set).ec == std::errc())
        use.morphed_uv_sets.insert(set);
    }
  }
}

GltfCamera camera_of(const JsonNode& node, const Placement& place) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  GltfCamera out;
  out.name = node.text_or_empty("name");
  const std::string type = node.at("type").text();
  out.perspective = type == "perspective";
  if (!out.perspective && type != "orthographic") node.at("type").fail_type("perspective or orthographic");
  const JsonNode lens = node.at(type);
  lens.expect_object();
  if (out.perspective)
    out.yfov = number_at(lens, "yfov", out.yfov, 0, 4);
  else
    out.ymag = number_at(lens, "ymag", out.ymag, -infinite, infinite);
  out.znear = number_at(lens, "znear", out.znear, 0, infinite);
  out.position = place.origin;
  // A camera looks along its own -z.
  const Vec3 along = place.linear * Vec3{0, 0, -1};
  const double length = math::hypot(along[0], along[1], along[2]);
  if (length > 0)
    for (std::size_t i = 0; i < 3; ++i) out.direction[i] = along[i] / length;
  return out;
}

class Walk {
 public:
  Walk(const GltfDocument& document, GltfScene& scene) : document_(document), scene_(scene) {}

  ///   asked   the options name it
  void scene(int index, bool asked) {
    const JsonNode node = document_.element("scenes", index);
    if (!node.has("nodes")) return;
    const JsonNode roots = node.at("nodes");
    roots.expect_array();
    std::vector<Step> open;
    for (std::size_t i = roots.size(); i-- > 0;) open.push_back({document_.index(roots.at(i), "nodes"), {}});
    counts_ = asked;
    is_lower_level_ = false;
    walk(std::move(open), index);
    // Lower levels of detail come last: those that are nodes of the scene themselves are drawn by then.
    is_lower_level_ = true;
    while (!lower_levels_.empty()) walk(std::exchange(lower_levels_, {}), index);
  }

 private:
  struct Step {
    int node;
    Placement parent;
  };

  void walk(std::vector<Step> open, int index) {
    // The tree is walked without recursion, because a deep one would overflow the stack.
    while (!open.empty()) {
      const Step step = open.back();
      open.pop_back();
      const JsonNode at = document_.element("nodes", step.node);
      int& seen_in = seen_in_.try_emplace(step.node, -1).first->second;
      // Another scene has drawn the node already, in a strict tree below the same parents.
      const bool drawn = seen_in >= 0;
      if (drawn && is_lower_level_) continue;
      if (seen_in == index)
        at.fail("reached twice in scene " + std::to_string(index), "each node under one parent");
      seen_in = index;
      const Placement place = within(step.parent, placement_of(at));
      for (const auto& row : place.linear)
        for (const double value : row)
          if (!(std::abs(value) <= widest))
            at.fail("a transform beyond 1e12", "a scene of a size that can be computed");
      if (!drawn) visit(at, place);
      for (const int level : lower_levels(document_, at, "nodes"))
        lower_levels_.push_back({level, step.parent});
      if (!at.has("children")) continue;
      const JsonNode children = at.at("children");
      children.expect_array();
      for (std::size_t i = children.size(); i-- > 0;)
        open.push_back({document_.index(children.at(i), "nodes"), place});
    }
  }

  void visit(const JsonNode& node, const Placement& place) {
    const bool is_seen = counts_ && !is_lower_level_;
    if (node.has("camera") && is_seen)
      scene_.cameras.push_back(
          camera_of(document_.element("cameras", document_.index(node.at("camera"), "cameras")), place));
    if (!node.has("mesh")) return;
    const int index = document_.index(node.at("mesh"), "meshes");
    const JsonNode primitives = document_.element("meshes", index).at("primitives");
    primitives.expect_array();
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      primitives.at(i).expect_object();
      primitive(primitives.at(i), {index, static_cast<int>(i)}, place);
      if (scene_.options.mesh && is_seen) add_to_mesh(primitives.at(i), place);
    }
  }

  /// An attribute of a primitive: `count` elements of some numbers.
  GltfElements attribute(const JsonNode& attributes, const char* name, std::size_t components,
                         std::optional<std::size_t> count) const {
    GltfElements out = open_accessor(document_, document_.index(attributes.at(name), "accessors"));
    if (out.components != components || (count && out.count != *count))
      attributes.at(name).fail("an accessor of another type or count",
                               "VEC" + std::to_string(components) + (count ? ", one for each POSITION" : ""));
    return out;
  }

  /// The positions of a primitive; none where nothing is drawn.
  std::optional<GltfElements> positions_of(const JsonNode& node) const {
    const JsonNode attributes = node.at("attributes");
    attributes.expect_object();
    if (!attributes.has("POSITION")) return std::nullopt;
    return attribute(attributes, "POSITION", 3, std::nullopt);
  }

  void add_to_mesh(const JsonNode& node, const Placement& place) {
    Mesh& mesh = scene_.mesh;
    const auto positions = positions_of(node);
    if (!positions) return;
    const auto [corners, triangles] =
        drawn_corners(document_, node, positions->count, most_gltf_triangles - mesh.triangles.size());
    if (corners < 3 || triangles.empty()) return;
    // Few triangles may bring many vertices, once for each node.
    if (mesh.vertices.size() + positions->count > most_gltf_triangles)
      node.fail("vertices beyond " + std::to_string(most_gltf_triangles), "at most so many in all");
    const JsonNode attributes = node.at("attributes");
    if (!attributes.has("NORMAL"))
      attributes.fail("no NORMAL", "a mesh with normals: which edges are smooth cannot be told without");
    const GltfElements normals = attribute(attributes, "NORMAL", 3, positions->count);
    GltfElements uvs;
    if (attributes.has("TEXCOORD_0"))
      uvs = attribute(attributes, "TEXCOORD_0", 2, positions->count);
    else
      mesh.has_uvs = false;
    // Normals turn by the cofactors of what moves positions.
    const auto& [x, y, z] = place.linear;
    const Mat3 turn{cross(y, z), cross(z, x), cross(x, y)};
    const auto begin = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::size_t i = 0; i < positions->count; ++i) {
      const Vec3 position = moved(*positions, i, attributes, place), normal = turn * numbers_of(normals, i);
      const double length = std::sqrt(dot(normal, normal));
      if (!(length > 0 && std::isfinite(length)))
        attributes.at("NORMAL").fail("the normal of vertex " + std::to_string(i) + " has no direction",
                                     "vectors of length 1");
      Mesh::Vertex& vertex = mesh.vertices.emplace_back();
      for (std::size_t c = 0; c < 3; ++c) {
        vertex.position[c] = static_cast<float>(position[c]);
        vertex.normal[c] = static_cast<float>(normal[c] / length);
      }
      for (std::size_t c = 0; uvs.first != nullptr && c < 2; ++c) {
        vertex.uv[c] = static_cast<float>(uvs.number(i, c));
        if (!std::isfinite(vertex.uv[c]))
          attributes.at("TEXCOORD_0").fail("a UV that is not finite", "finite UVs");
      }
    }
    for (const auto& [a, b, c] : triangles) mesh.triangles.push_back({begin + a, begin + b, begin + c});
  }

  void primitive(const JsonNode& node, std::pair<int, int> id, const Placement& place) {
    const auto materials = materials_of_primitive(document_, node, scene_.options.variants);
    if (materials.empty()) return;
    for (const int material : materials) {
      scene_.material_written[static_cast<std::size_t>(material)] = true;
      if (counts_) scene_.material_used[static_cast<std::size_t>(material)] = true;
    }
    const auto found = positions_of(node);
    if (!found) return;  // nothing is drawn, says the specification
    const GltfElements& positions = *found;
    const JsonNode attributes = node.at("attributes");
    GltfUse use = areas(node, attributes, positions, place);
    read_uvs(attributes, positions.count, use);
    read_colors(attributes, positions.count, use);
    read_targets(node, use);
    for (std::size_t i = 0; i < materials.size(); ++i) {
      if (i > 0) count(node, triangles_.size());
      use.material = materials[i];
      const int here = static_cast<int>(scene_.uses.size());
      const auto [first, is_new] = first_use_.try_emplace({id.first, id.second, materials[i]}, here);
      use.same_uv_as = is_new ? -1 : first->second;
      scene_.uses.push_back(use);
    }
  }

  /// Triangles of a primitive into triangles_, their areas and centres into a use.
  GltfUse areas(const JsonNode& node, const JsonNode& attributes, const GltfElements& positions,
                const Placement& place) {
    triangles_ = drawn_corners(document_, node, positions.count, most_gltf_triangles - total_).elements;
    count(node, triangles_.size());
    GltfUse use;
    use.world_area.reserve(triangles_.size());
    use.world_center.reserve(triangles_.size());
    use.world_radius.reserve(triangles_.size());
    use.world_edges.reserve(triangles_.size());
    for (const auto& triangle : triangles_) {
      std::array<Vec3, 3> corner;
      for (std::size_t i = 0; i < 3; ++i) corner[i] = moved(positions, triangle[i], attributes, place);
      Vec3 a, b, center;
      for (std::size_t c = 0; c < 3; ++c) {
        a[c] = corner[1][c] - corner[0][c];
        b[c] = corner[2][c] - corner[0][c];
        center[c] = (corner[0][c] + corner[1][c] + corner[2][c]) / 3;
      }
      const double twice =
          math::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
      use.world_area.push_back(static_cast<float>(twice / 2));
      use.world_center.push_back(
          {static_cast<float>(center[0]), static_cast<float>(center[1]), static_cast<float>(center[2])});
      double radius = 0;
      for (const Vec3& each : corner)
        radius = std::max(radius, math::hypot(each[0] - center[0], each[1] - center[1], each[2] - center[2]));
      use.world_radius.push_back(static_cast<float>(radius));
      const auto product = [](const Vec3& p, const Vec3& q) {
        return static_cast<float>(p[0] * q[0] + p[1] * q[1] + p[2] * q[2]);
      };
      use.world_edges.push_back({product(a, a), product(a, b), product(b, b)});
    }
    return use;
  }

  void read_uvs(const JsonNode& attributes, std::size_t vertices, GltfUse& use) {
    for (std::size_t set = 0; set < 2; ++set) {
      const std::string name = "TEXCOORD_" + std::to_string(set);
      if (!attributes.has(name)) continue;
      const GltfElements uvs = attribute(attributes, name.c_str(), 2, vertices);
      use.uv[set].reserve(triangles_.size());
      for (const auto& triangle : triangles_) {
        auto& corners = use.uv[set].emplace_back();
        for (std::size_t i = 0; i < 3; ++i)
          corners[i] = {static_cast<float>(uvs.number(triangle[i], 0)),
                        static_cast<float>(uvs.number(triangle[i], 1))};
      }
    }
  }

  void read_colors(const JsonNode& attributes, std::size_t vertices, GltfUse& use) const {
    if (!attributes.has("COLOR_0")) return;
    const JsonNode index = attributes.at("COLOR_0");
    const GltfElements colors = open_accessor(document_, document_.index(index, "accessors"));
    if (colors.components < 3 || colors.count != vertices)
      index.fail("an accessor of another type or count", "VEC3 or VEC4, one for each POSITION");
    for (std::size_t i = 0; i < vertices; ++i) {
      const Vec3 color = numbers_of(colors, i);
      use.colors.add({color, color});
    }
  }

  void count(const JsonNode& node, std::size_t triangles) {
    total_ += triangles;
    if (total_ > most_gltf_triangles)
      node.fail("triangles beyond " + std::to_string(most_gltf_triangles), "at most so many in all");
  }

  const GltfDocument& document_;
  GltfScene& scene_;
  std::map<int, int> seen_in_;                           // node to the last scene that reached it
  std::map<std::array<int, 3>, int> first_use_;          // mesh, primitive, material to its first use
  std::vector<std::array<std::uint32_t, 3>> triangles_;  // of the primitive at hand
  std::size_t total_ = 0;
  bool counts_ = true;              // the scene at hand is one of those that are asked for
  bool is_lower_level_ = false;     // the nodes at hand stand in the place of others
  std::vector<Step> lower_levels_;  // of the scene at hand, still to be walked
};

}  // namespace

void walk_scenes(const GltfDocument& document, GltfScene& scene) {
  const int scenes = static_cast<int>(document.count("scenes"));
  Walk walk(document, scene);
  if (scene.options.scene && (*scene.options.scene < 0 || *scene.options.scene >= scenes))
    throw Error::at(document.file, "no scene " + std::to_string(*scene.options.scene),
                    "one of its " + std::to_string(scenes) + " scenes");
  if (scenes == 0) {
    // A library of materials and meshes, says the specification: nothing is reached.
    return;
  }
  int first = 0;
  if (document.root.contains("scene")) first = document.index(document.node().at("scene"), "scenes");
  if (scene.options.scene) first = *scene.options.scene;
  const auto is_asked = [&](int i) { return scene.options.all_scenes || i == first; };
  for (int i = 0; i < scenes; ++i)
    if (is_asked(i)) walk.scene(i, true);
  for (int i = 0; i < scenes && !scene.options.mesh; ++i)
    if (!is_asked(i)) walk.scene(i, false);
}

}  // namespace etak
