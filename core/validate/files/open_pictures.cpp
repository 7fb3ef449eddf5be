// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/open_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/error.h"
#include "core/base/files/steady_file.h"
#include "core/base/number.h"
#include "core/color/srgb.h"
#include "core/image/files/png.h"
#include "core/image/load.h"

namespace etak {

namespace {

constexpr std::string_view png_signature("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t largest = std::size_t{1} << 32;

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

std::string gamma_name(double gamma) {
  if (std::abs(gamma - 1) < 0.01) return "linear";
  // 0.45455 stands in countless sRGB files as the nearest power.
  if (std::abs(gamma - 0.45455) < 0.005) return "gamma22";
  return "gamma " + number(gamma, 5);
}

// What the chunks before the first IDAT say; nothing is trusted but lengths that fit.
void read_png_chunks(ByteSource& bytes, TextureHeader& header) {
  if (bytes.size() < 8 || bytes.view(0, 8) != png_signature) return;
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const std::string head(bytes.view(at, 8));
    const std::size_t length = big_endian(head, 0);
    const std::string_view type = std::string_view(head).substr(4);
    if (type == "IDAT" || length > bytes.size() - at - 12) return;
    // No more than the longest name of a colour profile.
    const std::string_view data = bytes.view(at + 8, std::min<std::size_t>(length, 80));
    if (type == "IHDR" && length == 13) {
      header.palette = data[9] == 3;
      header.bits = std::max<int>(8, static_cast<std::uint8_t>(data[8]));
    }
    if (type == "gAMA" && length == 4 && header.colour_space.empty())
      header.colour_space = gamma_name(big_endian(data, 0) / 100000.0);
    if (type == "iCCP")
      header.colour_space = "icc: " + std::string(data.substr(0, std::min<std::size_t>(data.find('\0'), 79)));
    if (type == "sRGB") {
      header.colour_space = "srgb";  // wins over gAMA, as the standard says
      return;
    }
    at += 12 + length;
  }
}

// `count` texels of `channels` values as RGBA codes.
template <class Value, class Code>
void spread(const Value* from, std::size_t count, std::size_t channels, std::uint8_t* to, Code code) {
  for (std::size_t i = 0; i < count; ++i, from += channels, to += 4) {
    for (std::size_t c = 0; c < 3; ++c) to[c] = code(from[channels >= 3 ? c : 0]);
    to[3] = channels % 2 == 0 ? code(from[channels - 1]) : std::uint8_t{255};
  }
}

std::uint8_t same(std::uint8_t value) {
  return value;
}
std::uint8_t rounded(std::uint16_t value) {
  return static_cast<std::uint8_t>((value * 255u + 32767u) / 65535u);
}

class PngRowSource : public RowSource {
 public:
  PngRowSource(std::unique_ptr<SteadyFile> file, PngReader reader, TextureHeader header)
      : file_(std::move(file)), reader_(std::move(reader)), header_(std::move(header)) {}

  const TextureHeader& header() const override { return header_; }

  void read_rows(std::uint8_t* rgba, std::size_t stride, int count) override {
    file_->read_checked([&] { convert_rows(rgba, stride, count); });
    rows_ += count;
    if (rows_ == reader_.info().height) file_->check_unchanged();
  }

 private:
  void convert_rows(std::uint8_t* rgba, std::size_t stride, int count) {
    const PngInfo& info = reader_.info();
    const auto width = static_cast<std::size_t>(info.width),
               channels = static_cast<std::size_t>(info.channels);
    if (info.channels == 4 && info.bits == 8) {
      reader_.read_rows(rgba, stride, count);
    } else {
      const std::size_t own = width * channels * (info.bits == 16 ? 2 : 1);
      buffer_.resize(own * static_cast<std::size_t>(count) + 1);
      reader_.read_rows(buffer_.data(), own, count);
      for (int i = 0; i < count; ++i) {
        const std::uint8_t* from = buffer_.data() + own * static_cast<std::size_t>(i);
        std::uint8_t* to = rgba + stride * static_cast<std::size_t>(i);
        if (info.bits == 8) {
          spread(from, width, channels, to, same);
        } else {
          wide_.resize(width * channels);
          std::memcpy(wide_.data(), from, own);
          spread(wide_.data(), width, channels, to, rounded);
        }
      }
    }
  }

  std::unique_ptr<SteadyFile> file_;
  PngReader reader_;
  TextureHeader header_;
  std::vector<std::uint8_t> buffer_;
  std::vector<std::uint16_t> wide_;
  int rows_ = 0;
};

class LoadedRowSource : public RowSource {
 public:
  LoadedRowSource(LoadedImage image, TextureHeader header)
      : image_(std::move(image)), header_(std::move(header)) {}

  const TextureHeader& header() const override { return header_; }

  void read_rows(std::uint8_t* rgba, std::size_t stride, int count) override {
    const auto width = static_cast<std::size_t>(header_.width),
               channels = static_cast<std::size_t>(header_.channels);
    for (int i = 0; i < count; ++i, ++next_, rgba += stride) {
      if (const auto* codes = std::get_if<Image8>(&image_.pixels))
        spread(codes->at(0, next_).data(), width, channels, rgba, same);
      else if (const auto* wide = std::get_if<Image16>(&image_.pixels))
        spread(wide->at(0, next_).data(), width, channels, rgba, rounded);
    }
  }

