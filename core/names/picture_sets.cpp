// SPDX-License-Identifier: Apache-2.0
#include "core/names/picture_sets.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "core/base/text/ascii.h"
#include "core/image/load.h"
#include "core/image/picture_endings.h"

namespace etak {
namespace {

bool is_color(FileRole role) {
  return role == FileRole::base_color || role == FileRole::diffuse_alpha;
}

// Whether pictures of this role are judged together with a colour.
bool is_part(FileRole role) {
  return role == FileRole::specular_gloss || traits(role).data;
}

// Whether the roles may be taken from names that are no proof alone. They need a picture of another role
// whose name is one, or a colour and a part together. Single letters of Unreal's names also number things (a,
// b, c), so that a colour and a part by letters alone need a third role or a longer word besides.
bool unsure_agree(std::span<const NamedPicture> same) {
  bool color = false, part = false, words = false;
  bool proof = false;
  std::set<FileRole> roles, judged;
  for (const NamedPicture& picture : same) {
    const ParsedName& name = picture.name;
    const bool letters = !name.sure && name.convention == Convention::unreal;
    color = color || is_color(name.role);
    part = part || is_part(name.role);
    words = words || (!letters && (is_color(name.role) || is_part(name.role)));
    roles.insert(name.role);
    if (!is_judged(name.role)) continue;
    judged.insert(name.role);
    proof = proof || name.sure;
  }
  return (proof && judged.size() > 1) || (color && part && (words || roles.size() >= 3));
}

class SetMaker {
 public:
  explicit SetMaker(std::vector<NamedPicture*> same) : left_(std::move(same)) {}

  std::vector<PictureSet> run() {
    settle_roles();
    PictureSet maps = take_maps();
    take_f0();
    const bool metal = has(FileRole::metal_rough) || has(FileRole::metallic);
    if (has(FileRole::base_color) && (metal || !has(FileRole::specular_gloss)))
      take_metal_rough();
    else if (has(FileRole::base_color))
      rename(FileRole::base_color, FileRole::diffuse_alpha);
    take_pairs();
    take_lone_parts();
    if (!maps.members.empty()) judge_together(std::move(maps));
    return std::move(sets_);
  }

 private:
  bool has(FileRole role) const {
    return std::ranges::any_of(left_, [&](const NamedPicture* p) { return p->name.role == role; });
  }

  std::size_t count(bool (*wanted)(FileRole)) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(left_, [&](const NamedPicture* p) { return wanted(p->name.role); }));
  }

  void rename(FileRole from, FileRole to) {
    for (NamedPicture* picture : left_)
      if (picture->name.role == from) picture->name.role = to;
  }

  // Takes out the first picture of a role that is left; null: none.
  NamedPicture* take(FileRole role) {
    const auto found = std::ranges::find_if(left_, [&](const auto* p) { return p->name.role == role; });
    if (found == left_.end()) return nullptr;
    NamedPicture* out = *found;
    left_.erase(found);
    return out;
  }

  void settle_roles() {
    // "Diffuse" beside metallic or roughness, and without F0, is another word for the base colour.
    const bool parts = has(FileRole::metal_rough) || has(FileRole::metallic) || has(FileRole::roughness) ||
                       has(FileRole::gloss);
    if (parts && !has(FileRole::specular_gloss) && !has(FileRole::base_color))
      rename(FileRole::diffuse_alpha, FileRole::base_color);
    for (NamedPicture* picture : left_) {
      ParsedName& name = picture->name;
      if (!name.otherwise) continue;
      if (is_color(name.role) && count(is_color) > 1) {
        name.role = *name.otherwise;
      } else if (name.role == FileRole::metallic && !has(FileRole::roughness)) {
        name.role = *name.otherwise;
        picture->note =
            "masks in an order that its name does not tell; metallic only beside a roughness file";
      }
    }
    std::erase_if(left_,
                  [](const NamedPicture* p) { return !is_judged(p->name.role) && !is_map(p->name.role); });
  }

