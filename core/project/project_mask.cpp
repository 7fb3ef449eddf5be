// SPDX-License-Identifier: Apache-2.0
#include "core/project/project_mask.h"

#include <algorithm>
#include <map>

#include "core/atlas/sources/sources.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/links.h"
#include "core/base/files/paths.h"
#include "core/base/text/ascii.h"
#include "core/project/project_pictures.h"

namespace etak {
namespace {

// Least share of the texels of a mask that a colour of it fills.
constexpr double least_share = 0.001;

// Three codes a texel, as the packer reads them.
Image8 mask_codes(const std::string& path, const PictureDoor& door) {
  const Image8 from = codes_of(load_picture(path, door), false);
  Image8 out(from.width, from.height, 3);
  const bool grey = from.channels < 3;
  for (std::size_t i = 0; i < out.pixel_count(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      out.values[3 * i + c] = from.values[static_cast<std::size_t>(from.channels) * i + (grey ? 0 : c)];
  return out;
}

// How many texels have a colour that all texels around them have too.
std::map<MaskCode, std::size_t> flat_colors(const Image8& mask, bool& colors) {
  std::map<MaskCode, std::size_t> out;
  const auto code = [&](int x, int y) {
    const auto texel = mask.at(x, y);
    return MaskCode{texel[0], texel[1], texel[2]};
  };
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      const MaskCode at = code(x, y);
      colors = colors || at[0] != at[1] || at[1] != at[2];
      bool flat = true;
      for (int v = std::max(0, y - 1); flat && v <= std::min(mask.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); flat && u <= std::min(mask.width - 1, x + 1); ++u)
          flat = code(u, v) == at;
      if (flat) ++out[at];
    }
  return out;
}

std::string stem_of(const MaskedMaterial& masked) {
  const std::string out = identifier(masked.name, '_');
  return out.empty() ? "material" : out;
}

std::string manifest_name(const MaskedMaterial& masked) {
  return stem_of(masked) + ".mask.json";
}

std::string path_in(const std::string& folder, const std::string& name) {
  return folder.empty() ? name : folder + '/' + name;
}

// Whether an F0 can be named by its record in a file that is read elsewhere.
bool is_of_the_library(const ProjectMaterial& m, const Project& project, const MaterialLibrary& library) {
  if (!m.measured || m.measured->viewing != Viewing{}) return false;
  const auto record = library.find(m.measured->material);
  return record && gives_f0(record->material_class) &&
         std::ranges::none_of(project.spectra, [&](const Material& each) {
           return m.measured->material.find(each.id) != std::string::npos ||
                  m.measured->outside.find(each.id) != std::string::npos;
         });
}

}  // namespace

MaskSurvey survey_mask(const std::string& path, const PictureDoor& door) {
  const Image8 mask = mask_codes(path, door);
  MaskSurvey out{mask.width, mask.height, false, {}};
  const std::map<MaskCode, std::size_t> flat = flat_colors(mask, out.colors);
  std::vector<std::pair<std::size_t, MaskCode>> frequent;
  for (const auto& [code, count] : flat)
    if (static_cast<double>(count) >= least_share * static_cast<double>(mask.pixel_count()))
      frequent.emplace_back(count, code);
  std::ranges::stable_sort(frequent, std::greater<>(), [](const auto& each) { return each.first; });
  for (const auto& [count, color] : frequent) {
    const auto apart = [&code = color](const MaskCode& each) {
      return codes_apart(each, code) >= least_codes_apart;
    };
    if (out.codes.size() < MaterialMask::most_parts && std::ranges::all_of(out.codes, apart))
      out.codes.push_back(color);
  }
  if (out.colors) return out;
  if (out.codes.size() < MaterialMask::least_parts) out.codes = {{0, 0, 0}, {255, 255, 255}};
  std::ranges::sort(out.codes);
  return out;
}

AtlasManifest manifest_of(const MaskedMaterial& masked, const Project& project,
                          const MaterialLibrary& library) {
  Project used;
  used.spectra = project.spectra;
  MaterialMask mask;
  mask.image.path = masked.mask;
  mask.colors = masked.colors;
  mask.specular_gloss = mask.metal_rough = true;
  AtlasManifest out;
  for (const MaskedMaterial::Part& part : masked.parts) {
    const ProjectMaterial* m = project.find(part.material);
    if (m == nullptr)
      throw Error::at(masked.name, "no material " + in_quotes(part.material), "one of the project");
    if (has_packed_textures(*m))
      throw Error::at(m->name, "has textures",
                      "numbers: the mask is the texture of the material that is made");
    used.materials = {*m};
    std::vector<std::string> ignored;  // colours outside of sRGB, which resolve_manifest() tells too
    const AtlasManifest one = manifest_of(used, library, ignored);
    const ManifestMaterial& row = one.materials.front();
    MaskPart made{part.code, {}, row.diffuse, row.specular, row.gloss, row.roughness, masked.name};
    if (is_of_the_library(*m, project, library))
      made.specular = LibrarySource{m->measured->material, m->measured->dataset, m->measured->outside};
    mask.parts.push_back(std::move(made));
  }
  if (mask.parts.size() < MaterialMask::least_parts || mask.parts.size() > MaterialMask::most_parts)
    throw Error::at(masked.name, std::to_string(mask.parts.size()) + " materials", "two to four");
  ManifestMaterial& made = out.materials.emplace_back();
  made.name = made.place = masked.name;
  made.alpha_mode = AlphaMode::opaque;
  made.mask = std::move(mask);
  return out;
}

MaterialPair masked_pair(const AtlasManifest& manifest, const MaterialLibrary& library,
                         const PictureDoor& door) {
  const PictureReading reading{std::nullopt, door, {}, {}};
  const PackInput in = std::move(resolve_manifest(manifest, library, reading).materials.at(0));
  return in.masked->pair(in.width, in.height);
}

std::vector<std::string> masked_files_in(const std::string& folder, const MaskedMaterial& masked) {
  std::vector<std::string> out;
  std::vector<std::string> names{manifest_name(masked)};
  for (const std::string_view role : mask_file_endings) names.push_back(stem_of(masked) + std::string(role));
  for (const std::string& name : names)
    if (is_there(path_in(folder, name))) out.push_back(name);
  return out;
}

ProjectMaterial write_masked(const MaskedMaterial& masked, const Project& project,
                             const MaterialLibrary& library, const PictureDoor& door,
                             const std::string& folder, bool overwrite, std::vector<std::string>& remarks) {
  if (const auto there = masked_files_in(folder, masked); !overwrite && !there.empty())
    throw Error::at(path_in(folder, there.front()), "exists already", "another name, or leave to replace it");
  const AtlasManifest manifest = manifest_of(masked, project, library);
  const PictureReading reading{std::nullopt, door, {}, {}};
  PackInputs inputs = resolve_manifest(manifest, library, reading);
  const auto files = mask_files(inputs.materials.at(0));
  remarks.insert(remarks.end(), inputs.remarks.begin(), inputs.remarks.end());
  ProjectMaterial out;
  out.name = masked.name;
  out.alpha_mode = AlphaMode::opaque;
  const std::string document = path_in(folder, manifest_name(masked));
  for (const auto& [name, bytes] : files) write_file(path_in(folder, name), bytes, overwrite);
  write_file(document, format_masks(manifest, document), overwrite);
  const auto take = [&](Channel channel, const char* ending) {
    set_texture(out, channel, ImageSource{path_in(folder, stem_of(masked) + ending), {}, {}});
  };
  take(Channel::diffuse, "_diffuse.png");
  take(Channel::specular, "_specular.png");
  take(Channel::gloss, "_gloss.png");
  return out;
}

}  // namespace etak
