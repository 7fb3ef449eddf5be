// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/gl_textures.h"

#include "core/base/error.h"

namespace etak {
namespace {

using Kind = QOpenGLTexture;

std::unique_ptr<GlTexture> filled(std::unique_ptr<GlTexture> out, Kind::TextureFormat inside,
                                  Kind::PixelFormat channels, const std::vector<float>& values) {
  out->setFormat(inside);
  out->setAutoMipMapGenerationEnabled(false);
  out->allocateStorage(channels, Kind::Float32);
  out->setData(channels, Kind::Float32, values.data());
  out->setWrapMode(Kind::ClampToEdge);
  return out;
}

}  // namespace

std::unique_ptr<GlTexture> gl_texture(const Image& map, bool round) {
  auto out = std::make_unique<GlTexture>(Kind::Target2D);
  out->setSize(map.width, map.height);
  // Drivers read texels of four floats faster than those of three.
  out = filled(std::move(out), Kind::RGBA32F, map.channels == 4 ? Kind::RGBA : Kind::RGB, map.values);
  out->setMinMagFilters(Kind::Linear, Kind::Linear);
  if (round) out->setWrapMode(Kind::DirectionS, Kind::Repeat);
  return out;
}

std::unique_ptr<GlTexture> gl_texture(const OcioShader::Table& table) {
  auto out = std::make_unique<GlTexture>(table.depth > 0    ? Kind::Target3D
                                         : table.height > 0 ? Kind::Target2D
                                                            : Kind::Target1D);
  out->setSize(table.width, table.height, table.depth);
  const bool grey = table.channels == 1;
  out = filled(std::move(out), grey ? Kind::R32F : Kind::RGB32F, grey ? Kind::Red : Kind::RGB, table.values);
  const Kind::Filter filter = table.nearest ? Kind::Nearest : Kind::Linear;
  out->setMinMagFilters(filter, filter);
  return out;
}

std::unique_ptr<GlTarget> gl_target(const QSize& size) {
  auto out = std::make_unique<GlTarget>(size);
  if (out->isValid()) return out;
  throw Error::at("OpenGL", "cannot draw a picture of " + std::to_string(size.width()) + " x " +
                                std::to_string(size.height()) + " pixels");
}

}  // namespace etak
