// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "core/findings/report.h"
#include "core/judge/target.h"
#include "core/pack/pack.h"
#include "core/validate/config.h"

namespace etak {

class SceneOnPages;  // files/scene_on_pages.h

/// How an atlas is judged.
///   never_fails   findings are told, but make no atlas bad
///   version       of the program, for the report as JSON
struct PackCheckOptions {
  ValidateConfig config;
  bool never_fails = false;
  unsigned threads = 1;
  std::string version;
};

/// What the validator says of an atlas that is packed (target etak::validate_files), looked at while the
/// pages are in memory: what validate() says of the layout on the disk. Of a scene it is what validate() says
/// of the scene itself, by what its pages hold and with places on them (SceneOnPages), and of the pages what
/// their layout alone can break. One check for each call of pack().
class PackCheck {
 public:
  ///   output   the folder that the atlas goes to
  PackCheck(const std::string& output, PackCheckOptions options);
  ~PackCheck();

  /// Has every page checked before it is put in place; this must live until pack() returns.
  void attach(PackOptions& options);

  /// To be called by PackOptions::beside: gathers what was found, also into the report of what was packed.
  const ValidationReport& finish(PackResult& report);

  /// The report; null before finish(), and where the atlas was up to date.
  const ValidationReport* report() const { return finished_ ? &report_ : nullptr; }
  /// Whether the findings fail the run, and whether something could not be checked.
  bool failed() const { return finished_ && !report_.passed && !options_.never_fails; }
  bool incomplete() const { return finished_ && report_.incomplete; }

 private:
  bool check_page(const AtlasLayout& layout, int page,
                  const std::function<std::unique_ptr<RowSource>(Texture)>& rows, const PagePixels* pixels);

  PackCheckOptions options_;
  std::string path_, label_;                  // of the layout
  std::map<std::string, CheckedFile> files_;  // by label
  PictureDoor door_;
  std::unique_ptr<SceneOnPages> scene_;  // null: no scene is packed
  ValidationReport report_;
  bool finished_ = false;
};

}  // namespace etak
