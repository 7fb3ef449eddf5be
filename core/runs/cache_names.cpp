// SPDX-License-Identifier: Apache-2.0
// What in a folder is a cache's own: the tag that marks the folder, and the names that a cache makes in it. Nothing
// else there is ever replaced or removed.
#include <string>

#include "core/base/hash/content_hash.h"
#include "core/base/hash/sha256.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/runs/cache_state.h"

namespace etak {
namespace {

// The first line is the one by which programs that make copies know any cache; the second one is etak's own.
constexpr std::string_view tag_begin =
    "Signature: 8a477f597d28d172789f06886806bc55\n"
    "# etak-cache\n";
constexpr std::string_view tag_rest =
    "# The results in this folder are made again where they are missing: it may be removed at any time.\n";
constexpr std::size_t new_digits = 16;

bool is_hex_with(std::string_view name, std::size_t digits, std::string_view ending) {
  return name.size() == digits + ending.size() && are_hex_digits(name.substr(0, digits)) &&
         name.ends_with(ending);
}

// Entries of etak from before there was a size end in ".json": nothing finds them any more, so that they are the
// first to go.
bool is_entry_name(std::string_view name) {
  constexpr std::size_t digits = digest_digits - folder_digits;
  return is_hex_with(name, digits, entry_ending) || is_hex_with(name, digits, ".json");
}

bool is_marked(int root) {
  const auto tag = first_bytes_of(root, tag_file);
  return tag && tag->starts_with(tag_begin);
}

// Whether a file is what a power cut leaves of one.
bool is_lost(std::string_view text) {
  return text.find_first_not_of('\0') == text.npos;
}

// The secret in DIR/secret, which its SHA-256 follows; empty where there is none, or something else.
std::string secret_in(int root) {
  const std::string text = first_bytes_of(root, secret_file).value_or("");
  const std::string secret = text.substr(0, ContentHash::secret_size);
  return secret + sha256(secret) == text ? secret : "";
}

// The first name in the folder that no cache makes; empty where there is none.
std::string foreign_name(int root) {
  for (const std::string& name : names_in(root)) {
    if (name == secret_file && !secret_in(root).empty()) continue;
    if (name == account_file)
      if (const auto text = first_bytes_of(root, account_file); text && is_account(*text)) continue;
    const IsOwnName is_own = own_names_of(name);
    const Descriptor folder = is_own == nullptr ? Descriptor() : open_folder(root, name);
    if (!folder) return name;
    for (const std::string& inner : names_in(folder.get()))
      if (!is_own(inner)) return name + '/' + inner;
  }
  return {};
}

}  // namespace

bool is_new_name(std::string_view name) {
  return is_hex_with(name, new_digits, {});
}

IsOwnName own_names_of(std::string_view folder) {
  if (folder == folder_of_new_entries) return is_new_name;
  return is_hex_with(folder, folder_digits, {}) ? is_entry_name : nullptr;
}

std::optional<std::string> first_bytes_of(int folder, const std::string& name) {
  const Descriptor file(sys::open_in(folder, name, sys::OpenIn::read));
  sys::FileInfo info;
  if (!file || !sys::file_info(file.get(), info) || info.kind != sys::FileInfo::Kind::file)
    return std::nullopt;
  std::string out(static_cast<std::size_t>(std::min<std::uint64_t>(info.size, longest_head)), '\0');
  if (!fill_from(file.get(), out)) return std::nullopt;
  return out;
}

bool is_account(std::string_view text) {
  return text.starts_with("etak-cache/") || is_lost(text);
}

std::optional<CacheAccount> read_account(std::string_view text) {
  if (!text.ends_with('\n')) return std::nullopt;
  text.remove_suffix(1);
  if (take_word(text) != cache_format) return std::nullopt;
  const auto bytes = whole_number<std::uint64_t>(take_word(text)), runs = whole_number<std::uint64_t>(text);
  if (!bytes || !runs) return std::nullopt;
  return CacheAccount{*bytes, *runs};
}

void CacheFolder::State::own_folder() {
  if (is_marked(root.get())) return;
  // Another run may have marked the folder and used it since this one has looked.
  if (const std::string foreign = foreign_name(root.get()); !foreign.empty() && !is_marked(root.get()))
    throw Error::at(
        setting("cache"),
        printable(options.path, 200) + " is no cache of etak: it holds " + in_quotes(foreign, 200),
        "a new or empty folder, or one that CACHEDIR.TAG marks as a cache of etak");
  // Where the folder takes no file, its entries are read all the same, and the next run tries again.
  NewEntry::Open tag(*this);
  if (!tag.create()) return;
  tag.add(std::string(tag_begin) + std::string(tag_rest));
  (void)tag.rename_to(root.get(), tag_file);
}

void CacheFolder::State::take_secret() {
  secret = secret_in(root.get());
  if (!secret.empty()) return;
  const FolderLock guard(root.get(), most_wait_for_lock);
  secret = secret_in(root.get());
  const auto text = first_bytes_of(root.get(), secret_file);
  sys::FileInfo info;
  const bool foreign = text ? !is_lost(*text) : sys::file_info_in(root.get(), secret_file, info);
  std::string drawn(ContentHash::secret_size, '\0');
  NewEntry::Open file(*this);
  if (foreign || !sys::random_bytes(drawn.data(), drawn.size()) || !file.create()) return;
  file.add(drawn + sha256(drawn));
  // Where there was no lock, the secret of the last program stays, and what was kept by another one is not found.
  if (file.rename_to(root.get(), secret_file)) secret = secret_in(root.get());
}

}  // namespace etak
