// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/files/output_folder.h"
#include "core/pack/blocks/compress_options.h"
#include "core/pack/decision.h"
#include "core/pack/earlier.h"
#include "core/pack/scene/scene_output.h"
#include "core/pack/source.h"
#include "core/pack/stages.h"

namespace etak {

/// The pages of an atlas.
struct MadePages {
  std::unique_ptr<OutputFolder> folder;  // with the files of all pages, not in place yet; null in a dry run
  bool good = true;                      // what the check says of all pages
  SceneChoice scene;                     // of a scene
  std::set<std::string> scene_pictures;  // files that the scene reads beside the pages' textures
  std::vector<BlockLevel> blocks;        // what compression did
  std::vector<BlockPicture> block_pictures;
};

/// The way to pack whose textures weigh least: of a scene, where files are weighed (weighs_files()), by what scene.gltf
/// reads, and where that is equal by the area of the pages. All of its pages are
/// composed and their pictures compressed for that; the decision keeps the sizes.
///   ways   as decide() gives them
/// Throws Error and PackCancelled.
PackDecision lightest(const PackOptions& options, PackSource& source, std::vector<PackDecision> ways,
                      PackStages& stages);

/// Composes, checks and writes every page of a decision. None where what the texels taught changes the
/// layout: then nothing was kept.
///   source     its facts, and what the decision leaves out, get what the texels taught
///   learned    by material; gets what the texels taught
/// Throws Error and PackCancelled.
std::optional<MadePages> make_pages(const PackOptions& options, PackSource& source,
                                    const EarlierAtlas& earlier, PackDecision& decision,
                                    std::vector<Learned>& learned, PackStages& stages);

}  // namespace etak
