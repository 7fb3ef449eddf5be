// SPDX-License-Identifier: Apache-2.0
#include "core/validate/find/picture_namer.h"

#include <utility>

#include "core/base/files/input.h"
#include "core/base/text/ascii.h"
#include "core/findings/suppress.h"
#include "core/validate/find/file_hints.h"

namespace etak {

std::string PictureNamer::label(const std::string& path) {
  // Input from a pipe lies in no folder and keeps its name.
  if (is_pipe_input(path)) return path;
  // Labels of one folder begin alike.
  const std::string_view folder = folder_of(path);
  if (labelled_ != folder || label_.empty()) {
    labelled_ = folder;
    label_ = relative_label(labelled_ + 'x', config_.root);
    if (label_.ends_with("/x") || label_ == "x")
      label_.pop_back();
    else
      return std::exchange(label_, {}), relative_label(path, config_.root);
  }
  return label_ + path.substr(folder.size());
}

std::optional<NamedPicture> PictureNamer::named(const std::string& path) {
  if (config_.roles.empty() && config_.sets.empty()) return picture_named(reader_, path);
  const std::string_view folder = folder_of(path), name = std::string_view(path).substr(folder.size());
  NamedPicture out;
  out.path = path;
  if (!config_.roles.empty()) {
    const std::string relative = label(path);
    for (const RolePattern& pattern : config_.roles) {
      if (!glob_matches(pattern.pattern, relative)) continue;
      out.name.role = pattern.role;
      out.name.convention = Convention::own;
      out.name.set =
          pattern_stem(pattern.pattern.substr(folder_of(pattern.pattern).size()), std::string(name));
      out.key = lower_case(std::string(folder) + out.name.set);
      return out;
    }
  }
  if (!config_.sets.empty()) {
    const std::string relative = label(path);
    for (const std::string& pattern : config_.sets) {
      std::size_t from = 0;
      auto by_pattern = reader_.read_by_pattern(pattern, relative, from);
      if (!by_pattern) continue;
      out.name = std::move(*by_pattern);
      out.key = lower_case(relative.substr(0, from) + out.name.set);
      return out;
    }
  }
  return picture_named(reader_, path);
}

}  // namespace etak
