// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/files/output.h"

namespace etak {

/// Files that belong into a folder and into folders of it. They are written to a temporary in the folder
/// (temporary.h) and renamed to their places at the end, one directly after the other, each in one step: a
/// process killed between two renames leaves whole files, of which some are the old ones. Where a rename fails, those
/// before it are undone. What has appeared in a place since prepare() looked is not replaced. What the folder
/// holds besides stays. Where all files lie in one folder, OutputFolder exchanges them in a single step.
class OutputTree : public Output {
 public:
  /// Makes the folder where it is missing; it is removed again where nothing is put in place. Throws Error.
  ///   overwrite   false: a file that is there already is an Error
  OutputTree(const std::string& path, bool overwrite);
  ~OutputTree() override;

  /// A new file. Throws Error, also for a full disk.
  ///   name   its path below the folder, without "..": "page.html", "wood/oak_spec.png"
  ///   mode   its permissions; none: those of a new file
  void write(const std::string& name, std::string_view bytes, std::optional<unsigned> mode = std::nullopt);

 private:
  void prepare() override;
  void place() override;
  void flush() override;
  void tidy() override;

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace etak
