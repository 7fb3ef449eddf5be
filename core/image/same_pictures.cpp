// SPDX-License-Identifier: Apache-2.0
#include "core/image/same_pictures.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/steady_file.h"
#include "core/base/hash/content_hash.h"
#include "core/base/system.h"
#include "core/image/files/png.h"

namespace etak {
namespace {

// Makes the pictures of the same bytes one.
void join_same_bytes(std::span<const PictureFile> pictures, const std::vector<bool>& used,
                     std::vector<int>& out) {
  // 0 for what is not there: who reads it tells so.
  const auto size_of = [](const PictureFile& picture) -> std::uint64_t {
    if (picture.path.empty()) return picture.bytes.size();
    sys::FileInfo info;
    return sys::file_info(picture.path, info) && info.kind == sys::FileInfo::Kind::file ? info.size : 0;
  };
  std::map<std::uint64_t, std::vector<std::size_t>> by_size;
  for (std::size_t i = 0; i < out.size(); ++i)
    if (used[i]) by_size[size_of(pictures[i])].push_back(i);
  for (const auto& [size, same] : by_size) {
    if (size == 0 || same.size() < 2) continue;
    std::map<std::string, std::size_t> known;
    for (const std::size_t i : same) {
      ContentHash hash;
      hash.add(pictures[i].path.empty() ? pictures[i].bytes
                                        : read_file(pictures[i].path, largest_picture_bytes));
      out[i] = static_cast<int>(known.try_emplace(hash.hex(), i).first->second);
    }
  }
}

// The rows of a PNG as they are in the file; none where it cannot be read row by row.
class PngTexels {
 public:
  explicit PngTexels(const PictureFile& picture) {
    if (picture.path.empty()) {
      png_ = PngReader::open(std::string_view(picture.bytes), picture.label);
    } else {
      file_ = std::make_unique<SteadyFile>(picture.path, largest_picture_bytes);
      png_ = PngReader::open(*file_, picture.path);
    }
    if (png_)
      row_.resize(static_cast<std::size_t>(header().width) * static_cast<std::size_t>(header().channels) *
                  static_cast<std::size_t>(header().bits / 8));
  }
  explicit operator bool() const { return png_.has_value(); }
  const PictureHeader& header() const { return png_->header(); }
  const std::vector<std::uint8_t>& next_row() {
    png_->read_rows(row_.data(), row_.size(), 1);
    return row_;
  }

 private:
  std::unique_ptr<SteadyFile> file_;
  std::optional<PngReader> png_;
  std::vector<std::uint8_t> row_;
};

// Both are read at once, and no further than to the first row that differs.
bool same_texels(const PictureFile& one, const PictureFile& other) {
  PngTexels a(one), b(other);
  if (!a || !b || a.header() != b.header()) return false;
  for (int y = 0; y < a.header().height; ++y)
    if (a.next_row() != b.next_row()) return false;
  return true;
}

// What pictures of the same texels have in common and can be told quickly: the header and the first row.
std::string first_look(const PictureFile& picture) {
  PngTexels texels(picture);
  if (!texels) return {};
  const PictureHeader& header = texels.header();
  std::string out;
  for (const int value : {header.width, header.height, header.channels, header.bits})
    out += std::to_string(value) + ' ';
  const std::vector<std::uint8_t>& row = texels.next_row();
  return out.append(row.begin(), row.end());
}

}  // namespace

std::vector<int> first_of_same_pictures(std::span<const PictureFile> pictures,
                                        const std::vector<bool>& used) {
  std::vector<int> out(pictures.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<int>(i);
  join_same_bytes(pictures, used, out);
  std::map<std::string, std::vector<int>> alike;  // by the first look
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!used[i] || out[i] != static_cast<int>(i)) continue;
    // A broken file is told where its texels are needed.
    std::string look;
    try {
      look = first_look(pictures[i]);
    } catch (const Error&) {
    }
    if (look.empty()) continue;
    std::vector<int>& others = alike[look];
    const auto same = std::ranges::find_if(others, [&](int other) {
      return same_texels(pictures[static_cast<std::size_t>(other)], pictures[i]);
    });
    if (same == others.end())
      others.push_back(static_cast<int>(i));
    else
      out[i] = *same;
  }
  // Pictures of the bytes of one that another stands for.
  for (int& first : out) first = out[static_cast<std::size_t>(first)];
  return out;
}

}  // namespace etak
