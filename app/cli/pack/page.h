// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/cli/pack/pack.h"
#include "core/base/files/output_folder.h"
#include "core/pack/pack.h"
#include "core/pages/atlas_page.h"

namespace etak::cli {

/// Whether the file of --page-report lies in the folder of the atlas, which pack() makes.
bool is_in_atlas_folder(const PackArguments& arguments);

/// The HTML page of --page-report. It takes small pictures of the atlas's pages while they are in memory.
class PackPage {
 public:
  /// Throws Error for a --page-link that is not TEXT=TARGET with an allowed target.
  explicit PackPage(const PackArguments& arguments);

  /// Makes pack() hand every page to this object, after the check that `options` has.
  void attach(PackOptions& options);

  /// The HTML page, to be put in place together with the atlas. Null where none was asked for, and where the
  /// page was written into the folder of the atlas.
  ///   findings   null: the atlas was not checked
  ///   folder     the folder of the atlas, which is not in place yet; null in a dry run
  std::unique_ptr<Output> output(const PackResult& result, const ValidationReport* findings,
                                 OutputFolder* folder);

  /// The page that output() returned, as text; none where it returned null.
  const std::optional<std::string>& written() const { return written_; }

 private:
  const PackArguments& arguments_;
  AtlasPageData data_;
  std::optional<std::string> written_;
};

}  // namespace etak::cli
