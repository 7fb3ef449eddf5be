// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/scene_on_pages.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <tuple>
#include <utility>

#include "core/atlas/texels/page_pixels.h"
#include "core/atlas/texels/place_texels.h"
#include "core/judge/engine.h"
#include "core/judge/rules.h"
#include "core/scene/gltf_convert.h"
#include "core/validate/files/check.h"
#include "core/validate/files/scene_use.h"
#include "core/validate/files/tiles.h"

namespace etak {

namespace {

// Where a part of a region's crop lies on its page; a region may be stored with fewer texels.
PixelBox on_page(const PixelBox& part, const AtlasRect& rect) {
  const int width = rect.rotated ? rect.height : rect.width, height = rect.rotated ? rect.width : rect.height;
  const auto scaled = [](int from, int length, int stored, int shown) {
    const auto first = static_cast<int>(std::int64_t{from} * stored / shown);
    const auto end = static_cast<int>((std::int64_t{from + length} * stored + shown - 1) / shown);
    return std::pair(first, end - first);
  };
  const auto [x, across] = scaled(part.x - rect.crop.x, part.width, width, rect.crop.width);
  const auto [y, down] = scaled(part.y - rect.crop.y, part.height, height, rect.crop.height);
  if (!rect.rotated) return {rect.x + x, rect.y + y, across, down};
  return {rect.x + height - y - down, rect.y + x, down, across};
}

// A place of a finding in the frame of the material's own textures.
struct FoundPart {
  PixelBox box;
  std::size_t area = 0;
};

// The plateaus that a finding speaks of; its box alone where it speaks of other texels.
std::vector<FoundPart> parts_of(const Finding& finding, const Evidence& evidence) {
  const Rule* rule = find_rule(finding.rule);
  const PlateauSummary* found = rule != nullptr && rule->region && evidence.tiles.size() == 1
                                    ? evidence.tiles[0].region(*rule->region)
                                    : nullptr;
  if (found == nullptr || found->regions == 0 || found->box != *finding.box)
    return {{*finding.box, finding.area_px}};
  std::vector<FoundPart> out;
  for (const Plateau& plateau : found->largest) out.push_back({plateau.box, plateau.area});
  return out;
}

// The part of a finding that lies in one region.
struct InRegion {
  std::size_t rect = 0;
  PixelBox box;
  double area = 0;
};

// What lies in each region. Boxes of regions may overlap: a part that lies in several whole counts for the smallest.
std::vector<InRegion> in_regions(const std::vector<FoundPart>& parts, const std::vector<AtlasRect>& rects) {
  std::vector<InRegion> out;
  for (std::size_t r = 0; r < rects.size(); ++r) out.push_back({r, {}, 0});
  const auto add = [&](std::size_t r, const PixelBox& box, double area) {
    out[r].box = out[r].box.width == 0 ? box : around(out[r].box, box);
    out[r].area += area;
  };
  for (const FoundPart& part : parts) {
    const AtlasRect* whole = nullptr;
    for (const AtlasRect& rect : rects)
      if (common_part(part.box, rect.crop) == part.box &&
          (whole == nullptr || rect.crop.area() < whole->crop.area()))
        whole = &rect;
    if (whole != nullptr) {
      add(static_cast<std::size_t>(whole - rects.data()), part.box, static_cast<double>(part.area));
      continue;
    }
    for (std::size_t r = 0; r < rects.size(); ++r)
      if (const PixelBox common = common_part(part.box, rects[r].crop); common.width > 0 && common.height > 0)
        add(r, common,
            static_cast<double>(part.area) * static_cast<double>(common.area()) /
                static_cast<double>(part.box.area()));
  }
  std::erase_if(out, [](const InRegion& each) { return each.box.width == 0; });
  return out;
}

}  // namespace

const AtlasRect* put_on_pages(Finding& finding, const Evidence& evidence, const std::vector<AtlasRect>& rects,
                              const std::string& name) {
  finding.tile = name;
  if (!finding.box || rects.empty()) {
    finding.box.reset();
    return nullptr;
  }
  std::vector<InRegion> found = in_regions(parts_of(finding, evidence), rects);
  finding.box.reset();
  if (found.empty()) return nullptr;
  const double width = rects[0].source_width, height = rects[0].source_height;
  const auto island_of = [&](const InRegion& each) {
    const PixelBox& box = each.box;
    return FindingIsland{
        name, on_page(box, rects[each.rect]), static_cast<std::size_t>(std::lround(each.area)),
        UvBox{box.x / width, box.y / height, (box.x + box.width) / width, (box.y + box.height) / height}};
  };
  const auto worst = std::ranges::max_element(found, {}, &InRegion::area);
  const FindingIsland shown = island_of(*worst);
  finding.box = shown.box;
  finding.uv = shown.uv;
  if (found.size() > 1)
    for (const InRegion& each : found) finding.islands.push_back(island_of(each));
  return &rects[worst->rect];
}

SceneOnPages::SceneOnPages(PackedScene packed, std::string label, std::string scene_label,
                           const PictureDoor& door)
    : packed_(std::move(packed)),
      label_(std::move(label)),
      of_scene_{FileRole::scene, packed_.uses->scene().path, std::move(scene_label), false},
      check_(*packed_.uses, of_scene_, door) {}

const PackedScene::Material* SceneOnPages::packed(int material) const {
  const auto found = packed_.materials.find(material);
  return found == packed_.materials.end() ? nullptr : &found->second;
}

void SceneOnPages::start(const AtlasLayout& layout) {
  looks_.clear();
  constants_.clear();
  page_labels_.clear();
  file_ = {};
  file_.path = label_;
  std::map<std::string, std::vector<const AtlasRect*>> rects;
  for (const AtlasRect& rect : layout.rects) rects[rect.name].push_back(&rect);
  for (const AtlasMaterialRow& row : layout.materials) constants_.emplace(row.name, row.constant);
  const std::filesystem::path folder = std::filesystem::path(label_).parent_path();
  for (const AtlasPage& page : layout.pages) {
    auto& labels = page_labels_.emplace_back();
    for (std::size_t t = 0; t < labels.size(); ++t) {
      // The file of the other texture speaks for a texture that the page does without.
      const auto& files = page.files[page.files[t].empty() ? 1 - t : t];
      labels[t] = files.empty() ? label_ : (folder / files.front()).generic_string();
    }
  }
  for (SceneLook& look : check_.looks()) {
    Look& to = looks_.emplace_back();
    to.look = std::move(look);
    to.packed = std::ranges::all_of(to.look.materials, [&](int m) { return packed(m) != nullptr; });
    if (!to.packed) continue;
    for (const int material : to.look.materials)
      for (const AtlasRect* rect : rects[packed(material)->name]) {
        to.places.push_back({material, *rect});
        to.last_page = std::max(to.last_page, rect->page);
      }
  }
}

// The pictures before any page: texels that no triangle reads are the scene's own, those that one reads have
// the constants that the layout has in the place of channels, and 0 until their page comes.
void SceneOnPages::begin(Look& look) const {
  const PackedScene::Material& first = *packed(look.look.materials.front());
  Pictures& to = look.pictures;
  to.a = first.pair->diffuse_alpha;
  to.b = first.pair->specular_gloss;
  to.metallic = *first.metallic;
  for (const int material : look.look.materials) {
    const PackedScene::Material& from = *packed(material);
    const auto row = constants_.find(from.name);
    if (row == constants_.end()) continue;
    std::array<std::uint8_t, channel_count> codes{};
    for (std::size_t c = 0; c < codes.size(); ++c) codes[c] = row->second[c].value_or(0);
    const std::uint8_t* used = from.use != nullptr && from.use->touched > 0 ? from.use->mask.data() : nullptr;
    for (std::size_t i = 0; i < to.a.pixel_count(); ++i) {
      if (used != nullptr && used[i] == 0) continue;
      std::copy_n(codes.begin(), 4, to.a.values.begin() + static_cast<std::ptrdiff_t>(4 * i));
      std::copy_n(codes.begin() + 4, 4, to.b.values.begin() + static_cast<std::ptrdiff_t>(4 * i));
    }
  }
}

void SceneOnPages::take_back(Look& look, int page, const PagePixels& pixels) const {
  for (const Place& place : look.places) {
    const AtlasRect& rect = place.rect;
    if (rect.page != page) continue;
    const PackedScene::Material& from = *packed(place.material);
    const Codes& constant = constants_.at(from.name);
    const std::uint8_t* used = from.use != nullptr && from.use->touched > 0 ? from.use->mask.data() : nullptr;
    for (const Texture texture : both_textures) {
      const PixelsView8 view = pixels.view(texture);
      if (view.data == nullptr) continue;
      const std::size_t first = first_channel(texture);
      std::array<bool, 4> stored{};
      for (std::size_t c = 0; c < 4; ++c) stored[c] = !constant[first + c] && rect.holds_channel(first + c);
      if (std::ranges::none_of(stored, std::identity{})) continue;
      const Image8 part = texels_back(view, {rect.x, rect.y, rect.width, rect.height}, rect.rotated);
      Image8& to = texture == Texture::diffuse_alpha ? look.pictures.a : look.pictures.b;
      for (int y = 0; y < rect.crop.height; ++y) {
        const int row = texel_under(y, rect.crop.height, part.height);
        const std::size_t line =
            static_cast<std::size_t>(rect.crop.y + y) * static_cast<std::size_t>(to.width);
        for (int x = 0; x < rect.crop.width; ++x) {
          if (used != nullptr && used[line + static_cast<std::size_t>(rect.crop.x + x)] == 0) continue;
          const auto texel = to.at(rect.crop.x + x, rect.crop.y + y);
          const auto code = part.at(texel_under(x, rect.crop.width, part.width), row);
          for (std::size_t c = 0; c < 4; ++c)
            if (stored[c]) texel[c] = code[c];
        }
      }
    }
  }
}

void SceneOnPages::judge_look(Look& look, const Settings& settings, unsigned threads, CheckedFile& file) {
  std::vector<std::uint8_t> use;
  std::array<std::string, 2> labels;
  if (look.packed) {
    std::vector<const TexelUse*> uses;
    for (const int material : look.look.materials) uses.push_back(packed(material)->use);
    use = texels_in_use(uses);
    labels = look.last_page < 0 ? std::array{label_, label_}
                                : page_labels_[static_cast<std::size_t>(look.last_page)];
  } else {
    look.pictures = check_.pictures_of(look.look);
    use = texels_in_use(*packed_.uses, look.look.materials, look.pictures.a.width, look.pictures.a.height);
    labels = check_.labels_of(look.look);
  }
  JudgedLook judged =
      check_.judge(look.look, {std::exchange(look.pictures, {}), use, labels}, {}, settings, threads);
  if (look.packed) {
    std::vector<AtlasRect> rects;
    for (const Place& place : look.places) {
      const auto where = [](const AtlasRect& r) { return std::tie(r.page, r.x, r.y, r.crop); };
      if (std::ranges::none_of(rects, [&](const AtlasRect& r) { return where(r) == where(place.rect); }))
        rects.push_back(place.rect);
    }
    const std::string& name = packed(look.look.materials.front())->name;
    for (Finding& finding : judged.file.findings)
      if (const AtlasRect* at = put_on_pages(finding, judged.evidence, rects, name))
        finding.file = page_labels_[static_cast<std::size_t>(at->page)][finding.file == labels[0] ? 0 : 1];
  }
  add_look(std::move(judged), file);
}

void SceneOnPages::judge(int page, const PagePixels* pixels, const Settings& settings, unsigned threads) {
  CheckTarget target;
  target.label = label_;
  target.files = {of_scene_};
  const bool wants_pixels = needs_of(target, settings).pixels();
  const CheckedFile found =
      check_by(target, settings, [&](const Settings& own, Evidence&, CheckedFile& file) {
        for (Look& look : looks_) {
          if (!wants_pixels) break;
          const bool is_here =
              std::ranges::any_of(look.places, [&](const Place& place) { return place.rect.page == page; });
          const bool is_nowhere = pixels == nullptr && look.last_page < 0;
          if (!is_here && !is_nowhere) continue;
          if (look.packed && look.pictures.a.width == 0) begin(look);
          if (is_here) take_back(look, page, *pixels);
          if (is_nowhere || page == look.last_page) judge_look(look, own, threads, file);
        }
        if (pixels == nullptr) check_.judge_headers({}, own, file);
      });
  file_.findings.insert(file_.findings.end(), found.findings.begin(), found.findings.end());
  sort_findings(file_);
  file_.companions = found.companions;
  file_.roles = found.roles;
  add_sums(found, file_);
}

}  // namespace etak
