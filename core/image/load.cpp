// SPDX-License-Identifier: Apache-2.0
#include "core/image/load.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "core/base/error.h"
#include "core/base/files/steady_file.h"
#include "core/base/memory.h"
#include "core/color/srgb.h"
#include "core/image/files/containers.h"
#include "core/image/picture_bytes.h"

namespace etak {
namespace {

// Calls a function of the door for `source`: a path, or bytes and their label. Throws Error where the door
// has no such function.
template <class Decode, class... Source>
Picture decoded(const Decode& decode, const std::string& label, const Source&... source) {
  if (!decode) throw Error::at(label, "is of a form that needs a decoder of pictures", "a plain PNG");
  return decode(source...);
}

template <class Value>
Picture whole(PngReader& png) {
  const PictureHeader& header = png.header();
  Pixels<Value> pixels(header.width, header.height, header.channels);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): values as bytes
  png.read_rows(reinterpret_cast<std::uint8_t*>(pixels.values.data()),
                static_cast<std::size_t>(header.width * header.channels) * sizeof(Value), header.height);
  return {header, std::move(pixels)};
}

// Level 0 of a KTX2 or DDS file that etak reads itself: OpenImageIO has no reader of KTX2, and refuses RGBA8 under the
// newer header of DDS. DDS files of other formats than RGBA8 and BC1 to BC7 are left to the door.
std::optional<Picture> texture_file(std::string_view bytes, const std::string& label,
                                    const PictureDoor& door) {
  const std::string format = picture_format(bytes.substr(0, 32), label);
  const bool ktx2 = format == "ktx2";
  if (!ktx2 && (format != "dds" || !has_known_dds_format(bytes))) return {};
  TextureFile file = ktx2 ? read_ktx2(bytes, label, door.astc) : read_dds(bytes, label);
  Picture out;
  if (holds_floats(file.blocks)) {
    out.header = header_of(file.floats.front());
    out.header.bits = 16;
    out.pixels = std::move(file.floats.front());
  } else {
    out.header = header_of(file.levels.front());
    out.pixels = std::move(file.levels.front());
  }
  out.header.format = format;
  if (file.blocks != nullptr && file.blocks->code != BlockCode::r8) {
    out.header.lossy = true;
    out.header.blocks = file.blocks->name;
    out.header.bits_per_texel = bits_per_texel(*file.blocks);
  }
  if (file.srgb) out.header.colour_space = "srgb";
  return out;
}

// Writes each texel of `from`, which has `channels` values, as four values (see four_channels()), each
// converted by code().
template <class Value, class Out, class Code>
void spread(const std::vector<Value>& from, std::size_t channels, Out* to, Value full, Code code) {
  for (std::size_t i = 0; i < from.size(); i += channels, to += 4)
    std::ranges::transform(four_channels(from.data() + i, channels, full), to, code);
}

// The rows of a picture; where they come from a file, throws Error if the file changes while they are read.
class FileRows : public RowSource {
 public:
  FileRows(std::unique_ptr<SteadyFile> file, ValueRows rows)
      : RowSource(rows.header()), file_(std::move(file)), rows_(std::move(rows)) {}

  void read_rows(std::uint8_t* rgba, std::size_t stride, int count) override {
    if (!file_) return convert(rgba, stride, count);
    file_->read_checked([&] { convert(rgba, stride, count); });
    if ((read_ += count) == header_.height) file_->check_unchanged();
  }

  void read_float_rows(float* rgba, std::size_t stride, int count) override {
    for (int i = 0; i < count; ++i, rgba += stride)
      spread(next_row(floats_), channels(), rgba, 1.0f, [](float value) { return value; });
  }

 private:
  std::size_t channels() const { return static_cast<std::size_t>(header_.channels); }

  template <class Value>
  const std::vector<Value>& next_row(std::vector<Value>& row) {
    row.resize(static_cast<std::size_t>(header_.width) * channels());
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): values as bytes
    rows_.read(reinterpret_cast<std::uint8_t*>(row.data()), row.size() * sizeof(Value), 1);
    return row;
  }

