// SPDX-License-Identifier: Apache-2.0
#include "app/cli/validate_cache.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "core/atlas/content_hash.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/input.h"
#include "core/base/number.h"

namespace etak::cli {
namespace {

namespace fs = std::filesystem;

// Length and hash of a file's bytes; empty when it cannot be read.
std::string fingerprint_of_file(const std::string& path) {
  try {
    const OpenedInput input = open_input(path, SIZE_MAX);
    ContentHash hash;
    // Pieces of a multiple of 32 bytes, as ContentHash asks; one buffer per thread.
    thread_local std::vector<char> buffer(std::size_t{1} << 20);
    for (std::size_t filled = 0;;) {
      const ssize_t got = ::read(input.file.get(), buffer.data() + filled, buffer.size() - filled);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return {};
      filled += static_cast<std::size_t>(got);
      if (got != 0 && filled < buffer.size()) continue;
      hash.add(buffer.data(), filled);
      filled = 0;
      if (got == 0) return hash.hex();
    }
  } catch (const Error&) {
    return {};
  }
}

std::string program_fingerprint() {
  // A rebuilt etak may judge differently under the same version number.
  std::error_code failure;
  const auto size = fs::file_size("/proc/self/exe", failure);
  const auto time = fs::last_write_time("/proc/self/exe", failure);
  return failure ? std::string(ETAK_VERSION)
                 : std::string(ETAK_VERSION) + ' ' + std::to_string(size) + ' ' +
                       std::to_string(time.time_since_epoch().count());
}

void add_manifest(std::string& text, const Manifest& manifest) {
  text += std::to_string(manifest.gutter) + ' ' + std::to_string(manifest.mips.value_or(-1)) + ' ' +
          (manifest.transfer ? std::string(name(*manifest.transfer)) : "-") + ' ' +
          (manifest.linear8_f0 ? '1' : '0') + (manifest.transparent ? '1' : '0') + '\n' + manifest.material +
          '\n' + manifest.surface_class + '\n';
  for (const Tile& tile : manifest.tiles)
    text += tile.name + '\n' + tile.material + '\n' + tile.surface_class + '\n' + std::to_string(tile.box.x) +
            ' ' + std::to_string(tile.box.y) + ' ' + std::to_string(tile.box.width) + ' ' +
            std::to_string(tile.box.height) + ' ' + std::to_string(tile.page) + ' ' +
            (tile.typical_gloss ? number(*tile.typical_gloss, 17) : "-") + '\n';
}

}  // namespace

ResultCache::ResultCache(const std::string& folder, const std::string& settings)
    : folder_(folder), settings_(settings + '\n' + program_fingerprint()) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (!fs::is_directory(folder))
    throw Error::at("--cache", printable(folder, 200) + " is no folder", "a folder");
}

std::string ResultCache::key_of(const FoundTarget& found) const {
  std::string text = settings_ + '\n' + found.target.label + '\n';
  for (const TargetFile& file : found.target.files)
    text += file.label + '\n' + std::string(name(file.role)) + (file.guessed ? " guessed\n" : "\n");
  add_manifest(text, found.target.manifest);
  for (const std::string& path : found.depends) {
    const std::string fingerprint = fingerprint_of_file(path);
    if (fingerprint.empty()) return {};
    text += fingerprint + '\n';
  }
  ContentHash hash;
  hash.add(text);
  return hash.hex();
}

std::string ResultCache::entry(const std::string& key) const {
  return folder_ + '/' + key.substr(0, 2) + '/' + key.substr(2) + ".json";
}

std::optional<CheckedFile> ResultCache::find(const std::string& key) const {
  if (key.empty()) return std::nullopt;
  try {
    return read_cache_text(read_file(entry(key)));
  } catch (const Error&) {
    return std::nullopt;
  }
}

void ResultCache::keep(const std::string& key, const CheckedFile& file) const {
  if (key.empty() || file.unreadable) return;
  const std::string text = cache_text(file);
  if (text.empty()) return;
  // Not write_file(): a result that is lost in a power cut is only computed again, and flushing thousands of
  // files takes longer than that. The rename keeps other runs from seeing a part.
  static std::atomic<unsigned> count{0};
  const std::string path = entry(key);
  const std::string temporary = path + '.' + std::to_string(::getpid()) + '.' + std::to_string(count++);
  std::error_code failure;
  fs::create_directories(fs::path(path).parent_path(), failure);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(temporary.c_str(), "wb"), std::fclose);
  bool whole = out && std::fwrite(text.data(), 1, text.size(), out.get()) == text.size();
  whole = whole && std::fflush(out.get()) == 0;
  if (whole) fs::rename(temporary, path, failure);
  if (!whole || failure) fs::remove(temporary, failure);
}

}  // namespace etak::cli