  // Normal, occlusion and emissive maps, with height where there are normals that it can be held against.
  PictureSet take_maps() {
    PictureSet set;
    const bool has_normals = has(FileRole::normal);
    for (NamedPicture* picture : left_)
      if (is_map(picture->name.role)) {
        if (picture->name.role != FileRole::height || has_normals) set.members.push_back(picture);
      } else {
        set.beside.push_back(picture);
      }
    std::erase_if(left_, [](const NamedPicture* p) { return is_map(p->name.role); });
    std::ranges::stable_sort(set.members, {}, [](const NamedPicture* p) { return p->name.role; });
    return set;
  }

  void judge_together(PictureSet set) {
    for (NamedPicture* member : set.members)
      member->as = set.missing.empty() ? ListedAs::judged : ListedAs::lone;
    sets_.push_back(std::move(set));
  }

  void take_f0() {
    while (NamedPicture* picture = take(FileRole::f0_only)) judge_together({{picture}, {}});
  }

  // All base colours are judged with the same parts: colour variants of one material share one roughness.
  void take_metal_rough() {
    std::vector<NamedPicture*> parts;
    const auto add = [&](FileRole role) {
      NamedPicture* picture = take(role);
      if (picture != nullptr) parts.push_back(picture);
      return picture;
    };
    NamedPicture* const packed = add(FileRole::metal_rough);
    const std::string channels = packed == nullptr               ? ""
                                 : packed->name.channels.empty() ? "-rm-"
                                                                 : packed->name.channels;
    const bool packs_metal = channels.find('m') != channels.npos;
    const bool packs_roughness = channels.find_first_of("rs") != channels.npos;
    const bool metal = packs_metal || add(FileRole::metallic) != nullptr;
    const bool rough =
        packs_roughness || add(FileRole::roughness) != nullptr || add(FileRole::gloss) != nullptr;
    while (NamedPicture* color = take(FileRole::base_color)) {
      PictureSet set{{color}, {}};
      set.members.insert(set.members.end(), parts.begin(), parts.end());
      if (!metal && !rough)
        set.missing = "a base colour without roughness and metallic, single or packed";
      else if (!metal && packed == nullptr && !absent_metalness_is_dielectric(color->name.convention))
        set.missing = "base colour and roughness without metallic, which names of " +
                      std::string(name(color->name.convention)) + " always bring";
      else if (!metal)
        color->note = "no metalness: a dielectric, as " + said_by(color->name.convention);
      judge_together(std::move(set));
    }
    for (const FileRole role :
         {FileRole::metal_rough, FileRole::metallic, FileRole::roughness, FileRole::gloss})
      while (NamedPicture* spare = take(role)) spare->note = "another file of the set says it already";
    if (!has(FileRole::diffuse_alpha))
      while (NamedPicture* spare = take(FileRole::specular_gloss))
        spare->note = "F0 of a metal-rough set comes from its base colour";
    else if (!has(FileRole::specular_gloss))
      while (NamedPicture* spare = take(FileRole::diffuse_alpha)) spare->note = "the base colour is judged";
  }

  static std::string said_by(Convention convention) {
    return convention == Convention::common || convention == Convention::own
               ? "of materials that leave the file out"
               : "names of " + std::string(name(convention)) + " mean it";
  }

  void take_pairs() {
    while (has(FileRole::diffuse_alpha) || has(FileRole::specular_gloss)) {
      PictureSet set;
      for (const FileRole role : {FileRole::diffuse_alpha, FileRole::specular_gloss})
        if (NamedPicture* picture = take(role)) set.members.push_back(picture);
      // A pair may have its gloss in a file of its own.
      if (set.members.size() == 2) {
        NamedPicture* gloss = take(FileRole::gloss);
        if (gloss == nullptr) gloss = take(FileRole::roughness);
        if (gloss != nullptr) set.members.push_back(gloss);
      }
      judge_together(std::move(set));
    }
  }

