// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/links.h"

#include <algorithm>
#include <atomic>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/files/paths.h"
#include "core/base/setting.h"
#include "core/base/system.h"

namespace etak {
namespace {

namespace fs = std::filesystem;

std::atomic<bool> follow_all{false};

fs::path or_here(const fs::path& folder) {
  return folder.empty() ? fs::path(".") : folder;
}

// Whether `target`, which holds no links, is the folder or lies in it.
bool lies_in(const fs::path& target, const fs::path& folder) {
  const fs::path whole = sys::canonical(or_here(folder));
  return !whole.empty() &&
         std::mismatch(whole.begin(), whole.end(), target.begin(), target.end()).first == whole.end();
}

}  // namespace

void set_follow_links(bool follow) {
  follow_all = follow;
}

bool follows_links() {
  return follow_all;
}

std::string path_beside(const std::string& folder, const std::string& name) {
  const fs::path root(folder), whole = root / name;
  if (follow_all || fs::path(name).is_absolute()) return sys::path_text(whole);
  fs::path at = root;
  for (const fs::path& part : fs::path(name)) {
    const fs::path holder = at;
    at /= part;
    if (!is_link(sys::path_text(at))) continue;
    const fs::path target = sys::canonical(at);
    if (target.empty()) break;  // the link leads nowhere, which the reader reports
    if (!lies_in(target, root) && !lies_in(target, holder))
      throw Error::at(sys::path_text(at),
                      "is a link to " + printable(sys::path_text(target), 200) + ", out of its folder",
                      "a file of that folder, or " + setting("follow-links"));
  }
  return sys::path_text(whole);
}

std::string name_from(const std::filesystem::path& folder, const std::string& file) {
  namespace fs = std::filesystem;
  const fs::path whole = sys::absolute(file).lexically_normal();
  if (folder.empty()) return sys::path_text(whole);
  // Where the two have no folder in common, "../" would lead to the root, which differs between computers.
  const bool far = whole.root_path() != folder.root_path() || folder.relative_path().empty() ||
                   *whole.relative_path().begin() != *folder.relative_path().begin();
  const fs::path near = far ? fs::path() : whole.lexically_relative(folder);
  return near.empty() ? sys::path_text(whole) : near.generic_string();
}

std::filesystem::path folder_of_document(const std::string& file) {
  return sys::absolute(file).lexically_normal().parent_path();
}

}  // namespace etak
