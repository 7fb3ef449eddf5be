// SPDX-License-Identifier: Apache-2.0
#include "core/maps/file_role.h"

#include <algorithm>

namespace etak {

namespace {

constexpr RoleTraits roles[] = {
    {FileRole::diffuse_alpha, "diffuse", RoleKind::pair},
    {FileRole::specular_gloss, "specular", RoleKind::pair},
    {FileRole::f0_only, "f0", RoleKind::pair},
    {FileRole::base_color, "base-color", RoleKind::metal_rough},
    {FileRole::metal_rough, "metal-rough", RoleKind::metal_rough, true},
    {FileRole::metallic, "metallic", RoleKind::metal_rough, true},
    {FileRole::roughness, "roughness", RoleKind::metal_rough, true},
    {FileRole::gloss, "gloss", RoleKind::metal_rough, true},
    {FileRole::layout, "layout", RoleKind::document},
    {FileRole::scene, "scene", RoleKind::document},
    {FileRole::material, "material", RoleKind::document},
    {FileRole::spectrum, "spectrum", RoleKind::document},
    {FileRole::surfaces, "surfaces", RoleKind::document},
    {FileRole::normal, "normal", RoleKind::map},
    {FileRole::height, "height", RoleKind::map},
    {FileRole::occlusion, "occlusion", RoleKind::map},
    {FileRole::emissive, "emissive", RoleKind::map},
    {FileRole::opacity, "opacity", RoleKind::named},
    {FileRole::other, "other", RoleKind::named},
    {FileRole::ignored, "ignore", RoleKind::named},
};

}  // namespace

const RoleTraits& traits(FileRole role) {
  return *std::ranges::find(roles, role, &RoleTraits::role);
}

std::string_view name(FileRole role) {
  return traits(role).name;
}

std::optional<FileRole> role_named(std::string_view text) {
  for (const RoleTraits& each : roles)
    if (each.name == text && (is_judged(each.role) || each.kind == RoleKind::document))
      return each.role == FileRole::gloss ? std::nullopt : std::optional(each.role);
  return std::nullopt;
}

std::optional<FileRole> picture_role_named(std::string_view text) {
  for (const RoleTraits& each : roles)
    if (each.name == text && is_picture(each.role)) return each.role;
  return std::nullopt;
}

bool is_judged(FileRole role) {
  const RoleKind kind = traits(role).kind;
  return kind == RoleKind::pair || kind == RoleKind::metal_rough;
}

bool is_map(FileRole role) {
  return traits(role).kind == RoleKind::map;
}

bool is_picture(FileRole role) {
  return traits(role).kind != RoleKind::document;
}

std::string_view name(GreenAxis green) {
  switch (green) {
    case GreenAxis::opengl:
      return "opengl";
    case GreenAxis::directx:
      return "directx";
    case GreenAxis::unsaid:
      break;
  }
  return "";
}

std::optional<GreenAxis> green_named(std::string_view text) {
  for (const GreenAxis green : {GreenAxis::opengl, GreenAxis::directx})
    if (text == name(green)) return green;
  return std::nullopt;
}

}  // namespace etak