  // Metallic, roughness and packed pictures cannot be judged without a base colour.
  void take_lone_parts() {
    if (left_.empty()) return;
    PictureSet set;
    std::string what;
    for (NamedPicture* picture : left_) {
      set.members.push_back(picture);
      const std::string_view word = name(picture->name.role);
      if (what.find(word) == what.npos) (what += what.empty() ? "" : ", ") += word;
    }
    left_.clear();
    set.missing = what + " without the base colour";
    judge_together(std::move(set));
  }

  std::vector<NamedPicture*> left_;
  std::vector<PictureSet> sets_;
};

using PictureForm = std::pair<std::string_view, std::string_view>;  // resolution and format

PictureForm form_of(const NamedPicture& picture) {
  return {picture.name.resolution, picture.name.format};
}

std::string_view number_of(const NamedPicture& picture) {
  return picture.name.number;
}

// Whether a role is there twice, with two values of what is asked.
template <class Value>
bool comes_twice(std::span<NamedPicture* const> same, Value (*value_of)(const NamedPicture&)) {
  std::map<FileRole, Value> values;
  return std::ranges::any_of(same, [&](const NamedPicture* picture) {
    const Value value = value_of(*picture);
    return is_judged(picture->name.role) &&
           values.try_emplace(picture->name.role, value).first->second != value;
  });
}

// Calls a function for each run of pictures with one value, in the order of the values.
template <class Value, class Each>
void for_each_value(std::vector<NamedPicture*> same, Value (*value_of)(const NamedPicture&), Each each) {
  if (!comes_twice(std::span<NamedPicture* const>(same), value_of)) return each(std::move(same));
  std::ranges::stable_sort(same, {}, [&](const NamedPicture* p) { return value_of(*p); });
  for (auto begin = same.begin(), end = begin; begin != same.end(); begin = end) {
    while (end != same.end() && value_of(**end) == value_of(**begin)) ++end;
    each({begin, end});
  }
}

// The key that puts the versions of a picture in order, the one to judge first: a name without a version is taken for
// what was handed over, "final" for the last of the versions, and copies and old states come after all others.
// Numbers count by their value: v12 is later than v9.
std::pair<int, std::string> age(const NamedPicture& picture) {
  const std::string& version = picture.name.version;
  if (version.empty()) return {0, {}};
  for (const char* state : {"cop", "kopie", "old", "bak", "backup"})
    if (version.find(state) != version.npos) return {3, version};
  // Numbers get leading zeros, so that all are equally long, and each digit d becomes 9 - d, so that the largest
  // number comes first.
  std::string turned;
  for (std::size_t i = 0; i < version.size();) {
    const std::size_t end = std::min(version.find_first_not_of("0123456789", i), version.size());
    if (end == i) {
      turned += version[i++];
      continue;
    }
    const std::size_t first = std::min(version.find_first_not_of('0', i), end);
    turned.append(12 - std::min<std::size_t>(end - first, 12), '9');
    for (; i < end; ++i)
      if (i >= first) turned += static_cast<char>('9' - (version[i] - '0'));
  }
  return {version.find("final") != version.npos ? 1 : 2, turned};
}

// Gives the files without a number to each number that lacks their role. They are a set of their own where a
// colour is among them; maps need no other file and are judged once.
std::vector<std::vector<NamedPicture*>> numbered_groups(std::vector<NamedPicture*> same) {
  std::vector<std::vector<NamedPicture*>> out;
  for_each_value(std::move(same), number_of,
                 [&](std::vector<NamedPicture*> group) { out.push_back(std::move(group)); });
  if (out.size() < 2 || !out.front().front()->name.number.empty()) return out;
  std::vector<NamedPicture*>& plain = out.front();
  for (std::size_t i = 1; i < out.size(); ++i) {
    const std::vector<NamedPicture*> own = out[i];
    for (NamedPicture* picture : plain)
      if (!is_map(picture->name.role) && std::ranges::none_of(own, [&](const NamedPicture* other) {
            return other->name.role == picture->name.role;
          }))
        out[i].push_back(picture);
  }
  if (std::ranges::none_of(plain, [](const NamedPicture* p) { return is_color(p->name.role); }))
    std::erase_if(plain, [](const NamedPicture* p) { return !is_map(p->name.role); });
  return out;
}

