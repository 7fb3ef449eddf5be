// SPDX-License-Identifier: Apache-2.0
#include "core/pack/one_page.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <tuple>

#include "core/atlas/sources/floats.h"
#include "core/atlas/sources/pictures.h"
#include "core/base/error.h"
#include "core/base/hash/content_hash.h"
#include "core/base/parallel.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"
#include "core/image/texture_bytes.h"
#include "core/pack/decision.h"
#include "core/pack/pack.h"
#include "core/pack/scene/scene_facts.h"

namespace etak {
namespace {

constexpr std::size_t part_count = channel_parts.size();
constexpr std::size_t diffuse_part = 0, alpha_part = 1, gloss_part = 3;

// The hash of each part of all texels of a material.
using PartHashes = std::array<std::array<std::uint64_t, 2>, part_count>;

template <class Value>
PartHashes part_hashes(const PairOf<Value>& pair) {
  PartHashes out;
  std::vector<Value> row;
  for (std::size_t p = 0; p < part_count; ++p) {
    const Pixels<Value>& picture = pair.of(both_textures[p / 2]);
    const std::size_t first = channel_parts[p].first % 4, size = channel_parts[p].size;
    ContentHash hash;
    for (int y = 0; y < picture.height; ++y) {
      row.clear();
      for (int x = 0; x < picture.width; ++x)
        for (std::size_t c = first; c < first + size; ++c) row.push_back(picture.at(x, y)[c]);
      hash.add(row.data(), sizeof(Value) * row.size());
    }
    out[p] = hash.value();
  }
  return out;
}

// Reads the texels of a material, and teaches its facts where they are not known yet.
PartHashes looked_at(PackInput& m, bool floats) {
  if (floats) return part_hashes(load_floats(m));
  std::vector<std::string> ignored;  // told when the sheet is made
  const MaterialPair pair = load_pair(m, ignored);
  if (!m.facts.learned) look_at(pair, nullptr, m.facts.opaque, m.facts);
  return part_hashes(pair);
}

// A part that is the same in all texels of a material.
struct Number {
  std::array<std::uint8_t, 3> code{};
  std::array<double, 3> exact{};  // of floats
  friend auto operator<=>(const Number&, const Number&) = default;
};

std::optional<Number> number_of(const MaterialFacts& facts, std::size_t part) {
  Number out;
  for (std::size_t c = 0; c < channel_parts[part].size; ++c) {
    const std::size_t channel = channel_parts[part].first + c;
    if (!facts.range.constant(channel)) return std::nullopt;
    out.code[c] = facts.range.most[channel];
    if (facts.floats) out.exact[c] = facts.exact[channel];
  }
  return out;
}

// A part as some materials share it.
struct Shared {
  std::size_t part, owner;
  std::vector<std::size_t> users;
  std::optional<std::size_t> sheet;
  // The alpha that all materials of a colour read; none where they differ, or it is a number.
  std::optional<std::size_t> alpha;
};

// The parts that materials share.
struct Sharing {
  std::vector<Shared> shared;
  std::array<std::vector<Number>, part_count> numbers;
  // What a material reads as a part: an index into `shared`, or into `numbers`.
  struct Use {
    bool number = false;
    std::size_t index = 0;
  };
  std::vector<std::array<Use, part_count>> uses;
};

Sharing find_sharing(const std::vector<PackInput>& materials, const std::vector<PartHashes>& hashes,
                     const LeaveOutOptions& options) {
  Sharing out;
  out.uses.resize(materials.size());
  std::map<std::tuple<std::size_t, int, int, WrapBoth, std::array<std::uint64_t, 2>, std::size_t>,
           std::size_t>
      known;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const PackInput& m = materials[i];
    if (!m.facts.reached) continue;
    for (std::size_t p = 0; p < part_count; ++p) {
      Sharing::Use& use = out.uses[i][p];
      if (const auto number = options.leaves("constant") ? number_of(m.facts, p) : std::nullopt) {
        auto& numbers = out.numbers[p];
        const auto found = std::ranges::find(numbers, *number);
        use = {true, static_cast<std::size_t>(found - numbers.begin())};
        if (found == numbers.end()) numbers.push_back(*number);
        continue;
      }
      const auto [found, fresh] = known.try_emplace(
          {p, m.width, m.height, m.wrap, hashes[i][p], options.leaves("equal") ? 0 : i}, out.shared.size());
      if (fresh) out.shared.push_back({p, i, {}, {}, {}});
      use.index = found->second;
      out.shared[use.index].users.push_back(i);
    }
  }
  for (Shared& color : out.shared) {
    if (color.part != diffuse_part) continue;
    const Sharing::Use& first = out.uses[color.users[0]][alpha_part];
    const bool same = std::ranges::all_of(color.users, [&](std::size_t user) {
      const Sharing::Use& alpha = out.uses[user][alpha_part];
      return !alpha.number && alpha.index == first.index;
    });
    if (same) color.alpha = first.index;
  }
  return out;
}

// What a sheet holds of each part, an index into Sharing::shared.
using Sheet = std::array<std::optional<std::size_t>, part_count>;

bool fits(const Sheet& sheet, std::size_t index, const Sharing& of, const std::vector<PackInput>& materials) {
  const Shared& part = of.shared[index];
  if (sheet[part.part]) return false;
  for (const auto& other : sheet) {
    if (!other) continue;
    const PackInput &a = materials[of.shared[*other].owner], &b = materials[part.owner];
    if (a.width != b.width || a.height != b.height || a.wrap != b.wrap) return false;
  }
  if (part.part == diffuse_part) return !sheet[alpha_part] || part.alpha == sheet[alpha_part];
  return part.part != alpha_part || !sheet[diffuse_part] || of.shared[*sheet[diffuse_part]].alpha == index;
}

// Materials of many parts come first, whose parts then lie together where they can.
std::vector<Sheet> sheets_of(Sharing& of, const std::vector<PackInput>& materials) {
  std::vector<std::size_t> order(materials.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto varying = [&](std::size_t i) {
    return std::ranges::count_if(of.uses[i], [](const Sharing::Use& use) { return !use.number; });
  };
  std::ranges::stable_sort(order, std::ranges::greater{}, varying);
  std::vector<Sheet> out;
  for (const std::size_t i : order) {
    if (!materials[i].facts.reached) continue;
    for (const Sharing::Use& use : of.uses[i]) {
      if (use.number || of.shared[use.index].sheet) continue;
      auto at = std::ranges::find_if(
          out, [&](const Sheet& sheet) { return fits(sheet, use.index, of, materials); });
      if (at == out.end()) at = out.insert(at, Sheet{});
      (*at)[of.shared[use.index].part] = use.index;
      of.shared[use.index].sheet = static_cast<std::size_t>(at - out.begin());
    }
  }
  return out;
}

constexpr bool is_alpha(std::size_t part) {
  return part == alpha_part;
}

// The material that lends each part to a sheet; null: none.
using Lenders = std::array<const PackInput*, part_count>;

template <class Value, class Load>
PairOf<Value> joined_parts(const Lenders& lenders, int width, int height, Value full, const Load& load) {
  PairOf<Value> out{Pixels<Value>(width, height, 4), Pixels<Value>(width, height, 4)};
  for (std::size_t i = 3; i < out.diffuse_alpha.values.size(); i += 4) out.diffuse_alpha.values[i] = full;
  for (auto lender = lenders.begin(); lender != lenders.end(); ++lender) {
    if (*lender == nullptr || std::find(lenders.begin(), lender, *lender) != lender) continue;
    const PairOf<Value> from = load(**lender);
    for (std::size_t p = 0; p < part_count; ++p) {
      if (lenders[p] != *lender) continue;
      const Texture texture = both_textures[p / 2];
      const std::size_t first = channel_parts[p].first % 4;
      for (std::size_t i = first; i < out.of(texture).values.size(); i += 4)
        std::copy_n(from.of(texture).values.begin() + static_cast<std::ptrdiff_t>(i), channel_parts[p].size,
                    out.of(texture).values.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  return out;
}

// Reads the planes of the lenders as they lie in their files, so that the sheet can be read in strips.
void set_planes(const Lenders& lenders, PackInput& to) {
  for (std::size_t p = 0; p < part_count; ++p) {
    const bool color = p % 2 == 0;
    PlaneSource& plane = color ? to.color[p / 2] : to.grey[p / 2];
    plane.color = color;
    if (!color) plane.pick = {0, 0, 0};
    plane.constant.fill(is_alpha(p) ? 255 : 0);
    plane.exact.fill(is_alpha(p) ? 1 : 0);
    if (lenders[p] != nullptr) plane = color ? lenders[p]->color[p / 2] : lenders[p]->grey[p / 2];
    to.streamed = to.streamed && (lenders[p] == nullptr || lenders[p]->streamed);
  }
}

bool same_normals(const std::vector<std::size_t>& users, const std::vector<PackInput>& materials) {
  const PackInput& first = materials[users[0]];
  return std::ranges::all_of(users, [&](std::size_t i) {
    return i == users[0] || (materials[i].normal.path == first.normal.path && !materials[i].load_normals &&
                             !first.load_normals);
  });
}

PackInput sheet_input(const Sheet& sheet, const Sharing& of, const std::vector<PackInput>& materials,
                      std::vector<std::string>& remarks) {
  Lenders lenders{};
  PackInput out;
  out.facts.levels = 1, out.facts.unseen = 15;
  const PackInput* lead = nullptr;
  PixelBox& crop = out.facts.crop;
  for (std::size_t p = 0; p < part_count; ++p) {
    if (!sheet[p]) continue;
    const Shared& part = of.shared[*sheet[p]];
    lenders[p] = &materials[part.owner];
    if (lead == nullptr) lead = lenders[p], crop = lead->facts.crop;
    for (const std::size_t user : part.users) {
      const MaterialFacts& facts = materials[user].facts;
      crop = around(crop, facts.crop);
      out.facts.levels =
          facts.levels == 0 || out.facts.levels == 0 ? 0 : std::max(out.facts.levels, facts.levels);
      out.facts.unseen = std::min(out.facts.unseen, facts.unseen);
    }
  }
  out.name = out.facts.name = lead->name;
  out.width = out.facts.width = lead->width;
  out.height = out.facts.height = lead->height;
  out.wrap = lead->wrap;
  if (lenders[alpha_part] != nullptr) {
    out.alpha_mode = lenders[alpha_part]->alpha_mode;
    out.alpha_cutoff = lenders[alpha_part]->alpha_cutoff;
  }
  if (lenders[gloss_part] != nullptr) {
    if (same_normals(of.shared[*sheet[gloss_part]].users, materials)) {
      out.normal = lenders[gloss_part]->normal;
      out.load_normals = lenders[gloss_part]->load_normals;
    } else {
      remarks.push_back(
          lenders[gloss_part]->name +
          ": its gloss is shared by materials of other normal maps, which then widen none of its mips");
    }
  }
  if (std::ranges::none_of(lenders, [](const PackInput* m) { return m != nullptr && m->convert; })) {
    set_planes(lenders, out);
    return out;
  }
  out.streamed = false;
  out.convert = [lenders, width = out.width, height = out.height](std::vector<std::string>& told) {
    return joined_parts<std::uint8_t>(lenders, width, height, 255,
                                      [&](const PackInput& m) { return load_pair(m, told); });
  };
  out.convert_floats = [lenders, width = out.width, height = out.height] {
    return joined_parts<float>(lenders, width, height, 1, [](const PackInput& m) { return load_floats(m); });
  };
  return out;
}

// One texel for each number, those of the four parts above each other.
PackInput numbers_input(const std::array<std::vector<Number>, part_count>& numbers) {
  PackInput out;
  std::size_t most = 0;
  for (const auto& each : numbers) most = std::max(most, each.size());
  out.name = out.facts.name = "numbers";
  out.width = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(most))));
  out.height = (static_cast<int>(most) + out.width - 1) / out.width;
  out.facts.width = out.width, out.facts.height = out.height;
  out.facts.crop = {0, 0, out.width, out.height};
  out.facts.levels = 1;  // a number is read in the middle of its texel, where nothing shrinks it
  out.streamed = false;
  const auto pair_of = [numbers, width = out.width, height = out.height]<class Value>(Value,
                                                                                      const auto& value) {
    PairOf<Value> pair{Pixels<Value>(width, height, 4), Pixels<Value>(width, height, 4)};
    for (std::size_t p = 0; p < part_count; ++p)
      for (std::size_t i = 0; i < numbers[p].size(); ++i)
        for (std::size_t c = 0; c < channel_parts[p].size; ++c)
          pair.of(both_textures[p / 2]).values[4 * i + channel_parts[p].first % 4 + c] =
              value(numbers[p][i], c);
    return pair;
  };
  out.convert = [pair_of](std::vector<std::string>&) {
    return pair_of(std::uint8_t{}, [](const Number& n, std::size_t c) { return n.code[c]; });
  };
  out.convert_floats = [pair_of] {
    return pair_of(float{}, [](const Number& n, std::size_t c) { return static_cast<float>(n.exact[c]); });
  };
  return out;
}

std::optional<PagesApart> pages_apart(PackOptions options, const PackSource& source) {
  options.output.goal = PackGoal::gpu;
  FoundResolutions found;
  try {
    const PackDecision way = std::move(decide(options, source, nullptr, found).front());
    PagesApart out{way.plan.pages.size(), 0, 0};
    for (const PlannedPage& page : way.plan.pages)
      for (const Texture texture : both_textures)
        if (page.has[index_of(texture)]) out.gpu += texture_bytes({page.width, page.height, 4}, true);
    for (std::size_t i = 0; i < way.left_out.fates.size(); ++i)
      out.without_texels += source.inputs.materials[i].facts.reached && !way.left_out.fates[i].texels ? 1 : 0;
    return out;
  } catch (const Error&) {
    return std::nullopt;  // there are such pages for no size that was asked for
  }
}

// What numbers and sharing take away, and the account of the materials as they were read.
void tell_account(const Sharing& of, OnePage& to) {
  LeaveOutLine numbers{"constant", "", 0, 0, 0, 0, 0, {}}, equal{"equal", "", 0, 0, 0, 0, 0, {}};
  for (std::size_t i = 0; i < to.materials.size(); ++i) {
    const PackInput& m = to.materials[i];
    const auto texels = static_cast<std::uint64_t>(m.width) * static_cast<std::uint64_t>(m.height);
    to.before.texels += 2 * texels;
    to.before.channel_texels += channel_count * texels;
    if (!m.facts.reached) continue;
    std::array<std::string, 2> found;
    for (std::size_t p = 0; p < part_count; ++p) {
      const Sharing::Use& use = of.uses[i][p];
      if (!use.number && of.shared[use.index].owner == i) continue;
      (use.number ? numbers : equal).channel_texels += channel_parts[p].size * texels;
      std::string& names = found[use.number ? 0 : 1];
      names += (names.empty() ? m.name + " (" : " ") + std::string(channel_parts[p].name);
    }
    if (!found[0].empty()) numbers.parts.push_back(found[0] + ")");
    if (!found[1].empty()) equal.parts.push_back(found[1] + ")");
  }
  for (LeaveOutLine* line : {&numbers, &equal}) {
    line->materials = line->parts.size();
    line->detail = joined(line->parts, ", ");
    if (line->materials > 0) to.lines.push_back(std::move(*line));
  }
}

}  // namespace

std::shared_ptr<const OnePage> share_parts(const PackOptions& options, PackSource& source,
                                           PackResult& result) {
  const auto out = std::make_shared<OnePage>();
  std::vector<PackInput>& materials = source.inputs.materials;
  for (const PackInput& m : materials)
    if (m.facts.reached && m.own_page)
      throw Error::at(m.name, "it tiles over its surface, which no part of a page can do",
                      "another " + setting("goal") + " than one-page");
  const bool floats = writes_floats(options.output.write);
  std::vector<PartHashes> hashes(materials.size());
  parallel_chunks(materials.size(), options.run.threads, 1, [&](std::size_t begin, std::size_t, unsigned) {
    if (materials[begin].facts.reached) hashes[begin] = looked_at(materials[begin], floats);
  });
  result.apart = pages_apart(options, source);
  out->materials = std::move(materials);
  Sharing sharing = find_sharing(out->materials, hashes, options.leave_out);
  const std::vector<Sheet> sheets = sheets_of(sharing, out->materials);
  materials.clear();
  for (const Sheet& sheet : sheets)
    materials.push_back(sheet_input(sheet, sharing, out->materials, result.remarks));
  if (std::ranges::any_of(sharing.numbers, [](const auto& each) { return !each.empty(); }))
    materials.push_back(numbers_input(sharing.numbers));
  // Sheets need all of their texels, whatever these hold: nothing more is to be found out.
  for (PackInput& sheet : materials) {
    sheet.facts.learned = true;
    sheet.facts.range.least.fill(0);
    sheet.facts.range.most.fill(255);
    sheet.facts.range.grey = false;
  }
  for (std::size_t s = 0; s < materials.size(); ++s) {
    std::size_t& held = out->channels.emplace_back(0);
    for (std::size_t p = 0; p < part_count; ++p)
      if (s < sheets.size() ? sheets[s][p].has_value() : !sharing.numbers[p].empty())
        held += channel_parts[p].size;
  }
  out->places.resize(out->materials.size());
  for (std::size_t i = 0; i < out->materials.size(); ++i)
    for (std::size_t p = 0; p < part_count && out->materials[i].facts.reached; ++p) {
      const Sharing::Use& use = sharing.uses[i][p];
      if (use.number)
        out->places[i][p] = {sheets.size(), static_cast<int>(use.index)};
      else
        out->places[i][p] = {*sharing.shared[use.index].sheet, std::nullopt};
    }
  tell_account(sharing, *out);
  return out;
}

}  // namespace etak