  void convert(std::uint8_t* rgba, std::size_t stride, int count) {
    if (header_.bits == 8 && header_.channels == 4) return rows_.read(rgba, stride, count);
    for (int i = 0; i < count; ++i, rgba += stride)
      if (header_.bits == 8)
        spread(next_row(codes_), channels(), rgba, std::uint8_t{255}, [](std::uint8_t code) { return code; });
      else
        spread(next_row(wide_), channels(), rgba, std::uint16_t{65535}, rounded_code);
  }

  std::unique_ptr<SteadyFile> file_;
  ValueRows rows_;
  int read_ = 0;
  std::vector<std::uint8_t> codes_;
  std::vector<std::uint16_t> wide_;
  std::vector<float> floats_;
};

std::unique_ptr<SteadyFile> open_file(const std::string& path) {
  auto file = std::make_unique<SteadyFile>(path, largest_picture_bytes);
  if (file->size() == 0) throw Error::at(path, "an empty file", "a picture");
  return file;
}

std::unique_ptr<RowSource> rows_of(Picture picture) {
  return std::make_unique<FileRows>(nullptr, ValueRows(std::move(picture)));
}

}  // namespace

Picture load_picture(std::string_view bytes, const std::string& label, const PictureDoor& door) {
  return with_memory_for(
      label, [] { return "its pixels"; },
      [&] {
        BytesInMemory file(bytes);
        if (auto png = PngReader::open(file, label))
          return png->header().bits == 8 ? whole<std::uint8_t>(*png) : whole<std::uint16_t>(*png);
        if (auto texture = texture_file(bytes, label, door)) return *std::move(texture);
        Picture out = decoded(door.bytes, label, bytes, label);
        if (const auto png = png_header(file)) {
          out.header.palette = png->palette;
          out.header.colour_space = png->colour_space;
          out.header.primaries = png->primaries;
        }
        return out;
      });
}

Picture load_picture(const std::string& path, const PictureDoor& door) {
  const std::string format = picture_format(read_head(path, 32), path);
  if (format != "png" && !is_gpu_texture(format))
    return with_memory_for(
        path, [] { return "its pixels"; }, [&] { return decoded(door.file, path, path); });
  return load_picture(SteadyFile(path, largest_picture_bytes).all(), path, door);
}

Picture load_picture(const PictureFile& file, const PictureDoor& door) {
  if (!file.bytes.empty()) return load_picture(file.bytes, file.label, door);
  (void)open_file(file.path);  // throws Error for an empty file
  return load_picture(file.path, door);
}

const PictureHeader& ValueRows::header() const {
  if (const auto* png = std::get_if<PngReader>(&from_)) return png->header();
  return std::get<std::shared_ptr<const Picture>>(from_)->header;
}

void ValueRows::read(std::uint8_t* out, std::size_t stride, int count) {
  if (auto* png = std::get_if<PngReader>(&from_)) return png->read_rows(out, stride, count);
  std::visit(
      [&](const auto& pixels) {
        for (int i = 0; i < count; ++i, out += stride) {
          const auto row = pixels.at(0, next_++);
          std::memcpy(out, row.data(), static_cast<std::size_t>(pixels.width) * row.size_bytes());
        }
      },
      std::get<std::shared_ptr<const Picture>>(from_)->pixels);
}

std::unique_ptr<RowSource> open_rows(const std::string& path) {
  auto file = open_file(path);
  auto png = file->read_checked([&] { return PngReader::open(*file, path); });
  return png ? std::make_unique<FileRows>(std::move(file), ValueRows(std::move(*png))) : nullptr;
}

std::unique_ptr<RowSource> open_picture(const std::string& path, const PictureDoor& door) {
  if (auto rows = open_rows(path)) return rows;
  return rows_of(load_picture(path, door));
}

