// SPDX-License-Identifier: Apache-2.0
#include "core/render/mesh/mesh_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/math/functions.h"

namespace etak {
namespace {

constexpr std::size_t leaf = 4;  // triangles of a node without children
constexpr std::size_t vertex_rays_all = 3'200'000, vertex_rays_most = 64, vertex_rays_least = 16;
constexpr std::size_t ground_rays = 128;
constexpr int ground_side = 128;  // texels of the map of the ground along one of its sides

Vec3 sum(const Vec3& a, const Vec3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
std::array<float, 3> difference(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// The map of the ground holds the whole plane: a coordinate x lies at x / (1 + |x|) of it, (-1, 1).
double to_map(double x) {
  return x / (1 + std::abs(x));
}
double from_map(double at) {
  return at / (1 - std::abs(at));
}

}  // namespace

Mesh in_place_of_ball(Mesh mesh, const std::string& place) {
  Vec3 least{1e30, 1e30, 1e30}, most{-1e30, -1e30, -1e30};
  for (const Mesh::Vertex& vertex : mesh.vertices)
    for (std::size_t i = 0; i < 3; ++i) {
      least[i] = std::min(least[i], double{vertex.position[i]});
      most[i] = std::max(most[i], double{vertex.position[i]});
    }
  const Vec3 to_middle = scaled(sum(least, most), -0.5);
  const auto from_middle = [&](const Mesh::Vertex& vertex) {
    return sum(widened(vertex.position), to_middle);
  };
  double reach = 0;
  for (const Mesh::Vertex& vertex : mesh.vertices)
    reach = std::max(reach, std::sqrt(dot(from_middle(vertex), from_middle(vertex))));
  if (mesh.triangles.empty() || !(reach > 0))
    throw Error::at(place, "no triangle of any size", "a mesh of triangles");
  for (Mesh::Vertex& vertex : mesh.vertices) {
    const Vec3 there = scaled(from_middle(vertex), 1 / reach);
    for (std::size_t i = 0; i < 3; ++i) vertex.position[i] = static_cast<float>(there[i]);
  }
  return mesh;
}

MeshShape::MeshShape(Mesh mesh, unsigned threads) : mesh_(std::move(mesh)) {
  std::vector<std::uint32_t> order(mesh_.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  build(order, 0, order.size());
  for (const std::uint32_t at : order) {
    const auto& [a, b, c] = mesh_.triangles[at];
    const Point& corner = mesh_.vertices[a].position;
    triangles_.push_back({corner, difference(mesh_.vertices[b].position, corner),
                          difference(mesh_.vertices[c].position, corner)});
  }
  double area = 1e-30;
  for (const auto& [a, b, c] : mesh_.triangles) {
    const auto &p = mesh_.vertices[a].uv, &q = mesh_.vertices[b].uv, &r = mesh_.vertices[c].uv;
    uv_share_ +=
        std::abs(double{q[0] - p[0]} * double{r[1] - p[1]} - double{r[0] - p[0]} * double{q[1] - p[1]});
    const auto& corner = mesh_.vertices[a].position;
    const Vec3 normal = cross(widened(difference(mesh_.vertices[b].position, corner)),
                              widened(difference(mesh_.vertices[c].position, corner)));
    area += std::sqrt(dot(normal, normal));
  }
  uv_share_ /= area;
  ground_ = 1e30;
  for (const Mesh::Vertex& vertex : mesh_.vertices) ground_ = std::min(ground_, double{vertex.position[1]});

  const std::size_t count = mesh_.vertices.size();
  const std::size_t rays =
      std::clamp(vertex_rays_all / std::max<std::size_t>(count, 1), vertex_rays_least, vertex_rays_most);
  open_.resize(2 * count);
  parallel_chunks(count, threads, 64, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i)
      for (const bool turned : {false, true}) {
        const Vec3 normal = scaled(widened(mesh_.vertices[i].normal), turned ? -1 : 1);
        open_[2 * i + (turned ? 1 : 0)] =
            static_cast<float>(open_sky(widened(mesh_.vertices[i].position), normal, rays, nearest));
      }
  });
  ground_light_.resize(ground_side * ground_side);
  parallel_chunks(
      ground_light_.size(), threads, ground_side, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t i = begin; i < end; ++i) {
          const auto place = [](std::size_t at) { return from_map((2 * double(at) + 1) / ground_side - 1); };
          const Vec3 at{place(i % ground_side), ground_ - 1e-3, place(i / ground_side)};
          ground_light_[i] = static_cast<float>(open_sky(at, {0, 1, 0}, ground_rays, 0));
        }
      });
}

