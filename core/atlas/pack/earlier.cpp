// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/pack/earlier.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/setting.h"
#include "core/base/system.h"

namespace etak {
namespace {

bool exists(const std::string& path) {
  sys::FileInfo info;
  return sys::file_info(path, info);
}

}  // namespace

bool EarlierAtlas::is_whole() const {
  return layout && std::all_of(files.begin(), files.end(),
                               [&](const std::string& name) { return exists(folder + '/' + name); });
}

EarlierAtlas earlier_atlas(const std::string& folder) {
  EarlierAtlas out{folder, {}, {}};
  const std::string path = folder + '/' + layout_file_name;
  if (!exists(path)) return out;
  try {
    out.layout = parse_layout(read_file(path), path);
  } catch (const Error&) {
    return out;
  }
  out.files.emplace_back(layout_file_name);
  for (const AtlasPage& page : out.layout->pages)
    for (const auto& files : page.files) out.files.insert(out.files.end(), files.begin(), files.end());
  out.files.insert(out.files.end(), out.layout->other_files.begin(), out.layout->other_files.end());
  return out;
}

void refuse_stranger(const EarlierAtlas& earlier, const std::string& name, bool overwrite) {
  const bool owned = std::find(earlier.files.begin(), earlier.files.end(), name) != earlier.files.end();
  if (!owned && !overwrite && exists(earlier.folder + '/' + name))
    throw Error::at(earlier.folder + '/' + name, "exists already and is of no earlier atlas",
                    "another folder, or " + setting("force") + " to replace it");
}

void check_place(const EarlierAtlas& earlier, bool overwrite) {
  check_folder_target(earlier.folder, {}, may_replace(overwrite));
  refuse_stranger(earlier, layout_file_name, overwrite);
}

}  // namespace etak
