// SPDX-License-Identifier: Apache-2.0
#include "core/pages/finding_pictures.h"
#include "core/base/files/read_places.h"

#include <algorithm>
#include <map>
#include <optional>
#include <span>

#include "core/base/error.h"
#include "core/base/files/output_folder.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/text/free_names.h"
#include "core/findings/output/formats.h"
#include "core/image/files/png.h"
#include "core/judge/engine.h"
#include "core/judge/rules.h"
#include "core/pages/mask.h"
#include "core/pages/validation_pictures.h"
#include "core/scene/gltf.h"
#include "core/validate/files/load.h"
#include "core/validate/files/metal_rough.h"
#include "core/validate/files/scene_use.h"
#include "core/validate/repairs/repair_files.h"

namespace etak {
namespace {

bool has_place(const Finding& finding) {
  const Rule* rule = find_rule(finding.rule);
  return counts(finding) && ((rule != nullptr && rule->region) || finding.box);
}

// Whether a finding is about texture A, not B. The role of its file decides; where the file is no picture of
// the target (a scene), the kind of region that the rule looks for.
bool is_about_a(const Finding& finding, const CheckTarget& target, const Pictures& pictures) {
  if (pictures.b.pixel_count() == 0) return true;
  if (pictures.a.pixel_count() == 0) return false;
  for (const TargetFile& file : target.files)
    if (file.label == finding.file && file.role != FileRole::scene)
      return file.role == FileRole::diffuse_alpha || file.role == FileRole::base_color;
  const Rule* rule = find_rule(finding.rule);
  if (rule == nullptr || !rule->region) return false;
  return *rule->region == RegionKind::albedo_dark || *rule->region == RegionKind::albedo_bright ||
         *rule->region == RegionKind::albedo_single;
}

// The marks of one finding on its picture. A finding of a tile has marks inside that tile only.
Image8 marks_of(const Finding& finding, const CheckTarget& target, const Pictures& pictures,
                const Image8& picture, const Settings& settings) {
  const Rule* rule = find_rule(finding.rule);
  Image8 marks;
  if (rule != nullptr && rule->region) marks = region_picture(*rule->region, pictures, target, settings);
  const bool fits = marks.width == picture.width && marks.height == picture.height;
  if (!fits && finding.box)
    marks = box_marks(picture.width, picture.height, finding.box->x, finding.box->y, finding.box->width,
                      finding.box->height);
  else if (!fits)
    marks = Image8(picture.width, picture.height, 1);
  if (finding.tile.empty()) return marks;
  Image8 inside(picture.width, picture.height, 1);
  bool found = false;
  for (const CheckTile& tile : target.manifest.tiles) {
    if (tile.name != finding.tile && tile.island_of != finding.tile) continue;
    found = true;
    const Image8 own =
        box_marks(picture.width, picture.height, tile.box.x, tile.box.y, tile.box.width, tile.box.height);
    for (std::size_t i = 0; i < own.values.size(); ++i) inside.values[i] |= own.values[i];
  }
  for (std::size_t i = 0; found && i < marks.values.size(); ++i)
    if (inside.values[i] == 0) marks.values[i] = 0;
  return marks;
}

// The name of a finding's mask without ".png". A name must not begin with a dot, which would hide the file;
// files above the root of the run therefore lose their "../".
std::string file_name(const Finding& finding) {
  std::string out = finding.file;
  while (out.starts_with("../")) out.erase(0, 3);
  if (out.starts_with('.')) out.insert(0, 1, '_');
  if (!finding.tile.empty()) out += '.' + finding.tile;
  if (finding.tile.empty() && !finding.material.empty()) out += '.' + finding.material;
  for (char& c : out)
    if (c == '/' || static_cast<unsigned char>(c) < 0x20) c = '_';
  return out + '.' + finding.rule;
}

// The pictures of a checked file, which are loaded again: the check reads them in strips and keeps none.
class PictureSource {
 public:
  PictureSource(const CheckTarget& target, const PictureDoor& door) {
    if (target.files.empty()) return;
    const FileRole role = target.files.front().role;
    try {
      if (role == FileRole::scene) {
        GltfOptions parts;
        parts.mesh_door = door.mesh;
        scene_.emplace(read_gltf(target.files.front().path, parts));
        uses_.emplace(*scene_);
        looks_.emplace(*scene_);
        textures_.emplace(scene_->images, door);
      } else if (role != FileRole::material && role != FileRole::spectrum) {
        files_ = load_pictures(target, door);
      }
    } catch (const Error&) {
      // The report has a finding for a file that cannot be read; there is nothing to show.
    }
  }

  bool is_scene() const { return scene_.has_value(); }

