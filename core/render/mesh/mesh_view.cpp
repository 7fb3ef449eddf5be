// SPDX-License-Identifier: Apache-2.0
#include "core/render/mesh/mesh_view.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace etak {
namespace {

constexpr int side = 4;  // samples of a pixel along one of its sides
constexpr float nothing = -2;
const double least_cosine = std::sqrt(1 - silhouette_limit * silhouette_limit);  // of a normal and the viewer

void add(Vec3& sum, const Vec3& v, double by) {
  for (std::size_t i = 0; i < 3; ++i) sum[i] += v[i] * by;
}
Vec3 unit(const Vec3& v) {
  return scaled(v, 1 / std::max(std::sqrt(dot(v, v)), 1e-30));
}

// Samples of one pixel that see the same surface, summed.
struct Group {
  Vec3 first_position, first_normal, position{}, normal{}, tangent{}, bitangent{};
  std::array<double, 2> first_uv, uv{};
  double open = 0;
  int count = 0;

  // Whether the light and the texel there are as good as those of the first sample.
  bool takes(const Vec3& p, const Vec3& n, const std::array<double, 2>& at, double pixel) const {
    Vec3 way = p;
    add(way, first_position, -1);
    return dot(way, way) < 9 * pixel * pixel && dot(n, first_normal) > 0.98 &&
           std::abs(at[0] - first_uv[0]) + std::abs(at[1] - first_uv[1]) < 1.0 / 32;
  }
};

}  // namespace

MeshView::MeshView(const MeshShape& shape, const Camera& camera, int width, int height)
    : shape_(shape),
      mesh_(shape.mesh()),
      camera_(camera),
      width_(width),
      first_(static_cast<std::size_t>(height) + 1) {
  for (const Mesh::Vertex& vertex : mesh_.vertices) {
    const Vec3 at = camera.axes() * widened(vertex.position);
    seen_.push_back(
        {at[0], at[1], camera.perspective() ? camera.spread() * (camera.distance() - at[2]) : 1.0});
    near_.push_back(static_cast<float>(at[2]));
  }
  // Once to count the triangles of each row, once to put them there.
  const auto each_row = [&](std::uint32_t triangle, const auto& visit) {
    double low = 1e30, high = -1e30;
    for (const std::uint32_t corner : mesh_.triangles[triangle]) {
      const double y = seen_[corner][1] / seen_[corner][2];
      low = std::min(low, y);
      high = std::max(high, y);
    }
    const auto row_of = [&](double y) {
      return static_cast<int>(std::clamp(camera.centre_row() - y / camera.pixel(), -1.0, double(height)));
    };
    for (int row = std::max(0, row_of(high)); row <= std::min(height - 1, row_of(low)); ++row)
      visit(static_cast<std::size_t>(row));
  };
  const auto count = static_cast<std::uint32_t>(mesh_.triangles.size());
  for (std::uint32_t i = 0; i < count; ++i) each_row(i, [&](std::size_t row) { ++first_[row + 1]; });
  for (std::size_t row = 1; row < first_.size(); ++row) first_[row] += first_[row - 1];
  of_rows_.resize(first_.back());
  std::vector<std::size_t> next = first_;
  for (std::uint32_t i = 0; i < count; ++i) each_row(i, [&](std::size_t row) { of_rows_[next[row]++] = i; });
}

// The share of a corner at (x, y) is in proportion to the determinant of the other two and (x, y, 1), whose sign also
// tells the side of an edge. Triangles that share an edge get the same numbers for it but for the sign, so that no
// sample falls between them.
void MeshView::cover(int row, std::uint32_t triangle, Samples& samples) const {
  const auto& [a, b, c] = mesh_.triangles[triangle];
  const Vec3 edges[] = {cross(seen_[b], seen_[c]), cross(seen_[c], seen_[a]), cross(seen_[a], seen_[b])};
  double left = 1e30, right = -1e30;
  for (const std::uint32_t corner : {a, b, c}) {
    const double x = seen_[corner][0] / seen_[corner][2] / camera_.pixel() + camera_.centre_column();
    left = std::min(left, x);
    right = std::max(right, x);
  }
  const int first = static_cast<int>(std::clamp(std::floor(left * side - 0.5), 0.0, double(width_) * side)),
            last = static_cast<int>(std::clamp(std::ceil(right * side + 0.5), 0.0, double(width_) * side));
  for (int down = 0; down < side; ++down) {
    const double y = camera_.y(row + (down + 0.5) / side);
    for (int column = first; column < last; ++column) {
      const Vec3 at{camera_.x((column + 0.5) / side), y, 1};
      const double u = dot(edges[0], at), v = dot(edges[1], at), w = dot(edges[2], at), all = u + v + w;
      if (all == 0 || !((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))) continue;
      const auto second = static_cast<float>(v / all), third = static_cast<float>(w / all);
      const float depth = near_[a] + second * (near_[b] - near_[a]) + third * (near_[c] - near_[a]);
      const auto sample = static_cast<std::size_t>(column * side + down);  // those of a pixel lie together
      if (depth <= samples.depth[sample]) continue;
      samples.depth[sample] = depth;
      samples.triangle[sample] = triangle;
      samples.place[sample] = {second, third};
    }
  }
}

