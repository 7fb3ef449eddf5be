// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/pack/decision.h"
#include "core/pack/scene/gltf_pack.h"
#include "core/pack/scene/scene_maps.h"

namespace etak {

/// The files of a scene's pages, each once, in the order in which they were first asked for.
struct ImageList {
  std::vector<std::string> names;
  std::vector<PictureHeader> headers;
  std::map<std::string, int> numbers;
  std::set<std::string> occluded;  // those whose red channel holds occlusion

  int number_of(const std::string& file, const PlannedPage& page, int channels);
};

/// What a scene's document is to hold in some forms, and the pictures that it names.
struct SceneOutput {
  GltfOutput gltf;
  ImageList images;
  Others others;

  /// The files and bytes that the pictures take.
  TextureTotals totals(const PackDecision& decision) const;

 private:
  TextureTotals file(std::size_t image, const PackDecision& decision) const;
};

/// Whether the packer writes this material or leaves it as it was.
bool is_written(const SceneRead& read, const SceneRead::Entry& entry, Others others);

/// Whether a material of these forms stays as it was because KHR_materials_pbrSpecularGlossiness may not stand beside other
/// extensions that it has.
bool stays_for_its_extensions(const GltfMaterial& material, const std::vector<GltfForm>& forms);

/// What becomes of other materials in these forms: where the smallest is asked for, they stay as they are beside
/// plain ones in metal-rough form.
Others others_in(const SceneRead& read, const std::vector<GltfForm>& forms);

SceneOutput scene_output(const SceneRead& read, const SceneMaps& maps, const std::vector<GltfForm>& forms,
                         const PackDecision& decision);

}  // namespace etak
