// SPDX-License-Identifier: Apache-2.0
#include "core/validate/find/find_targets.h"

#include <algorithm>
#include <utility>

#include "core/validate/find/finds.h"

namespace etak {

FoundTargets find_targets(ValidationRequest& request) {
  Finds finds(request);
  const Searched searched = search(finds);
  take_pictures(searched, take_documents(searched, finds), finds);
  FoundTargets& out = finds.found;
  sort_where_needed(out.targets, [](const FoundTarget& a, const FoundTarget& b) {
    return a.target.label < b.target.label;
  });
  std::ranges::sort(out.unknown);
  std::ranges::stable_sort(out.listing.files, {}, &ListedFile::file);
  return std::move(out);
}

}  // namespace etak
