// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/checked_before.h"

#include "core/validate/files/result_cache.h"

namespace etak {

void CheckedBefore::begin(const std::string& settings) {
  const std::lock_guard guard(lock_);
  if (settings != settings_) kept_.clear();
  settings_ = settings;
  for (auto& [identity, kept] : kept_) kept.used = false;
}

void CheckedBefore::end() {
  const std::lock_guard guard(lock_);
  std::erase_if(kept_, [](const auto& entry) { return !entry.second.used; });
}

std::optional<CheckedFile> CheckedBefore::find(const FoundTarget& found) {
  const std::string identity = identity_of(found);
  Kept* kept = nullptr;
  {
    const std::lock_guard guard(lock_);
    const auto at = kept_.find(identity);
    if (at == kept_.end() || at->second.depends != found.depends) return std::nullopt;
    kept = &at->second;
    kept->used = true;
  }
  // Nobody removes an entry while a run goes on.
  if (!are_unchanged(found.depends, kept->files)) return std::nullopt;
  return kept->file;
}

std::vector<sys::FileInfo> CheckedBefore::look_at(const FoundTarget& found) {
  std::vector<sys::FileInfo> out(found.depends.size());
  for (std::size_t i = 0; i < out.size(); ++i) (void)sys::file_info(found.depends[i], out[i]);
  return out;
}

void CheckedBefore::keep(const FoundTarget& found, const std::vector<sys::FileInfo>& before,
                         const CheckedFile& file) {
  if (file.unreadable || !are_unchanged(found.depends, before)) return;
  Kept kept{found.depends, before, file};
  kept.file.target = nullptr;
  kept.file.stats = {};  // of work that the next run does not do
  const std::lock_guard guard(lock_);
  kept_.insert_or_assign(identity_of(found), std::move(kept));
}

std::vector<std::string> CheckedBefore::files() const {
  const std::lock_guard guard(lock_);
  std::vector<std::string> out;
  for (const auto& [identity, kept] : kept_) out.insert(out.end(), kept.depends.begin(), kept.depends.end());
  return out;
}

}  // namespace etak