  /// The pictures that a finding is about; in a scene, those of the material that the finding's pointer
  /// ("/materials/3") names. Null where there are none.
  const Pictures* of(const Finding& finding) {
    constexpr std::string_view list = "/materials/";
    if (!scene_) return files_ ? &*files_ : nullptr;
    if (!finding.pointer.starts_with(list)) return nullptr;
    double index = -1;
    if (!parse_number(finding.pointer.substr(list.size()), index) || index < 0 ||
        index >= static_cast<double>(scene_->materials.size()))
      return nullptr;
    if (index != material_) {
      try {
        files_ = convert_material(scene_->materials[static_cast<std::size_t>(index)], *textures_);
        hide_unused(*files_, texels_in_use(*uses_, looks_->of(static_cast<int>(index)), files_->a.width,
                                           files_->a.height));
      } catch (const Error&) {
        files_.reset();
      }
      material_ = index;
    }
    return files_ ? &*files_ : nullptr;
  }

 private:
  std::optional<Pictures> files_;
  std::optional<GltfScene> scene_;
  std::optional<MaterialUses> uses_;
  std::optional<MaterialLooks> looks_;
  std::optional<ScenePictures> textures_;
  double material_ = -1;  // index of the material whose pictures files_ holds
};

std::vector<std::size_t> with_places(const ValidationReport& report) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < report.files.size(); ++i) {
    const auto& findings = report.files[i].findings;
    if (report.files[i].target && std::any_of(findings.begin(), findings.end(), has_place)) out.push_back(i);
  }
  return out;
}

std::vector<const CheckTarget*> targets_of(const CheckedFile& file) {
  if (file.tiles.empty()) return {file.target.get()};
  std::vector<const CheckTarget*> out;
  for (const auto& tile : file.tiles) out.push_back(tile.get());
  return out;
}

}  // namespace

std::unique_ptr<Output> masks(const ValidationReport& report, const Settings& settings,
                              const PictureDoor& door, const std::string& folder, unsigned threads) {
  auto out = std::make_unique<OutputFolder>(folder, Replace::files);
  const std::vector<std::string> inputs = checked_paths(report);
  out->keep_off(std::make_shared<const ReadPlaces>(inputs));
  out->limit_mode(strictest_mode(inputs));
  // Names are given out in the report's order, so that they do not depend on the threads.
  const auto wanted = with_places(report);
  FreeNames taken;
  std::vector<std::vector<std::string>> names(wanted.size());
  for (std::size_t w = 0; w < wanted.size(); ++w)
    for (const Finding& finding : report.files[wanted[w]].findings) {
      std::string& name = names[w].emplace_back();
      if (!has_place(finding)) continue;
      const std::string asked = file_name(finding);
      name = taken.free(asked, [&](int number) { return asked + '.' + std::to_string(number); });
    }
  parallel_chunks(wanted.size(), threads, 1, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t w = begin; w < end; ++w) {
      const CheckedFile& file = report.files[wanted[w]];
      // The tiles of a UDIM set are worked on one after the other, so that memory holds the pictures of one.
      for (const CheckTarget* target : targets_of(file)) {
        PictureSource source(*target, door);
        for (std::size_t i = 0; i < file.findings.size(); ++i) {
          const Finding& finding = file.findings[i];
          if (names[w][i].empty() || &file.target_of(finding) != target) continue;
          const Pictures* pictures = source.of(finding);
          if (pictures == nullptr) continue;
          const Image8& picture = is_about_a(finding, *target, *pictures) ? pictures->a : pictures->b;
          if (picture.pixel_count() == 0) continue;
          const Image8 marks = marks_of(finding, *target, *pictures, picture, settings);
          out->write(names[w][i] + ".png", png_bytes(mask_picture(picture, marks), {}));
        }
      }
    }
  });
  return out;
}

