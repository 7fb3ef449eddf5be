// SPDX-License-Identifier: Apache-2.0
#include "core/validate/target.h"

#include <array>
#include <utility>

namespace etak {

namespace {

constexpr std::array<std::pair<FileRole, std::string_view>, 11> roles{{{FileRole::diffuse_alpha, "diffuse"},
                                                                       {FileRole::specular_gloss, "specular"},
                                                                       {FileRole::f0_only, "f0"},
                                                                       {FileRole::base_color, "base-color"},
                                                                       {FileRole::metal_rough, "metal-rough"},
                                                                       {FileRole::metallic, "metallic"},
                                                                       {FileRole::roughness, "roughness"},
                                                                       {FileRole::layout, "layout"},
                                                                       {FileRole::scene, "scene"},
                                                                       {FileRole::material, "material"},
                                                                       {FileRole::spectrum, "spectrum"}}};

}  // namespace

std::string_view name(FileRole role) {
  for (const auto& [value, text] : roles)
    if (value == role) return text;
  return "";
}

std::optional<FileRole> role_named(std::string_view text) {
  for (const auto& [value, row] : roles)
    if (row == text) return value;
  return std::nullopt;
}

PictureRows PicturesInMemory::rows() const {
  const auto of = [](const Image8* image) { return image == nullptr ? nullptr : rows_of(*image); };
  return {of(a), of(b), of(metallic)};
}

}  // namespace etak
