// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/base/files/output.h"
#include "core/base/files/output_target.h"
#include "core/base/files/temporary.h"

namespace etak {

/// A file whose bytes are on the disk beside its target. A symbolic link stays and its target is replaced; a
/// device or pipe (/dev/stdout) is never replaced, but written to while the other outputs are being
/// prepared.
class OutputFile : public Output {
 public:
  /// Writes a temporary beside `path` (temporary.h) and flushes it to disk. Throws Error when `path` exists
  /// and `overwrite` is false, or on any failure; nothing is left then.
  ///   most_mode   permissions beyond these are taken away (strictest_mode)
  OutputFile(const std::string& path, std::string_view bytes, bool overwrite, unsigned most_mode = 0777);

 private:
  void prepare() override;
  void place() override;
  void flush() override;
  [[noreturn]] void fail(const char* what) const;

  std::string path_;  // as the caller wrote it, for messages
  bool overwrite_;
  FileTarget target_;
  Descriptor folder_;
  Temporary temporary_;
  std::string for_device_;
};

}  // namespace etak
