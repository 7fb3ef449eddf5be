// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pack/page.h"

#include <filesystem>

#include "core/atlas/texels/page_pixels.h"
#include "core/base/error.h"
#include "core/base/files/output_file.h"
#include "core/base/files/paths.h"
#include "core/base/files/read_places.h"
#include "core/base/system.h"
#include "core/base/text/ascii.h"
#include "core/image/files/png.h"
#include "core/pages/validation_pictures.h"

namespace etak::cli {
namespace {

constexpr int most_shown = 640;
constexpr std::size_t most_block_pictures = 8;
// Squares of the checker pattern across a page; the pattern shows where alpha hides the colour.
constexpr int shown_squares = 40;

std::string png_of(const Image8& image) {
  return png_bytes(thumbnail(image, most_shown), {});
}

// A PNG of a texture in which each texel has the RGB that `color(texel, x, y)` gives.
template <class Color>
std::string picture_of(const PixelsView8& view, Color color) {
  Image8 out(view.width, view.height, 3);
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const std::array<std::uint8_t, 3> rgb = color(view.at(x, y), x, y);
      std::copy(rgb.begin(), rgb.end(), out.at(x, y).begin());
    }
  return png_of(out);
}

AtlasPagePictures pictures_of(const AtlasPage& page, const PagePixels& pixels) {
  AtlasPagePictures out;
  const auto has = [&](Texture texture) { return !page.files[static_cast<std::size_t>(texture)].empty(); };
  if (has(Texture::diffuse_alpha)) {
    const int square = std::max(1, page.width / shown_squares);
    out.diffuse = picture_of(pixels.view(Texture::diffuse_alpha), [&](const std::uint8_t* t, int x, int y) {
      const int ground = (x / square + y / square) % 2 == 0 ? 0x66 : 0x99;
      const auto over = [&](int code) {
        return static_cast<std::uint8_t>((code * t[3] + ground * (255 - t[3]) + 127) / 255);
      };
      return std::array<std::uint8_t, 3>{over(t[0]), over(t[1]), over(t[2])};
    });
  }
  if (has(Texture::specular_gloss)) {
    const PixelsView8 view = pixels.view(Texture::specular_gloss);
    out.specular = picture_of(view, [](const std::uint8_t* t, int, int) {
      return std::array<std::uint8_t, 3>{t[0], t[1], t[2]};
    });
    out.gloss = picture_of(view, [](const std::uint8_t* t, int, int) {
      return std::array<std::uint8_t, 3>{t[3], t[3], t[3]};
    });
  }
  return out;
}

// Whether a page may link to `target`: a relative reference, http or https. Other schemes run scripts
// (javascript:, data:) or open files of the reader's machine (file:). A host without a scheme (//host/x)
// opens files as well, where the page itself is opened as a file.
bool is_page_target(const std::string& target) {
  const std::string front = lower_case(target.substr(0, 8));
  if (front.starts_with("http://") || front.starts_with("https://")) return true;
  const auto slash = [](char c) { return c == '/' || c == '\\'; };
  if (target.size() > 1 && slash(target[0]) && slash(target[1])) return false;
  return target.find(':') >= target.find_first_of("/?#");
}

std::pair<std::string, std::string> page_link(const std::string& link) {
  const std::size_t equals = link.find('=');
  if (equals == link.npos || equals == 0) throw Error::at("--page-link", printable(link), "TEXT=TARGET");
  std::pair<std::string, std::string> out{link.substr(0, equals), link.substr(equals + 1)};
  if (!is_page_target(out.second))
    throw Error::at("--page-link", printable(link), "a TARGET that is relative, http: or https:");
  return out;
}

}  // namespace

PackPage::PackPage(const PackArguments& arguments) : arguments_(arguments) {
  for (const std::string& link : arguments.page_links) data_.links.push_back(page_link(link));
}

void PackPage::attach(PackOptions& options) {
  if (arguments_.page_report.empty()) return;
  // Where the HTML page is missing, -u must not skip the work.
  if (!is_there(arguments_.page_report)) options.output.update = false;
  options.run.block_pictures = most_block_pictures;
  options.check.written_page = {};  // without it, pages are whole in memory when `page` is called
  options.check.page = [this, check = std::move(options.check.page)](const AtlasLayout& layout, int page,
                                                                     const PagePixels& pixels) {
    if (page == 0) data_.pictures.clear();
    if (static_cast<std::size_t>(page) < layout.pages.size())
      data_.pictures.push_back(pictures_of(layout.pages[static_cast<std::size_t>(page)], pixels));
    return !check || check(layout, page, pixels);
  };
}

bool is_in_atlas_folder(const PackArguments& arguments) {
  const auto folder = [](const std::filesystem::path& path) { return path.lexically_normal().parent_path(); };
  return folder(arguments.page_report) == folder(std::filesystem::path(arguments.settings.out) / "");
}

std::unique_ptr<Output> PackPage::output(const PackResult& result, const ValidationReport* findings,
                                         OutputFolder* folder) {
  if (arguments_.page_report.empty()) return nullptr;
  data_.title =
      "Atlas of " + sys::path_text(std::filesystem::path(result.input).lexically_normal().filename());
  data_.layout = result.layout;
  data_.left_out = result.left_out.lines;
  data_.blocks = result.blocks;
  data_.block_pictures = result.block_pictures;
  data_.before = result.left_out.before;
  data_.after = result.left_out.after;
  data_.findings = findings;
  if (folder == nullptr || !is_in_atlas_folder(arguments_)) {
    written_ = atlas_page(data_);
    std::vector<std::string> read;
    for (const auto& [file, stamp] : result.inputs) read.push_back(file);
    return std::make_unique<OutputFile>(arguments_.page_report, *written_, true, strictest_mode(read) | 0200);
  }
  folder->write(sys::path_text(std::filesystem::path(arguments_.page_report).filename()), atlas_page(data_));
  return nullptr;
}

}  // namespace etak::cli
