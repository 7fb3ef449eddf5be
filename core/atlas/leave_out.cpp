// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/leave_out.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "core/base/error.h"

namespace etak {
namespace {

std::uint64_t area(const PixelBox& box) {
  return static_cast<std::uint64_t>(box.width) * static_cast<std::uint64_t>(box.height);
}

PixelBox whole(const MaterialFacts& m) {
  return {0, 0, m.width, m.height};
}

PixelBox around(const PixelBox& a, const PixelBox& b) {
  const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

std::uint64_t area(const std::vector<PixelBox>& boxes) {
  std::uint64_t sum = 0;
  for (const PixelBox& box : boxes) sum += area(box);
  return sum;
}

// The materials while one step after the other takes things away.
class Steps {
 public:
  Steps(const std::vector<MaterialFacts>& materials, const LeaveOutOptions& options)
      : materials_(materials), options_(options), channels_(materials.size()) {
    out_.fates.resize(materials.size());
    for (std::size_t i = 0; i < materials.size(); ++i) {
      out_.fates[i].owner = i;
      out_.fates[i].boxes = {whole(materials[i])};
      channels_[i].fill(true);
    }
    list_users();
    out_.before = out_.after = account();
  }

  LeaveOut run() {
    step("unreached", [&](std::size_t i) { return unreached(i); });
    equal();
    step("alpha", [&](std::size_t i) { return drop_alpha(i); });
    step("constant", [&](std::size_t i) { return drop_constant(i); });
    step("grey", [&](std::size_t i) { return one_number(i); });
    step("crop", [&](std::size_t i) { return crop(i); });
    if (options_.islands) step("islands", [&](std::size_t i) { return split(i); });
    for (std::size_t i = 0; i < materials_.size(); ++i)
      out_.fates[i].channels =
          static_cast<std::size_t>(std::count(channels_[i].begin(), channels_[i].end(), true));
    return std::move(out_);
  }

 private:
  TexelAccount account() const {
    TexelAccount sum;
    for (std::size_t i = 0; i < materials_.size(); ++i) {
      const MaterialFate& fate = out_.fates[i];
      if (!fate.texels || fate.owner != i) continue;
      const std::uint64_t texels = area(fate.boxes);
      sum.texels += 2 * texels;
      sum.channel_texels +=
          texels * static_cast<std::uint64_t>(std::count(channels_[i].begin(), channels_[i].end(), true));
    }
    return sum;
  }

  void record(const char* what, std::size_t touched, const std::string& detail) {
    const TexelAccount now = account();
    if (touched > 0)
      out_.lines.push_back({what, detail, touched, out_.after.texels - now.texels,
                            out_.after.channel_texels - now.channel_texels,
                            4 * (out_.after.texels - now.texels), 0});
    out_.after = now;
  }

  template <class Act>
  void step(const char* what, Act act) {
    if (!options_.leaves(what)) return;
    std::size_t touched = 0;
    std::string names;
    for (std::size_t i = 0; i < materials_.size(); ++i)
      if (out_.fates[i].texels && act(i)) {
        if (touched < 3) names += (touched == 0 ? "" : ", ") + materials_[i].name;
        ++touched;
      }
    if (touched > 3) names += ", ...";
    record(what, touched, names);
  }

  bool unreached(std::size_t i) {
    if (materials_[i].reached) return false;
    out_.fates[i].texels = false;
    return true;
  }

  // What of a material's texels matters: colour, alpha, and F0 with gloss.
  enum Part { color_part, alpha_part, specular_part, part_count };
  using Parts = std::array<bool, part_count>;

  bool varies(const MaterialFacts& m, std::size_t first, std::size_t count) const {
    if (!options_.leaves("constant")) return true;
    for (std::size_t c = first; c < first + count; ++c)
      if (!m.range.constant(c)) return true;
    return false;
  }

  // A part that is one number over the texels in use is not read from them.
  Parts parts_read(const MaterialFacts& m) const {
    if (!m.learned) return {true, !m.opaque, true};
    const bool alpha = !m.opaque && varies(m, alpha_channel, 1);
    const bool alpha_in_color = m.alpha_hash == std::array<std::uint64_t, 2>{};
    return {varies(m, 0, 3) || (alpha && alpha_in_color), alpha, varies(m, specular_channel, 4)};
  }

  // The size of a material and what its texels hold in some parts. A material finds all that it reads in the
  // texels of another when both have the same key of the parts that it reads.
  using Hash = std::array<std::uint64_t, 2>;
  using TexelKey = std::tuple<Parts, int, int, Hash, Hash, Hash>;
  static TexelKey key_of(const MaterialFacts& m, const Parts& parts) {
    const auto hash = [&](Part part, const Hash& value) { return parts[part] ? value : Hash{}; };
    return {parts,
            m.width,
            m.height,
            hash(color_part, m.color_hash),
            hash(alpha_part, m.alpha_hash),
            hash(specular_part, m.specular_hash)};
  }

  // One that reads another texture than its owner must not make more of that be kept than it saves.
  bool is_worth_it(std::size_t user, std::size_t with) const {
    Parts read_by_either{};
    for (std::size_t p = 0; p < part_count; ++p) read_by_either[p] = reads_[user][p] || reads_[with][p];
    const auto textures = [](const Parts& reads) {
      return std::uint64_t{reads[color_part] || reads[alpha_part]} + std::uint64_t{reads[specular_part]};
    };
    const auto of_user = textures(reads_[user]), of_owner = textures(reads_[with]);
    if (of_user == textures(read_by_either) && of_owner == textures(read_by_either)) return true;
    const auto box = [&](std::size_t i) {
      return options_.leaves("crop") ? materials_[i].crop : whole(materials_[i]);
    };
    return area(around(box(user), box(with))) * textures(read_by_either) <=
           area(box(user)) * of_user + area(box(with)) * of_owner;
  }

  void equal() {
    if (!options_.leaves("equal")) return;
    std::vector<std::size_t> order;
    for (const MaterialFacts& m : materials_) reads_.push_back(parts_read(m));
    for (std::size_t i = 0; i < materials_.size(); ++i)
      if (out_.fates[i].texels) order.push_back(i);
    // Those that read most first: the others can use theirs.
    const auto parts = [&](std::size_t i) { return std::count(reads_[i].begin(), reads_[i].end(), true); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return parts(a) > parts(b); });
    // Owners by their keys of all parts that some material reads, in the order in which they became such.
    const std::set<Parts> kinds(reads_.begin(), reads_.end());
    std::map<TexelKey, std::vector<std::size_t>> by_texels;
    std::map<std::string, std::size_t> by_source;
    std::vector<std::size_t> shared;
    for (const std::size_t i : order) {
      const MaterialFacts& m = materials_[i];
      if (!m.learned) {
        out_.fates[i].owner = by_source.try_emplace(m.source, i).first->second;
      } else if (parts(i) > 0) {  // else it has no texels anyway
        const std::vector<std::size_t>& owners = by_texels[key_of(m, reads_[i])];
        const auto owner =
            std::find_if(owners.begin(), owners.end(), [&](std::size_t o) { return is_worth_it(i, o); });
        if (owner != owners.end())
          out_.fates[i].owner = *owner;
        else
          for (const Parts& kind : kinds) by_texels[key_of(m, kind)].push_back(i);
      }
      if (out_.fates[i].owner != i) shared.push_back(i);
    }
    list_users();
    std::sort(shared.begin(), shared.end());
    std::string names;
    for (std::size_t k = 0; k < std::min<std::size_t>(3, shared.size()); ++k)
      names += (k == 0 ? "" : ", ") + materials_[shared[k]].name + " = " +
               materials_[out_.fates[shared[k]].owner].name;
    if (shared.size() > 3) names += ", ...";
    record("equal", shared.size(), names);
  }

  void list_users() {
    users_.assign(materials_.size(), {});
    for (std::size_t j = 0; j < materials_.size(); ++j) users_[out_.fates[j].owner].push_back(j);
  }

  // Those that use texels of `i`, itself among them.
  template <class Act>
  void users(std::size_t i, Act act) const {
    for (const std::size_t j : users_[i])
      if (out_.fates[j].texels) act(j);
  }

  bool is_owner(std::size_t i) const { return out_.fates[i].owner == i; }

  bool drop_alpha(std::size_t i) {
    if (!materials_[i].opaque) return false;
    out_.fates[i].constant[alpha_channel] = 255;
    bool needed = false;
    users(out_.fates[i].owner, [&](std::size_t j) { needed = needed || !materials_[j].opaque; });
    if (!is_owner(i) || needed) return false;
    channels_[i][alpha_channel] = false;
    return true;
  }

  bool drop_constant(std::size_t i) {
    const MaterialFacts& m = materials_[i];
    if (!m.learned) return false;
    MaterialFate& fate = out_.fates[i];
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
      leave(i);
      return true;
    }
    if (is_owner(i))
      for (std::size_t c = 0; c < channel_count; ++c) {
        bool varies = false;
        users(i, [&](std::size_t j) {
          const bool alpha_unused = c == alpha_channel && materials_[j].opaque;
          varies = varies || (!alpha_unused && !materials_[j].range.constant(c));
        });
        channels_[i][c] = channels_[i][c] && varies;
      }
    return any;
  }

