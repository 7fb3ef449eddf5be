// SPDX-License-Identifier: Apache-2.0
#include "core/image/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <memory>

#include "core/base/error.h"
#include "core/base/file.h"

namespace etak {
namespace {

constexpr const char* unassociated = "oiio:UnassociatedAlpha";
constexpr float largest_half = 65504;

// OpenImageIO's messages may span lines; etak's are one line.
std::string one_line(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool blank = c == '\n' || c == '\r' || c == '\t' || c == ' ';
    if (!blank)
      out += c;
    else if (!out.empty() && out.back() != ' ')
      out += ' ';
  }
  while (!out.empty() && (out.back() == ' ' || out.back() == '.')) out.pop_back();
  return printable(out, 200);
}

std::unique_ptr<OIIO::ImageInput> open_input(const std::string& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0)
    throw Error::at(path, std::string("cannot be opened: ") + std::strerror(errno));
  if (!S_ISREG(info.st_mode)) throw Error::at(path, "is no regular file", "a picture file");
  OIIO::ImageSpec config;
  config[unassociated] = 1;
  auto input = OIIO::ImageInput::open(path, &config);
  if (!input)
    throw Error::at(path, "cannot be read as a picture (" + one_line(OIIO::geterror()) + ")",
                    "a PNG, OpenEXR, Radiance HDR or TIFF file");
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || spec.width > max_image_side || spec.height > max_image_side ||
      spec.depth > 1)
    throw Error::at(path,
                    "is " + std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels",
                    "1 to " + std::to_string(max_image_side) + " on a side");
  if (spec.nchannels < 1 || spec.nchannels > 4)
    throw Error::at(path, "has " + std::to_string(spec.nchannels) + " channels", "1 to 4");
  return input;
}

ImageInfo info_of(const OIIO::ImageInput& input) {
  const OIIO::ImageSpec& spec = input.spec();
  return {spec.width,
          spec.height,
          spec.nchannels,
          static_cast<int>(spec.format.basesize() * 8),
          spec.format.is_floating_point(),
          input.format_name()};
}

template <class Value>
Pixels<Value> read_pixels(OIIO::ImageInput& input, const std::string& path, OIIO::TypeDesc type) {
  const OIIO::ImageSpec spec = input.spec();
  Pixels<Value> image(spec.width, spec.height, spec.nchannels);
  if (!input.read_image(0, 0, 0, spec.nchannels, type, image.values.data()))
    throw Error::at(path, "is damaged (" + one_line(input.geterror()) + ")");
  return image;
}

template <class Value>
void write(const std::string& path, const Pixels<Value>& image, const char* format,
           OIIO::TypeDesc memory_type, OIIO::ImageSpec spec, bool overwrite) {
  std::vector<unsigned char> bytes;
  {
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(std::string("etak.") + format);
    if (!output || !output->supports("ioproxy"))
      throw Error::at(path, std::string("this OpenImageIO cannot write ") + format);
    spec[unassociated] = 1;
    output->set_ioproxy(&memory);
    if (!output->open(path, spec) || !output->write_image(memory_type, image.values.data()) ||
        !output->close())
      throw Error::at(path, "cannot be encoded (" + one_line(output->geterror()) + ")");
  }
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
  write_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, overwrite);
}

}  // namespace

ImageInfo read_image_info(const std::string& path) {
  return info_of(*open_input(path));
}

Image read_image(const std::string& path) {
  const auto input = open_input(path);
  return read_pixels<float>(*input, path, OIIO::TypeFloat);
}

Image8 read_image8(const std::string& path) {
  const auto input = open_input(path);
  const ImageInfo info = info_of(*input);
  if (info.bits != 8 || info.floating)
    throw Error::at(path, "holds values of " + std::to_string(info.bits) + " bits", "8 bits");
  return read_pixels<std::uint8_t>(*input, path, OIIO::TypeUInt8);
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

}  // namespace etak