void MeshView::gather(int column, Samples& samples) const {
  Group groups[side * side];
  int used = 0;
  const auto begin = static_cast<std::size_t>(column) * side * side;
  // How u and v change along the two sides of a triangle that begin at its first corner.
  const auto uv_steps = [&](const std::array<std::uint32_t, 3>& corners) {
    const auto &a = mesh_.vertices[corners[0]].uv, &b = mesh_.vertices[corners[1]].uv,
               &c = mesh_.vertices[corners[2]].uv;
    return std::array{double{b[0]} - double{a[0]}, double{c[0]} - double{a[0]}, double{b[1]} - double{a[1]},
                      double{c[1]} - double{a[1]}};
  };
  for (std::size_t sample = begin; sample < begin + side * side; ++sample) {
    if (samples.depth[sample] == nothing) continue;
    const auto& corners = mesh_.triangles[samples.triangle[sample]];
    const auto [second, third] = samples.place[sample];
    const double shares[] = {1 - double{second} - double{third}, double{second}, double{third}};
    Vec3 position{}, normal{}, mean{};
    std::array<double, 2> uv{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Mesh::Vertex& vertex = mesh_.vertices[corners[i]];
      add(position, widened(vertex.position), shares[i]);
      add(normal, widened(vertex.normal), shares[i]);
      add(mean, widened(vertex.normal), 1);
      for (std::size_t c = 0; c < 2; ++c) uv[c] += shares[i] * double{vertex.uv[c]};
    }
    // A surface has both sides: the normal is that of the side that is seen.
    const Vec3 &a = seen_[corners[0]], &b = seen_[corners[1]], &c = seen_[corners[2]];
    Vec3 along = widened(mesh_.vertices[corners[1]].position),
         across = widened(mesh_.vertices[corners[2]].position);
    add(along, widened(mesh_.vertices[corners[0]].position), -1);
    add(across, widened(mesh_.vertices[corners[0]].position), -1);
    const bool in_front = dot(cross(a, b), c) > 0, outwards = dot(cross(along, across), mean) > 0;
    const bool turned = in_front != outwards;
    normal = scaled(unit(normal), turned ? -1 : 1);
    Group* group = std::find_if(groups, groups + used, [&](const Group& each) {
      return each.takes(position, normal, uv, camera_.pixel());
    });
    if (group == groups + used) groups[used++] = {position, normal, {}, {}, {}, {}, uv, {}, 0, 0};
    add(group->position, position, 1);
    add(group->normal, normal, 1);
    for (std::size_t i = 0; i < 2; ++i) group->uv[i] += uv[i];
    const std::array<double, 4> steps = uv_steps(corners);
    const double sign = (steps[0] * steps[3] < steps[1] * steps[2]) != turned ? -1 : 1;
    add(group->tangent, along, sign * steps[3]);
    add(group->tangent, across, -sign * steps[2]);
    add(group->bitangent, along, sign * steps[1]);
    add(group->bitangent, across, -sign * steps[0]);
    for (std::size_t i = 0; i < 3; ++i) group->open += shares[i] * double{shape_.open(corners[i], turned)};
    ++group->count;
  }
  for (const Group& each : std::span(groups, static_cast<std::size_t>(used))) {
    const double part = 1.0 / each.count;
    const Vec3 position = scaled(each.position, part), &back = camera_.axes()[2];
    Vec3 viewer = back, normal = unit(each.normal);
    if (camera_.perspective()) {
      viewer = scaled(back, camera_.distance());
      add(viewer, position, -1);
      viewer = unit(viewer);
    }
    add(normal, viewer, std::max(least_cosine - dot(normal, viewer), 0.0));
    samples.fragments.push_back({column,
                                 each.count / double(side * side),
                                 position,
                                 unit(normal),
                                 viewer,
                                 {each.uv[0] * part, each.uv[1] * part},
                                 unit(each.tangent),
                                 unit(each.bitangent),
                                 each.open * part});
  }
}

void MeshView::see(int row, Samples& samples) const {
  const auto count = static_cast<std::size_t>(width_) * side * side;
  samples.depth.assign(count, nothing);
  samples.triangle.resize(count);
  samples.place.resize(count);
  samples.fragments.clear();
  const auto at = static_cast<std::size_t>(row);
  if (first_[at] == first_[at + 1]) return;
  for (std::size_t i = first_[at]; i < first_[at + 1]; ++i) cover(row, of_rows_[i], samples);
  for (int column = 0; column < width_; ++column) gather(column, samples);
}

}  // namespace etak
