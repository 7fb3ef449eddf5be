// SPDX-License-Identifier: Apache-2.0
#include "core/image/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <webp/decode.h>
#include <webp/encode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/steady_file.h"
#include "core/image/astc_codec.h"
#include "core/image/files/icc.h"
#include "core/image/mesh_codecs.h"
#include "core/image/picture_bytes.h"
#include "core/math/functions.h"

namespace etak {
namespace {

constexpr const char* unassociated = "oiio:UnassociatedAlpha";
constexpr float largest_half = 65504;

// Gives OpenImageIO's readers access to a file that etak has opened. The readers get this in place of a path,
// so that they read the very file that etak has checked, and do not map it into memory.
class ProxyOfFile : public OIIO::Filesystem::IOProxy {
 public:
  explicit ProxyOfFile(const SteadyFile& file) : IOProxy(file.path(), Read), file_(file) {}
  const char* proxytype() const override { return "etak"; }
  std::size_t size() const override { return file_.size(); }
  std::size_t read(void* to, std::size_t count) override {
    const std::size_t got = pread(to, count, m_pos);
    m_pos += static_cast<std::int64_t>(got);
    return got;
  }
  std::size_t pread(void* to, std::size_t count, std::int64_t at) override {
    return at < 0 ? 0 : file_.read_what_is_there(static_cast<std::size_t>(at), static_cast<char*>(to), count);
  }

