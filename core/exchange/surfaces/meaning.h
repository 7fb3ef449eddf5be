// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/color/rgb.h"
#include "core/exchange/surfaces/document.h"
#include "core/exchange/surfaces/models.h"

namespace etak {

/// What the surface is by its metalness (0.1 and below, 0.9 and above), or by its model: a conductor has n and k. An F0
/// that is stated by itself may be of either.
enum class SurfaceSort { metal, dielectric, between, either };

/// A surface of a document as a surface: what its inputs and the defaults of its model come to.
///   metalness   none: a picture or a node gives it, or the model has none
///   f0          at normal incidence, linear sRGB; none where a picture, a node or a film has a part in it, where it is neither
///               metal nor dielectric, and where no input states it
///   f82         at cos 1/7, where the model states the edge of a metal
///   f0_from, edge_from, metal_from, film_from   the inputs that state them, of the surface that was asked for; null: none
///   ior         of a dielectric, stated or the default
///   film_nm     thickness of a stated film
///   base_color, diffuse   as stated; none: not known
///   roughness   perceptual
///   transmission   share of the body that is clear; none: a picture or a node gives it
struct DocumentValues {
  SurfaceSort sort = SurfaceSort::either;
  std::optional<double> metalness;
  std::optional<LinearRgb> f0, f82, base_color, diffuse;
  std::optional<double> ior, film_nm, roughness, transmission;
  const SurfaceInput *f0_from = nullptr, *edge_from = nullptr, *metal_from = nullptr, *film_from = nullptr;
};

/// The values live as long as the surface.
///   from   OpenPBR 1.1 (F82 tint), Standard Surface 1.0.1 (Gulbrandsen's n and k), glTF 2.0 with KHR_materials_ior and
///          _specular, UsdPreviewSurface 2.6; n and k by Fresnel's equations
DocumentValues values_of(const DocumentSurface& surface);

}  // namespace etak
