// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/outputs.h"

#include <algorithm>

#include "core/atlas/texels/page_pixels.h"
#include "core/base/files/output_folder.h"
#include "core/image/files/containers.h"
#include "core/image/files/png_choice.h"
#include "core/image/files/png_strips.h"
#include "core/image/load.h"

namespace etak {
namespace {

// One texture of a page, from its first level on.
struct PageTexture {
  int page;
  Texture texture;
  const PagePixels& pixels;
  int first = 0;
};

void write_container(OutputFolder& folder, const PageTexture& of, const std::string& name,
                     const WriteOptions& options, const TextureInBlocks* blocks) {
  const PagePixels& pixels = of.pixels;
  const Texture texture = of.texture;
  std::vector<ConstPixelsView8> texels;
  for (int l = of.first; l < pixels.levels(); ++l) texels.push_back(pixels.view(texture, l));
  std::vector<TextureLevel> levels = texture_levels(texels);
  if (blocks != nullptr) levels.resize(blocks->levels.size());
  for (std::size_t l = 0; blocks != nullptr && l < levels.size(); ++l) levels[l].bytes = blocks->levels[l];
  const BlockFormat* const code = blocks != nullptr ? blocks->format : nullptr;
  const bool srgb = code == nullptr || code->vk_srgb != 0;
  const auto file = folder.open(name);
  const FileSink sink{[&](std::string_view bytes) { file->add(bytes); },
                      [&](std::size_t at, std::string_view bytes) { file->patch(at, bytes); }};
  if (name.ends_with(".ktx2"))
    write_ktx2(levels, code, srgb, options.zstd_level, sink);
  else
    write_dds(levels, code, srgb, texture == Texture::specular_gloss, sink);
  file->close();
}

void write_pngs(OutputFolder& folder, const PageTexture& of, const WriteOptions& options) {
  for (int l = 0; l < of.pixels.levels(); ++l) {
    const PixelsView8 view = of.pixels.view(of.texture, l);
    const PictureHeader info{view.width, view.height, 4, 8};
    const PngRows image{info, view.data, view.stride};
    PngOptions png;
    png.level = options.png_level ? *options.png_level : png_level_for(image);
    png.threads = options.threads;
    folder.write(page_file(of.page, of.texture, "png", l),
                 [&](const std::function<void(std::string_view)>& sink) {
                   // The file's header comes first, then a strip of rows with each call, then the end of the file.
                   int calls = 0, rows = 0;
                   const auto telling = [&](std::string_view bytes) {
                     sink(bytes);
                     if (calls++ == 0 || l != 0 || !options.written || rows == info.height) return;
                     const int more = std::min(png_strip_rows(info, png.level), info.height - rows);
                     rows += more;
                     options.written(static_cast<std::size_t>(more) * static_cast<std::size_t>(info.width));
                   };
                   write_png(image, png, telling);
                 });
  }
}

}  // namespace

bool writes_floats(const WriteOptions& options) {
  return std::any_of(options.formats.begin(), options.formats.end(),
                     [](const std::string& format) { return holds_floats(format); });
}

bool writes_containers(const WriteOptions& options) {
  return std::ranges::any_of(options.formats, is_gpu_texture);
}

std::string page_file(int page, Texture texture, std::string_view format, int level) {
  return "page" + std::to_string(page) + "_" + std::string(name(texture)) +
         (level == 0 ? "" : ".mip" + std::to_string(level)) + "." + std::string(format);
}

std::vector<std::string> page_files(int page, Texture texture, int levels,
                                    const std::vector<std::string>& formats) {
  std::vector<std::string> out;
  for (const std::string& format : formats) out.push_back(page_file(page, texture, format));
  for (const std::string& format : formats)
    if (format == "png" || holds_floats(format))
      for (int l = 1; l < levels; ++l) out.push_back(page_file(page, texture, format, l));
  return out;
}

void write_page(OutputFolder& folder, int page, Texture texture, const PagePixels& pixels,
                const WriteOptions& options, const TextureInBlocks* blocks) {
  const PageTexture of{page, texture, pixels};
  for (const std::string& format : options.formats) {
    if (format == "png")
      write_pngs(folder, of, options);
    else if (!holds_floats(format))
      write_container(folder, of, page_file(page, texture, format), options, blocks);
  }
}

void write_fourth(OutputFolder& folder, int page, Texture texture, const PagePixels& pixels,
                  const WriteOptions& options) {
  TextureInBlocks fourth{block_format_named("R8"), {}};
  for (int l = 0; l < pixels.levels(); ++l) {
    const PixelsView8 view = pixels.view(texture, l);
    std::string& to = fourth.levels.emplace_back();
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) to += static_cast<char>(view.at(x, y)[3]);
  }
  for (const std::string& format : options.formats)
    if (is_gpu_texture(format))
      write_container(folder, {page, texture, pixels},
                      fourth_file_beside(page_file(page, texture, format), texture), options, &fourth);
}

void write_tail(OutputFolder& folder, int page, Texture texture, const PagePixels& pixels, int first,
                const WriteOptions& options) {
  for (const std::string& format : options.formats)
    if (is_gpu_texture(format))
      write_container(folder, {page, texture, pixels, first},
                      tail_file_beside(page_file(page, texture, format), texture), options, nullptr);
}

}  // namespace etak
