// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/result_cache.h"

#include <utility>

#include "core/base/files/input.h"
#include "core/base/hash/sha256.h"
#include "core/base/number.h"

namespace etak {
namespace {

CacheOptions of_results(CacheOptions options) {
  options.kind = "validate";
  return options;
}

void add_manifest(std::string& text, const Manifest& manifest) {
  text += std::to_string(manifest.gutter) + ' ' + std::to_string(manifest.mips.value_or(-1)) + ' ' +
          (manifest.transfer ? std::string(name(*manifest.transfer)) : "-") + ' ' +
          (manifest.linear8_f0 ? '1' : '0') + (manifest.transparent ? '1' : '0') +
          (manifest.packed ? '1' : '0') + (manifest.scene.empty() ? '0' : '1') + '\n' + manifest.material +
          '\n' + manifest.surface_class + '\n';
  for (const CheckTile& tile : manifest.tiles)
    text += tile.name + '\n' + tile.material + '\n' + tile.surface_class + '\n' + std::to_string(tile.box.x) +
            ' ' + std::to_string(tile.box.y) + ' ' + std::to_string(tile.box.width) + ' ' +
            std::to_string(tile.box.height) + ' ' + std::to_string(tile.page) + ' ' +
            (tile.typical_gloss ? number(*tile.typical_gloss, 17) : "-") + '\n';
}

bool same_file(const sys::FileInfo& a, const sys::FileInfo& b) {
  const auto same = [](const sys::FileInfo::Time& x, const sys::FileInfo::Time& y) {
    return x.seconds == y.seconds && x.nanoseconds == y.nanoseconds;
  };
  return a.device == b.device && a.number == b.number && a.size == b.size && same(a.written, b.written) &&
         same(a.changed, b.changed);
}

}  // namespace

std::string identity_of(const FoundTarget& found) {
  std::string text;
  text.reserve(512);
  (text += found.target.label) += '\n';
  for (const auto* files : {&found.target.files, &found.target.beside})
    for (const TargetFile& file : *files) {
      ((text += file.label) += '\n') += name(file.role);
      ((text += file.guessed ? " guessed " : " ") += file.channels) += ' ';
      (text += name(file.green)) += '\n';
    }
  add_manifest(text, found.target.manifest);
  return text;
}

bool are_unchanged(const std::vector<std::string>& paths, const std::vector<sys::FileInfo>& before) {
  if (paths.size() != before.size()) return false;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    sys::FileInfo now;
    // Input from a pipe is kept in memory and does not change.
    if (is_pipe_input(paths[i])) continue;
    if (!sys::file_info(paths[i], now) || !same_file(now, before[i])) return false;
  }
  return true;
}

ResultCache::ResultCache(CacheOptions options, const std::string& settings, const std::string& version)
    : folder_(of_results(std::move(options))), settings_(settings + '\n' + program_fingerprint(version)) {}

CacheKey ResultCache::key_of(const FoundTarget& found) const {
  CacheKey out;
  out.files.resize(found.depends.size());
  for (std::size_t i = 0; i < found.depends.size(); ++i) {
    const SeenAsFile seen = found.plain ? SeenAsFile::yes : SeenAsFile::no;
    out.hashes.push_back(sha256_of_file(found.depends[i], out.files[i], seen));
    if (out.hashes.back().empty()) return out;
  }
  std::string hashes;
  for (const std::string& hash : out.hashes) (hashes += hash) += '\n';
  Sha256 all;
  all.add(settings_);
  all.add("\n");
  all.add(identity_of(found));
  all.add(hashes);
  out.digest = all.finish();
  return out;
}

std::optional<CheckedFile> ResultCache::find(const CacheKey& key) {
  if (key.digest.empty()) return std::nullopt;
  const auto entry = folder_.find(key.digest);
  if (!entry) return std::nullopt;
  auto out = read_result_text(entry->text);
  if (!out) folder_.refuse_hit();
  return out;
}

void ResultCache::keep(const CacheKey& key, const FoundTarget& found, const CheckedFile& file) {
  if (key.digest.empty() || file.unreadable || !are_unchanged(found.depends, key.files)) return;
  folder_.keep(key.digest, result_text(file));
}

}  // namespace etak
