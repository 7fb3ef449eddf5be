// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/atlas/layout.h"
#include "core/image/channels.h"
#include "core/pack/scene/gltf_pack.h"
#include "core/validate/files/scene_check.h"

namespace etak {

class PagePixels;

/// Puts the place of a finding about a scene's material on the pages that the material's texels lie on: of
/// each island that the rule found something in, the worst in front. A finding of texels that numbers replace
/// has no place on a page.
///   evidence   what was judged, in the material's own pictures
///   rects      of the material, each place once
///   name       of the material in the layout
///   returns    the rectangle that has the place; null: none
const AtlasRect* put_on_pages(Finding& finding, const Evidence& evidence, const std::vector<AtlasRect>& rects,
                              const std::string& name);

/// A scene that is packed, judged by what its pages hold: the texels of each material are taken back into the
/// frame of its own textures, where they are judged by the evidence that a check of the scene's files goes by
/// (which texels triangles read, what is metal), and what is found is put on the pages. What was found
/// differs from what a check of the scene's files finds only in what packing did.
class SceneOnPages {
 public:
  /// `door`, and what `packed` points to, outlive this.
  ///   label, scene_label   of the layout and of the scene that is packed, relative to the run's root
  SceneOnPages(PackedScene packed, std::string label, std::string scene_label, const PictureDoor& door);
  SceneOnPages(const SceneOnPages&) = delete;
  SceneOnPages& operator=(const SceneOnPages&) = delete;

  /// Forgets all pages: those of `layout` come now, from the first on.
  void start(const AtlasLayout& layout);

  /// Judges the materials whose texels are on this page and those before it, and not on later ones. After the
  /// last page (`page` is the number of pages, `pixels` null) those that are on none, and the textures'
  /// headers.
  void judge(int page, const PagePixels* pixels, const Settings& settings, unsigned threads);

  /// The path of the scene that is packed.
  const std::string& path() const { return of_scene_.path; }
  /// The findings since start().
  const CheckedFile& found() const { return file_; }

 private:
  /// A part of the texels of a look's material.
  struct Place {
    int material = 0;  // of the document
    AtlasRect rect;
  };
  struct Look {
    SceneLook look;
    bool packed = false;        // all of its materials are
    std::vector<Place> places;  // of all its materials, which may share texels
    int last_page = -1;         // -1: it is on none
    Pictures pictures;
  };
  using Codes = std::array<std::optional<std::uint8_t>, channel_count>;

  void begin(Look& look) const;
  void take_back(Look& look, int page, const PagePixels& pixels) const;
  void judge_look(Look& look, const Settings& settings, unsigned threads, CheckedFile& file);
  const PackedScene::Material* packed(int material) const;

  const PackedScene packed_;
  const std::string label_;
  const TargetFile of_scene_;
  SceneCheck check_;
  std::vector<Look> looks_;
  std::map<std::string, Codes> constants_;               // by the material's name in the layout
  std::vector<std::array<std::string, 2>> page_labels_;  // by page, and texture
  CheckedFile file_;
};

}  // namespace etak
