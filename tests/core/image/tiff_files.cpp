// SPDX-License-Identifier: Apache-2.0
#include "tests/core/image/tiff_files.h"

#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>

namespace etak::test {
namespace {

template <class Value>
void write(const std::string& path, const Pixels<Value>& image, OIIO::TypeDesc type) {
  OIIO::ImageSpec spec(image.width, image.height, image.channels, type);
  spec.alpha_channel = image.channels % 2 == 0 ? image.channels - 1 : -1;
  spec["compression"] = "zip";
  spec["oiio:UnassociatedAlpha"] = 1;
  const auto output = OIIO::ImageOutput::create(path);
  REQUIRE(output);
  REQUIRE(output->open(path, spec));
  REQUIRE(output->write_image(type, image.values.data()));
  REQUIRE(output->close());
}

}  // namespace

void write_tiff(const std::string& path, const Image8& image) {
  write(path, image, OIIO::TypeUInt8);
}

void write_tiff(const std::string& path, const Image16& image) {
  write(path, image, OIIO::TypeUInt16);
}

void write_tiff(const std::string& path, const Image& image) {
  write(path, image, OIIO::TypeFloat);
}

}  // namespace etak::test
