// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "app/cli/pack/pack.h"
#include "core/atlas/pack/pack.h"
#include "core/validate/finding.h"

namespace etak::cli {

/// What the validator says of an atlas: the rules of `etak validate` on its layout, looked at while the pages
/// are still in memory.
class PackFindings {
 public:
  /// Reads the configuration and the library that is asked for as `etak validate` of the result would. Throws
  /// Error.
  explicit PackFindings(PackArguments& arguments);
  ~PackFindings();
  PackFindings(const PackFindings&) = delete;
  PackFindings& operator=(const PackFindings&) = delete;

  /// Has every page checked before it is written, unless --no-validate says otherwise.
  void attach(PackOptions& options);

  /// Puts the findings into the report of what was packed.
  void finish(PackReport& report);

  /// What was found; null when nothing was checked.
  const ValidationReport* report() const;
  /// Lines for people, the verdict last; empty when nothing was checked.
  std::string text(bool color) const;
  /// The verdict alone.
  std::string verdict() const;
  /// Whether there are findings at or above --fail-on (never without the check).
  bool failed() const;
  /// Whether something could not be checked.
  bool incomplete() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace etak::cli