// Puts a texture for a GPU and the picture that it may have been made of beside each other, in the first set that judges one.
void put_sources_beside(std::span<NamedPicture> same, std::vector<PictureSet>& sets) {
  const auto key = [](const NamedPicture& each) {
    return std::pair(without_ending(each.path), each.name.role);
  };
  std::map<std::pair<std::string_view, FileRole>, NamedPicture*> sources;
  for (NamedPicture& each : same)
    if (!is_gpu_texture(path_ending(each.path))) sources.emplace(key(each), &each);
  for (NamedPicture& blocks : same) {
    const auto source = sources.find(key(blocks));
    if (source == sources.end() || source->second == &blocks) continue;
    for (PictureSet& set : sets) {
      const bool has_blocks = std::ranges::count(set.members, &blocks) > 0,
                 has_source = std::ranges::count(set.members, source->second) > 0;
      if (has_blocks != has_source) set.beside.push_back(has_blocks ? source->second : &blocks);
      if (has_blocks || has_source) break;
    }
  }
}

}  // namespace

std::string_view name(ListedAs as) {
  switch (as) {
    case ListedAs::judged:
      return "checked";
    case ListedAs::not_judged:
      return "not checked by a rule";
    case ListedAs::lone:
      return "missing companion";
    case ListedAs::unknown:
      return "not recognised";
    case ListedAs::unreadable:
      return "unreadable";
  }
  return "";
}

std::string_view folder_of(std::string_view path) {
  return path.substr(0, path.rfind('/') + 1);  // npos + 1 is 0
}

std::optional<NamedPicture> picture_named(const NameReader& reader, const std::string& path) {
  const std::string_view folder = folder_of(path), name = std::string_view(path).substr(folder.size());
  NamedPicture out;
  out.path = path;
  auto parsed = reader.read(name);
  // "basecolor/wall.png", and "normal/wall_normal.png" whose folder says the same: the set lies in the folder around.
  const std::string_view around = folder_of(folder.substr(0, folder.size() - !folder.empty()));
  auto of_folder = reader.read_in_folder(folder.substr(around.size()), name);
  out.by_folder = of_folder && (!parsed || parsed->role == of_folder->role);
  if (!parsed) parsed = std::move(of_folder);
  if (!parsed) return std::nullopt;
  out.name = std::move(*parsed);
  out.guessed = out.name.convention != Convention::own;
  out.key = lower_case(std::string(out.by_folder ? around : folder) + out.name.set);
  // Each part begins with a line end, so that keys with and without it differ.
  if (!out.name.tile.empty()) out.key += '\n' + out.name.tile;
  if (!out.name.lod.empty()) out.key += '\n' + out.name.lod;
  return out;
}

std::vector<PictureSet> sets_of(std::span<NamedPicture> same) {
  const bool agree = unsure_agree(same);
  std::vector<NamedPicture*> known;
  for (NamedPicture& picture : same) {
    if (!picture.name.sure && !agree) {
      picture.as = ListedAs::unknown;
      picture.note = "its name tells no role without companions";
    } else {
      known.push_back(&picture);
    }
  }
  std::vector<PictureSet> out;
  std::ranges::stable_sort(known, [](const NamedPicture* a, const NamedPicture* b) {
    return std::pair(a->name.role, a->companion) < std::pair(b->name.role, b->companion) ||
           (a->name.role == b->name.role && a->companion == b->companion && age(*a) < age(*b));
  });
  for_each_value(std::move(known), form_of, [&](std::vector<NamedPicture*> form) {
    for (std::vector<NamedPicture*>& group : numbered_groups(std::move(form)))
      for (PictureSet& set : SetMaker(std::move(group)).run()) out.push_back(std::move(set));
  });
  put_sources_beside(same, out);
  return out;
}

}  // namespace etak
