// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/exchange/export_surface.h"

namespace etak {

/// Pictures in place of numbers of a surface, as files beside the document. Where a name is empty, the number
/// holds.
///   base_color, emission_color                               sRGB
///   base_metalness, specular_roughness, geometry_opacity     one channel, linear
///   geometry_normal                                          tangent space, green up
///   scale   how often all of them repeat over u and v, from the top left corner on
struct MaterialXPictures {
  std::string base_color, base_metalness, specular_roughness, geometry_opacity, emission_color{},
      geometry_normal{};
  std::array<double, 2> scale{1, 1};
};

/// An id as a name for documents: letters, digits and '_', no digit first.
std::string identifier(const std::string& id);

/// A text as a comment of its own line.
std::string material_x_comment(const std::string& text);

/// A MaterialX 1.39 document with one surfacematerial of one open_pbr_surface (OpenPBR 1.1) per surface: a
/// metal is base_color F0 with specular_color as its F82 tint, a dielectric base_color with specular_ior.
/// Nodes are named by the surfaces' ids, made valid and unique. What had to be changed also stands there as a
/// comment.
///   surfaces   valid, of srgb (lin_rec709), acescg or display_p3 (lin_displayp3); each colour states its own
///              space, and the document that of the first. Throws Error for an empty list, for an invalid
///              surface, and for a surface of another space
///   changes    one list per surface
///   pictures   one per surface, or none at all: each becomes an image node
std::string material_x(std::span<const ExportSurface> surfaces, Fit fit, std::vector<Changes>& changes,
                       std::span<const MaterialXPictures> pictures = {});

}  // namespace etak
