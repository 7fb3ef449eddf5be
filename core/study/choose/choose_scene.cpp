// SPDX-License-Identifier: Apache-2.0
#include "core/study/choose/choose_scene.h"

#include <algorithm>

#include "core/atlas/manifest.h"
#include "core/atlas/sources/pictures.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/files/paths.h"
#include "core/material/find.h"
#include "core/pack/scene/scene_output.h"
#include "core/scene/gltf.h"

namespace etak {
namespace {

constexpr int most_side = 2048;

// The middle of a box, at most most_side texels on a side.
PixelBox window(PixelBox box) {
  const auto cut = [](int& first, int& size) {
    first += std::max(0, size - most_side) / 2;
    size = std::min(size, most_side);
  };
  cut(box.x, box.width);
  cut(box.y, box.height);
  return box;
}

// Adds the spectrum where F0 comes from a material of the library. Under another medium than air only the
// colour of F0 is used.
void add_spectrum(const ManifestMaterial& m, const MaterialLibrary& library, ChooseSubject& out) {
  const auto* source = m.specular ? std::get_if<LibrarySource>(&*m.specular) : nullptr;
  if (source == nullptr || !source->outside.empty()) return;
  const FoundDataset found = find_dataset(library, source->material, source->dataset, {});
  if (std::holds_alternative<Reflectance>(found.chosen().optics)) return;
  out.dataset = found.chosen();
  out.library = out.stack() ? out.stack()->text : found.material.id + "/" + found.chosen().id;
  out.base = film_base(found.material.material_class);
}

}  // namespace

bool names_scene(const std::string& path) {
  return is_gltf_file(path) || path.ends_with(".json") || is_folder(path) || is_pipe_input(path);
}

std::vector<ChooseSubject> scene_subjects(const std::string& path, const PackOptions& options,
                                          const MaterialLibrary& library, std::vector<std::string>& remarks) {
  PackInputs inputs;
  AtlasManifest manifest;
  std::unique_ptr<const SceneRead> scene;
  if (is_gltf_file(path)) {
    scene = read_scene(path, options);
    inputs = scene->inputs;
    add_remarks(*scene, {}, remarks);
  } else {
    std::string pattern;
    manifest = is_folder(path) ? manifest_in_folder(path, options, remarks, pattern)
                               : parse_manifest(read_file(path), path);
    inputs = resolve_manifest(manifest, library, options.input.pictures);
  }
  remarks.insert(remarks.end(), inputs.remarks.begin(), inputs.remarks.end());
  std::vector<ChooseSubject> out;
  for (std::size_t i = 0; i < inputs.materials.size(); ++i) {
    const PackInput& in = inputs.materials[i];
    if (!in.facts.reached) continue;
    ChooseSubject subject;
    subject.name = in.name;
    if (!scene) add_spectrum(manifest.materials[i], library, subject);
    subject.mipmaps = !scene || scene->sampled_levels(0) != 1;
    const MaterialPair pair = load_pair(in, remarks);
    const PixelBox box = window(in.facts.crop);
    if (box != in.facts.crop)
      remarks.push_back(in.name + ": of its texture the middle " + std::to_string(box.width) + " x " +
                        std::to_string(box.height) + " texels were looked at");
    subject.texture = std::make_shared<const TexelChain>(view(pair.diffuse_alpha), view(pair.specular_gloss),
                                                         box, inputs.gloss);
    out.push_back(std::move(subject));
  }
  return out;
}

}  // namespace etak
