// SPDX-License-Identifier: Apache-2.0
#include "core/validate/repairs/repair_material.h"

#include <algorithm>
#include <memory>

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

void add_file(CheckTarget& target, FileRole role, const std::string& path, const Image8& picture) {
  write_file(path, png_bytes(picture, {}), false);
  target.files.push_back({role, path, path, false});
}

// Writes the first three channels under a name that is free, and returns its path.
std::string write_colors(const Image8& from, const std::string& folder, const std::string& stem) {
  Image8 colors(from.width, from.height, 3);
  for (std::size_t i = 0; i < colors.pixel_count(); ++i)
    std::copy_n(from.values.data() + static_cast<std::size_t>(from.channels) * i, 3,
                colors.values.data() + 3 * i);
  PngOptions options;
  options.srgb = true;
  std::string path = folder + '/' + stem + ".png";
  for (int i = 2; is_there(path); ++i) path = folder + '/' + stem + '_' + std::to_string(i) + ".png";
  write_file(path, png_bytes(colors, options), false);
  return path;
}

// The pair as the copies have it, and what was done.
MaterialPair repaired_pair(const MaterialPair& pair, const ProjectMaterial& material,
                           const Settings& settings, const PictureDoor& door, const std::string& work,
                           RepairedMaterial& out) {
  CheckTarget target;
  target.label = material.name;
  add_file(target, FileRole::diffuse_alpha, work + '/' + diffuse_file, pair.diffuse_alpha);
  add_file(target, FileRole::specular_gloss, work + '/' + specular_file, pair.specular_gloss);
  if (material.measured) target.manifest.material = material.measured->material;
  RepairRequest request;
  request.settings = settings;
  request.settings.transfer_stated = true;
  request.door = door;
  ValidationReport report;
  report.files.push_back(check(target, door, request.settings));
  report.files.back().target = std::make_shared<const CheckTarget>(target);
  const std::string folder = work + "/copies";
  OutputTree copies(folder, false);
  const RepairReport repairs = repair_files(report, request, copies);
  for (const LeftFinding& each : repairs.left)
    if (find_repair(each.rule) != nullptr) out.left.push_back(each.rule + ": " + each.why);
  MaterialPair made = pair;
  if (repairs.files.empty()) return made;
  copies.commit();
  for (const RepairedFile& file : repairs.files) {
    for (const RepairStep& step : file.steps) out.done.push_back(step.rule + ": " + step.what);
    const bool diffuse = file.copy.ends_with(diffuse_file);
    (diffuse ? made.diffuse_alpha : made.specular_gloss) =
        codes_of(load_picture(folder + '/' + file.copy, door), false);
  }
  return made;
}

LinearRgb first_color(const Image8& picture) {
  const auto texel = picture.at(0, 0);
  return srgb_decode(Srgb8{texel[0], texel[1], texel[2]});
}

}  // namespace

RepairedMaterial repair_material(const ProjectMaterial& material, const MaterialLibrary& library,
                                 const Settings& settings, const PictureDoor& door, const std::string& work,
                                 const std::string& folder) {
  RepairedMaterial out{material, {}, {}};
  MaterialPair pair = pictures_of(material, library, door);
  if (material.alpha_mode == AlphaMode::opaque)
    for (std::size_t i = 3; i < pair.diffuse_alpha.values.size(); i += 4) pair.diffuse_alpha.values[i] = 255;
  const MaterialPair made = repaired_pair(pair, material, settings, door, work, out);
  // With a base colour both colours come from it and from the metalness.
  const bool both = material.texture(Channel::base_color) && !out.done.empty();
  const std::string stem =
      identifier(material.name, '_').empty() ? "material" : identifier(material.name, '_');
  const auto take = [&](Channel channel, const Image8& before, const Image8& after, LinearRgb& number) {
    if (before == after && !both) return false;
    if (gives(material, channel))
      set_texture(
          out.material, channel,
          ImageSource{
              write_colors(after, folder, stem + '_' + std::string(name(channel)) + "_fixed"), {}, {}});
    else
      number = first_color(after);
    return true;
  };
  take(Channel::diffuse, pair.diffuse_alpha, made.diffuse_alpha, out.material.diffuse);
  if (take(Channel::specular, pair.specular_gloss, made.specular_gloss, out.material.specular) &&
      !gives(material, Channel::specular))
    out.material.measured.reset();
  return out;
}

}  // namespace etak
