// SPDX-License-Identifier: Apache-2.0
// UVs rewritten vertex by vertex, where a material's texels were moved in parts that share no transform.
#include <algorithm>
#include <cassert>
#include <cstring>
#include <limits>
#include <span>

#include "core/base/number.h"
#include "core/scene/gltf_write_json.h"
#include "core/scene/uv_use.h"

namespace etak {
namespace {

using Index = std::uint32_t;
constexpr Index unset = std::numeric_limits<Index>::max();

std::string uv_name(int set) {
  return "TEXCOORD_" + std::to_string(set);
}

/// How many UV sets a primitive has: they are numbered without gaps.
int uv_sets(const Json& primitive) {
  int sets = 0;
  while (primitive["attributes"].contains(uv_name(sets))) ++sets;
  return sets;
}

/// Calls see(primitive, materials) for every primitive that draws with the material.
template <class See>
void each_primitive(const GltfRewrite& rewrite, int material, const See& see) {
  const GltfDocument document = rewrite.document();
  const int meshes = static_cast<int>(document.count("meshes"));
  for (int mesh = 0; mesh < meshes; ++mesh) {
    const JsonNode primitives = document.element("meshes", mesh).at("primitives");
    primitives.expect_array();
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const auto materials = materials_of_primitive(document, primitives.at(i), true);
      if (std::find(materials.begin(), materials.end(), material) != materials.end())
        see(primitives.at(i), materials, mesh, i);
    }
  }
}

/// A new accessor over bytes of its own.
int add_accessor(GltfRewrite& rewrite, const std::string& tight, std::size_t size, Json accessor,
                 int target) {
  rewrite.buffers.push_back(
      rewrite.added.emplace_back(put_in_view(rewrite.root, accessor, {tight, size, target})));
  accessor["count"] = size == 0 ? 0 : tight.size() / size;
  return rewrite.append("accessors", std::move(accessor));
}

/// One primitive's new UVs.
class Primitive {
 public:
  Primitive(GltfRewrite& rewrite, const AtlasMaterial& material, int mesh, std::size_t primitive)
      : rewrite_(rewrite), material_(material), mesh_(mesh), primitive_(primitive) {
    const GltfTexture* texture =
        leading_texture(rewrite.scene.materials[static_cast<std::size_t>(material.material)]);
    own_ = uv_matrix(material.own ? *material.own : texture ? texture->transform : UvTransform{});
    if (texture) sampler_ = texture->sampler;
  }

  void rewrite(int to_set) {
    if (!read()) return;
    for (std::size_t i = 0; i < drawn_.elements.size(); ++i) place(i);
    // Vertices that nothing draws are placed one by one.
    for (Index i = 0; i < vertices_; ++i)
      if (island_of_[i] == unset) place_vertex(i);
    if (!copies_.empty()) {
      copy_vertices();
      write_indices();
    }
    write_uvs(to_set);
  }

 private:
  Json& json() { return rewrite_.root["meshes"][static_cast<std::size_t>(mesh_)]["primitives"][primitive_]; }
  JsonNode node() const {
    const GltfDocument document = rewrite_.document();
    return document.element("meshes", mesh_).at("primitives").at(primitive_);
  }

  bool read() {
    const GltfDocument document = rewrite_.document();
    const JsonNode at = node();
    const JsonNode attributes = at.at("attributes");
    if (!attributes.has("POSITION")) return false;
    if (at.has("targets"))
      for (const Json& target : at.value["targets"])
        if (target.contains(uv_name(material_.uv_set)))
          at.at("targets").fail("morphed UVs of a material whose UVs have to be rewritten", "UVs that stay");
    const GltfElements positions =
        open_accessor(document, document.index(attributes.at("POSITION"), "accessors"));
    vertices_ = static_cast<Index>(positions.count);
    source_.assign(vertices_, Uv{0, 0});
    if (attributes.has(uv_name(material_.uv_set))) {
      const JsonNode index = attributes.at(uv_name(material_.uv_set));
      const GltfElements uvs = open_accessor(document, document.index(index, "accessors"));
      if (uvs.components != 2 || uvs.count != positions.count)
        index.fail("an accessor of another type or count", "VEC2, one for each POSITION");
      for (Index i = 0; i < vertices_; ++i) source_[i] = own_ * Uv{uvs.number(i, 0), uvs.number(i, 1)};
    }
    drawn_ = drawn_corners(document, at, positions.count, most_gltf_triangles);
    target_.assign(vertices_, {0, 0});
    island_of_.assign(vertices_, unset);
    period_.assign(vertices_, {});
    next_copy_.assign(vertices_, unset);
    return true;
  }

