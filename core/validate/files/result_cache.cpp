// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/result_cache.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/files/temporary.h"
#include "core/base/hash/sha256.h"
#include "core/base/number.h"

namespace etak {
namespace {

constexpr std::string_view format_name = "etak-result/3 ";
constexpr std::size_t largest_entry = std::size_t{64} << 20;
constexpr std::size_t shortest_key = 16, longest_key = 4096;

// A rebuilt etak may judge differently under the same version number.
std::string program_fingerprint(const std::string& version) {
  return version + ' ' + sha256_of_file(sys::program_bytes());
}

// Device, inode, size and times of the files, which change when a file is written.
std::string stamps_of(const std::vector<std::string>& paths) {
  std::string out;
  for (const std::string& path : paths) {
    sys::FileInfo info;
    // Input from a pipe is kept in memory and does not change.
    if (!is_pipe_input(path) && !sys::file_info(path, info)) out += "none";
    for (const std::int64_t part :
         {static_cast<std::int64_t>(info.device), static_cast<std::int64_t>(info.number),
          static_cast<std::int64_t>(info.size), info.written.seconds, info.written.nanoseconds,
          info.changed.seconds, info.changed.nanoseconds})
      out += ' ' + std::to_string(part);
    out += '\n';
  }
  return out;
}

// The content of an open file; nullopt when it is no regular file, too long, or cannot be read.
std::optional<std::string> read_entry(const Descriptor& file) {
  sys::FileInfo info;
  if (!file || !sys::file_info(file.get(), info) || info.kind != sys::FileInfo::Kind::file)
    return std::nullopt;
  std::string out(1, '\0');
  for (std::size_t filled = 0;;) {
    const std::ptrdiff_t got = sys::read(file.get(), out.data() + filled, out.size() - filled);
    if (got < 0 || filled > largest_entry) return std::nullopt;
    filled += static_cast<std::size_t>(got);
    if (got == 0) {
      out.resize(filled);
      return out;
    }
    if (filled == out.size()) out.resize(std::max(2 * filled, static_cast<std::size_t>(info.size) + 1));
  }
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

}  // namespace

std::string read_cache_key(const std::string& path) {
  std::string out = read_file(path, longest_key);
  if (out.size() < shortest_key)
    throw Error::at(path, "a key of " + std::to_string(out.size()) + " bytes",
                    "at least " + std::to_string(shortest_key) + " bytes, best of head -c 32 /dev/urandom");
  return out;
}

ResultCache::ResultCache(const std::string& folder, const std::string& settings, const std::string& version,
                         std::string key)
    : settings_(settings + '\n' + program_fingerprint(version)), key_(std::move(key)) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  folder_ = Descriptor(sys::open_file(folder, sys::Open::folder));
  if (!folder_) throw Error::at("--cache", printable(folder, 200) + " is no folder", "a folder");
}

CacheKey ResultCache::key_of(const FoundTarget& found) const {
  CacheKey out;
  // The stamps are taken before the bytes are read, so that a file that is written meanwhile counts as
  // changed.
  out.stamps = stamps_of(found.depends);
  std::string text = settings_ + '\n' + found.target.label + '\n';
  for (const auto* files : {&found.target.files, &found.target.beside})
    for (const TargetFile& file : *files)
      text += file.label + '\n' + std::string(name(file.role)) + (file.guessed ? " guessed " : " ") +
              file.channels + ' ' + std::string(name(file.green)) + '\n';
  add_manifest(text, found.target.manifest);
  for (const std::string& path : found.depends) {
    const std::string fingerprint = sha256_of_file(path);
    if (fingerprint.empty()) return out;
    text += fingerprint + '\n';
  }
  out.digest = sha256(text);
  return out;
}

std::string ResultCache::seal_of(const std::string& digest, std::string_view text) const {
  std::string sealed = std::string(format_name) + digest + '\n';
  sealed += text;
  return key_.empty() ? sha256(sealed) : hmac_sha256(key_, sealed);
}

// The folder of an entry. No link is followed, because a program that can write to the cache could redirect
// others by one.
Descriptor ResultCache::folder_of(const std::string& digest) const {
  return open_folder(folder_.get(), digest.substr(0, 2));
}

std::string ResultCache::name_of(const std::string& digest) {
  return digest.substr(2) + ".json";
}

std::optional<CheckedFile> ResultCache::find(const CacheKey& key) const {
  if (key.digest.empty()) return std::nullopt;
  const Descriptor folder = folder_of(key.digest);
  if (!folder) return std::nullopt;
  const auto entry =
      read_entry(Descriptor(sys::open_in(folder.get(), name_of(key.digest), sys::OpenIn::read)));
  if (!entry) return std::nullopt;
  const std::string_view all = *entry;
  const std::size_t end = std::min(all.find('\n'), all.size());
  const std::string_view text = all.substr(std::min(end + 1, all.size()));
  if (!all.starts_with(format_name) ||
      !same_digest(all.substr(format_name.size(), end - format_name.size()), seal_of(key.digest, text)))
    return std::nullopt;
  return read_cache_text(std::string(text));
}

void ResultCache::keep(const CacheKey& key, const FoundTarget& found, const CheckedFile& file) const {
  if (key.digest.empty() || file.unreadable || stamps_of(found.depends) != key.stamps) return;
  const std::string text = cache_text(file);
  if (text.empty()) return;
  const std::string name = name_of(key.digest);
  (void)sys::make_folder_in(folder_.get(), key.digest.substr(0, 2), 0777);
  const Descriptor folder = folder_of(key.digest);
  if (!folder) return;
  // Not write_file(): a result that is lost in a power cut is only computed again, and flushing thousands of
  // files takes longer than that. The rename keeps other runs from reading half an entry.
  Temporary out(folder.get(), name, Temporary::Kind::file);
  if (out &&
      write_all(out.open().get(), std::string(format_name) + seal_of(key.digest, text) + '\n' + text) &&
      sys::set_mode(out.open().get(), mode_of_new_file()) &&
      sys::rename_in(folder.get(), out.name(), folder.get(), name))
    (void)out.keep();
}

}  // namespace etak