  void read_float_rows(float* rgba, std::size_t stride, int count) override {
    const Image& image = std::get<Image>(image_.pixels);
    const auto channels = static_cast<std::size_t>(image.channels);
    for (int i = 0; i < count; ++i, ++next_, rgba += stride)
      for (int x = 0; x < image.width; ++x) {
        const auto from = image.at(x, next_);
        float* to = rgba + 4 * x;
        for (std::size_t c = 0; c < 3; ++c) to[c] = from[channels >= 3 ? c : 0];
        to[3] = channels % 2 == 0 ? from[channels - 1] : 1.0f;
      }
  }

 private:
  LoadedImage image_;
  TextureHeader header_;
  int next_ = 0;
};

TextureHeader header_of(const LoadedImage& image) {
  TextureHeader header;
  header.width = image.width();
  header.height = image.height();
  header.channels = image.channels();
  header.bits = image.bits();
  header.floating = std::holds_alternative<Image>(image.pixels);
  header.lossy = image.lossy;
  header.format = image.format;
  if (image.icc_profile)
    header.colour_space = "icc";
  else if (image.srgb)
    header.colour_space = "srgb";
  else if (image.gamma)
    header.colour_space = gamma_name(*image.gamma);
  return header;
}

TextureHeader header_of(const PngInfo& info, ByteSource& bytes) {
  TextureHeader header;
  header.width = info.width;
  header.height = info.height;
  header.channels = info.channels;
  header.format = "png";
  read_png_chunks(bytes, header);
  header.bits = info.bits;
  return header;
}

std::unique_ptr<SteadyFile> open_file(const std::string& path) {
  auto file = std::make_unique<SteadyFile>(path, largest);
  if (file->size() == 0) throw Error::at(path, "an empty file", "a picture");
  return file;
}

// Takes the file over where it is PNG.
std::unique_ptr<RowSource> rows_of_png(std::unique_ptr<SteadyFile>& file, const std::string& path) {
  auto reader = file->read_checked([&] { return PngReader::open(*file, path); });
  if (!reader) return nullptr;
  TextureHeader header = header_of(reader->info(), *file);
  return std::make_unique<PngRowSource>(std::move(file), std::move(*reader), std::move(header));
}

// A picture that is decoded at once, and its header.
std::pair<LoadedImage, TextureHeader> load_whole(std::string_view bytes, const std::string& label,
                                                 const PictureDecoder& decoder) {
  LoadedImage image = load_picture(bytes, label, decoder);
  TextureHeader header = header_of(image);
  BytesInMemory source(bytes);
  read_png_chunks(source, header);
  return {std::move(image), std::move(header)};
}

}  // namespace

std::unique_ptr<RowSource> open_rows(const std::string& path) {
  auto file = open_file(path);
  return rows_of_png(file, path);
}

std::unique_ptr<RowSource> open_picture(const std::string& path, const PictureDecoder& decoder) {
  auto file = open_file(path);
  if (auto rows = rows_of_png(file, path)) return rows;
  auto [image, header] = load_whole(file->all(), path, decoder);
  return std::make_unique<LoadedRowSource>(std::move(image), std::move(header));
}

TextureHeader read_texture_header(const std::string& path, std::string_view bytes, const std::string& label,
                                  const PictureDecoder& decoder) {
  if (!bytes.empty()) {
    BytesInMemory source(bytes);
    if (const auto reader = PngReader::open(source, label)) return header_of(reader->info(), source);
    return load_whole(bytes, label, decoder).second;
  }
  const auto file = open_file(path);
  return file->read_checked([&] {
    if (const auto reader = PngReader::open(*file, label)) return header_of(reader->info(), *file);
    return load_whole(file->all(), label, decoder).second;
  });
}

Image8 load_codes(const std::string& path, std::string_view bytes, const std::string& label,
                  const PictureDecoder& decoder, TextureHeader& header) {
  auto [image, read_header] =
      bytes.empty() ? load_whole(open_file(path)->all(), label, decoder) : load_whole(bytes, label, decoder);
  header = std::move(read_header);
  if (auto* codes = std::get_if<Image8>(&image.pixels)) return std::move(*codes);
  Image8 out(image.width(), image.height(), image.channels());
  if (const auto* wide = std::get_if<Image16>(&image.pixels)) {
    std::transform(wide->values.begin(), wide->values.end(), out.values.begin(), rounded);
    return out;
  }
  const Image& floats = std::get<Image>(image.pixels);
  const auto channels = static_cast<std::size_t>(floats.channels);
  for (std::size_t i = 0; i < floats.values.size(); ++i) {
    const float v = floats.values[i] > 0 ? floats.values[i] : 0;  // NaN too
    out.values[i] = i % channels == 3 ? to_code(v) : srgb_u8(std::min(1.0, static_cast<double>(v)));
  }
  return out;
}

}  // namespace etak
