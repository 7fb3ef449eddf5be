// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/atlas/layout.h"
#include "core/scene/gltf.h"

namespace etak {

class OutputFolder;
struct PackOptions;
struct PackResult;
struct PackSource;

/// What texture files take.
///   disk   bytes of the files
///   gpu    bytes uncompressed with all mips (core/image/texture_bytes.h), but for textures that are in blocks; of a
///          texture that lies there in several formats, of one
struct TextureTotals {
  std::size_t files = 0;
  std::uint64_t disk = 0, gpu = 0;

  void add(const TextureTotals& other) {
    files += other.files;
    disk += other.disk;
    gpu += other.gpu;
  }
  friend bool operator==(const TextureTotals&, const TextureTotals&) = default;
};

/// What is weighed where the same can be written in several ways.
///   gpu    bytes on a GPU
///   disk   bytes of the files
///   both   the two as shares of what the input takes, added
///   one_page   nothing: one pair of textures holds all materials (core/pack/one_page.h)
///   within   the two, and more of either than the input takes only where nothing takes less: the GPU counts
///            first. Of the input what takes no page to save does not count: copies, pictures of one colour
enum class PackGoal { gpu, disk, both, one_page, within };

/// "gpu", "disk", "both", "one-page" or "auto".
constexpr const char* name(PackGoal goal) {
  constexpr std::array names{"gpu", "disk", "both", "one-page", "auto"};
  return names[static_cast<std::size_t>(goal)];
}

/// Whether shares of what the input takes are weighed.
constexpr bool is_by_shares(PackGoal goal) {
  return goal == PackGoal::both || goal == PackGoal::within;
}

/// Whether files are compressed to be weighed.
constexpr bool weighs_disk(PackGoal goal) {
  return goal == PackGoal::disk || is_by_shares(goal);
}

/// What textures weigh: of two ways to write them the lighter one is taken.
class TextureWeight {
 public:
  ///   input   all textures that were read
  TextureWeight(PackGoal goal, const TextureTotals& input) : goal_(goal), input_(input) {}

  double operator()(const TextureTotals& totals) const {
    if (!is_by_shares(goal_)) return static_cast<double>(goal_ == PackGoal::gpu ? totals.gpu : totals.disk);
    const double disk = share(totals.disk, input_.disk), gpu = share(totals.gpu, input_.gpu);
    const double beyond =
        goal_ == PackGoal::both ? 0 : (gpu > 1 ? 1e6 * gpu : 0) + (disk > 1 ? 1e3 * disk : 0);
    return disk + gpu + beyond;
  }

 private:
  static double share(std::uint64_t part, std::uint64_t whole) {
    return static_cast<double>(part) / static_cast<double>(std::max<std::uint64_t>(whole, 1));
  }

  PackGoal goal_;
  TextureTotals input_;
};

/// The textures of one role: "base colour", "normal", "diffuse and alpha", "roughness of the scene", ...
struct RoleTotals {
  std::string role;
  bool material = false;  // colour, metal, roughness, F0 or gloss: what the pair holds
  TextureTotals totals;
  friend bool operator==(const RoleTotals&, const RoleTotals&) = default;
};

/// All textures of the input and of the folder that was written, each file once, by role.
struct PackTotals {
  std::vector<RoleTotals> input, output;
  TextureTotals lossy;                 // those of the input that compressing has changed: JPEG, ...
  std::optional<TextureTotals> scene;  // what scene.gltf reads, where one was written

  static TextureTotals all(const std::vector<RoleTotals>& roles);
  /// The totals of material roles alone: in the output the pair's pages, which is what an engine loads that reads
  /// layout.json.
  static TextureTotals of_materials(const std::vector<RoleTotals>& roles);
  friend bool operator==(const PackTotals&, const PackTotals&) = default;
};

/// What a form of the written scene costs.
///   gpu       bytes of all textures that scene.gltf reads, uncompressed with all mips; where files were not
///             weighed, at most so many: a picture that turns out to be grey takes less
///   disk      bytes of their files; none where files were not weighed
///   exact     the form says what was read, but for the rounding of the pair's codes
///   written   it is the one that was asked for, or found to be the smallest
///   textures  that scene.gltf reads
struct FormCost {
  GltfForm form = GltfForm::specular_ior;
  std::size_t textures = 0;
  std::uint64_t gpu = 0;
  std::optional<std::uint64_t> disk;
  bool exact = true, written = false;
  friend bool operator==(const FormCost&, const FormCost&) = default;
};

/// What scene.gltf would read by a goal, in the form that weighs least by it.
struct GoalCost {
  PackGoal goal = PackGoal::gpu;
  GltfForm form = GltfForm::specular_ior;
  TextureTotals totals;
  friend bool operator==(const GoalCost&, const GoalCost&) = default;
};

/// Counts the textures that were read and those in `folder`, which is not in place yet. Throws Error.
///   result   its layout, and which textures are in blocks
PackTotals pack_totals(const PackSource& source, const PackOptions& options, const PackResult& result,
                       const OutputFolder& folder);

}  // namespace etak
