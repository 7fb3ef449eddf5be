// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/cli/pack.h"
#include "core/atlas/pack.h"
#include "core/report/atlas_page.h"

namespace etak::cli {

/// --page-report: an HTML page of the atlas, with small pictures of its pages taken while they are in memory.
class PackPage {
 public:
  explicit PackPage(const PackArguments& arguments) : arguments_(arguments) {}

  /// Looks at every page, after whatever checks it.
  void attach(PackOptions& options);

  /// Writes the file. Throws Error.
  void write(const PackReport& report, const ValidationReport* findings);

 private:
  const PackArguments& arguments_;
  AtlasPageData data_;
};

}  // namespace etak::cli
