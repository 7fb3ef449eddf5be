// SPDX-License-Identifier: Apache-2.0
// Bundles of a cache: files with copies of many small entries, which take one call each to read where files of
// their own take four. The bytes of an entry are in a bundle as in its own file, behind them all their index, and
// last a trailer. Nothing of a bundle is believed but entries whose seal is right, so that the index has none.
#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <utility>

#include "core/base/bytes/bytes_le.h"
#include "core/base/bytes/hex.h"
#include "core/base/files/cache_state.h"

namespace etak {
namespace {

constexpr std::string_view folder_of_bundles = "bundles", bundle_ending = ".bundle";
constexpr std::string_view magic = "etak-cache-bundle/1\n";
// A row of the index is the digest, the offset and the size; rows are in the order of digests.
constexpr std::size_t number_size = 8, row_size = digest_digits + 2 * number_size;
constexpr std::size_t trailer_size = magic.size() + number_size;  // with the number of rows
constexpr std::size_t fewest_entries = 1000;
// Of all bundles that a run reads, so that an index that somebody has made takes no more memory than this.
constexpr std::size_t most_rows = std::size_t{1} << 20;
constexpr std::size_t most_bundles = 32;

// Whether all of `out` could be read from there.
bool fill_at(int file, std::span<char> out, std::uint64_t at) {
  return read_all_at(file, out, static_cast<std::size_t>(at)) == out.size();
}

// The index of an open bundle, with at most so many rows; false where it is none.
bool read_index(CacheFolder::State::Bundle& bundle, std::size_t most) {
  sys::FileInfo info;
  if (!bundle.file || !sys::file_info(bundle.file.get(), info) || info.kind != sys::FileInfo::Kind::file ||
      info.size < trailer_size)
    return false;
  std::array<char, trailer_size> bytes;
  if (!fill_at(bundle.file.get(), bytes, info.size - trailer_size)) return false;
  const std::string_view trailer(bytes.data(), bytes.size());
  const std::uint64_t rows = bytes_le::number64(trailer, magic.size());
  if (!trailer.starts_with(magic) || rows > most || rows > (info.size - trailer_size) / row_size)
    return false;
  bundle.index.resize(static_cast<std::size_t>(rows) * row_size);
  bundle.entries_end = info.size - trailer_size - bundle.index.size();
  bundle.written = info.written;
  return fill_at(bundle.file.get(), bundle.index, bundle.entries_end);
}

// Offset and size of an entry; none where the index does not have it, or where they lead out of the entries.
std::optional<std::pair<std::uint64_t, std::size_t>> place_in(const CacheFolder::State::Bundle& bundle,
                                                              std::string_view digest) {
  const std::string_view index = bundle.index;
  std::size_t first = 0, count = index.size() / row_size;
  while (count > 0) {
    const std::size_t half = count / 2;
    if (index.substr((first + half) * row_size, digest_digits) < digest) {
      first += half + 1;
      count -= half + 1;
    } else {
      count = half;
    }
  }
  if (first * row_size == index.size()) return std::nullopt;
  const std::string_view row = index.substr(first * row_size, row_size);
  if (!row.starts_with(digest)) return std::nullopt;
  const std::uint64_t at = bytes_le::number64(row, digest_digits),
                      size = bytes_le::number64(row, digest_digits + number_size);
  if (size > usual_entry || at > bundle.entries_end || size > bundle.entries_end - at) return std::nullopt;
  return std::pair(at, static_cast<std::size_t>(size));
}

}  // namespace

bool is_bundle_name(std::string_view name) {
  constexpr std::size_t digits = 16;
  return name.size() == digits + bundle_ending.size() && are_hex_digits(name.substr(0, digits)) &&
         name.ends_with(bundle_ending);
}

Descriptor CacheFolder::State::open_bundles() {
  return root ? open_folder(root.get(), std::string(folder_of_bundles)) : Descriptor();
}

void CacheFolder::State::read_bundles() {
  bundles_folder = open_bundles();
  if (!bundles_folder) return;
  std::size_t rows = 0;
  std::vector<std::string> names = names_in(bundles_folder.get());
  std::ranges::sort(names);
  for (const std::string& name : names) {
    if (!is_bundle_name(name) || bundles.size() == most_bundles) continue;
    auto bundle = std::make_unique<Bundle>();
    bundle->name = name;
    bundle->file = Descriptor(sys::open_in(bundles_folder.get(), name, sys::OpenIn::read));
    if (!read_index(*bundle, most_rows - rows)) continue;
    rows += bundle->index.size() / row_size;
    bundles.push_back(std::move(bundle));
  }
}

std::optional<CacheEntry> CacheFolder::State::look_up_in_bundles(const std::string& digest, bool& damaged) {
  for (const std::unique_ptr<Bundle>& bundle : bundles) {
    const auto place = place_in(*bundle, digest);
    if (!place) continue;
    std::array<char, usual_entry> bytes;
    const std::span<char> wanted(bytes.data(), place->second);
    auto out = fill_at(bundle->file.get(), wanted, place->first)
                   ? read_entry(digest, {wanted.data(), wanted.size()}, wanted.size(), -1)
                   : std::nullopt;
    if (!out) {
      damaged = true;
      continue;
    }
    if (!bundle->used.exchange(true) && is_old(bundle->written))
      (void)sys::touch_in(bundles_folder.get(), bundle->name.c_str());
    return out;
  }
  return std::nullopt;
}

void CacheFolder::State::add_to_bundle(const std::string& digest, std::string_view bytes) {
  const std::lock_guard guard(bundle_lock);
  if (!bundling || bundle_rows.size() == most_rows) return;
  if (!new_bundle) {
    new_bundle = std::make_unique<NewEntry::Open>(*this);
    bundling = new_bundle->create();
  }
  // A bundle may take what one entry may.
  const std::uint64_t size =
      new_bundle->got + bytes.size() + (bundle_rows.size() + 1) * row_size + trailer_size;
  bundling = bundling && in_blocks(size) <= options.most_bytes / 4;
  if (!bundling) return new_bundle.reset();
  std::string row = digest;
  bytes_le::append64(row, new_bundle->got);
  bytes_le::append64(row, bytes.size());
  bundle_rows.push_back(std::move(row));
  new_bundle->add(bytes);
}

void CacheFolder::State::keep_bundle() {
  const std::lock_guard guard(bundle_lock);
  bundling = false;
  const std::unique_ptr<NewEntry::Open> open = std::move(new_bundle);
  std::vector<std::string> rows = std::exchange(bundle_rows, {});
  if (!open || rows.size() < fewest_entries) return;
  std::ranges::sort(rows);
  for (const std::string& row : rows) open->add(row);
  std::string trailer(magic);
  bytes_le::append64(trailer, rows.size());
  open->add(trailer);
  (void)sys::make_folder_in(root.get(), std::string(folder_of_bundles), 0777);
  const Descriptor folder = open_bundles();
  std::uint64_t random = 0;
  if (!folder || !sys::random_bytes(&random, sizeof random)) return;
  // The one that was used longest ago makes room.
  std::vector<std::pair<sys::FileInfo::Time, std::string>> there;
  for (const std::string& name : names_in(folder.get())) {
    sys::FileInfo info;
    if (is_bundle_name(name) && sys::file_info_in(folder.get(), name.c_str(), info))
      there.emplace_back(info.written, name);
  }
  if (there.size() >= most_bundles) {
    const auto oldest = std::ranges::min_element(there, {}, [](const auto& each) {
      return std::tuple(each.first.seconds, each.first.nanoseconds, each.second);
    });
    (void)sys::remove_in(folder.get(), oldest->second.c_str());
  }
  const std::uint64_t size = open->got;
  if (open->rename_to(folder.get(), hex(random) + std::string(bundle_ending))) added += in_blocks(size);
}

void CacheFolder::expect(std::size_t look_ups) {
  State& s = *state_;
  if (look_ups < fewest_entries || !s.root) return;
  s.read_bundles();
  s.bundling = !s.closed;
}

}  // namespace etak
