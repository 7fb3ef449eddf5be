// SPDX-License-Identifier: Apache-2.0
#include "core/pack/pack_cache.h"

#include <algorithm>
#include <array>
#include <set>
#include <type_traits>

#include "core/base/bytes/member_bytes.h"
#include "core/base/files/input.h"
#include "core/base/files/paths.h"
#include "core/base/files/temporary.h"
#include "core/base/hash/sha256.h"
#include "core/base/parallel.h"
#include "core/pack/earlier.h"
#include "core/pack/pack.h"

namespace etak {
namespace {

CacheOptions of_atlases(CacheOptions options) {
  options.kind = "pack";
  return options;
}

// What the text of an entry holds.
struct KeptText {
  PackTold told;
  std::vector<KeptAtlas::File> files;
};

template <class Struct>
concept KeptPart = std::is_same_v<Struct, PackTold> || std::is_same_v<Struct, KeptAtlas::File> ||
    std::is_same_v<Struct, KeptText>;

// Calls `take` with the bytes of a file from `at` on, piece by piece; false where they cannot be read.
template <class Take>
bool for_bytes(int file, std::uint64_t at, std::uint64_t count, Take take) {
  std::array<char, std::size_t{1} << 16> piece;
  while (count > 0) {
    const std::ptrdiff_t got = sys::read_at(
        file, piece.data(), static_cast<std::size_t>(std::min<std::uint64_t>(count, piece.size())), at);
    if (got <= 0) return false;
    take(std::string_view(piece.data(), static_cast<std::size_t>(got)));
    at += static_cast<std::uint64_t>(got);
    count -= static_cast<std::uint64_t>(got);
  }
  return true;
}

bool same_stamp(const sys::FileInfo& info, const FileStamp& stamp) {
  return FileStamp{info.device, info.number, info.size, info.written.seconds, info.written.nanoseconds} ==
         stamp;
}

}  // namespace

template <class To, class Struct>
requires KeptPart<std::remove_const_t<Struct>>
void members(To& to, Struct& s) {
  using Type = std::remove_const_t<Struct>;
  const auto all = [&](auto&... values) { (to.member(values), ...); };
  if constexpr (std::is_same_v<Type, PackTold>)
    all(s.text, s.json, s.findings, s.findings_in_colour, s.verdict, s.remarks, s.failed, s.incomplete,
        s.page);
  else if constexpr (std::is_same_v<Type, KeptAtlas::File>)
    all(s.name, s.sha256, s.size);
  else
    all(s.told, s.files);
}

PackCache::PackCache(CacheOptions options, const std::string& version, unsigned threads)
    : folder_(of_atlases(std::move(options))), program_(program_fingerprint(version)), threads_(threads) {}

std::string PackCache::key_of(const PackJobIdentity& job) const {
  std::string text = "job\n" + program_ + '\n' + job.settings + '\n' + job.input + '\n' + job.output + '\n';
  std::vector<std::string> files = job.files;
  if (is_folder(job.input)) {
    const Descriptor folder(sys::open_file(job.input, sys::Open::folder));
    if (!folder) return {};
    for (const std::string& name : names_in(folder.get())) text += name + '\n';
  } else {
    files.push_back(job.input);
  }
  for (const std::string& file : files) {
    sys::FileInfo info;
    const std::string hash = folder_.hash_of(file, info);
    if (hash.empty()) return {};
    text += file + '\n' + hash + '\n';
  }
  return sha256(text);
}

// The key of an atlas by the bytes of the files that its input names; empty where one cannot be read, or is not
// what was expected of it.
std::string PackCache::second_key(const std::string& first, const std::vector<std::string>& files,
                                  const std::vector<std::pair<std::string, FileStamp>>* expected) const {
  std::vector<std::string> hashes(files.size());
  parallel_chunks(files.size(), threads_, 1, [&](std::size_t begin, std::size_t, unsigned) {
    sys::FileInfo info;
    std::string hash = folder_.hash_of(files[begin], info);
    // The bytes of a pipe are kept in memory and do not change.
    if (expected == nullptr || is_pipe_input(files[begin]) || same_stamp(info, (*expected)[begin].second))
      hashes[begin] = std::move(hash);
  });
  std::string text = "atlas\n" + first + '\n';
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (hashes[i].empty()) return {};
    text += files[i] + '\n' + hashes[i] + '\n';
  }
  return sha256(text);
}

