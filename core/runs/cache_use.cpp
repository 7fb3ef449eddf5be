// SPDX-License-Identifier: Apache-2.0
#include "core/runs/cache_use.h"

#include <vector>

#include "core/base/json/json_text.h"
#include "core/base/number.h"

namespace etak {

std::string cache_text(const CacheUse& use) {
  const CacheCounts& counts = use.counts;
  std::string out = grouped(counts.hits) + " hits, " + grouped(counts.misses) + " misses (" +
                    grouped(counts.refused) + " damaged or foreign), " + grouped(counts.written) +
                    " written, " + grouped(counts.evicted) + " evicted, " + grouped(counts.too_large) +
                    " too large, " + grouped(counts.not_written) + " not written";
  if (use.size)
    out += "; now " + grouped(use.size->entries) + " entries of " + grouped(use.size->bytes) + " bytes";
  return out;
}

std::string cache_json(const CacheUse& use) {
  const CacheCounts& counts = use.counts;
  std::vector<JsonMember> members{
      {"schema", json("etak-cache-use/1")},  {"hits", json(counts.hits)},
      {"misses", json(counts.misses)},       {"refused", json(counts.refused)},
      {"written", json(counts.written)},     {"evicted", json(counts.evicted)},
      {"too_large", json(counts.too_large)}, {"not_written", json(counts.not_written)}};
  if (use.size) {
    members.push_back({"entries", json(use.size->entries)});
    members.push_back({"bytes", json(use.size->bytes)});
  }
  if (!use.fault.empty()) members.push_back({"fault", json(use.fault)});
  return json_object(members, 0) + '\n';
}

}  // namespace etak
