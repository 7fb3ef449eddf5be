// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/atlas/pack/pack.h"
#include "core/atlas/pack/scene/conversion_cost.h"
#include "core/atlas/pack/scene/gltf_pack.h"
#include "core/atlas/pack/scene/kept_pictures.h"
#include "core/atlas/pack/scene/scene_maps.h"
#include "core/atlas/texels/page_memory.h"
#include "core/scene/uv_use.h"

namespace etak {

/// What gltf_pack.cpp reads of a scene, and scene_output.cpp writes of it.
struct ScenePack::State {
  struct Entry {
    int material = -1;  // in the document
    std::optional<TexelUse> use;
    std::shared_ptr<const MaterialPair> pair;
    Image8 metallic;     // for a check that asks for it
    bool tiles = false;  // on a page of its own
    bool exact = true;   // as diffuse and F0 the material is what it was, but for the rounding of codes
    double clamped = 0;  // percent of the texels whose gloss was brought back to 0..1
    std::vector<std::string> remarks;  // from the thread that learned it
  };

  /// A picture that is written as less than its file.
  struct LightPicture {
    std::optional<OneTexel> texel;  // none: its file, of what that says of texels alone
    TextureTotals totals;
  };

  GltfScene scene;
  std::optional<MaterialUses> uses;  // of the scene, once that is read
  const PackOptions& options;
  GlossForm gloss;
  std::vector<Entry> entries;  // beside the inputs
  PackInputs inputs;
  std::vector<std::string> remarks;
  std::map<int, Image8> pictures;
  std::map<int, int> pictures_awaited;  // by image: lookups in learn() that are still to come
  std::mutex pictures_lock;
  std::map<int, PictureHeader> headers;  // by image, of those that were asked for
  std::vector<int> stands_for;           // by image: the first of the same bytes
  std::map<int, LightPicture> light;     // by image that stands for itself, where its file can do with less
  // Of the decision that is being written.
  std::vector<GltfForm> forms;
  SceneMaps maps;
  std::vector<FormCost> costs;
  GltfOutput output;  // `taken` is not known yet
  std::set<std::string> written;

  explicit State(const PackOptions& options);

  // Pictures of the document.
  std::string_view bytes_of(const PictureFile& image, FileBytes& file) const;
  Image8 decoded(int image) const;
  const PictureHeader& header(int image);
  const Image8& picture(int image);  // kept until those who asked have given it back
  void await_pictures(const GltfMaterial& m);
  void give_back_pictures(const GltfMaterial& m);
  FloatPair floats_of(int material) const;

  // Reading.
  std::string name_of(const GltfMaterial& m, std::set<std::string>& names) const;
  void add_material(const GltfMaterial& m, std::set<std::string>& names);
  void learn(std::size_t entry);
  static void tell_conversion(const PackInput& in, const GltfMaterial& m, Entry& entry,
                              const ConversionCost& cost);
  void scale_of(PackInput& in, const Entry& entry, const GltfTexture& lead);
  void normals_of(PackInput& in, const GltfMaterial& m, Entry& entry, const GltfTexture& lead);
  void use_of(PackInput& in, Entry& entry, const GltfTexture& lead);

  void find_light_pictures();

  // Writing.
  bool writes_scene() const;
  TextureTotals image_totals(int image);
  /// What the image takes beside the written scene, where no page has it: one texel may stand for it.
  TextureTotals kept_totals(int image);
  /// Of images of the document, each file once.
  TextureTotals input_totals(const std::vector<bool>& images);
  TextureTotals kept_totals(const std::vector<bool>& images);
  /// Images that are written as less than their files, beside the pages.
  std::vector<int> kept_light() const;
  void tell_light_pictures(std::vector<std::string>& remarks);
  /// What becomes of other materials in these forms: where the smallest is asked for, they stay as they are
  /// beside plain ones in metal-rough form.
  Others others_in(const std::vector<GltfForm>& of_forms) const;
  /// Of all textures that scene.gltf would read, with these on its pages.
  TextureTotals scene_totals(const std::vector<GltfForm>& of_forms, const SceneMaps& placed,
                             const PackDecision& decision);
  /// Which of the scene's other textures may be placed.
  SceneMaps placeable(const PackDecision& decision, Others others);
  /// By Others.
  using MapsOfOthers = std::array<SceneMaps, 2>;
  MapsOfOthers placeable(const PackDecision& decision);
  /// Those of `maps` that are placed in these forms.
  SceneMaps placed(const MapsOfOthers& maps, const std::vector<GltfForm>& of_forms,
                   const PackDecision& decision, const TextureWeight& weight);
  /// The forms one of which is written.
  std::vector<GltfForm> forms_to_weigh(const MapsOfOthers& maps, const PackDecision& decision) const;
  bool is_exact(GltfForm form, const MapsOfOthers& maps, const PackDecision& decision) const;
};

}  // namespace etak
