// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/names/names.h"

namespace etak {

/// What becomes of a file that was found.
enum class ListedAs {
  judged,      // checked by the rules, alone or with the files of its set
  not_judged,  // known, but no rule is about what it holds
  lone,        // without the companion that it would be judged with (ETK002)
  unknown,     // its name tells no role
  unreadable,  // cannot be checked at all (ETK001)
};
std::string_view name(ListedAs as);  // "checked", "not checked by a rule", "missing companion", ...

/// The folder of a path, ending in '/'; empty for a bare name.
std::string_view folder_of(std::string_view path);

/// A picture with what its name tells, and what is done with it.
struct NamedPicture {
  std::string path;
  std::string key;         // equal for what may belong together: folder, set, tile and level, in lower case
  ParsedName name;         // its role is settled by sets_of()
  bool by_folder = false;  // its folder has the name of the role, and the set lies in the folder around
  bool guessed = false;    // the role comes from the name, not from [roles] or --role
  bool companion = false;  // found beside what was named: judged with that or not at all
  bool by_hand = false;
  bool plain = false;  // of FileCandidate
  ListedAs as = ListedAs::not_judged;
  std::string note;
};

/// A picture by what its name tells, or the name of its folder; nullopt: neither tells a role.
std::optional<NamedPicture> picture_named(const NameReader& reader, const std::string& path);

/// Pictures that are judged together, or that would be if their companion were there.
///   missing   what is missing, for ETK002: "a base colour without roughness"; empty: the set is whole, or
///             the rule itself sees what is missing
///   beside    of a set of maps: what they are held against, and what is judged with another set; of any set the pictures
///             that its textures for a GPU may have been made of, or the other way round
struct PictureSet {
  std::vector<NamedPicture*> members;
  std::string missing;
  std::vector<NamedPicture*> beside = {};
};

/// Puts the pictures of one key together: diffuse with specular (and gloss), base colour with metallic and
/// roughness or with a packed picture, F0 alone; normal, height, occlusion and emissive maps are a set of their
/// own, the last. Two resolutions, formats or numbers of one set are two sets; files without a number belong to
/// each number that lacks their role. Of several versions of a part the newest is taken. The other pictures
/// decide what an ambiguous word means: "diffuse" beside roughness is a base colour, "albedo" beside F0 is
/// diffuse.
std::vector<PictureSet> sets_of(std::span<NamedPicture> same);

}  // namespace etak
