// SPDX-License-Identifier: Apache-2.0
#include "core/light/area_lobes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/color/gloss.h"
#include "core/math/functions.h"

namespace etak {
namespace {

constexpr AreaLobe fits[] = {
#include "area_lobe_rows.inc"
};
static_assert(std::size(fits) == std::size_t{4} * area_lobe_rows * area_lobe_columns);
// Below this F0 a lobe's F rises so far towards grazing angles that it has a fit of its own.
constexpr double most_dielectric = 0.12;
constexpr double least_roughness = 0.1;  // of the first row; below it the lobe only grows narrower

AreaLobe mixed(const AreaLobe& p, const AreaLobe& q, double share) {
  const auto mix = [share](double x, double y) { return x * (1 - share) + y * share; };
  return {mix(p.a, q.a), mix(p.b, q.b), mix(p.d, q.d), mix(p.e, q.e), mix(p.cosine, q.cosine)};
}

Vec3 crossed(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The width of a model's lobe as Beckmann's or GGX's alpha.
double width_of(const Model& model, const std::vector<double>& values) {
  std::size_t at = 0;
  for (const Parameter& each : model.parameters) {
    const double value = values[at];
    if (each.role == Role::gloss) return alpha_of_gloss(value);
    if (each.role == Role::alpha) return value;
    // A lobe around the mirrored direction turns twice as far as the half vector: four times the exponent.
    if (each.role == Role::exponent) return alpha_of_exponent(model.id == "phong" ? 4 * value : value);
    // The half vector where ABC falls to a half, as GGX has it.
    if (each.name == "a1" && at + 1 < values.size())
      return std::sqrt(2 / std::max(value, 1e-6) * (math::exp2(1 / std::max(values[at + 1], 0.1)) - 1) /
                       (std::numbers::sqrt2 - 1));
    at += each.color ? 3 : 1;
  }
  return 1;
}

// A row of the table for any width, with d and e divided by it.
std::array<AreaLobe, area_lobe_columns> lobes_of(int family, double alpha) {
  const double held = std::max(alpha, area_lobe_alpha(0));
  const double at = (std::sqrt(held) - least_roughness) / (1 - least_roughness) * (area_lobe_rows - 1);
  const int row = std::clamp(static_cast<int>(at), 0, area_lobe_rows - 2);
  const double share = (held - area_lobe_alpha(row)) / (area_lobe_alpha(row + 1) - area_lobe_alpha(row));
  const AreaLobe* first = fits + (family * area_lobe_rows + row) * area_lobe_columns;
  std::array<AreaLobe, area_lobe_columns> out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = mixed(first[i], first[i + area_lobe_columns], share);
  return out;
}

}  // namespace

double area_lobe_alpha(int row) {
  const double roughness = least_roughness + (1 - least_roughness) * row / (area_lobe_rows - 1);
  return roughness * roughness;
}

double area_lobe_cosine(int column) {
  const double u = double(column) / (area_lobe_columns - 1);
  return std::max(1 - u * u, 0.02);
}

AreaFit area_fit(const Model& model, const std::vector<double>& values) {
  const std::string_view id = model.id, d = model.distribution != nullptr ? model.distribution->id : "";
  const double alpha = std::clamp(width_of(model, values), 1e-4, 1.0);
  if (d == "ggx") {
    double f0[3];
    model.fresnel->f64({0, 0, 1, 0, 0, 1}, values.data(), f0);
    return {(f0[0] + f0[1] + f0[2]) / 3 < most_dielectric ? 3 : 0, alpha, true};
  }
  if (d.starts_with("beckmann") || id.starts_with("cook-torrance") || id == "schueler-full")
    return {1, alpha, true};
  if (d == "phong" || d == "schueler" || id.starts_with("schueler")) return {2, alpha, true};
  return {d == "abc" || d.starts_with("abc") || d == "sgd" ? 0 : 2, alpha, false};
}

std::string_view area_family_name(int family) {
  constexpr std::string_view names[] = {"GGX", "Beckmann", "Phong", "GGX"};
  return names[family];
}

AreaTable area_table(const Model& model, const std::vector<double>& values, bool gloss_of_texture) {
  AreaTable out{area_fit(model, values), {}};
  constexpr int textured_rows = 5;
  const int rows = gloss_of_texture ? textured_rows : 1;
  for (int row = 0; row < rows; ++row) {
    auto& lobes = out.rows.emplace_back(
        lobes_of(out.fit.family, gloss_of_texture ? alpha_of_gloss(row / (rows - 1.0)) : out.fit.alpha));
    // A formula for both parts has a lobe as wide as the hemisphere besides its narrow one.
    if (model.kind == ModelKind::combined)
      for (AreaLobe& each : lobes) each.cosine = std::max(each.cosine, 0.5);
  }
  return out;
}

AreaLobe AreaTable::at(double nv, double gloss) const {
  const double u = std::sqrt(1 - std::clamp(nv, 0.0, 1.0)) * (area_lobe_columns - 1);
  const auto column = std::min(static_cast<std::size_t>(u), std::size_t{area_lobe_columns - 2});
  const double share = u - double(column);
  const auto in_row = [&](std::size_t row) { return mixed(rows[row][column], rows[row][column + 1], share); };
  double alpha = fit.alpha;
  AreaLobe out;
  if (rows.size() == 1) {
    out = in_row(0);
  } else {
    const double last = double(rows.size() - 1), held = std::clamp(gloss, 0.0, 1.0);
    const auto row = std::min(static_cast<std::size_t>(held * last), rows.size() - 2);
    const double first = alpha_of_gloss(double(row) / last), next = alpha_of_gloss(double(row + 1) / last);
    alpha = alpha_of_gloss(held);
    out = mixed(in_row(row), in_row(row + 1), (alpha - first) / (next - first));
  }
  out.d *= alpha;
  out.e *= alpha;
  return out;
}

AreaAxes area_axes(const Light& light) {
  Vec3 right = crossed(light.direction, light.up);
  if (dot(right, right) < 1e-12)
    right = crossed(light.direction, std::abs(light.direction[2]) < 0.9 ? Vec3{0, 0, 1} : Vec3{0, 1, 0});
  right = scaled(right, 1 / std::sqrt(dot(right, right)));
  return {scaled(right, light.width / 2), scaled(crossed(right, light.direction), light.height / 2)};
}

Vec3 area_place(const Light& light, double x, double y) {
  const AreaAxes axes = area_axes(light);
  const bool round = light.kind == LightKind::disc;
  const double reach = std::sqrt(x), turn = 2 * std::numbers::pi * y;
  const double right = round ? reach * math::cos(turn) : 2 * x - 1,
               up = round ? reach * math::sin(turn) : 2 * y - 1;
  Vec3 out = light.position;
  for (std::size_t i = 0; i < 3; ++i) out[i] += axes.right[i] * right + axes.up[i] * up;
  return out;
}

double area_density(const Light& light, const Vec3& position, const Vec3& direction) {
  const AreaAxes axes = area_axes(light);
  Vec3 way{};
  for (std::size_t i = 0; i < 3; ++i) way[i] = light.position[i] - position[i];
  const double facing = -dot(direction, light.direction),
               r = facing > 0 ? -dot(way, light.direction) / facing : 0;
  if (r <= 0) return 0;
  Vec3 at{};
  for (std::size_t i = 0; i < 3; ++i) at[i] = direction[i] * r - way[i];
  const double x = dot(at, axes.right) / dot(axes.right, axes.right),
               y = dot(at, axes.up) / dot(axes.up, axes.up);
  const bool round = light.kind == LightKind::disc;
  // A place of area_place() counts as met in spite of rounding.
  if (round ? x * x + y * y > 1 + 1e-9 : std::max(std::abs(x), std::abs(y)) > 1 + 1e-9) return 0;
  return r * r / (facing * light.width * light.height * (round ? std::numbers::pi / 4 : 1));
}

AreaCut area_cut(const Light& light) {
  AreaCut out;
  const double half = math::hypot(light.width, light.height) / (2 * std::numbers::sqrt2),
               away = std::sqrt(dot(light.position, light.position));
  const double degrees = 2 * math::atan2(half, away) * 180 / std::numbers::pi;
  if (light.kind == LightKind::disc) {
    constexpr int sides = 16;
    const double step = 2 * std::numbers::pi / sides, radius = std::sqrt(step / math::sin(step));
    const auto rim = [&](int i, double share) {
      return std::array{share * radius * math::cos(i * step), share * radius * math::sin(i * step)};
    };
    const double inner = degrees < 25 ? 1 : 0.55;
    for (int i = 0; i < sides; i += 2)
      out.insert(out.end(), {{0, 0}, rim(i, inner), rim(i + 1, inner), rim(i + 2, inner)});
    for (int i = 0; i < sides && inner < 1; ++i)
      out.insert(out.end(), {rim(i, inner), rim(i, 1), rim(i + 1, 1), rim(i + 1, inner)});
    return out;
  }
  const int side = degrees < 8 ? 1 : degrees < 15 ? 2 : degrees < 35 ? 3 : degrees < 70 ? 4 : 5;
  const auto corner = [side](int i, int j) { return std::array{2.0 * i / side - 1, 2.0 * j / side - 1}; };
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i)
      out.insert(out.end(), {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
  return out;
}

}  // namespace etak
