// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/sources/plane.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/atlas/texels/page_memory.h"
#include "core/base/error.h"
#include "core/base/files/input.h"
#include "core/base/files/steady_file.h"
#include "core/base/parallel.h"
#include "core/image/linear_tables.h"
#include "core/image/picture_bytes.h"

namespace etak {
namespace {

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
  constexpr std::size_t signature_and_first_chunk = 33;
  const std::string header = read_head(path, signature_and_first_chunk);
  BytesInMemory bytes(header);
  // PngReader tells later what is wrong with a broken PNG.
  if (auto png = png_header(bytes); png && png->strips) return *png;
  if (is_gpu_texture(picture_format(header, path))) return load_picture(path, door).header;
  return door.header(path);
}

std::array<int, 3> picked_channels(const PlaneSource& source, int channels) {
  // A picture of colours that serves as a grey quantity must say which channel is meant.
  const auto pick = source.color && !source.picked && channels <= 2 ? std::array{0, 0, 0} : source.pick;
  const int last = source.color ? std::ranges::max(pick) : pick[0];
  if (last >= channels)
    throw Error::at(source.path, "has " + std::to_string(channels) + " channels",
                    "at least " + std::to_string(last + 1));
  return pick;
}

void refuse_not_finite(const PlaneSource& source) {
  throw Error::at(source.path, "holds a value that is no finite number", "finite numbers");
}

void check_size(const PlaneSource& source, int width, int height, int expected_width, int expected_height) {
  if (width == expected_width && height == expected_height) return;
  throw Error::at(source.path, "is " + std::to_string(width) + " x " + std::to_string(height),
                  std::to_string(expected_width) + " x " + std::to_string(expected_height) +
                      ", as when it was looked at");
}

DecodedFiles decoded_files(std::vector<std::string> paths, const PictureDoor& door,
                           const DecodedFiles& known) {
  std::sort(paths.begin(), paths.end());
  paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
  DecodedFiles out;
  for (const std::string& path : paths) out[path].stamp = stamp_of(path);
  parallel_chunks(paths.size(), thread_count(0), 1, [&](std::size_t i, std::size_t, unsigned) {
    DecodedFile& file = out.at(paths[i]);
    const auto before = known.find(paths[i]);
    file.picture = before != known.end() && before->second.stamp == file.stamp
                       ? before->second.picture
                       : std::make_shared<const Picture>(load_picture(paths[i], door));
  });
  return out;
}

std::shared_ptr<const Picture> PlaneSource::known() const {
  if (decoded == nullptr) return nullptr;
  const auto at = decoded->find(path);
  return at != decoded->end() ? at->second.picture : nullptr;
}

PlaneRows::PlaneRows(const PlaneSource& source, FileBytes& memory, int first) : source_(&source) {
  if (!source.is_image()) return;
  auto known = source.known();
  assert(known || first == 0);
  if (!known) memory.load(source.path);
  if (known)
    file_.emplace(std::move(known), first);
  else if (auto png = PngReader::open(memory.view(), source.path))
    file_.emplace(std::move(*png));
  else
    file_.emplace(load_picture(source.path, *source.door));
  const PictureHeader& header = file_->header();
  width_ = header.width;
  height_ = header.height;
  pick_ = picked_channels(source, header.channels);
  file_channels_ = header.channels;
  channels_ = source.space ? 3 : header.channels;
  if (source.space || header.floating) return;
  if (header.bits == 16 || (source.curve && source.curve->apply)) {
    codes_ = (source.curve ? *source.curve : CodeCurve()).codes(header.bits, &clamps_);
    for (const bool each : clamps_) may_clamp_ = may_clamp_ || each;
  }
}

// Puts three channels of codes into rows_: those of the picked channels, converted from the colour space.
template <class Sample>
void PlaneRows::convert_space(const Sample* in, std::size_t texels, int step, float scale) {
  floats_.resize(3 * texels);
  for (std::size_t i = 0; i < texels; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto value =
          static_cast<float>(in[i * static_cast<std::size_t>(step) + static_cast<std::size_t>(pick_[c])]);
      if (!std::isfinite(value)) refuse_not_finite(*source_);
      floats_[3 * i + c] = value / scale;
    }
  source_->space(floats_.data(), texels);
  rows_.resize(3 * texels);
  const LinearTables& tables = linear_tables();
  // Values that round to 0 and to 255 are inside: half a code at either end, which is linear at the lower one.
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

// Puts the codes of values_ into rows_. Values of files of floats are linear.
void PlaneRows::convert_floats() {
  static const CodeCurve unchanged;
  const CodeCurve& curve = source_->curve ? *source_->curve : unchanged;
  const auto& apply = curve.apply_float ? curve.apply_float : curve.apply;
  rows_.resize(values_.size());
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const double value = double{values_[i]};
    if (!std::isfinite(value)) refuse_not_finite(*source_);
    const double encoded = apply ? apply(value) : value;
    rows_[i] = code_of(encoded);
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
  assert(width_ > 0);
  const auto texels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(count);
  const std::size_t all = texels * static_cast<std::size_t>(file_channels_);
  const auto fill = [&]<class Value>(std::vector<Value>& values) {
    values.resize(all);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): values as bytes
    file_->read(reinterpret_cast<std::uint8_t*>(values.data()),
                all * sizeof(Value) / static_cast<std::size_t>(count), count);
  };
  const auto coded = [&]<class Code>(const std::vector<Code>& values) {
    if (source_->space)
      convert_space(values.data(), texels, file_channels_, float{std::numeric_limits<Code>::max()});
    else
      convert(values.data(), all);
  };
  if (file_->header().floating) {
    fill(values_);
    if (source_->space)
      convert_space(values_.data(), texels, file_channels_, 1);
    else
      convert_floats();
  } else if (file_->header().bits == 16) {
    fill(wide_);
    coded(wide_);
  } else {
    fill(raw_);
    if (!source_->space && codes_.empty()) return raw_.data();
    coded(raw_);
  }
  return rows_.data();
}

}  // namespace etak
