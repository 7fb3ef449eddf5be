// SPDX-License-Identifier: Apache-2.0
#include "core/validate/repairs/repair_material.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <tuple>
#include <variant>

#include "core/atlas/sources/plane.h"
#include "core/base/files/file.h"
#include "core/base/files/output_tree.h"
#include "core/base/files/paths.h"
#include "core/base/text/ascii.h"
#include "core/color/srgb.h"
#include "core/image/files/png.h"
#include "core/image/load.h"
#include "core/project/project_pictures.h"
#include "core/validate/files/check.h"
#include "core/validate/repairs/repair.h"
#include "core/validate/repairs/repair_files.h"

namespace etak {
namespace {

constexpr const char* diffuse_file = "diffuse.png";
constexpr const char* specular_file = "specular.png";

using Codes = std::variant<Image8, Image16>;

/// How a material is repaired.
struct Repairing {
  const Settings& settings;
  const PictureDoor& door;
  std::string work, folder;
  std::string stem;  // of names of files

  std::string free_path(std::string_view what) const {
    const std::string start = folder + '/' + stem + '_' + std::string(what) + "_fixed";
    std::string path = start + ".png";
    for (int i = 2; is_there(path); ++i) path = start + '_' + std::to_string(i) + ".png";
    return path;
  }
};

// The sRGB codes of a texture of the pair, RGBA. Of a picture of 16 bits that the channel takes as it is, those of the file.
Codes codes_for(const Image8& pair, const std::optional<ImageSource>& source, const PictureDoor& door) {
  if (!source || !source->channels.empty() || !(source->space.empty() || source->space == "srgb"))
    return pair;
  if (picture_header(source->path, door).bits != 16) return pair;
  const Picture picture = load_picture(source->path, door);
  const auto* wide = std::get_if<Image16>(&picture.pixels);
  if (wide == nullptr || wide->channels < 3) return pair;
  Image16 out(pair.width, pair.height, 4);
  for (std::size_t i = 0; i < out.pixel_count(); ++i) {
    std::copy_n(wide->values.data() + i * static_cast<std::size_t>(wide->channels), 3, &out.values[4 * i]);
    out.values[4 * i + 3] = static_cast<std::uint16_t>(257 * pair.values[4 * i + 3]);
  }
  return out;
}

std::string png_of(const Codes& codes, const PngOptions& options) {
  return std::visit([&](const auto& picture) { return png_bytes(picture, options); }, codes);
}

void add_file(CheckTarget& target, FileRole role, const std::string& path, const Codes& picture) {
  write_file(path, png_of(picture, {}), false);
  target.files.push_back({role, path, path, false});
}

// Writes the first three channels and returns the path.
std::string write_colors(const Codes& from, const std::string& path) {
  const Codes colors = std::visit(
      []<class Code>(const Pixels<Code>& all) -> Codes {
        Pixels<Code> out(all.width, all.height, 3);
        for (std::size_t i = 0; i < out.pixel_count(); ++i)
          std::copy_n(&all.values[static_cast<std::size_t>(all.channels) * i], 3, &out.values[3 * i]);
        return out;
      },
      from);
  PngOptions options;
  options.srgb = true;
  write_file(path, png_of(colors, options), false);
  return path;
}

// Repairs a target into a folder below that of the work, and returns the files in which something was done.
std::vector<RepairedFile> repaired_copies(CheckTarget target, const std::string& into, const Repairing& by,
                                          RepairedMaterial& out) {
  target.label = out.material.name;
  if (out.material.measured) target.manifest.material = out.material.measured->material;
  RepairRequest request;
  request.settings = by.settings;
  request.settings.transfer_stated = true;
  request.door = by.door;
  ValidationReport report;
  report.files.push_back(check(target, by.door, request.settings));
  report.files.back().target = std::make_shared<const CheckTarget>(target);
  OutputTree copies(into, false);
  RepairReport repairs = repair_files(report, request, copies);
  for (const LeftFinding& each : repairs.left)
    if (find_repair(each.rule) != nullptr) out.left.push_back(each.rule + ": " + each.why);
  if (repairs.files.empty()) return {};
  copies.commit();
  std::erase_if(repairs.files, [](const RepairedFile& file) { return file.steps.empty(); });
  for (const RepairedFile& file : repairs.files)
    for (const RepairStep& step : file.steps) out.done.push_back(step.rule + ": " + step.what);
  return repairs.files;
}

// The material's own files of base colour, metalness and roughness; none where not all channels are taken as they are, or
// metalness has no file of its own.
std::optional<CheckTarget> metal_rough_target(const ProjectMaterial& m) {
  const auto &base = m.texture(Channel::base_color), &metal = m.texture(Channel::metallic);
  if (!base || !metal || base->path == metal->path || !base->channels.empty()) return std::nullopt;
  if (!base->space.empty() && base->space != "srgb") return std::nullopt;
  std::string letters = "----";
  const auto put = [&](const ImageSource& source, char letter) {
    letters[source.channels.empty() ? 0 : std::string_view("rgba").find(source.channels[0])] = letter;
  };
  CheckTarget out;
  out.files = {{FileRole::base_color, base->path, "base_color.png", false}};
  for (const auto& [channel, letter, role] : {std::tuple(Channel::occlusion, 'o', FileRole::ignored),
                                              {Channel::roughness, 'r', FileRole::roughness},
                                              {Channel::smoothness, 's', FileRole::gloss}}) {
    const auto& source = m.texture(channel);
    if (source && source->path == metal->path)
      put(*source, letter);
    else if (source && role != FileRole::ignored && source->channels.empty() && source->path != base->path)
      out.files.push_back({role, source->path, "roughness.png", false});
  }
  put(*metal, 'm');
  const bool alone = metal->channels.empty() && letters == "m---";
  out.files.push_back({alone ? FileRole::metallic : FileRole::metal_rough, metal->path, "metallic.png", false,
                       alone ? "" : letters});
  return out;
}

// Repairs files as they are, with all their channels and bits, and lets the material read the copies.
//   what   the folder of the copies
bool repair_own_files(const CheckTarget& target, const std::string& what, const Repairing& by,
                      RepairedMaterial& out) {
  const std::string into = by.work + '/' + what;
  const std::vector<RepairedFile> files = repaired_copies(target, into, by, out);
  for (const RepairedFile& file : files) {
    const auto own = std::ranges::find(target.files, file.file, &TargetFile::label);
    const std::string path = by.free_path(file.file.substr(0, file.file.find('.')));
    write_file(path, read_file(into + '/' + file.copy), false);
    for (auto& texture : out.material.textures)
      if (texture && texture->path == own->path) texture->path = path;
  }
  return !files.empty();
}

// The pair as the copies have it.
std::array<Codes, 2> repaired_pair(const std::array<Codes, 2>& pair, const Repairing& by,
                                   RepairedMaterial& out) {
  CheckTarget target;
  add_file(target, FileRole::diffuse_alpha, by.work + '/' + diffuse_file, pair[0]);
  add_file(target, FileRole::specular_gloss, by.work + '/' + specular_file, pair[1]);
  const std::string into = by.work + "/copies";
  std::array<Codes, 2> made = pair;
  for (const RepairedFile& file : repaired_copies(target, into, by, out)) {
    Picture copy = load_picture(into + '/' + file.copy, by.door);
    Codes& codes = made[file.copy.ends_with(diffuse_file) ? 0 : 1];
    if (auto* wide = std::get_if<Image16>(&copy.pixels))
      codes = std::move(*wide);
    else
      codes = codes_of(std::move(copy), false);
  }
  return made;
}

LinearRgb first_color(const Codes& picture) {
  const auto texel = std::get<Image8>(picture).at(0, 0);  // that of a number
  return srgb_decode(Srgb8{texel[0], texel[1], texel[2]});
}

// Repairs diffuse colour and F0 as they are drawn.
void repair_colors(const ProjectMaterial& material, const MaterialLibrary& library, const Repairing& by,
                   RepairedMaterial& out) {
  MaterialPair drawn = pictures_of(material, library, by.door);
  if (material.alpha_mode == AlphaMode::opaque)
    for (std::size_t i = 3; i < drawn.diffuse_alpha.values.size(); i += 4)
      drawn.diffuse_alpha.values[i] = 255;
  const std::array pair{codes_for(drawn.diffuse_alpha, material.texture(Channel::diffuse), by.door),
                        codes_for(drawn.specular_gloss, material.texture(Channel::specular), by.door)};
  const std::size_t before = out.done.size();
  const std::array made = repaired_pair(pair, by, out);
  // With a base colour both colours come from it and from the metalness.
  const bool both = material.texture(Channel::base_color) && out.done.size() > before;
  const auto take = [&](Channel channel, std::size_t at, LinearRgb& number) {
    if (pair[at] == made[at] && !both) return false;
    if (gives(material, channel))
      set_texture(out.material, channel,
                  ImageSource{write_colors(made[at], by.free_path(name(channel))), {}, {}});
    else
      number = first_color(made[at]);
    return true;
  };
  take(Channel::diffuse, 0, out.material.diffuse);
  if (take(Channel::specular, 1, out.material.specular) && !gives(material, Channel::specular))
    out.material.measured.reset();
}

}  // namespace

RepairedMaterial repair_material(const ProjectMaterial& material, const MaterialLibrary& library,
                                 const Settings& settings, const PictureDoor& door, const std::string& work,
                                 const std::string& folder) {
  RepairedMaterial out{material, {}, {}};
  const std::string stem = identifier(material.name, '_');
  const Repairing by{settings, door, work, folder, stem.empty() ? "material" : stem};
  if (const auto& normal = material.texture(Channel::normal)) {
    CheckTarget target;
    const GreenAxis green = material.green_down ? GreenAxis::directx : GreenAxis::opengl;
    target.files = {{FileRole::normal, normal->path, "normal.png", false, {}, green}};
    repair_own_files(target, "normal", by, out);
  }
  const std::optional<CheckTarget> own = metal_rough_target(material);
  if (!own || !repair_own_files(*own, "metal_rough", by, out)) repair_colors(material, library, by, out);
  return out;
}

}  // namespace etak