// Cuts the triangles of a node in two halves along the side in which their middles lie farthest apart.
void MeshShape::build(std::vector<std::uint32_t>& order, std::size_t first, std::size_t last) {
  Node node{{1e30f, 1e30f, 1e30f}, {-1e30f, -1e30f, -1e30f}};
  Point low = node.least, high = node.most;
  const auto middle = [&](std::uint32_t triangle, std::size_t axis) {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    return mesh_.vertices[a].position[axis] + mesh_.vertices[b].position[axis] +
           mesh_.vertices[c].position[axis];
  };
  for (std::size_t i = first; i < last; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const std::uint32_t corner : mesh_.triangles[order[i]]) {
        const float at = mesh_.vertices[corner].position[axis];
        node.least[axis] = std::min(node.least[axis], at);
        node.most[axis] = std::max(node.most[axis], at);
      }
      low[axis] = std::min(low[axis], middle(order[i], axis));
      high[axis] = std::max(high[axis], middle(order[i], axis));
    }
  node.first = static_cast<std::uint32_t>(first);
  node.count = static_cast<std::uint32_t>(last - first);
  const std::size_t self = nodes_.size();
  nodes_.push_back(node);
  if (last - first <= leaf) return;
  std::size_t widest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (high[axis] - low[axis] > high[widest] - low[widest]) widest = axis;
  const std::size_t half = first + (last - first) / 2;
  const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(half), at(last), [&](std::uint32_t a, std::uint32_t b) {
    const float of_a = middle(a, widest), of_b = middle(b, widest);
    return of_a != of_b ? of_a < of_b : a < b;
  });
  build(order, first, half);
  nodes_[self].second = static_cast<std::uint32_t>(nodes_.size());
  build(order, half, last);
}

// Moeller and Trumbore's test of a ray and a triangle, in a tree of boxes.
bool MeshShape::meets(const Vec3& from, const Vec3& way, double least, double most) const {
  Vec3 inverse{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    inverse[axis] = 1 / (std::abs(way[axis]) > 1e-12 ? way[axis] : 1e-12);
  const auto in_box = [&](const Node& node) {
    double enters = least, leaves = most;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double a = (double{node.least[axis]} - from[axis]) * inverse[axis],
                   b = (double{node.most[axis]} - from[axis]) * inverse[axis];
      enters = std::max(enters, std::min(a, b));
      leaves = std::min(leaves, std::max(a, b));
    }
    return enters <= leaves;
  };
  const auto in_triangle = [&](const Triangle& triangle) {
    const Vec3 along = widened(triangle.along), across = widened(triangle.across), p = cross(way, across);
    const double all = dot(along, p);
    if (std::abs(all) < 1e-14) return false;
    const Vec3 to = sum(from, scaled(widened(triangle.corner), -1));
    const double u = dot(to, p) / all;
    if (u < 0 || u > 1) return false;
    const Vec3 q = cross(to, along);
    const double v = dot(way, q) / all, t = dot(across, q) / all;
    return v >= 0 && u + v <= 1 && t > least && t < most;
  };
  std::array<std::uint32_t, 64> waiting;  // enough for halves of 2^32 triangles
  std::size_t count = 0;
  std::uint32_t at = 0;
  while (true) {
    const Node& node = nodes_[at];
    if (in_box(node)) {
      if (node.second != 0) {
        waiting[count++] = node.second;
        ++at;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        if (in_triangle(triangles_[i])) return true;
    }
    if (count == 0) return false;
    at = waiting[--count];
  }
}

// The share of rays to one side that leave the mesh. They lie on a spiral, as dense as the cosine to the normal. All
// points have the same ones, so that neighbours differ smoothly.
double MeshShape::open_sky(const Vec3& from, const Vec3& normal, std::size_t rays, double least) const {
  const Vec3 aside = std::abs(normal[1]) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
  Vec3 tangent = cross(aside, normal);
  tangent = scaled(tangent, 1 / std::max(std::sqrt(dot(tangent, tangent)), 1e-30));
  const Vec3 bitangent = cross(normal, tangent);
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  std::size_t open = 0;
  for (std::size_t i = 0; i < rays; ++i) {
    const double r2 = (double(i) + 0.5) / double(rays), r = std::sqrt(r2), phi = turn * double(i);
    const Vec3 way = sum(sum(scaled(tangent, r * math::cos(phi)), scaled(bitangent, r * math::sin(phi))),
                         scaled(normal, std::sqrt(1 - r2)));
    if (!meets(from, way, least, 1e9)) ++open;
  }
  return double(open) / double(rays);
}

double MeshShape::foot_reach(const Vec3& way) const {
  constexpr double near_ground = 0.05;
  double out = -1;
  for (const Mesh::Vertex& vertex : mesh_.vertices)
    if (double{vertex.position[1]} < ground_ + near_ground)
      out = std::max(out, dot(way, widened(vertex.position)));
  return out;
}

double MeshShape::ground_light(double x, double z) const {
  const auto texel = [](double at) {
    return std::clamp((to_map(at) + 1) / 2 * ground_side - 0.5, 0.0, double(ground_side - 1));
  };
  const double column = texel(x), row = texel(z);
  const auto left = std::min(static_cast<std::size_t>(column), std::size_t{ground_side - 2}),
             top = std::min(static_cast<std::size_t>(row), std::size_t{ground_side - 2});
  const auto at = [&](std::size_t i, std::size_t j) { return double{ground_light_[j * ground_side + i]}; };
  const double across = column - double(left);
  return std::lerp(std::lerp(at(left, top), at(left + 1, top), across),
                   std::lerp(at(left, top + 1), at(left + 1, top + 1), across), row - double(top));
}

bool MeshShape::hides(const Vec3& from, const Vec3& way, double length) const {
  return meets(from, way, nearest, length);
}

}  // namespace etak
