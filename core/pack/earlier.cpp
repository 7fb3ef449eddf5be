// SPDX-License-Identifier: Apache-2.0
#include "core/pack/earlier.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/paths.h"
#include "core/base/hash/content_hash.h"
#include "core/base/setting.h"
#include "core/base/system.h"

namespace etak {
bool EarlierAtlas::is_whole() const {
  return layout && std::all_of(files.begin(), files.end(),
                               [&](const std::string& name) { return is_there(folder + '/' + name); });
}

EarlierAtlas earlier_atlas(const std::string& folder) {
  EarlierAtlas out{folder, {}, {}, ReadPlaces()};
  const std::string path = folder + '/' + layout_file_name;
  if (!is_there(path)) return out;
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
  const std::string path = earlier.folder + '/' + name;
  sys::FileInfo info;
  if (!sys::file_info(path, info)) return;
  earlier.inputs.refuse(info, path);
  const bool owned = std::find(earlier.files.begin(), earlier.files.end(), name) != earlier.files.end();
  if (!owned && !overwrite)
    throw Error::at(path, "exists already and is of no earlier atlas",
                    "another folder, or " + setting("force") + " to replace it");
}

std::string remove_earlier(OutputFolder& folder, const EarlierAtlas& earlier,
                           const std::set<std::string>& names) {
  std::vector<std::string> left;
  for (const std::string& name : earlier.files) {
    sys::FileInfo info;
    const std::string path = earlier.folder + '/' + name;
    if (names.contains(name) || !sys::file_info(path, info)) continue;
    const auto& written = earlier.layout->xxh128;
    const auto hash = written.find(name);
    if (info.kind == sys::FileInfo::Kind::file && earlier.inputs.find(info) == nullptr &&
        hash != written.end() && content_hash_of_file(path) == hash->second)
      folder.remove_old(name);
    else
      left.push_back(printable(path, 200));
  }
  if (left.empty()) return {};
  return left.front() + (left.size() == 1 ? " is" : " and " + std::to_string(left.size() - 1) + " more are") +
         " of no use to the new atlas and stayed: not known to be as etak wrote it";
}

void check_place(const EarlierAtlas& earlier, bool overwrite) {
  check_folder_target(earlier.folder, {}, may_replace(overwrite));
  refuse_stranger(earlier, layout_file_name, overwrite);
}

}  // namespace etak
