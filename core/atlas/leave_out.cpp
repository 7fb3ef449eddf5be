// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/leave_out.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "core/atlas/plan.h"
#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"

namespace etak {
namespace {

PixelBox whole(const MaterialFacts& m) {
  return {0, 0, m.width, m.height};
}

std::uint64_t area(const std::vector<PicturePart>& parts) {
  std::uint64_t sum = 0;
  for (const PicturePart& part : parts) sum += part.area();
  return sum;
}

// What is left of the materials while one step after the other takes things away.
struct Remaining {
  const std::vector<MaterialFacts>& materials;
  const LeaveOutOptions& options;
  LeaveOut out{};
  std::vector<std::array<bool, channel_count>> channels{};  // of owners: what their region holds
  std::vector<std::vector<std::size_t>> users{};  // by owner, rising; some may need no texels any more
  bool one_owner = false;                         // no other material has texels of its own
};

TexelAccount account(const Remaining& left) {
  TexelAccount sum;
  for (std::size_t i = 0; i < left.materials.size(); ++i) {
    const MaterialFate& fate = left.out.fates[i];
    if (!fate.texels || fate.owner != i) continue;
    const std::uint64_t texels = area(fate.kept);
    sum.texels += 2 * texels;
    sum.channel_texels += texels * static_cast<std::uint64_t>(
                                       std::count(left.channels[i].begin(), left.channels[i].end(), true));
  }
  return sum;
}

//   touched   the materials from which something was taken, as the report names them
void record(Remaining& left, const char* what, std::vector<std::string> touched) {
  const TexelAccount now = account(left);
  if (!touched.empty())
    left.out.lines.push_back({what, joined(touched, ", "), touched.size(), left.out.after.texels - now.texels,
                              left.out.after.channel_texels - now.channel_texels,
                              4 * (left.out.after.texels - now.texels), 0, std::move(touched)});
  left.out.after = now;
}

// Calls `act` for every material that has texels; `act` tells whether it took something from the material.
void step(Remaining& left, const char* what, bool (*act)(Remaining&, std::size_t)) {
  if (!left.options.leaves(what)) return;
  std::vector<std::string> touched;
  for (std::size_t i = 0; i < left.materials.size(); ++i)
    if (left.out.fates[i].texels && act(left, i)) touched.push_back(left.materials[i].name);
  record(left, what, std::move(touched));
}

void list_users(Remaining& left) {
  left.users.assign(left.materials.size(), {});
  for (std::size_t j = 0; j < left.materials.size(); ++j) left.users[left.out.fates[j].owner].push_back(j);
}

Remaining everything(const std::vector<MaterialFacts>& materials, const LeaveOutOptions& options) {
  Remaining left{materials, options};
  left.out.fates.resize(materials.size());
  left.channels.resize(materials.size());
  for (std::size_t i = 0; i < materials.size(); ++i) {
    left.out.fates[i].owner = i;
    left.out.fates[i].kept = {{whole(materials[i])}};
    left.channels[i].fill(true);
  }
  list_users(left);
  left.out.before = left.out.after = account(left);
  return left;
}

bool unreached(Remaining& left, std::size_t i) {
  if (left.materials[i].reached) return false;
  left.out.fates[i].texels = false;
  return true;
}

// The parts of a material's texels that matter: colour, alpha, and F0 with gloss.
enum Part { color_part, alpha_part, specular_part, part_count };
using Parts = std::array<bool, part_count>;

bool any_varies(const MaterialFacts& m, std::size_t first, std::size_t count) {
  for (std::size_t c = first; c < first + count; ++c)
    if (!m.range.constant(c)) return true;
  return false;
}

// A part that is one number over the texels in use is not read from them.
Parts parts_read(const MaterialFacts& m, bool leave_constant) {
  if (!m.learned) return {true, !m.opaque, true};
  const bool alpha = !m.opaque && (!leave_constant || any_varies(m, alpha_channel, 1));
  const bool alpha_in_color = m.alpha_hash == std::array<std::uint64_t, 2>{};
  return {!leave_constant || any_varies(m, 0, 3) || (alpha && alpha_in_color), alpha,
          !leave_constant || any_varies(m, specular_channel, 4)};
}

// The size of a material and what its texels hold in some parts. A material finds all that it reads in the
// texels of another when both have the same key of the parts that it reads.
using Hash = std::array<std::uint64_t, 2>;
using TexelKey = std::tuple<Parts, int, int, Hash, Hash, Hash>;
TexelKey key_of(const MaterialFacts& m, const Parts& parts) {
  const auto hash = [&](Part part, const Hash& value) { return parts[part] ? value : Hash{}; };
  return {parts,
          m.width,
          m.height,
          hash(color_part, m.color_hash),
          hash(alpha_part, m.alpha_hash),
          hash(specular_part, m.specular_hash)};
}

// Whether a material may use the texels of `with`. Where the two read different textures, both textures must
// be kept over the boxes of both: that must not be more than the two take apart.
bool is_worth_it(const Remaining& left, const std::vector<Parts>& read, std::size_t user, std::size_t with) {
  Parts read_by_either{};
  for (std::size_t p = 0; p < part_count; ++p) read_by_either[p] = read[user][p] || read[with][p];
  const auto textures = [](const Parts& reads) {
    return std::uint64_t{reads[color_part] || reads[alpha_part]} + std::uint64_t{reads[specular_part]};
  };
  const auto of_user = textures(read[user]), of_owner = textures(read[with]);
  if (of_user == textures(read_by_either) && of_owner == textures(read_by_either)) return true;
  const auto box = [&](std::size_t i) {
    return left.options.leaves("crop") ? left.materials[i].crop : whole(left.materials[i]);
  };
  return around(box(user), box(with)).area() * textures(read_by_either) <=
         box(user).area() * of_user + box(with).area() * of_owner;
}

void share_equal(Remaining& left) {
  if (!left.options.leaves("equal")) return;
  std::vector<Parts> read;
  std::vector<std::size_t> order;
  for (const MaterialFacts& m : left.materials)
    read.push_back(parts_read(m, left.options.leaves("constant")));
  for (std::size_t i = 0; i < left.materials.size(); ++i)
    if (left.out.fates[i].texels) order.push_back(i);
  // Materials that read most parts come first, because the others can use their texels.
  const auto parts = [&](std::size_t i) { return std::count(read[i].begin(), read[i].end(), true); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return parts(a) > parts(b); });
  // Owners by the keys of all parts that some material reads, in the order in which they became owners.
  const std::set<Parts> kinds(read.begin(), read.end());
  std::map<TexelKey, std::vector<std::size_t>> by_texels;
  std::map<std::string, std::size_t> by_source;
  std::vector<std::size_t> shared;
  for (const std::size_t i : order) {
    const MaterialFacts& m = left.materials[i];
    if (!m.learned) {
      left.out.fates[i].owner = by_source.try_emplace(m.source, i).first->second;
    } else if (parts(i) > 0) {  // else it has no texels anyway
      const std::vector<std::size_t>& owners = by_texels[key_of(m, read[i])];
      const auto owner = std::find_if(owners.begin(), owners.end(),
                                      [&](std::size_t o) { return is_worth_it(left, read, i, o); });
      if (owner != owners.end())
        left.out.fates[i].owner = *owner;
      else
        for (const Parts& kind : kinds) by_texels[key_of(m, kind)].push_back(i);
    }
    if (left.out.fates[i].owner != i) shared.push_back(i);
  }
  list_users(left);
  std::sort(shared.begin(), shared.end());
  std::vector<std::string> names;
  for (const std::size_t i : shared)
    names.push_back(left.materials[i].name + " = " + left.materials[left.out.fates[i].owner].name);
  record(left, "equal", std::move(names));
}

// Calls `act` for every material that uses texels of material `i`, which may be one of them.
template <class Act>
void users(const Remaining& left, std::size_t i, Act act) {
  for (const std::size_t j : left.users[i])
    if (left.out.fates[j].texels) act(j);
}

bool is_owner(const Remaining& left, std::size_t i) {
  return left.out.fates[i].owner == i;
}

bool drop_alpha(Remaining& left, std::size_t i) {
  if (!left.materials[i].opaque) return false;
  left.out.fates[i].constant[alpha_channel] = 255;
  bool needed = false;
  users(left, left.out.fates[i].owner, [&](std::size_t j) { needed = needed || !left.materials[j].opaque; });
  if (!is_owner(left, i) || needed) return false;
  left.channels[i][alpha_channel] = false;
  return true;
}

// Takes all texels from a material. Where others use its texels, the first of these becomes their owner.
void leave(Remaining& left, std::size_t i) {
  MaterialFate& fate = left.out.fates[i];
  fate.texels = false;
  if (!is_owner(left, i)) return;
  std::size_t heir = left.materials.size();
  users(left, i, [&](std::size_t j) { heir = std::min(heir, j); });
  if (heir == left.materials.size()) return;
  users(left, i, [&](std::size_t j) { left.out.fates[j].owner = heir; });
  left.users[heir] = std::move(left.users[i]);
  left.users[i].clear();
  left.channels[heir] = left.channels[i];
}

bool drop_constant(Remaining& left, std::size_t i) {
  const MaterialFacts& m = left.materials[i];
  if (!m.learned) return false;
  MaterialFate& fate = left.out.fates[i];
  bool any = false;
  for (const Texture texture : both_textures) {
    bool varies = false;
    for (std::size_t c = first_channel(texture); c < first_channel(texture) + 4; ++c) {
      if (fate.constant[c]) continue;
      if (m.range.constant(c))
        fate.constant[c] = m.range.most[c], any = true;
      else
        varies = true;
    }
    fate.varies[static_cast<std::size_t>(texture)] = varies;
  }
  if (!fate.varies[0] && !fate.varies[1]) {
    leave(left, i);
    return true;
  }
  if (is_owner(left, i))
    for (std::size_t c = 0; c < channel_count; ++c) {
      bool varies = false;
      users(left, i, [&](std::size_t j) {
        const bool alpha_unused = c == alpha_channel && left.materials[j].opaque;
        varies = varies || (!alpha_unused && !left.materials[j].range.constant(c));
      });
      left.channels[i][c] = left.channels[i][c] && varies;
    }
  return any;
}

// F0 that varies, but not in its colour.
bool one_number(Remaining& left, std::size_t i) {
  const MaterialFacts& m = left.materials[i];
  if (!m.learned || !m.range.grey || !any_varies(m, specular_channel, 3)) return false;
  left.out.fates[i].grey = true;
  if (!is_owner(left, i)) return true;
  bool all = true;
  users(left, i,
        [&](std::size_t j) { all = all && left.materials[j].learned && left.materials[j].range.grey; });
  if (all) left.channels[i][specular_channel + 1] = left.channels[i][specular_channel + 2] = false;
  return true;
}

// The mips of a region of the material's texels at most.
int levels_read(const Remaining& left, std::size_t i) {
  int read = 1;
  users(left, i, [&](std::size_t j) {
    const int levels = left.materials[j].levels;
    read = read == 0 || levels == 0 ? 0 : std::max(read, levels);
  });
  if (!left.options.leaves("mips")) read = 0;
  return levels_wanted(left.options.levels, read);
}

// What decides how many mips a region keeps clean.
//   alone   the only region of all, which needs no gutter and has as many mips clean as its sides
struct RegionMips {
  int wanted;
  std::optional<int> gutter;
  bool alone;
};

// The box grown outwards to whole texels of every mip that its region keeps clean. A box of odd sides would
// shift its mips by half a texel a level against those of the picture.
PixelBox in_whole_mips(PixelBox box, const MaterialFacts& m, const RegionMips& mips) {
  for (PixelBox before{}; !(box == before);) {
    before = box;
    int clean = clean_levels(box.width, box.height, mips.wanted, mips.gutter);
    if (mips.alone)
      clean = std::max(clean, std::min(mips.wanted, default_clean_levels(2 * box.width, 2 * box.height)));
    const int step = 1 << (clean - 1);
    const auto grown = [step](int& from, int& size, int most) {
      const int end = std::min(most, (from + size + step - 1) / step * step);
      from = from / step * step;
      size = end - from;
    };
    grown(box.x, box.width, m.width);
    grown(box.y, box.height, m.height);
  }
  return box;
}

bool has_one_owner(const Remaining& left) {
  std::size_t owners = 0;
  for (std::size_t i = 0; i < left.materials.size(); ++i)
    owners += left.out.fates[i].texels && is_owner(left, i) ? 1 : 0;
  return owners == 1;
}

bool crop(Remaining& left, std::size_t i) {
  if (!is_owner(left, i)) return false;
  PixelBox box{0, 0, 0, 0};
  users(left, i, [&](std::size_t j) {
    box = box.width == 0 ? left.materials[j].crop : around(box, left.materials[j].crop);
  });
  box = in_whole_mips(box, left.materials[i], {levels_read(left, i), left.options.gutter, left.one_owner});
  if (box == whole(left.materials[i])) return false;
  left.out.fates[i].kept = {{box}};
  return true;
}

bool split(Remaining& left, std::size_t i) {
  if (!is_owner(left, i)) return false;
  std::vector<PicturePart> parts;
  users(left, i, [&](std::size_t j) {
    const MaterialFacts& m = left.materials[j];
    if (left.options.outlines && !m.outlines.empty())
      parts.insert(parts.end(), m.outlines.begin(), m.outlines.end());
    else if (m.islands.empty())
      parts.push_back({m.crop});
    else
      for (const PixelBox& box : m.islands) parts.push_back({box});
  });
  const auto order = [](const PicturePart& a, const PicturePart& b) {
    return std::tie(a.box.y, a.box.x, a.box.width, a.box.height) <
           std::tie(b.box.y, b.box.x, b.box.width, b.box.height);
  };
  const RegionMips mips{levels_read(left, i), left.options.gutter, parts.size() == 1 && left.one_owner};
  for (PicturePart& part : parts) part.box = in_whole_mips(part.box, left.materials[i], mips);
  std::stable_sort(parts.begin(), parts.end(), order);
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  // Boxes may overlap: what two materials use of one picture may even be more than the box around both.
  if (area(parts) >= area(left.out.fates[i].kept)) return false;
  left.out.fates[i].kept = std::move(parts);
  return true;
}

}  // namespace