std::unique_ptr<RowSource> open_picture(const PictureFile& file, const PictureDoor& door) {
  return file.bytes.empty() ? open_picture(file.path, door) : open_picture(file.bytes, file.label, door);
}

std::unique_ptr<RowSource> open_picture(std::string_view bytes, const std::string& label,
                                        const PictureDoor& door) {
  if (auto png = PngReader::open(bytes, label))
    return std::make_unique<FileRows>(nullptr, ValueRows(std::move(*png)));
  return rows_of(load_picture(bytes, label, door));
}

namespace {

// The rules that all 16-bit values so far follow.
struct Multiples {
  bool of_257 = true, of_256 = true, vary = false;
  std::optional<std::uint16_t> first = {};

  bool any() const { return of_257 || of_256; }
  void add(const std::vector<std::uint16_t>& values) {
    if (!first && !values.empty()) first = values.front();
    for (const std::uint16_t value : values) {
      of_257 = of_257 && value % 257 == 0;
      of_256 = of_256 && value % 256 == 0;
      vary = vary || value != *first;
    }
  }
};

Multiples multiples_of(ValueRows rows) {
  const PictureHeader header = rows.header();
  std::vector<std::uint16_t> row(static_cast<std::size_t>(header.width * header.channels));
  Multiples out;
  for (int y = 0; y < header.height && out.any(); ++y) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): values as bytes
    rows.read(reinterpret_cast<std::uint8_t*>(row.data()), 2 * row.size(), 1);
    out.add(row);
  }
  return out;
}

bool is_wide(const PictureHeader& header) {
  return header.bits == 16 && !header.floating;
}

}  // namespace

bool holds_8_bits(const PictureFile& file, const PictureDoor& door) {
  constexpr std::size_t depth_of_png = 24;  // the place of the byte that has a PNG's bits a value
  const bool inside = !file.bytes.empty();
  const std::string head = inside ? file.bytes.substr(0, 32) : read_head(file.path, 32);
  const std::string format = picture_format(head, inside ? file.label : file.path);
  if (format == "png" ? head.size() <= depth_of_png || head[depth_of_png] != 16 : format != "tiff")
    return false;
  Multiples found;
  if (format == "png" && inside) {
    if (auto png = PngReader::open(file.bytes, file.label)) {
      if (!is_wide(png->header())) return false;
      found = multiples_of(ValueRows(std::move(*png)));
      return found.any() && found.vary;
    }
  } else if (format == "png") {
    const auto opened = open_file(file.path);
    auto png = opened->read_checked([&] { return PngReader::open(*opened, file.path); });
    if (png) {
      if (!is_wide(png->header())) return false;
      found = opened->read_checked([&] { return multiples_of(ValueRows(std::move(*png))); });
      return found.any() && found.vary;
    }
  }
  Picture whole = load_picture(file, door);
  if (!is_wide(whole.header)) return false;
  found = multiples_of(ValueRows(std::move(whole)));
  return found.any() && found.vary;
}

Image8 codes_of(Picture picture, bool floats_linear) {
  if (auto* codes = std::get_if<Image8>(&picture.pixels)) return std::move(*codes);
  const PictureHeader& header = picture.header;
  Image8 out(header.width, header.height, header.channels);
  if (const auto* wide = std::get_if<Image16>(&picture.pixels)) {
    std::ranges::transform(wide->values, out.values.begin(), rounded_code);
    return out;
  }
  const auto& floats = std::get<Image>(picture.pixels).values;
  for (std::size_t i = 0; i < floats.size(); ++i) {
    const bool plain = !floats_linear || i % static_cast<std::size_t>(header.channels) == 3;
    const float v = floats[i] > 0 ? std::min(1.0f, floats[i]) : 0;  // NaN gives 0 too
    out.values[i] = plain ? to_code(v) : srgb_u8(double{v});
  }
  return out;
}

}  // namespace etak
