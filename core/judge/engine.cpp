// SPDX-License-Identifier: Apache-2.0
#include "core/judge/engine.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <tuple>

#include "core/image/flood.h"
#include "core/judge/check_pictures.h"
#include "core/judge/pixels/pixel_pass.h"
#include "core/judge/pixels/plan.h"
#include "core/judge/rule_check.h"
#include "core/judge/rules.h"
#include "core/judge/rules/surface_check.h"

namespace etak {

namespace {

// The tiles of the target, cut at the edges of its pictures; without tiles one tile of the whole picture.
std::vector<CheckTile> tiles_of(const CheckTarget& target, int width, int height) {
  std::vector<CheckTile> tiles;
  for (CheckTile tile : target.manifest.tiles) {
    PixelBox& box = tile.box;
    // ETK506 reports a tile that leaves its page; the part inside is judged all the same.
    const auto cut = [](int& start, int& length, int side) {
      const long long end = std::min<long long>(static_cast<long long>(start) + length, side);
      start = std::max(start, 0);
      length = static_cast<int>(std::max<long long>(0, end - start));
    };
    cut(box.x, box.width, width);
    cut(box.y, box.height, height);
    if (box.width > 0 && box.height > 0) tiles.push_back(std::move(tile));
  }
  if (target.manifest.tiles.empty()) {
    CheckTile& whole = tiles.emplace_back();
    whole.material = target.manifest.material;
    whole.surface_class = target.manifest.surface_class;
    whole.box = {0, 0, width, height};
  }
  return tiles;
}

void add_counts(CheckedFile& file, const std::vector<TileEvidence>& tiles, bool has_b) {
  ByteCounts all;
  for (const TileEvidence& tile : tiles) all.add(tile.counts);
  const std::array<std::uint64_t, count_names.size()> counts{
      all.texels, all.opaque, all.alpha_zero,  all.zone_any,   all.zone_all,
      all.black,  all.metals, all.gloss_least, all.gloss_most, all.energy_over};
  for (std::size_t i = 0; i < (has_b ? counts.size() : counts_without_specular); ++i)
    file.counts.emplace_back(count_names[i], static_cast<std::int64_t>(counts[i]));
}

void add_stats(CheckStats& to, const CheckStats& from) {
  to.pictures_decoded += from.pictures_decoded;
  to.texels = from.texels;
  to.passes += from.passes;
  to.decode_seconds += from.decode_seconds;
  to.byte_seconds += from.byte_seconds;
  to.region_seconds += from.region_seconds;
}

void fill_evidence(std::optional<PictureEvidence>& picture, const RowSource* source, const std::string& label,
                   FileRole role) {
  if (source != nullptr && !picture) picture = {source->header(), label, role, {}};
}

// Plateau texels (2) in 8-connected groups of fewer than `least` become transition (1).
void demote_small_groups(Image8& marks, const PixelBox& box, std::size_t least) {
  std::vector<char> seen(marks.values.size());
  for (int y = box.y; y < box.y + box.height; ++y)
    for (int x = box.x; x < box.x + box.width; ++x) {
      const std::size_t first =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(marks.width) + static_cast<std::size_t>(x);
      if (seen[first] != 0 || marks.values[first] != 2) continue;
      seen[first] = 1;
      std::vector<std::size_t> group{first};
      flood(box, marks.width, seen, group, [&](std::size_t i) { return marks.values[i] == 2; });
      if (group.size() < least)
        for (const std::size_t i : group) marks.values[i] = 1;
    }
}

}  // namespace

Needs needs_of(const Settings& settings) {
  Needs needs;
  for (const Rule* rule : rules())
    if (severity_of(*rule, settings) != Severity::off) needs |= rule->needs;
  return needs;
}

Needs needs_of(const CheckTarget& target, const Settings& settings) {
  bool metal_rough = false, pictures = false, materials = false, maps = false;
  for (const TargetFile& file : target.files) {
    metal_rough = metal_rough || file.role == FileRole::metal_rough || file.role == FileRole::metallic ||
                  file.role == FileRole::scene;
    maps = maps || file.role == FileRole::scene || is_map(file.role);
    materials = materials || file.role == FileRole::material || file.role == FileRole::spectrum ||
                file.role == FileRole::surfaces;
    pictures =
        pictures || (is_judged(file.role) && file.role != FileRole::gloss) || file.role == FileRole::scene;
  }
  const bool atlas = !target.manifest.tiles.empty();
  const bool named = !target.manifest.material.empty() || !target.manifest.surface_class.empty() ||
                     std::ranges::any_of(target.manifest.tiles, [](const CheckTile& t) {
                       return !t.material.empty() || !t.surface_class.empty() || t.typical_gloss.has_value();
                     });
  Needs needs;
  for (const Rule* rule : rules()) {
    if (severity_of(*rule, settings) == Severity::off) continue;
    if (rule->needs.has(Need::metal_rough) && !metal_rough) continue;
    // A rule on headers that also judges maps runs without maps too.
    if (rule->needs.has(Need::maps) && !rule->needs.has(Need::header) && !maps) continue;
    if (rule->needs.has(Need::layout) && !atlas) continue;
    if (rule->needs.has(Need::named) && !named) continue;
    if (rule->needs.has(Need::material) && !materials) continue;
    if (rule->needs.pixels() && !pictures && !target.files.empty()) continue;
    needs |= rule->needs;
  }
  return needs;
}

CheckedFile checked_file_of(const CheckTarget& target) {
  CheckedFile file;
  file.path = target.own_label();
  for (const TargetFile& part : target.files) {
    if (part.label != file.path) file.companions.push_back(part.label);
    file.roles.push_back({part.label, std::string(name(part.role))});
  }
  return file;
}

Settings settings_for(const CheckTarget& target, const Settings& settings) {
  Settings own = settings;
  if (target.manifest.transfer) own.transfer = *target.manifest.transfer;
  if ((!target.manifest.scene.empty() && target.manifest.parts.empty()) || target.manifest.layout_alone)
    for (const Rule* rule : rules())
      if (!rule->needs.has(Need::layout)) own.rules[std::string(rule->id)].severity = Severity::off;
  return own;
}

void look_at_pixels(const CheckTarget& target, const std::function<PictureRows(Needs)>& open,
                    const Settings& settings, unsigned threads, Evidence& evidence, CheckedFile& file) {
  const Needs needs = needs_of(target, settings);
  PictureRows pictures = open(needs);
  const auto label_of = [&](std::initializer_list<FileRole> roles) {
    const TargetFile* found = target.with_role(roles);
    return found == nullptr ? target.label : found->label;
  };
  fill_evidence(evidence.a, pictures.a.get(), label_of({FileRole::diffuse_alpha, FileRole::base_color}),
                FileRole::diffuse_alpha);
  fill_evidence(evidence.b, pictures.b.get(),
                label_of({FileRole::specular_gloss, FileRole::f0_only, FileRole::base_color}),
                FileRole::specular_gloss);
  evidence.metal_rough = evidence.metal_rough || pictures.metallic != nullptr;
  const RowSource* any = pictures.b ? pictures.b.get() : pictures.a.get();
  if (any == nullptr) return;
  const int width = any->header().width, height = any->header().height;
  file.width = width;
  file.height = height;
  const bool sizes_differ = pictures.a && pictures.b &&
                            (pictures.a->header().width != pictures.b->header().width ||
                             pictures.a->header().height != pictures.b->header().height);
  if (sizes_differ || !needs.pixels() || width <= 0 || height <= 0) {
    file.stats.pictures_left_out += (pictures.a ? 1u : 0u) + (pictures.b ? 1u : 0u);
    return;
  }

  const PassPlan plan = first_plan(target, settings, pictures.a != nullptr, pictures.b != nullptr,
                                   pictures.metallic != nullptr, threads);
  const std::vector<CheckTile> tiles = tiles_of(target, width, height);
  std::vector<bool> every_row(tiles.size());
  for (std::size_t i = 0; i < tiles.size(); ++i) every_row[i] = wants_every_row(tiles[i], settings);
  PassResult found = pixel_pass(pictures, tiles, every_row, plan);
  add_stats(file.stats, found.stats);
  if (evidence.a) evidence.a->floats = found.a_floats;
  if (evidence.b) evidence.b->floats = found.b_floats;

  const bool has_gloss = evidence.b && (evidence.metal_rough || evidence.b->header.channels % 2 == 0);
  std::vector<std::size_t> suspects;
  std::vector<CheckTile> suspect_tiles;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    found.tiles[i].whole = target.manifest.tiles.empty();
    if (!needs_second_look(found.tiles[i], plan, settings, has_gloss)) continue;
    suspects.push_back(i);
    suspect_tiles.push_back(tiles[i]);
  }
  if (!suspects.empty()) {
    pictures = open(needs);
    const PassPlan closer = second_plan(plan);
    PassResult second =
        pixel_pass(pictures, suspect_tiles, std::vector<bool>(suspect_tiles.size(), true), closer);
    add_stats(file.stats, second.stats);
    for (std::size_t i = 0; i < suspects.size(); ++i) {
      TileEvidence& tile = found.tiles[suspects[i]];
      tile.detail = second.tiles[i].detail;
      if (tile.region(RegionKind::any_f0) != nullptr || closer.kinds.empty()) continue;
      tile.kinds.push_back(RegionKind::any_f0);
      tile.regions.push_back(std::move(second.tiles[i].regions.front()));
    }
  }
  add_counts(file, found.tiles, evidence.b.has_value());
  for (const TileEvidence& tile : found.tiles)
    if (const PlateauSummary* zone = tile.region(RegionKind::zone)) {
      file.plateau_px += zone->area;
      file.transition_px += zone->masked - zone->area;
    }
  evidence.tiles = std::move(found.tiles);
}

