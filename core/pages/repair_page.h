// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/findings/repair_report.h"
#include "core/image/image.h"

namespace etak {

/// An HTML page of repaired copies: each file before and after, where it was changed, what was done, and
/// what was left. It is one file without scripts, fonts or links to the network.
class RepairPage {
 public:
  /// Adds thumbnails of a repaired file; only the first 200 files get them, so that browsers can open the
  /// page.
  ///   before, after   its codes, of equal size and channels
  void add(const RepairedFile& file, const Image8& before, const Image8& after);

  ///   version   of etak
  std::string html(const RepairReport& report, const std::string& version) const;

 private:
  struct Shown {
    std::string copy, before, after, changed;  // PNG files
    int width = 0, height = 0;                 // of the thumbnails
  };
  std::vector<Shown> shown_;
};

}  // namespace etak
