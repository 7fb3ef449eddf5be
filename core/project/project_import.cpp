// SPDX-License-Identifier: Apache-2.0
#include "core/project/project_import.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/exchange/color_parts.h"
#include "core/exchange/surfaces/meaning.h"
#include "core/image/picture_endings.h"
#include "core/scene/gltf_surfaces.h"
#include "core/scene/material_texels.h"

namespace etak {
namespace {

bool is_scene(const std::string& path) {
  const std::string ending = path_ending(path);
  return ending == "gltf" || ending == "glb";
}

LinearRgb rgb(const Vec3& c) {
  return {c[0], c[1], c[2]};
}

LinearRgb within_one(const LinearRgb& c) {
  return {std::clamp(c.r, 0.0, 1.0), std::clamp(c.g, 0.0, 1.0), std::clamp(c.b, 0.0, 1.0)};
}

ProjectMaterial project_material_of(const DocumentSurface& surface, std::vector<std::string>& remarks) {
  const DocumentValues values = values_of(surface);
  ProjectMaterial out;
  out.name = printable(surface.name, 60);
  if (out.name.empty()) out.name = "material";
  out.alpha_mode = AlphaMode::opaque;
  const bool metal = values.sort == SurfaceSort::metal;
  if (values.f0) out.specular = *values.f0;
  const double opaque = 1 - std::clamp(values.transmission.value_or(0), 0.0, 1.0);
  const LinearRgb body = scaled(
      values.diffuse ? *values.diffuse : values.base_color.value_or(LinearRgb{0.18, 0.18, 0.18}), opaque);
  if (!metal && (values.diffuse || values.sort == SurfaceSort::dielectric))
    out.diffuse =
        within_one(rgb(converted({vec(within_one(body)), vec(within_one(out.specular))},
                                 DiffuseConvention::reduced_when_shading, DiffuseConvention::as_it_is)
                           .diffuse));
  if (values.roughness) out.gloss = Gloss::of_roughness(std::clamp(*values.roughness, 0.0, 1.0));
  const auto tell = [&](const std::string& what) { remarks.push_back(out.name + ": " + what); };
  for (const SurfaceInput& input : surface.inputs)
    if (const ModelInput* of = model_input(surface.model, input.name);
        of != nullptr && of->meaning != Meaning::none && input.values.empty())
      tell(printable(input.name) + " is given by a picture or a node, which is not imported");
  if (values.film_nm && *values.film_nm > 0) tell("its film is not imported");
  if (values.sort == SurfaceSort::between)
    tell("its metalness is neither 0 nor 1; it is imported as a dielectric of F0 0.04");
  return out;
}

}  // namespace

bool holds_surfaces(const std::string& path) {
  const std::string ending = path_ending(path);
  return ending == "mtlx" || ending == "usda" || is_scene(path);
}

std::vector<ProjectMaterial> imported_materials(const std::string& path, std::vector<std::string>& remarks) {
  const std::vector<DocumentSurface> surfaces =
      is_scene(path) ? surfaces_of_gltf(read_gltf(path, {})) : surfaces_of_document(path, path);
  if (surfaces.empty()) throw Error::at(path, "no material", "one of a model that etak validate judges");
  std::vector<ProjectMaterial> out;
  for (const DocumentSurface& each : surfaces) out.push_back(project_material_of(each, remarks));
  return out;
}

}  // namespace etak