namespace {

// Joins the findings of one rule and file in the islands of one material: the worst finding stays, with a
// list of all islands.
void join_islands(const Manifest& manifest, std::vector<Finding>& findings) {
  std::map<std::string_view, std::string_view> material_of;  // by tile
  for (const CheckTile& tile : manifest.tiles)
    if (!tile.island_of.empty()) material_of.emplace(tile.name, tile.island_of);
  if (material_of.empty()) return;
  std::map<std::tuple<std::string, std::string, std::string_view>, std::size_t> joined;
  std::vector<Finding> out;
  for (Finding& finding : findings) {
    const auto material = material_of.find(finding.tile);
    if (material == material_of.end()) {
      out.push_back(std::move(finding));
      continue;
    }
    FindingIsland island{finding.tile, finding.box, finding.area_px};
    finding.tile = material->second;
    const auto [at, fresh] =
        joined.try_emplace(std::tuple(finding.rule, finding.file, material->second), out.size());
    if (fresh) out.push_back(finding);
    Finding& worst = out[at->second];
    std::vector<FindingIsland> islands = std::move(worst.islands);
    islands.push_back(std::move(island));
    if (std::tie(finding.severity, finding.area_px) > std::tie(worst.severity, worst.area_px))
      worst = std::move(finding);
    worst.islands = std::move(islands);
  }
  for (Finding& finding : out)
    if (finding.islands.size() == 1) finding.islands.clear();
  findings = std::move(out);
}

// Makes notes of what the rules for bare surfaces say of colours that layers make by interference.
void explain_layers(const Manifest& manifest, std::vector<Finding>& findings) {
  constexpr std::array<std::string_view, 4> rules{"ETK101", "ETK106", "ETK202", "ETK609"};
  for (Finding& each : findings) {
    const auto tile = std::ranges::find(manifest.tiles, each.tile, &CheckTile::name);
    const std::string& layers = tile != manifest.tiles.end() ? tile->layers : manifest.layers;
    if (layers.empty() || std::ranges::find(rules, each.rule) == rules.end()) continue;
    each.severity = std::min(each.severity, Severity::info);
    each.message += "; layers make such colours by interference: " + layers;
  }
}

}  // namespace