namespace {

constexpr int thumbnail_side = 256, small_thumbnail_side = 96;
constexpr std::size_t most_large = 24;  // files
constexpr std::size_t at_once = 32;     // files

// How the pictures of a page are made.
//   side   of thumbnails
struct PagePictures {
  const Settings& settings;
  const PictureDoor& door;
  int side;
};

// The thumbnail of a texture with the heat map and the boxes of those of `findings` that are about it.
//   a   texture A (diffuse); false: texture B (specular)
ValidationPicture page_picture(bool a, std::span<const Finding* const> findings, const CheckTarget& target,
                               const Pictures& pictures, const PagePictures& how) {
  const Image8& picture = a ? pictures.a : pictures.b;
  ValidationPicture out;
  out.width = picture.width;
  out.height = picture.height;
  const Image8 small = thumbnail(picture, how.side);
  out.png = png_bytes(small, {});
  Image8 all(picture.width, picture.height, 1);
  bool any = false;
  for (const Finding* finding : findings) {
    if (!has_place(*finding) || is_about_a(*finding, target, pictures) != a) continue;
    const Image8 marks = marks_of(*finding, target, pictures, picture, how.settings);
    // A plateau of one finding wins over a transition of another.
    for (std::size_t i = 0; i < all.values.size(); ++i)
      all.values[i] = std::max(all.values[i], marks.values[i]);
    if (finding->box) out.boxes.push_back(*finding->box);
    any = true;
  }
  if (any) out.heat_png = png_bytes(heat_map(all, small.width, small.height), {});
  return out;
}

// What a picture shows, for the text below it. The rules see sets as diffuse and specular, whatever their files hold.
std::string caption(const CheckTarget& target, bool a) {
  if (MetalRoughSet::is_set(target)) {
    const auto base = std::ranges::find(target.files, FileRole::base_color, &TargetFile::role);
    const TargetFile& from = base == target.files.end() ? target.files.front() : *base;
    return (a ? "diffuse, from " : "specular, from ") + from.label +
           (target.files.size() > 1 ? " and its set" : "");
  }
  if (target.files.size() == 1) return target.files.front().label;
  const FileRole role = a ? FileRole::diffuse_alpha : FileRole::specular_gloss;
  const auto part = std::ranges::find(target.files, role, &TargetFile::role);
  return part != target.files.end() ? part->label : a ? "diffuse" : "specular";
}

void add_pictures(const CheckedFile& file, const CheckTarget& target, const PagePictures& how,
                  ValidationPageFile& out) {
  PictureSource source(target, how.door);
  // For a scene, every material with findings is shown; other targets have a single pair of textures.
  std::map<std::string, std::vector<const Finding*>> groups;
  for (const Finding& finding : file.findings)
    if (&file.target_of(finding) == &target)
      groups[source.is_scene() ? finding.pointer : ""].push_back(&finding);
  for (const auto& [pointer, findings] : groups) {
    const Pictures* pictures = source.of(*findings.front());
    if (pictures == nullptr) continue;
    for (const bool a : {true, false}) {
      if ((a ? pictures->a : pictures->b).pixel_count() == 0) continue;
      ValidationPicture shown = page_picture(a, findings, target, *pictures, how);
      shown.label = source.is_scene() ? findings.front()->material + (a ? ", diffuse" : ", specular")
                                      : caption(target, a);
      out.pictures.push_back(std::move(shown));
    }
    if (pictures->b.pixel_count() == 0) continue;
    const auto counts =
        f0_histogram(pictures->b, pictures->a, target.manifest.transfer.value_or(how.settings.transfer));
    if (!out.f0) out.f0.emplace();
    for (std::size_t code = 0; code < counts.size(); ++code) (*out.f0)[code] += counts[code];
  }
}

ValidationPageFile page_file(const CheckedFile& file, const PagePictures& how) {
  ValidationPageFile out;
  for (const CheckTarget* target : targets_of(file)) add_pictures(file, *target, how, out);
  return out;
}

// The bytes that pictures take in the page, where base64 writes 3 bytes as 4.
std::size_t bytes_on_page(const ValidationPageFile& file) {
  std::size_t out = file.f0 ? 4096 : 0;  // the bars of a histogram, at most
  for (const ValidationPicture& picture : file.pictures)
    out += (picture.png.size() + picture.heat_png.size()) / 3 * 4;
  return out;
}

}  // namespace

std::vector<ValidationPageFile> page_pictures(const ValidationReport& report, const Settings& settings,
                                              const PictureDoor& door, std::size_t most_bytes,
                                              unsigned threads) {
  std::vector<ValidationPageFile> out(report.files.size());
  std::vector<std::size_t> wanted = page_order(report);
  std::erase_if(wanted, [&](std::size_t i) { return !report.files[i].target || report.files[i].unreadable; });
  const int side = wanted.size() <= most_large ? thumbnail_side : small_thumbnail_side;
  std::size_t bytes = 0;
  for (std::size_t first = 0; first < wanted.size(); first += at_once) {
    const std::size_t count = std::min(at_once, wanted.size() - first);
    if (bytes <= most_bytes)
      parallel_chunks(count, threads, 1, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t w = first + begin; w < first + end; ++w)
          out[wanted[w]] = page_file(report.files[wanted[w]], {settings, door, side});
      });
    for (std::size_t w = first; w < first + count; ++w) {
      ValidationPageFile& file = out[wanted[w]];
      bytes += bytes_on_page(file);
      if (bytes <= most_bytes) continue;
      file = {};
      file.left_out = true;
    }
  }
  return out;
}

}  // namespace etak