 private:
  const SteadyFile& file_;
};

// A reader of OpenImageIO and what it reads from: bytes in memory, or a file. The reader uses these as long
// as it lives.
struct Input {
  std::unique_ptr<SteadyFile> file;   // null where the caller gave bytes
  std::unique_ptr<std::string> kept;  // the file's bytes, where it was read whole
  std::string_view bytes;             // `kept` or the caller's bytes; empty where the reader reads the file
  std::unique_ptr<OIIO::Filesystem::IOProxy> proxy;
  std::unique_ptr<OIIO::ImageInput> reader;
};

[[noreturn]] void fail_no_picture(const std::string& label, const std::string& why) {
  throw Error::at(label, "cannot be read as a picture (" + why + ")",
                  "a PNG, JPEG, WebP, OpenEXR, Radiance HDR or TIFF file");
}

void check_spec(const OIIO::ImageSpec& spec, const std::string& label) {
  const auto side = [](int pixels) { return pixels < 0 ? std::size_t{0} : static_cast<std::size_t>(pixels); };
  check_size({side(spec.width), side(spec.height)}, label);
  if (spec.depth > 1)
    throw Error::at(label, "is a volume of " + std::to_string(spec.depth) + " slices", "a flat picture");
  if (spec.nchannels < 1 || spec.nchannels > 4)
    throw Error::at(label, "has " + std::to_string(spec.nchannels) + " channels", "1 to 4");
  if (spec.deep) throw Error::at(label, "is a deep picture", "one value for each channel of a pixel");
  for (const char* attribute : {"jpeg:ColorSpace", "tiff:ColorSpace", "psd:ColorMode"})
    if (const std::string space = spec.get_string_attribute(attribute); space == "CMYK" || space == "YCCK")
      throw Error::at(label, "holds CMYK colours", "grey or RGB");
}

// Opens the reader of `format`. The reader is chosen by name, so that OpenImageIO tries no other reader on
// the bytes. Where input.bytes is empty, the file is read piece by piece.
void open_reader(Input& input, const std::string& format, const std::string& label) {
  input.reader = OIIO::ImageInput::create(format);
  if (!input.reader) {
    (void)OIIO::geterror();
    fail_no_picture(label, "this OpenImageIO has no reader of " + format);
  }
  if (!input.reader->supports("ioproxy"))
    fail_no_picture(label, "OpenImageIO reads " + format + " only from files that it opens itself");
  if (input.bytes.empty()) {
    input.proxy = std::make_unique<ProxyOfFile>(*input.file);
  } else {
    // The check comes before the decoder, which fills up missing data without an error.
    check_whole(input.bytes, format, label);
    input.proxy = std::make_unique<OIIO::Filesystem::IOMemReader>(input.bytes.data(), input.bytes.size());
  }
  input.reader->set_ioproxy(input.proxy.get());
  OIIO::ImageSpec config, spec;
  config[unassociated] = 1;
  if (!input.reader->open("etak." + format, spec, config)) {
    // The error text names internals of the decoder, so it is not shown; but OpenImageIO prints a text that
    // nobody fetches when the program ends.
    (void)input.reader->geterror();
    fail_no_picture(label, "its " + format + " header is damaged or of a form that is not read");
  }
}

Input open_bytes(std::string_view bytes, const std::string& label) {
  Input out;
  out.bytes = bytes;
  if (bytes.empty()) throw Error::at(label, "is empty", "a picture");
  const std::string format = picture_format(bytes, label);
  if (format.empty()) fail_no_picture(label, "its first bytes are those of no known format");
  open_reader(out, format, label);
  check_spec(out.reader->spec(), label);
  return out;
}

// OpenEXR and TIFF, whose files can be large and whose decoders notice an early end, are read piece by piece;
// other formats are read whole. Bytes of no known format are given to no reader: OpenImageIO would try all that it has,
// those of films, camera files and scans too.
void open_file(Input& out, const std::string& path) {
  std::string head(std::min<std::size_t>(out.file->size(), 32), '\0');
  out.file->read(0, head.data(), head.size());
  if (head.empty()) throw Error::at(path, "is empty", "a picture");
  const std::string format = picture_format(head, path);
  if (format.empty()) fail_no_picture(path, "its first bytes are those of no known format");
  if (format != "openexr" && format != "tiff") {
    out.kept = std::make_unique<std::string>(out.file->all());
    out.bytes = *out.kept;
  }
  open_reader(out, format, path);
  check_spec(out.reader->spec(), path);
}

// Returns work(). The readers of some formats throw std::length_error where the sizes in a broken file cannot be,
// and std::bad_alloc where these are merely too large.
template <class Work>
auto with_possible_sizes(const std::string& label, Work work) {
  try {
    return work();
  } catch (const std::length_error&) {
    throw Error::at(label, "is broken: sizes in it cannot be", "a whole picture");
  } catch (const std::bad_alloc&) {
    throw Error::at(label, "needs more memory than there is", "a smaller picture");
  }
}

// Calls use(input), and throws Error if the file has changed meanwhile.
template <class Use>
auto with_file(const std::string& path, Use use) {
  Input input;
  input.file = std::make_unique<SteadyFile>(path, largest_picture_bytes);
  auto out = with_possible_sizes(path, [&] {
    return input.file->read_checked([&] {
      open_file(input, path);
      return use(input);
    });
  });
  input.file->check_unchanged();
  return out;
}

PictureHeader header_of(const Input& input) {
  const OIIO::ImageSpec& spec = input.reader->spec();
  PictureHeader out{spec.width, spec.height, spec.nchannels, static_cast<int>(spec.format.basesize() * 8)};
  out.floating = spec.format.is_floating_point() || out.bits > 16;
  out.format = input.reader->format_name();
  out.lossy = is_lossy(input.bytes, out.format, spec.get_string_attribute("compression"));
  if (const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile")) {
    const auto colors = icc_colors(
        {static_cast<const char*>(profile->data()), static_cast<std::size_t>(profile->datasize())});
    out.colour_space = colors ? colors->curve : "icc";
    if (colors) out.primaries = colors->primaries;
  } else if (spec.get_int_attribute("Exif:ColorSpace") == 1) {
    out.colour_space = "srgb";
  }
  return out;
}

template <class Value>
Pixels<Value> read_pixels(const Input& input, const std::string& label, OIIO::TypeDesc type) {
  const OIIO::ImageSpec spec = input.reader->spec();
  Pixels<Value> image(spec.width, spec.height, spec.nchannels);
  const bool good = input.reader->read_image(0, 0, 0, spec.nchannels, type, image.values.data());
  if (!good || input.reader->has_error()) {
    (void)input.reader->geterror();
    throw Error::at(label, "is damaged",
                    std::string("whole and valid data of format ") + input.reader->format_name());
  }
  return image;
}

// The bytes of a whole file of `format`.
template <class Value>
std::string encoded(const std::string& label, const Pixels<Value>& image, const char* format,
                    OIIO::TypeDesc memory_type, OIIO::ImageSpec spec) {
  std::vector<unsigned char> bytes;
  {
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(std::string("etak.") + format);
    if (!output || !output->supports("ioproxy"))
      throw Error::at(label, std::string("this OpenImageIO cannot write ") + format);
    spec[unassociated] = 1;
    // Without a date OpenImageIO writes the current time, and no two runs would write the same bytes.
    spec["DateTime"] = "1970:01:01 00:00:00";
    output->set_ioproxy(&memory);
    if (!output->open(std::string("etak.") + format, spec) ||
        !output->write_image(memory_type, image.values.data()) || !output->close())
      throw Error::at(label,
                      std::string("cannot be encoded as ") + format + ", at " + std::to_string(image.width) +
                          " x " + std::to_string(image.height) + " pixels",
                      "a size and values that the format can hold");
  }
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

template <class Value>
void write(const std::string& path, const Pixels<Value>& image, const char* format,
           OIIO::TypeDesc memory_type, const OIIO::ImageSpec& spec, bool overwrite) {
  write_file(path, encoded(path, image, format, memory_type, spec), overwrite);
}

}  // namespace

PictureHeader read_picture_header(const std::string& path) {
  return with_file(path, [](const Input& input) { return header_of(input); });
}

Image read_image(const std::string& path) {
  return with_file(path,
                   [&](const Input& input) { return read_pixels<float>(input, path, OIIO::TypeFloat); });
}

namespace {

// The codes of a WebP picture with alpha, by which OpenImageIO 2.4 multiplies its colours whatever it is asked; none
// where the file is a film.
std::optional<Image8> codes_of_webp(const Input& input) {
  const OIIO::ImageSpec& spec = input.reader->spec();
  Image8 out(spec.width, spec.height, 4);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(input.bytes.data());
  if (WebPDecodeRGBAInto(bytes, input.bytes.size(), out.values.data(), out.values.size(), 4 * spec.width) ==
      nullptr)
    return std::nullopt;
  return out;
}

Picture read_any(const Input& input, const std::string& label) {
  Picture out{header_of(input), {}};
  if (out.header.format == "webp" && out.header.channels == 4)
    if (auto codes = codes_of_webp(input)) {
      out.pixels = *std::move(codes);
      return out;
    }
  if (!out.header.floating && out.header.bits == 8)
    out.pixels = read_pixels<std::uint8_t>(input, label, OIIO::TypeUInt8);
  else if (!out.header.floating)
    out.pixels = read_pixels<std::uint16_t>(input, label, OIIO::TypeUInt16);
  else
    out.pixels = read_pixels<float>(input, label, OIIO::TypeFloat);
  return out;
}

}  // namespace

Picture read_picture(const std::string& path) {
  return with_file(path, [&](const Input& input) { return read_any(input, path); });
}

Picture read_picture(std::string_view bytes, const std::string& label) {
  return with_possible_sizes(label, [&] { return read_any(open_bytes(bytes, label), label); });
}

std::string webp_bytes(const Image& image) {
  WebPConfig config;
  WebPPicture picture;
  WebPMemoryWriter out;
  WebPMemoryWriterInit(&out);
  const std::unique_ptr<WebPMemoryWriter, decltype(&WebPMemoryWriterClear)> bytes(&out,
                                                                                  WebPMemoryWriterClear);
  constexpr int level = 6;  // of 0 to 9; beyond it, hours buy a percent
  if (!WebPConfigInit(&config) || !WebPConfigLosslessPreset(&config, level) || !WebPPictureInit(&picture))
    throw Error("libwebp is of another version than etak was built for");
  config.exact = 1;  // colours under alpha 0 count
  picture.use_argb = 1;
  picture.width = image.width;
  picture.height = image.height;
  picture.writer = WebPMemoryWrite;
  picture.custom_ptr = &out;
  const std::unique_ptr<WebPPicture, decltype(&WebPPictureFree)> texels(&picture, WebPPictureFree);
  std::vector<std::uint8_t> rgba;
  rgba.reserve(4 * image.pixel_count());
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < image.values.size(); i += channels)
    for (const float value : four_channels(image.values.data() + i, channels, 1.0f))
      rgba.push_back(to_code(value));
  if (!WebPPictureImportRGBA(&picture, rgba.data(), 4 * image.width) || !WebPEncode(&config, &picture))
    throw Error("libwebp cannot write a picture of " + std::to_string(image.width) + " x " +
                std::to_string(image.height) + " (its error " + std::to_string(picture.error_code) + ")");
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes
  return {reinterpret_cast<const char*>(out.mem), out.size};
}

PictureDoor picture_door() {
  return {read_picture_header,
          [](const std::string& path) { return read_picture(path); },
          [](std::string_view bytes, const std::string& label) { return read_picture(bytes, label); },
          [](const Image& image, std::string_view format, std::string_view fourth) {
            return format == "exr"    ? exr_bytes(image, std::string(fourth))
                   : format == "webp" ? webp_bytes(image)
                                      : tiff_bytes(image, std::string(fourth));
          },
          text_picture,
          mesh_door(),
          astc_door()};
}

namespace {

// A ring as high as the digits before it.
TextPicture with_degree_sign(TextPicture text, int size) {
  const double radius = 0.14 * size, half_width = 0.035 * size;
  TextPicture out;
  out.left = text.left;
  out.top = std::min(text.top, -static_cast<int>(std::ceil(0.78 * size)));
  const int bottom = std::max(text.top + text.coverage.height, 0), gap = size / 12;
  out.coverage = Image(text.coverage.width + gap + static_cast<int>(std::ceil(2 * (radius + half_width))) + 1,
                       bottom - out.top, 1);
  for (int y = 0; y < text.coverage.height; ++y)
    for (int x = 0; x < text.coverage.width; ++x)
      out.coverage.at(x, y + text.top - out.top)[0] = text.coverage.at(x, y)[0];
  const double middle_x = text.coverage.width + gap + radius + half_width,
               middle_y = -0.75 * size + radius + half_width - out.top;
  for (int y = 0; y < out.coverage.height; ++y)
    for (int x = text.coverage.width; x < out.coverage.width; ++x) {
      const double off = std::abs(math::hypot(x + 0.5 - middle_x, y + 0.5 - middle_y) - radius);
      out.coverage.at(x, y)[0] = static_cast<float>(std::clamp(half_width + 0.5 - off, 0.0, 1.0));
    }
  return out;
}

}  // namespace

TextPicture text_picture(std::string_view text, int size) {
  // OpenImageIO 2.4 takes letters beyond ASCII for others.
  constexpr std::string_view degree = "\u00b0";
  if (text.ends_with(degree))
    return with_degree_sign(text_picture(text.substr(0, text.size() - degree.size()), size), size);
  if (std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) > 126; }))
    throw Error::at(printable(text, 200), "letters beyond ASCII, which pictures of text do not have", "SVG");
  // A whole path, because OpenImageIO looks for a mere name in the working folder first.
  static const char* const font = [] {
    constexpr std::array places{"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                                "/usr/share/fonts/dejavu/DejaVuSans.ttf",
                                "/usr/share/fonts/TTF/DejaVuSans.ttf",
                                "/usr/local/share/fonts/dejavu/DejaVuSans.ttf",
                                "/Library/Fonts/DejaVuSans.ttf"};
    const auto* const found = std::ranges::find_if(places, OIIO::Filesystem::is_regular);
    return found == places.end() ? nullptr : *found;
  }();
  if (font == nullptr)
    throw Error::at("text of a picture", "no font DejaVu Sans in the folders of fonts",
                    "the package fonts-dejavu-core, or SVG");
  const OIIO::string_view line(text.data(), text.size());
  const OIIO::ROI box = OIIO::ImageBufAlgo::text_size(line, size, font);
  if (!box.defined() || box.width() < 1 || box.height() < 1) return {};
  TextPicture out{Image(box.width(), box.height(), 1), box.xbegin, box.ybegin};
  OIIO::ImageBuf pixels(OIIO::ImageSpec(box.width(), box.height(), 1, OIIO::TypeFloat),
                        out.coverage.values.data());
  const float white = 1;
  if (!OIIO::ImageBufAlgo::render_text(pixels, -box.xbegin, -box.ybegin, line, size, font,
                                       OIIO::cspan<float>(&white, 1)))
    throw Error::at(font, "cannot be used: " + pixels.geterror(), "the font DejaVu Sans");
  return out;
}

