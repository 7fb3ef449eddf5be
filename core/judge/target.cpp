// SPDX-License-Identifier: Apache-2.0
#include "core/judge/target.h"

#include <algorithm>

namespace etak {

std::string CheckTarget::own_label() const {
  return !label.empty() ? label : files.empty() ? "" : files.front().label;
}

const TargetFile* CheckTarget::with_role(std::initializer_list<FileRole> wanted) const {
  for (const FileRole role : wanted)
    for (const TargetFile& file : files)
      if (file.role == role) return &file;
  return nullptr;
}

PictureRows Pictures::rows() const {
  const auto of = [](const Image8& image) { return image.width == 0 ? nullptr : rows_of(image); };
  return {of(a), of(b), of(metallic)};
}

}  // namespace etak