std::optional<KeptAtlas> PackCache::find(const std::string& key) {
  if (key.empty()) return std::nullopt;
  std::vector<std::string> files;
  std::string second;
  if (const auto list = folder_.find_part(key)) {
    MemberReader in(list->text);
    in.member(files);
    if (in.good()) second = second_key(key, files, nullptr);
  }
  if (second.empty()) {
    folder_.count_miss();
    return std::nullopt;
  }
  auto entry = folder_.find(second);
  if (!entry) return std::nullopt;
  KeptText text;
  MemberReader in(entry->text);
  in.member(text);
  std::uint64_t sum = 0;
  for (const KeptAtlas::File& file : text.files) sum += file.size;
  const bool plain = std::ranges::all_of(
      text.files, [](const KeptAtlas::File& file) { return is_plain_file_name(file.name); });
  if (!in.good() || !plain || sum != entry->rest_size) {
    folder_.refuse_hit();
    return std::nullopt;
  }
  return KeptAtlas{std::move(text.told), std::move(text.files), std::move(files), std::move(*entry)};
}

bool PackCache::is_in_place(const KeptAtlas& atlas, const std::string& output) {
  const EarlierAtlas earlier = earlier_atlas(output);
  std::set<std::string> names;
  for (const KeptAtlas::File& file : atlas.files) names.insert(file.name);
  // A file of the earlier atlas that this one lacks has to go.
  if (!std::ranges::all_of(earlier.files, [&](const std::string& name) { return names.contains(name); }))
    return false;
  return std::ranges::all_of(atlas.files, [&](const KeptAtlas::File& file) {
    return sha256_of_file(output + '/' + file.name) == file.sha256;
  });
}

std::unique_ptr<OutputFolder> PackCache::restored(KeptAtlas& atlas, const std::string& output,
                                                  bool overwrite) {
  EarlierAtlas earlier = earlier_atlas(output);
  earlier.inputs = ReadPlaces(atlas.inputs);
  check_place(earlier, overwrite);
  for (const KeptAtlas::File& file : atlas.files) refuse_stranger(earlier, file.name, overwrite);
  auto out = std::make_unique<OutputFolder>(output, may_replace(overwrite));
  out->limit_mode(strictest_mode(atlas.inputs));
  std::uint64_t at = atlas.entry.rest_at;
  std::set<std::string> names;
  for (const KeptAtlas::File& kept : atlas.files) {
    Sha256 hash;
    const auto file = out->open(kept.name);
    const bool whole = for_bytes(atlas.entry.file.get(), at, kept.size, [&](std::string_view bytes) {
      hash.add(bytes);
      file->add(bytes);
    });
    if (!whole || !same_digest(hash.finish(), kept.sha256)) {
      folder_.refuse_hit();
      return nullptr;
    }
    file->close();
    at += kept.size;
    names.insert(kept.name);
  }
  if (std::string stayed = remove_earlier(*out, earlier, names); !stayed.empty())
    atlas.told.remarks.push_back(std::move(stayed));
  return out;
}

std::optional<PackCache::Keeping> PackCache::gather(const std::string& key, const PackResult& result,
                                                    const PackTold& told,
                                                    const std::vector<std::string>& names,
                                                    const OutputFolder& folder) {
  // A search that the clock has ended may end elsewhere the next time.
  if (key.empty() || result.cut_by_time) return std::nullopt;
  std::vector<std::string> inputs;
  for (const auto& [file, stamp] : result.inputs) inputs.push_back(file);
  const std::string second = second_key(key, inputs, &result.inputs);
  if (second.empty()) return std::nullopt;

  KeptText text{told, {}};
  std::uint64_t all = 0;
  for (const std::string& name : names) {
    sys::FileInfo info;
    KeptAtlas::File& file = text.files.emplace_back();
    file.name = name;
    file.sha256 = sha256_of_file(folder.path_until_commit(name), info);
    file.size = info.size;
    if (file.sha256.empty()) return std::nullopt;
    all += info.size;
  }
  MemberWriter bytes;
  bytes.member(text);
  Keeping out;
  out.atlas_ = folder_.begin(second, bytes.bytes, all);
  if (!out.atlas_) return std::nullopt;
  for (const KeptAtlas::File& kept : text.files) {
    const Descriptor file(sys::open_file(folder.path_until_commit(kept.name), sys::Open::read));
    if (!file ||
        !for_bytes(file.get(), 0, kept.size, [&](std::string_view piece) { out.atlas_->add(piece); }))
      return std::nullopt;
  }
  MemberWriter list;
  list.member(inputs);
  out.first_ = key;
  out.list_ = std::move(list.bytes);
  out.cache_ = this;
  return out;
}

void PackCache::Keeping::keep() {
  atlas_->keep();
  cache_->folder_.keep(first_, list_);
}

}  // namespace etak
