// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "core/atlas/compose.h"
#include "core/atlas/layout.h"
#include "core/atlas/leave_out.h"
#include "core/atlas/pack/source.h"
#include "core/atlas/plan.h"
#include "core/atlas/resolution.h"

namespace etak {

struct PackOptions;

/// What an atlas is to hold and where it goes: decided of all materials together, and once more when their
/// texels have taught something.
class PackDecision {
 public:
  /// Both must outlive this; what the texels teach goes into the facts of the source.
  PackDecision(const PackOptions& options, PackSource& source)
      : options_(options), inputs_(source.inputs), scene_(source.scene.get()) {}

  /// Which texels are left out, which regions the others are and where those lie.
  ///   previous   null: none
  void decide(const AtlasLayout* previous);

  /// Takes what the texels taught into the facts; true when it changes which regions there are.
  bool learn(const std::vector<Learned>& learned);

  const std::vector<Region>& regions() const { return regions_; }
  const PackingPlan& plan() const { return plan_; }
  const LeaveOut& left_out() const { return left_out_; }

  /// Mips that the settings offer of a page.
  int offered_levels(int page) const;
  /// Of those the ones that a sampler reads, and in which some region has a texel of its own.
  int page_levels(int page) const;
  /// With how many texels a region is stored; found once.
  const Resolution& resolution(const Region& region);

 private:
  template <class Act>
  void users(std::size_t owner, Act act) const;
  std::vector<Region> regions_needed() const;
  bool reads_around(const Region& region) const;
  int levels() const;
  PlanOptions plan_options() const;

  const PackOptions& options_;
  PackInputs& inputs_;
  const ScenePack* const scene_;
  LeaveOut left_out_;
  std::vector<Region> regions_;
  std::map<std::array<int, 7>, Resolution> resolutions_;
  PackingPlan plan_;
};

}  // namespace etak
