// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/atlas/outputs.h"
#include "core/base/files/output_folder.h"
#include "core/pack/scene/gltf_pack.h"
#include "core/pack/scene/scene_maps.h"

namespace etak {

/// The contents of scene.gltf. Empty where none is written.
struct SceneChoice {
  std::vector<GltfForm> forms;
  SceneMaps maps;               // the scene's other textures that lie on the pages
  std::vector<FormCost> costs;  // what the textures that scene.gltf reads would take in each form
  GltfOutput output;            // `taken` is not known yet
  TextureTotals totals;         // of what it reads; files where these were weighed
  double weight = 0;            // of the same
};

/// A page that is whole in memory.
struct WholePage {
  int number = 0;
  const PagePixels& pixels;
  const PackDecision& decision;
  const WriteOptions& options;
};

/// Adds to the decision's sizes, which are there, what the scene's pictures of a page would take as files.
void weigh_page(const SceneRead& read, int page, const PagePixels& pixels, PackDecision& decision,
                const WriteOptions& options);

/// Which of the scene's other textures are placed on the pages, what each form would take, and where the
/// smallest is asked for, which it is. Before pages are written, of the decision they are written by.
SceneChoice choose_pictures(const SceneRead& read, const PackDecision& decision, PackGoal goal);

/// What other goals than the one that was asked for would make of these decisions, whose files were weighed.
std::vector<GoalCost> other_goals(const SceneRead& read, const std::vector<PackDecision>& ways);

/// Writes the pictures of a page that the scene reads beside the page's two textures; returns their names.
std::set<std::string> write_page(OutputFolder& folder, const WholePage& page, const SceneRead& read,
                                 const SceneChoice& choice);

/// Writes scene.gltf, its buffer and the files that it refers to; returns their names and those of `pictures`.
///   pictures   that write_page() wrote
std::vector<std::string> write_scene(OutputFolder& folder, const AtlasLayout& layout, const SceneRead& read,
                                     const SceneChoice& choice, const std::set<std::string>& pictures);

/// Adds the remarks about the scene; about its kept pictures only where something was chosen.
void add_remarks(const SceneRead& read, const SceneChoice& choice, std::vector<std::string>& remarks);

}  // namespace etak