LeaveOut leave_out(const std::vector<MaterialFacts>& materials, const LeaveOutOptions& options) {
  Remaining left = everything(materials, options);
  step(left, "unreached", unreached);
  share_equal(left);
  step(left, "alpha", drop_alpha);
  step(left, "constant", drop_constant);
  step(left, "grey", one_number);
  left.one_owner = has_one_owner(left);
  step(left, "crop", crop);
  if (options.islands) step(left, "islands", split);
  for (std::size_t i = 0; i < materials.size(); ++i)
    left.out.fates[i].channels =
        static_cast<std::size_t>(std::count(left.channels[i].begin(), left.channels[i].end(), true));
  return std::move(left.out);
}

std::set<std::string> parse_keep(const std::vector<std::string>& names) {
  std::set<std::string> out;
  for (const std::string& each : names) {
    if (each == "all") {
      out.insert(leave_out_names.begin(), leave_out_names.end());
      continue;
    }
    if (std::find(leave_out_names.begin(), leave_out_names.end(), each) == leave_out_names.end()) {
      std::string list;
      for (const std::string_view one : leave_out_names) list += std::string(one) + ", ";
      throw Error::at(setting("keep"), printable(each), list + "all");
    }
    out.insert(each);
  }
  return out;
}

}  // namespace etak
