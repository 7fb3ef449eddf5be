// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/leave_out.h"

#include <algorithm>
#include <map>
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

  void equal() {
    if (!options_.leaves("equal")) return;
    // Materials that need alpha first: the opaque ones can use theirs.
    using Key = std::tuple<int, int, std::array<std::uint64_t, 2>, std::array<std::uint64_t, 2>>;
    std::map<Key, std::vector<std::size_t>> owners;
    std::map<std::string, std::size_t> by_source;
    std::size_t touched = 0;
    std::string names;
    for (const bool opaque : {false, true})
      for (std::size_t i = 0; i < materials_.size(); ++i) {
        const MaterialFacts& m = materials_[i];
        if (m.opaque != opaque || !out_.fates[i].texels) continue;
        const std::size_t owner =
            m.learned ? equal_pixels(i, owners) : by_source.try_emplace(m.source, i).first->second;
        if (owner == i) continue;
        out_.fates[i].owner = owner;
        if (touched < 3) names += (touched == 0 ? "" : ", ") + m.name + " = " + materials_[owner].name;
        ++touched;
      }
    if (touched > 3) names += ", ...";
    record("equal", touched, names);
  }

  template <class Owners>
  std::size_t equal_pixels(std::size_t i, Owners& owners) {
    const MaterialFacts& m = materials_[i];
    auto& list = owners[{m.width, m.height, m.color_hash, m.specular_hash}];
    for (const std::size_t owner : list)
      if (m.opaque || materials_[owner].alpha_hash == m.alpha_hash) return owner;
    list.push_back(i);
    return i;
  }

  // Those that use texels of `i`, itself among them.
  template <class Act>
  void users(std::size_t i, Act act) const {
    for (std::size_t j = 0; j < materials_.size(); ++j)
      if (out_.fates[j].texels && out_.fates[j].owner == i) act(j);
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