void judge(const CheckTarget& target, const Evidence& evidence, const Settings& settings, CheckedFile& file) {
  const CodeTables& tables = code_tables(settings.transfer);
  std::vector<Finding> findings;
  for (const Rule* rule : rules()) {
    if (rule->check == nullptr || severity_of(*rule, settings) == Severity::off) continue;
    RuleCheck check(*rule, target, settings, evidence, tables, findings);
    try {
      rule->check(check);
    } catch (const std::exception& e) {
      findings.push_back(finding_of(*find_rule("ETK901"), Severity::error, file.path,
                                    "rule " + std::string(rule->id) + " failed: " + e.what()));
      file.unreadable = true;
    }
  }
  for (const DocumentSurface& surface : evidence.surfaces)
    file.surfaces.push_back(judged_surface(known_materials(settings), surface));
  explain_layers(target.manifest, findings);
  join_islands(target.manifest, findings);
  const auto key = [](const Finding& f) {
    return std::tuple(f.rule, f.tile, f.box ? f.box->y : -1, f.box ? f.box->x : -1, f.file, f.pointer);
  };
  std::stable_sort(findings.begin(), findings.end(),
                   [&](const Finding& a, const Finding& b) { return key(a) < key(b); });
  file.findings.insert(file.findings.end(), std::make_move_iterator(findings.begin()),
                       std::make_move_iterator(findings.end()));
}