  // F0 that varies, but not in its colour.
  bool one_number(std::size_t i) {
    const auto varies = [](const MaterialFacts& m) {
      return !m.range.constant(specular_channel) || !m.range.constant(specular_channel + 1) ||
             !m.range.constant(specular_channel + 2);
    };
    const MaterialFacts& m = materials_[i];
    if (!m.learned || !m.range.grey || !varies(m)) return false;
    out_.fates[i].grey = true;
    if (!is_owner(i)) return true;
    bool all = true;
    users(i, [&](std::size_t j) { all = all && materials_[j].learned && materials_[j].range.grey; });
    if (all) channels_[i][specular_channel + 1] = channels_[i][specular_channel + 2] = false;
    return true;
  }

  // A material that needs no texels; others that used its texels get the first of them as their owner.
  void leave(std::size_t i) {
    MaterialFate& fate = out_.fates[i];
    fate.texels = false;
    if (!is_owner(i)) return;
    std::size_t heir = materials_.size();
    users(i, [&](std::size_t j) { heir = std::min(heir, j); });
    if (heir == materials_.size()) return;
    users(i, [&](std::size_t j) { out_.fates[j].owner = heir; });
    users_[heir] = std::move(users_[i]);
    users_[i].clear();
    channels_[heir] = channels_[i];
  }

