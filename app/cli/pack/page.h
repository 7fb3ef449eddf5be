// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "app/cli/pack/pack.h"
#include "core/atlas/pack/pack.h"
#include "core/base/files/output_folder.h"
#include "core/pages/atlas_page.h"

namespace etak::cli {

/// Whether --page-report goes into the folder of the atlas itself, which packing makes.
bool is_in_atlas_folder(const PackArguments& arguments);

/// --page-report: an HTML page of the atlas, with small pictures of its pages taken while they are in memory.
class PackPage {
 public:
  /// Throws Error for a --page-link that is none.
  explicit PackPage(const PackArguments& arguments);

  /// Looks at every page, after whatever checks it.
  void attach(PackOptions& options);

  /// The page, to be put in place together with the atlas; null where none was asked for, and where it went
  /// into the folder of the atlas.
  ///   folder   of the atlas, not in place yet; null in a dry run
  std::unique_ptr<Output> output(const PackResult& result, const ValidationReport* findings,
                                 OutputFolder* folder);

 private:
  const PackArguments& arguments_;
  AtlasPageData data_;
};

}  // namespace etak::cli
