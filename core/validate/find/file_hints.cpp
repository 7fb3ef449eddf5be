// SPDX-License-Identifier: Apache-2.0
#include "core/validate/find/file_hints.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/files/input.h"
#include "core/base/files/links.h"
#include "core/base/files/paths.h"
#include "core/base/system.h"
#include "core/base/text/ascii.h"

namespace etak {

namespace fs = std::filesystem;

std::string why_missing(const std::string& path) {
  if (!is_there(path) && errno != ENOENT) return "cannot be read: " + reason_of(errno);
  if (is_link(path)) return "a link that leads to no file";
  return "there is no such file";
}

const char* missing_fix(std::string_view path) {
  // Without -z git writes a name beyond ASCII in quotes.
  return path.starts_with('"') && path.ends_with('"')
             ? "Give the name without quotes; git writes it so with -z."
             : "Correct the path, or write the file first.";
}

std::string pattern_stem(const std::string& pattern, const std::string& name) {
  const std::size_t dot = name.rfind('.');
  const std::string bare = name.substr(0, dot);
  if (!pattern.starts_with('*')) return bare;
  std::string ending =
      pattern.substr(1, pattern.rfind('.') == std::string::npos ? pattern.npos : pattern.rfind('.') - 1);
  if (ending.empty() || ending.find_first_of("*?/") != ending.npos || !bare.ends_with(ending)) return bare;
  return bare.substr(0, bare.size() - ending.size());
}

std::string level_0_of(const std::string& path) {
  if (path.find(".mip") == path.npos) return {};
  const fs::path whole(path);
  const std::string stem = sys::path_text(whole.stem());
  const std::size_t mip = stem.rfind(".mip");
  if (mip == std::string::npos || mip + 4 == stem.size() ||
      stem.find_first_not_of("0123456789", mip + 4) != std::string::npos)
    return {};
  return sys::path_text(whole.parent_path() / (stem.substr(0, mip) + sys::path_text(whole.extension())));
}

bool looks_like_spectrum(const std::string& path) {
  const std::string head = read_head(path, 4096);
  if (!path.ends_with(".csv")) return head.find("DATA:") != head.npos;
  std::size_t begin = 0;
  while (begin < head.size() && head[begin] == '#')
    begin = std::min(head.find('\n', begin), head.size() - 1) + 1;
  const std::string line = lower_case(head.substr(begin, head.find('\n', begin) - begin));
  for (const char* name : {"wavelength", "lambda", "wl", "nm", "um", "\"wavelength"})
    if (line.starts_with(name)) return true;
  return false;
}

void check_links(const std::string& folder, const std::string& path) {
  (void)path_beside(folder, sys::path_text(fs::path(path).lexically_relative(folder.empty() ? "." : folder)));
}

std::string relative_label(const std::string& path, const std::string& root) {
  const fs::path whole = sys::absolute(path).lexically_normal();
  const fs::path relative = whole.lexically_relative(root.empty() ? sys::working_folder() : fs::path(root));
  return relative.empty() ? sys::path_text(whole.filename()) : relative.generic_string();
}

}  // namespace etak
