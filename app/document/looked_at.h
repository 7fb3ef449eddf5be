// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/atlas/sources/plane.h"
#include "core/judge/settings.h"

namespace etak::editor {

/// What the bytes of a dropped picture tell.
///   failure   why it is no whole picture that can be read; empty: it is one
///   file      its texels, where they were decoded
///   green     of a normal map whose name does not tell it
struct Looked {
  QString failure = {};
  DecodedFile file = {};
  PictureHeader header = {};
  std::optional<GreenAxis> green = {};
};
using LookedAt = std::map<std::string, Looked>;

/// A picture, and whether the green of a normal map is asked for.
struct FileToLookAt {
  std::string path;
  bool green = false;
};

/// Looks at every file once, at several at a time. PNG files are decoded, as many as there is room for. For a worker.
LookedAt looked_at(std::vector<FileToLookAt> files);

}  // namespace etak::editor
