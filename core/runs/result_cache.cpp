// SPDX-License-Identifier: Apache-2.0
#include "core/runs/result_cache.h"

#include <utility>

#include "core/base/hash/sha256.h"
#include "core/runs/cache_state.h"

namespace etak {

std::vector<sys::FileInfo> look_at(const std::vector<std::string>& paths) {
  std::vector<sys::FileInfo> out(paths.size());
  for (std::size_t i = 0; i < paths.size(); ++i) (void)sys::file_info(paths[i], out[i]);
  return out;
}

bool are_unchanged(const std::vector<std::string>& paths, const std::vector<sys::FileInfo>& before) {
  if (paths.size() != before.size()) return false;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    sys::FileInfo now;
    // Input from a pipe is kept in memory and does not change.
    if (is_pipe_input(paths[i])) continue;
    const sys::FileInfo& then = before[i];
    if (!sys::file_info(paths[i], now) || now.device != then.device || now.number != then.number ||
        now.size != then.size || !same_time(now.written, then.written) ||
        !same_time(now.changed, then.changed))
      return false;
  }
  return true;
}

ResultCache::ResultCache(CacheOptions options, const std::string& settings, const std::string& version)
    : folder_(std::move(options)), settings_(settings + '\n' + program_fingerprint(version) + '\n') {}

CacheKey ResultCache::key_of(const std::string& identity, const std::vector<std::string>& files,
                             SeenAsFile seen, const std::string* sha256_of) const {
  CacheKey out;
  out.files.resize(files.size());
  std::string hashes;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const bool promised = sha256_of != nullptr && files[i] == *sha256_of;
    const std::string hash = folder_.hash_of(files[i], out.files[i], seen, promised ? &out.sha256 : nullptr);
    if (hash.empty()) return out;
    (hashes += hash) += '\n';
  }
  Sha256 all;
  all.add(settings_);
  all.add(identity);
  all.add(hashes);
  out.digest = all.finish();
  return out;
}

std::optional<std::string> ResultCache::find(const CacheKey& key) {
  if (key.digest.empty()) return std::nullopt;
  auto entry = folder_.find(key.digest);
  return entry ? std::optional(std::move(entry->text)) : std::nullopt;
}

void ResultCache::keep(const CacheKey& key, const std::vector<std::string>& files,
                       const std::string& result) {
  if (!key.digest.empty() && are_unchanged(files, key.files)) folder_.keep(key.digest, result);
}

}  // namespace etak
