// SPDX-License-Identifier: Apache-2.0
#include "core/judge/target.h"

#include <array>
#include <utility>

namespace etak {

namespace {

constexpr auto roles =
    std::to_array<std::pair<FileRole, std::string_view>>({{FileRole::diffuse_alpha, "diffuse"},
                                                          {FileRole::specular_gloss, "specular"},
                                                          {FileRole::f0_only, "f0"},
                                                          {FileRole::base_color, "base-color"},
                                                          {FileRole::metal_rough, "metal-rough"},
                                                          {FileRole::metallic, "metallic"},
                                                          {FileRole::roughness, "roughness"},
                                                          {FileRole::gloss, "gloss"},
                                                          {FileRole::layout, "layout"},
                                                          {FileRole::scene, "scene"},
                                                          {FileRole::material, "material"},
                                                          {FileRole::spectrum, "spectrum"},
                                                          {FileRole::normal, "normal"},
                                                          {FileRole::height, "height"},
                                                          {FileRole::occlusion, "occlusion"},
                                                          {FileRole::emissive, "emissive"},
                                                          {FileRole::opacity, "opacity"},
                                                          {FileRole::other, "other"},
                                                          {FileRole::ignored, "ignore"}});

std::optional<FileRole> role_in(std::string_view text, bool (*wanted)(FileRole)) {
  for (const auto& [value, row] : roles)
    if (row == text && wanted(value)) return value;
  return std::nullopt;
}

}  // namespace

std::string_view name(FileRole role) {
  for (const auto& [value, text] : roles)
    if (value == role) return text;
  return "";
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

std::optional<FileRole> role_named(std::string_view text) {
  return role_in(text, [](FileRole role) { return role <= FileRole::spectrum && role != FileRole::gloss; });
}

std::optional<FileRole> picture_role_named(std::string_view text) {
  return role_in(text, [](FileRole role) { return role <= FileRole::gloss || role > FileRole::spectrum; });
}

bool is_judged(FileRole role) {
  return role <= FileRole::gloss;
}

bool is_map(FileRole role) {
  return role >= FileRole::normal && role <= FileRole::emissive;
}

bool is_picture(FileRole role) {
  return is_judged(role) || role > FileRole::spectrum;
}

std::string CheckTarget::own_label() const {
  return !label.empty() ? label : files.empty() ? "" : files.front().label;
}

const TargetFile* CheckTarget::with_role(std::initializer_list<FileRole> wanted) const {
  for (const FileRole role : wanted)
    for (const TargetFile& file : files)
      if (file.role == role) return &file;
  return nullptr;
}

PictureRows PicturesInMemory::rows() const {
  const auto of = [](const Image8* image) { return image == nullptr ? nullptr : rows_of(*image); };
  return {of(a), of(b), of(metallic)};
}

}  // namespace etak