  /// Places the corners of a triangle. A vertex that another triangle has placed elsewhere is doubled.
  void place(std::size_t triangle) {
    auto& corners = drawn_.elements[triangle];
    const std::array<Uv, 3> uvs{source_[corners[0]], source_[corners[1]], source_[corners[2]]};
    Index island = 0;
    UvTransform fold;
    UvTransform region = material_.region;
    if (!material_.islands.empty()) {
      island = island_for(uvs, fold);
      region = material_.islands[island].region;
    }
    const UvMatrix matrix = uv_matrix(region) * uv_matrix(fold);
    // Two mirrored periods with one offset differ in direction.
    const Uv period{fold.offset[0] + (fold.scale[0] < 0 ? 0.5 : 0),
                    fold.offset[1] + (fold.scale[1] < 0 ? 0.5 : 0)};
    for (Index& corner : corners) corner = vertex_for(corner, island, period, matrix);
  }

  Index island_for(const std::array<Uv, 3>& uvs, UvTransform& fold) const {
    const auto footprint = footprint_of(uvs, sampler_, material_.texture_width, material_.texture_height);
    if (!footprint) fail_uv(uvs, "a triangle over more than one period of its texture");
    fold = footprint->fold;
    const auto [left, top, right, bottom] = footprint->texels;
    Index best = unset;
    std::int64_t best_area = 0;
    // First among boxes that hold all texels that the triangle reads; else among boxes that hold the
    // triangle up to half a texel.
    for (const int slack : {0, 1}) {
      for (Index i = 0; i < material_.islands.size(); ++i) {
        const auto [x, y, width, height] = material_.islands[i].box;
        if (left + slack < x || top + slack < y || right - slack >= x + width || bottom - slack >= y + height)
          continue;
        const RowRuns& own = material_.islands[i].texels;
        if (!own.empty() && !holds(own, footprint->centre[0], footprint->centre[1])) continue;
        const std::int64_t area = std::int64_t{width} * height;
        if (best == unset || area < best_area) {
          best = i;
          best_area = area;
        }
      }
      if (best != unset) return best;
    }
    fail_uv(uvs, "a triangle in none of the islands");
  }
  [[noreturn]] void fail_uv(const std::array<Uv, 3>& uvs, const std::string& what) const {
    node().fail(what + ", from UV " + number(uvs[0][0], 6) + " " + number(uvs[0][1], 6),
                "each triangle inside one island");
  }

  /// The vertex, or a copy of it, for this island and period.
  Index vertex_for(Index vertex, Index island, const Uv& period, const UvMatrix& matrix) {
    for (Index at = vertex;; at = next_copy_[at]) {
      if (island_of_[at] == unset) {
        island_of_[at] = island;
        period_[at] = period;
        target_[at] = matrix * source_[at];
        return at;
      }
      if (island_of_[at] == island && period_[at] == period) return at;
      if (next_copy_[at] != unset) continue;
      const auto copy = static_cast<Index>(island_of_.size());
      next_copy_[at] = copy;
      copies_.push_back(vertex);
      island_of_.push_back(island);
      period_.push_back(period);
      next_copy_.push_back(unset);
      source_.push_back(source_[vertex]);
      target_.push_back(matrix * source_[vertex]);
      return copy;
    }
  }

  void place_vertex(Index vertex) {
    const Uv uv = source_[vertex];
    if (material_.islands.empty()) {
      target_[vertex] = transformed(material_.region, uv);
      return;
    }
    const auto footprint =
        footprint_of({uv, uv, uv}, sampler_, material_.texture_width, material_.texture_height);
    if (!footprint) return;
    const Uv folded = transformed(footprint->fold, uv);
    for (const AtlasIsland& island : material_.islands) {
      const double x = folded[0] * material_.texture_width - island.box[0];
      const double y = folded[1] * material_.texture_height - island.box[1];
      if (x < 0 || y < 0 || x > island.box[2] || y > island.box[3]) continue;
      if (!island.texels.empty() && !holds(island.texels, footprint->centre[0], footprint->centre[1]))
        continue;
      target_[vertex] = transformed(island.region, folded);
      return;
    }
  }