  bool crop(std::size_t i) {
    if (!is_owner(i)) return false;
    PixelBox box{0, 0, 0, 0};
    users(i, [&](std::size_t j) {
      box = box.width == 0 ? materials_[j].crop : around(box, materials_[j].crop);
    });
    if (box == whole(materials_[i])) return false;
    out_.fates[i].boxes = {box};
    return true;
  }

  bool split(std::size_t i) {
    if (!is_owner(i)) return false;
    std::vector<PixelBox> boxes;
    users(i, [&](std::size_t j) {
      const MaterialFacts& m = materials_[j];
      if (m.islands.empty())
        boxes.push_back(m.crop);
      else
        boxes.insert(boxes.end(), m.islands.begin(), m.islands.end());
    });
    const auto order = [](const PixelBox& a, const PixelBox& b) {
      return std::tie(a.y, a.x, a.width, a.height) < std::tie(b.y, b.x, b.width, b.height);
    };
    std::sort(boxes.begin(), boxes.end(), order);
    boxes.erase(std::unique(boxes.begin(), boxes.end()), boxes.end());
    // Boxes may overlap: what two materials use of one picture may even be more than the box around both.
    if (area(boxes) >= area(out_.fates[i].boxes)) return false;
    out_.fates[i].boxes = std::move(boxes);
    return true;
  }

  const std::vector<MaterialFacts>& materials_;
  const LeaveOutOptions& options_;
  std::vector<std::array<bool, channel_count>> channels_;  // of owners: what their region holds
  std::vector<Parts> reads_;
  std::vector<std::vector<std::size_t>> users_;  // by owner, rising; some may need no texels any more
  LeaveOut out_;
};

}  // namespace

LeaveOut leave_out(const std::vector<MaterialFacts>& materials, const LeaveOutOptions& options) {
  return Steps(materials, options).run();
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
      throw Error::at("--keep", printable(each), list + "all");
    }
    out.insert(each);
  }
  return out;
}

}  // namespace etak
