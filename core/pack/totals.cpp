// SPDX-License-Identifier: Apache-2.0
#include "core/pack/totals.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/atlas/outputs.h"
#include "core/atlas/texels/page_pixels.h"
#include "core/base/error.h"
#include "core/base/files/input.h"
#include "core/base/files/output_folder.h"
#include "core/base/files/paths.h"
#include "core/base/files/steady_file.h"
#include "core/image/blocks/blocks.h"
#include "core/image/files/png.h"
#include "core/image/load.h"
#include "core/image/mips.h"
#include "core/image/texture_bytes.h"
#include "core/pack/pack.h"
#include "core/pack/source.h"
#include "core/scene/image_roles.h"

namespace etak {
namespace {

void add(std::vector<RoleTotals>& to, const std::string& role, bool material, const TextureTotals& totals) {
  const auto found = std::find_if(to.begin(), to.end(), [&](const RoleTotals& r) { return r.role == role; });
  if (found != to.end())
    found->totals.add(totals);
  else
    to.push_back({role, material, totals});
}

// A texture file, and whether compressing changed its values.
struct TextureFile {
  TextureTotals totals;
  bool lossy = false;
};

// A PNG's first chunk says enough, whatever its form.
PictureHeader header_of_file(const std::string& path, const PictureDoor& door) {
  constexpr std::size_t signature_and_first_chunk = 33;
  const std::string head = read_head(path, signature_and_first_chunk);
  BytesInMemory bytes(head);
  const std::optional<PictureHeader> png = png_header(bytes);
  return png && png->width > 0 ? *png : picture_header(path, door);
}

TextureFile texture_file(const std::string& path, const PictureDoor& door) {
  const PictureHeader header = header_of_file(path, door);
  return {{1, size_of_file(path), texture_bytes(header, true)}, header.lossy};
}

// What a manifest or a folder of pictures names: a file that serves several roles counts for the first.
void add_manifest(PackTotals& to, const std::vector<PackInput>& materials, const PictureDoor& door) {
  std::set<std::string> seen;
  const auto count = [&](const PlaneSource& plane, const char* role, bool material) {
    if (!plane.is_image() || !seen.insert(plane.path).second) return;
    const TextureFile file = texture_file(plane.path, door);
    add(to.input, role, material, file.totals);
    if (file.lossy) to.lossy.add(file.totals);
  };
  for (const PackInput& m : materials) {
    count(m.color[index_of(Texture::diffuse_alpha)], "diffuse", true);
    count(m.grey[index_of(Texture::diffuse_alpha)], "alpha", true);
    count(m.color[index_of(Texture::specular_gloss)], "F0", true);
    count(m.grey[index_of(Texture::specular_gloss)], "gloss", true);
    count(m.normal, "normal", false);
  }
}

// The bytes of a page's texture on a GPU, with all mips.
std::uint64_t page_bytes(const PackResult& result, std::size_t number, Texture texture) {
  const AtlasPage& page = result.layout.pages[number];
  const auto level = std::ranges::find_if(result.blocks, [&](const BlockLevel& each) {
    return each.page == static_cast<int>(number) && each.texture == texture;
  });
  if (level == result.blocks.end() || level->fallback)
    return texture_bytes({page.width, page.height, 4}, true);
  const auto tail = std::ranges::find_if(result.blocks, [&](const BlockLevel& each) {
    return each.page == level->page && each.texture == texture && each.tail;
  });
  std::uint64_t out = 0;
  for (int l = 0; l < full_mip_levels(page.width, page.height); ++l) {
    const int width = std::max(1, page.width >> l), height = std::max(1, page.height >> l);
    const bool in_blocks = tail == result.blocks.end() || l < tail->level;
    out += texture_level_bytes(in_blocks ? block_format_named(level->format) : nullptr, width, height);
    if (level->fourth_apart) out += texture_level_bytes(block_format_named("R8"), width, height);
  }
  return out;
}

// The pages' two textures, in every format that was written.
void add_pages(std::vector<RoleTotals>& to, const PackResult& result, const OutputFolder& folder) {
  for (std::size_t number = 0; number < result.layout.pages.size(); ++number)
    for (const Texture texture : both_textures) {
      const AtlasPage& page = result.layout.pages[number];
      const auto& files = page.files[index_of(texture)];
      if (files.empty()) continue;
      TextureTotals totals;
      totals.gpu = page_bytes(result, number, texture);
      for (const std::string& name : files) {
        ++totals.files;
        totals.disk += size_of_file(folder.path_until_commit(name));
      }
      add(to, texture == Texture::diffuse_alpha ? "diffuse and alpha" : "F0 and gloss", true, totals);
    }
}

// A picture that nothing reads may be broken or missing: it takes what its file takes.
TextureFile texture_file(const PictureFile& picture, bool unused, const PictureDoor& door) {
  TextureFile out{{1, picture.bytes.size(), 0}};
  try {
    if (!picture.path.empty()) return texture_file(picture.path, door);
    const PictureHeader header = open_picture(picture, door)->header();
    out.totals.gpu = texture_bytes(header, true);
    out.lossy = header.lossy;
  } catch (const Error&) {
    if (!unused) throw;
  }
  return out;
}

// The images of a scene, each file once, with their names beside it.
template <class See>
void each_image(const GltfScene& scene, const PictureDoor& door, const See& see) {
  std::set<std::string> seen;
  const std::vector<ImageRole> roles = image_roles(*scene.json, scene.path);
  for (std::size_t i = 0; i < roles.size(); ++i)
    if (roles[i].file.empty() || seen.insert(roles[i].file).second)
      see(roles[i], texture_file(scene.images[i], roles[i].is_unused(), door));
}

void add_input_scene(PackTotals& to, const GltfScene& scene, const PictureDoor& door) {
  each_image(scene, door, [&](const ImageRole& image, const TextureFile& file) {
    add(to.input, image.role, image.material, file.totals);
    if (file.lossy) to.lossy.add(file.totals);
  });
}

// What the scene reads beside the pages: pictures made of them, and those that stayed as they were.
void add_scene(PackTotals& to, const AtlasLayout& layout, const OutputFolder& folder,
               const std::string& written, const PictureDoor& door) {
  std::set<std::string> pages;
  for (const AtlasPage& page : layout.pages)
    for (const auto& files : page.files) pages.insert(files.begin(), files.end());
  to.scene.emplace();
  const GltfScene scene = read_gltf(folder.path_until_commit(written), {});
  each_image(scene, door, [&](const ImageRole& image, const TextureFile& file) {
    const TextureTotals& totals = file.totals;
    to.scene->add(totals);
    if (!pages.contains(image.file)) add(to.output, image.role, false, totals);
  });
}

}  // namespace

TextureTotals PackTotals::all(const std::vector<RoleTotals>& roles) {
  TextureTotals out;
  for (const RoleTotals& each : roles) out.add(each.totals);
  return out;
}

TextureTotals PackTotals::of_materials(const std::vector<RoleTotals>& roles) {
  TextureTotals out;
  for (const RoleTotals& each : roles)
    if (each.material) out.add(each.totals);
  return out;
}

PackTotals pack_totals(const PackSource& source, const PackOptions& options, const PackResult& result,
                       const OutputFolder& folder) {
  const AtlasLayout& layout = result.layout;
  const PictureDoor& door = options.input.pictures.door;
  PackTotals out;
  if (source.scene)
    add_input_scene(out, source.scene->scene, door);
  else
    add_manifest(out, source.materials(), door);
  add_pages(out.output, result, folder);
  const auto& others = layout.other_files;
  for (const char* scene : {"scene.gltf", "scene.glb"})
    if (std::find(others.begin(), others.end(), scene) != others.end())
      add_scene(out, layout, folder, scene, door);
  return out;
}

}  // namespace etak