  /// Appends the copies to every attribute and morph target.
  void copy_vertices() {
    copy_attributes(json()["attributes"]);
    if (json().contains("targets"))
      for (std::size_t i = 0; i < json()["targets"].size(); ++i) copy_attributes(json()["targets"][i]);
  }
  void copy_attributes(Json& attributes) {
    if (!attributes.is_object()) return;
    for (auto item = attributes.begin(); item != attributes.end(); ++item) {
      const GltfDocument document = rewrite_.document();
      const int index =
          document.index({*item, rewrite_.scene.path, node().pointer + "/" + item.key()}, "accessors");
      const GltfElements old = open_accessor(document, index);
      if (old.count != vertices_)
        node().fail("attributes of different counts", "one element for each POSITION");
      std::string tight((vertices_ + copies_.size()) * old.size, '\0');
      for (std::size_t i = 0; i < vertices_ + copies_.size(); ++i)
        std::memcpy(tight.data() + i * old.size,
                    old.first + (i < vertices_ ? i : std::size_t{copies_[i - vertices_]}) * old.stride,
                    old.size);
      Json accessor = rewrite_.root["accessors"][static_cast<std::size_t>(index)];
      // The new accessor stands in another array of the document: `attributes` does not move.
      *item = add_accessor(rewrite_, tight, old.size, std::move(accessor), 34962);
    }
  }

  void write_indices() {
    const bool wide = island_of_.size() > 65535;
    const std::size_t size = wide ? 4 : 2;
    const auto distinct = static_cast<std::size_t>(drawn_.distinct);
    std::string bytes(distinct * drawn_.elements.size() * size, '\0');
    char* to = bytes.data();
    for (const auto& corners : drawn_.elements)
      for (const Index index : std::span(corners).first(distinct)) {
        const auto narrow = static_cast<std::uint16_t>(index);
        if (wide)
          std::memcpy(to, &index, size);
        else
          std::memcpy(to, &narrow, size);
        to += size;
      }
    const Json accessor{{"componentType", wide ? 5125 : 5123}, {"type", "SCALAR"}};
    json()["indices"] = add_accessor(rewrite_, bytes, size, accessor, 34963);
    constexpr std::array modes{0, 1, 4};  // points, lines, triangles
    json()["mode"] = modes[distinct - 1];
  }

  void write_uvs(int to_set) {
    std::string bytes(target_.size() * 8, '\0');
    for (std::size_t i = 0; i < target_.size(); ++i) {
      const std::array<float, 2> uv{static_cast<float>(target_[i][0]), static_cast<float>(target_[i][1])};
      std::memcpy(bytes.data() + 8 * i, uv.data(), 8);
    }
    const int index = add_accessor(rewrite_, bytes, 8, {{"componentType", 5126}, {"type", "VEC2"}}, 34962);
    Json& attributes = json()["attributes"];
    // Sets are numbered without gaps: those that a primitive lacks get the same UVs.
    for (int set = uv_sets(json()); set < to_set; ++set) attributes[uv_name(set)] = index;
    attributes[uv_name(to_set)] = index;
  }

  GltfRewrite& rewrite_;
  const AtlasMaterial& material_;
  int mesh_;
  std::size_t primitive_;
  UvMatrix own_{};
  GltfSampler sampler_;
  Index vertices_ = 0;
  DrawnCorners drawn_;
  // Per vertex, copies behind the others.
  std::vector<Uv> source_, target_, period_;
  std::vector<Index> island_of_, next_copy_;
  std::vector<Index> copies_;  // the vertex that each copy is of
};

}  // namespace

int uv_set_for(const GltfRewrite& rewrite, const AtlasMaterial& material) {
  bool needed = false;
  int next = 0;
  const Json& json = rewrite.root["materials"][static_cast<std::size_t>(material.material)];
  each_texture_info(json, [&](const std::string&, const Json& info) {
    for (const auto& [key, texture] : rewrite.textures)
      if (info["index"] == texture) return;  // of the atlas itself
    int set = info.value("texCoord", 0);
    if (const Json* transform = extension(info, "KHR_texture_transform"))
      set = transform->value("texCoord", set);
    needed = needed || set == material.uv_set;
  });
  each_primitive(rewrite, material.material,
                 [&](const JsonNode& primitive, const auto& materials, int, std::size_t) {
                   needed = needed || materials.size() > 1;
                   if (primitive.has("attributes")) next = std::max(next, uv_sets(primitive.value));
                 });
  return needed ? std::max(next, material.uv_set + 1) : material.uv_set;
}

void rewrite_uvs(GltfRewrite& rewrite, const AtlasMaterial& material, int uv_set) {
  std::vector<std::pair<int, std::size_t>> found;
  each_primitive(rewrite, material.material,
                 [&](const JsonNode& primitive, const auto&, int mesh, std::size_t i) {
                   if (primitive.has("attributes")) found.emplace_back(mesh, i);
                 });
  for (const auto& [mesh, i] : found) Primitive(rewrite, material, mesh, i).rewrite(uv_set);
}

}  // namespace etak
