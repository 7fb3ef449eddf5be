// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/sources/plane.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>

#include "core/base/error.h"
#include "core/base/files/input.h"
#include "core/image/linear_tables.h"

namespace etak {
namespace {

std::uint32_t big_endian(const unsigned char* bytes) {
  return (std::uint32_t{bytes[0]} << 24) | (std::uint32_t{bytes[1]} << 16) | (std::uint32_t{bytes[2]} << 8) |
         bytes[3];
}

// The head of a PNG that png.h reads, without its other bytes. What is wrong with it PngReader tells later.
std::optional<PictureHeader> png_header(const std::string& path) {
  std::array<unsigned char, 29> head{};
  const std::string bytes = read_head(path, head.size());
  constexpr unsigned char first[] = {0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13, 'I', 'H', 'D', 'R'};
  if (bytes.size() < head.size() || std::memcmp(bytes.data(), first, sizeof first) != 0) return std::nullopt;
  std::copy(bytes.begin(), bytes.end(), head.begin());
  const std::uint32_t width = big_endian(&head[16]), height = big_endian(&head[20]);
  const int bits = head[24], color = head[25];
  const int channels = color == 0 ? 1 : color == 4 ? 2 : color == 2 ? 3 : color == 6 ? 4 : 0;
  const bool ours = (bits == 8 || bits == 16) && channels != 0 && head[28] == 0;
  const bool sizes = width >= 1 && height >= 1 && width <= std::uint32_t{max_image_side} &&
                     height <= std::uint32_t{max_image_side};
  if (!ours || !sizes) return std::nullopt;
  return PictureHeader{static_cast<int>(width), static_cast<int>(height), channels, bits, true};
}

std::uint8_t code_of(double encoded) {
  const double clamped = encoded > 0 ? (encoded < 1 ? encoded : 1.0) : 0.0;
  return static_cast<std::uint8_t>(255 * clamped + 0.5);
}

// Half a code beyond the ends is what rounding makes of the ends themselves.
bool outside(double encoded) {
  return !(encoded > -0.5 / 255 && encoded < 1 + 0.5 / 255);
}

}  // namespace

std::vector<std::uint8_t> CodeCurve::codes(int bits, std::vector<bool>* clamped) const {
  const std::size_t count = std::size_t{1} << bits;
  std::vector<std::uint8_t> out(count);
  if (clamped != nullptr) clamped->assign(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    const double value = static_cast<double>(i) / static_cast<double>(count - 1);
    const double encoded = apply ? apply(value) : value;
    out[i] = code_of(encoded);
    if (clamped != nullptr && outside(encoded)) (*clamped)[i] = true;
  }
  return out;
}

PictureHeader picture_header(const std::string& path, const PictureDoor& door) {
  if (const auto png = png_header(path)) return *png;
  PictureHeader header = door.header(path);
  header.strips = false;
  return header;
}

PlaneRows::PlaneRows(const PlaneSource& source, FileBytes& memory) : source_(&source) {
  if (!source.is_image()) return;
  memory.load(source.path);
  png_ = PngReader::open(memory.view(), source.path);
  if (!png_) {
    open_whole(source);
    return;
  }
  const PngInfo& info = png_->info();
  width_ = info.width;
  height_ = info.height;
  bits_ = info.bits;
  check_channels(info.channels);
  if (!source.space && (bits_ == 16 || (source.curve && source.curve->apply))) {
    static const CodeCurve unchanged;
    codes_ = (source.curve ? *source.curve : unchanged).codes(bits_, &clamps_);
    for (const bool each : clamps_) may_clamp_ = may_clamp_ || each;
  }
}

void PlaneRows::check_channels(int channels) {
  channels_ = file_channels_ = channels;
  pick_ = source_->pick;
  // A grey picture serves as a colour; a colour that is to be a grey quantity must say which channel.
  if (source_->color && !source_->picked && channels <= 2) pick_ = {0, 0, 0};
  const int last = source_->color ? std::max({pick_[0], pick_[1], pick_[2]}) : pick_[0];
  if (last >= channels)
    throw Error::at(source_->path, "has " + std::to_string(channels) + " channels",
                    "at least " + std::to_string(last + 1));
  if (source_->space) channels_ = 3;
}

// Three channels of codes in rows_, from what the space makes of the picked ones.
template <class Sample>
void PlaneRows::convert_space(const Sample* in, std::size_t texels, int step, float scale) {
  floats_.resize(3 * texels);
  for (std::size_t i = 0; i < texels; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto value =
          static_cast<float>(in[i * static_cast<std::size_t>(step) + static_cast<std::size_t>(pick_[c])]);
      if (!std::isfinite(value))
        throw Error::at(source_->path, "holds a value that is no finite number", "finite numbers");
      floats_[3 * i + c] = value / scale;
    }
  source_->space(floats_.data(), texels);
  rows_.resize(3 * texels);
  const LinearTables& tables = linear_tables();
  // What rounds to 0 and to 255 is inside: half a code at either end, which is linear at the lower one.
  constexpr float lowest = -0.5f / 255 / 12.92f, highest = 1.00447f;
  for (std::size_t i = 0; i < floats_.size(); ++i) {
    const float linear = floats_[i];
    if (!std::isfinite(linear))
      throw Error::at(source_->path, "has colours that " + source_->space_name + " makes no finite number of",
                      "values of that space");
    clamped_ += linear < lowest || linear > highest ? 1 : 0;
    rows_[i] = tables.srgb_code(linear);
  }
}

// Formats without strips of their own: the whole picture at once, as codes.
void PlaneRows::open_whole(const PlaneSource& source) {
  const auto loaded = source.door->load(source.path);
  std::visit(
      [&](const auto& picture) {
        width_ = picture.width;
        height_ = picture.height;
        check_channels(picture.channels);
      },
      loaded);
  if (source.space) {
    std::visit(
        [&](const auto& picture) {
          const bool codes = sizeof(picture.values[0]) == 1;
          convert_space(picture.values.data(), picture.pixel_count(), picture.channels,
                        codes ? 255.0f : 1.0f);
        },
        loaded);
    whole_.values.swap(rows_);
    return;
  }
  static const CodeCurve unchanged;
  const CodeCurve& curve = source.curve ? *source.curve : unchanged;
  if (const auto* codes = std::get_if<Image8>(&loaded)) {
    whole_ = *codes;
    if (curve.apply) {
      codes_ = curve.codes(8, &clamps_);
      convert(codes->values.data(), codes->values.size());
      whole_.values.swap(rows_);
    }
    return;
  }
  const Image& picture = std::get<Image>(loaded);
  whole_ = Image8(picture.width, picture.height, picture.channels);
  // Files of floats hold linear colours, codes of 16 bits encoded ones.
  const bool floats = source.door->header(source.path).bits != 16;
  const auto& apply = floats && curve.apply_float ? curve.apply_float : curve.apply;
  for (std::size_t i = 0; i < picture.values.size(); ++i) {
    const double value = double{picture.values[i]};
    if (!std::isfinite(value))
      throw Error::at(source.path, "holds a value that is no finite number", "finite numbers");
    const double encoded = apply ? apply(value) : value;
    whole_.values[i] = code_of(encoded);
    clamped_ += outside(encoded) ? 1 : 0;
  }
}

template <class Sample>
void PlaneRows::convert(const Sample* in, std::size_t samples) {
  rows_.resize(samples);
  for (std::size_t i = 0; i < samples; ++i) rows_[i] = codes_[in[i]];
  if (!may_clamp_) return;
  for (std::size_t i = 0; i < samples; ++i) clamped_ += clamps_[in[i]] ? 1 : 0;
}

const std::uint8_t* PlaneRows::read(int count) {
  assert(width_ > 0 && row_ + count <= height_);
  const auto texels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(count);
  const auto first =
      static_cast<std::size_t>(row_) * static_cast<std::size_t>(width_) * static_cast<std::size_t>(channels_);
  row_ += count;
  if (!png_) return whole_.values.data() + first;
  const std::size_t all = texels * static_cast<std::size_t>(file_channels_),
                    bytes = all * static_cast<std::size_t>(bits_ / 8);
  raw_.resize(bytes);
  png_->read_rows(raw_.data(), bytes / static_cast<std::size_t>(count), count);
  if (bits_ == 8) {
    if (source_->space)
      convert_space(raw_.data(), texels, file_channels_, 255);
    else if (codes_.empty())
      return raw_.data();
    else
      convert(raw_.data(), all);
  } else {
    std::vector<std::uint16_t> wide(all);
    std::memcpy(wide.data(), raw_.data(), 2 * all);
    if (source_->space)
      convert_space(wide.data(), texels, file_channels_, 65535);
    else
      convert(wide.data(), all);
  }
  return rows_.data();
}

}  // namespace etak