void write_png(const std::string& path, const Image8& image, bool overwrite) {
  OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeUInt8);
  write(path, image, "png", OIIO::TypeUInt8, spec, overwrite);
}

void write_exr(const std::string& path, const Image& image, bool floats, bool overwrite) {
  OIIO::ImageSpec spec(image.width, image.height, image.channels, floats ? OIIO::TypeFloat : OIIO::TypeHalf);
  spec["compression"] = "zip";
  if (floats) return write(path, image, "exr", OIIO::TypeFloat, spec, overwrite);
  Image finite = image;
  for (float& value : finite.values) value = std::clamp(value, -largest_half, largest_half);
  write(path, finite, "exr", OIIO::TypeFloat, spec, overwrite);
}

std::string exr_bytes(const Image& image, const std::string& fourth) {
  OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeFloat);
  spec["compression"] = "zip";
  if (image.channels == 4) spec.channelnames = {"R", "G", "B", fourth};
  return encoded("exr", image, "exr", OIIO::TypeFloat, spec);
}

std::string tiff_bytes(const Image& image, const std::string& fourth) {
  OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeFloat);
  spec["compression"] = "zip";
  spec.alpha_channel = image.channels == 4 && fourth == "alpha" ? 3 : -1;
  return encoded("tiff", image, "tif", OIIO::TypeFloat, spec);
}

}  // namespace etak
