// SPDX-License-Identifier: Apache-2.0
#include "core/validate/repairs/repair.h"

#include "core/image/flood.h"
#include "core/judge/engine.h"
#include "core/judge/pixels/code_tables.h"
#include "core/validate/repairs/rows.h"

namespace etak {

namespace {

constexpr const Repair* table_of_repairs[] = {
#define ETAK_REPAIR(name) &name,
#include "core/validate/repairs/repairs.inc"
#undef ETAK_REPAIR
};

// Finds the plateaus of marks and grows them.
class RegionSearch {
 public:
  RegionSearch(const Image8& marks, const Image8& of, TextureTransfer transfer)
      : marks_(marks), of_(of), tables_(code_tables(transfer)), seen_(marks.values.size()) {}

  std::vector<RepairRegion> find() {
    std::vector<RepairRegion> out;
    for (std::size_t i = 0; i < marks_.values.size(); ++i) {
      if (seen_[i] != 0 || marks_.values[i] != plateau) continue;
      RepairRegion region = plateau_from(i);
      grow(region);
      average(region);
      out.push_back(std::move(region));
    }
    return out;
  }

 private:
  static constexpr std::uint8_t plateau = 2;
  static constexpr int reach = 4;  // codes

  std::size_t channels() const { return static_cast<std::size_t>(of_.channels); }
  std::size_t colours() const { return of_.channels >= 3 ? 3 : 1; }
  const std::uint8_t* texel(std::size_t i) const { return of_.values.data() + i * channels(); }

  // Adds the texels that `wanted` accepts and that touch those of the region.
  template <class Wanted>
  void extend(RepairRegion& region, const Wanted& wanted) {
    flood({0, 0, marks_.width, marks_.height}, marks_.width, seen_, region.texels, wanted);
  }

  RepairRegion plateau_from(std::size_t first) {
    RepairRegion region;
    least_.fill(255);
    most_.fill(0);
    seen_[first] = 1;
    region.texels.push_back(first);
    extend(region, [&](std::size_t i) { return marks_.values[i] == plateau; });
    for (const std::size_t i : region.texels)
      for (std::size_t c = 0; c < colours(); ++c) {
        least_[c] = std::min(least_[c], int{texel(i)[c]});
        most_[c] = std::max(most_[c], int{texel(i)[c]});
      }
    return region;
  }

  void grow(RepairRegion& region) {
    extend(region, [&](std::size_t i) {
      if (marks_.values[i] == 0) return false;
      for (std::size_t c = 0; c < colours(); ++c)
        if (texel(i)[c] < least_[c] - reach || texel(i)[c] > most_[c] + reach) return false;
      return true;
    });
  }

  void average(RepairRegion& region) const {
    for (const std::size_t i : region.texels)
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint8_t code = texel(i)[colours() == 3 ? c : 0];
        region.mean[c] += code / 255.0;
        region.linear[c] += tables_.decoded[code];
      }
    for (std::size_t c = 0; c < 3; ++c) {
      region.mean[c] /= static_cast<double>(region.texels.size());
      region.linear[c] /= static_cast<double>(region.texels.size());
    }
  }

  const Image8& marks_;
  const Image8& of_;
  const CodeTables& tables_;
  std::vector<char> seen_;
  std::array<int, 3> least_{}, most_{};
};

}  // namespace

void RepairPicture::put_through(const std::function<double(double)>& curve) {
  std::vector<std::uint16_t> table(static_cast<std::size_t>(most) + 1);
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = code(curve(value(static_cast<std::uint16_t>(i))));
  const auto channels = static_cast<std::size_t>(codes.channels);
  for (std::size_t i = 0; i < codes.values.size(); i += channels)
    for (std::size_t c = 0; c < colour_channels(); ++c) codes.values[i + c] = table[codes.values[i + c]];
}

Image8 RepairBench::marks(RegionKind kind) const {
  return region_picture(kind, seen_, target, settings);
}

RepairPicture* RepairBench::with_role(std::initializer_list<FileRole> roles) const {
  for (RepairPicture& picture : pictures)
    if (std::ranges::find(roles, picture.file.role) != roles.end()) return &picture;
  return nullptr;
}

RepairPicture* RepairBench::named() const {
  const auto found = std::ranges::find(pictures, finding.file,
                                       [](const RepairPicture& picture) { return picture.file.label; });
  return found == pictures.end() ? nullptr : &*found;
}

std::span<const Repair* const> repairs() {
  return table_of_repairs;
}

const Repair* find_repair(std::string_view rule) {
  const auto found = std::ranges::find(table_of_repairs, rule, &Repair::rule);
  return found == std::end(table_of_repairs) ? nullptr : *found;
}

std::vector<RepairRegion> regions_to_repair(const RepairBench& bench, const Image8& marks, const Image8& of) {
  return RegionSearch(marks, of, bench.settings.transfer).find();
}

std::array<std::size_t, 2> metallic_channels(const RepairPicture& picture) {
  if (picture.file.role == FileRole::metallic) return {0, picture.colour_channels()};
  // As glTF packs them where the name does not say it.
  const std::string_view letters =
      picture.file.channels.empty() ? "-rm-" : std::string_view(picture.file.channels);
  const std::size_t at = letters.find('m');
  const auto channels = static_cast<std::size_t>(picture.codes.channels);
  return at < channels ? std::array{at, at + 1} : std::array<std::size_t, 2>{0, 0};
}

std::string wrong_size(const RepairPicture& picture, const Image8& marks) {
  if (picture.codes.width == marks.width && picture.codes.height == marks.height) return {};
  return "the pictures of the set differ in size";
}

}  // namespace etak