CheckedFile check_rows(const CheckTarget& target, const std::function<PictureRows(Needs)>& open,
                       const Settings& settings, unsigned threads) {
  const Settings own = settings_for(target, settings);
  CheckedFile file = checked_file_of(target);
  Evidence evidence;
  look_at_pixels(target, open, own, threads, evidence, file);
  for (const auto* picture : {&evidence.a, &evidence.b})
    if (*picture) evidence.headers.push_back(**picture);
  judge(target, evidence, own, file);
  return file;
}

CheckedFile check_pictures(const CheckTarget& target, const Pictures& pictures, const Settings& settings,
                           unsigned threads) {
  return check_rows(
      target, [&](Needs) { return pictures.rows(); }, settings, threads);
}

Image8 region_picture(RegionKind kind, const Pictures& pictures, const CheckTarget& target,
                      const Settings& settings) {
  const Image8& any = pictures.b.width != 0 ? pictures.b : pictures.a;
  Image8 out(any.width, any.height, 1);
  const Settings own = settings_for(target, settings);
  PassPlan plan =
      first_plan(target, own, pictures.a.width != 0, pictures.b.width != 0, pictures.metallic.width != 0, 1);
  plan.kinds = {kind};
  plan.fringe = plan.hashes = plan.frames = false;
  PixelBox box;
  const auto mark = [&](std::uint8_t value) {
    return [&out, &box, value](std::size_t, int y, const std::uint64_t* words) {
      for (int x = 0; x < box.width; ++x)
        if ((words[x / 64] >> (x % 64) & 1) != 0) out.at(box.x + x, box.y + y)[0] = value;
    };
  };
  for (const CheckTile& tile : tiles_of(target, any.width, any.height)) {
    box = tile.box;
    // The first pass marks the mask as it is, the second the plateaus.
    for (const bool plateaus : {false, true}) {
      PassPlan part = plan;
      part.recorder = mark(plateaus ? 2 : 1);
      if (!plateaus) part.zone.erode = 0;
      PictureRows rows = pictures.rows();
      pixel_pass(rows, {&tile, 1}, {false}, part);
    }
    demote_small_groups(out, box, least_region(plan.zone, box.area()));
  }
  return out;
}

std::vector<FlatColor> flat_colors(std::unique_ptr<RowSource> picture, TextureTransfer transfer,
                                   unsigned threads) {
  constexpr double same_codes = 3;
  Settings settings;
  settings.transfer = transfer;
  const CheckTarget target;
  PassPlan plan = first_plan(target, settings, false, true, false, threads);
  plan.kinds = {RegionKind::any_f0};
  plan.fringe = plan.hashes = plan.frames = false;
  const std::vector<CheckTile> tiles = tiles_of(target, picture->header().width, picture->header().height);
  PictureRows rows{nullptr, std::move(picture), nullptr};
  const PassResult found = pixel_pass(rows, tiles, {false}, plan);
  std::vector<FlatColor> out;
  for (const Plateau& each : found.tiles.front().region(RegionKind::any_f0)->largest) {
    const double share = static_cast<double>(each.area) / static_cast<double>(tiles.front().box.area());
    const auto like = std::ranges::find_if(out, [&](const FlatColor& known) {
      return code_distance(each.specular, known.linear, transfer) <= same_codes;
    });
    if (like == out.end()) {
      out.push_back({each.specular, share});
      continue;
    }
    for (std::size_t c = 0; c < 3; ++c)
      like->linear[c] += (each.specular[c] - like->linear[c]) * share / (like->share + share);
    like->share += share;
  }
  std::ranges::stable_sort(out, std::greater{}, &FlatColor::share);
  return out;
}

}  // namespace etak
