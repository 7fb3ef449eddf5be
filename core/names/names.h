// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/judge/target.h"

namespace etak {

// What the name of a picture tells: the set it belongs to, what it holds, and its resolution, format, UDIM
// tile and level of detail. The words are those of the conventions of studios and tools (conventions.cpp) and
// those of [names] in etak.toml.

/// What stands between the parts of a name.
inline constexpr std::string_view name_separators = "_-. ";

/// The program or library whose convention a name follows.
///   common   words that Blender, Godot, glTF exporters and many others share
///   own      [names] or [roles] of etak.toml
enum class Convention { common, ambient_cg, poly_haven, quixel, substance, unity, unreal, own };
std::string_view name(Convention convention);  // "common", "ambientCG", "Poly Haven", ...

/// Whether a set of this convention with base colour and roughness that brings no metalness is a dielectric.
/// False where the convention packs or names metalness always, so that its absence is a mistake.
bool absent_metalness_is_dielectric(Convention convention);

/// A row of the table of conventions.
///   words      endings of names, separated by spaces: in lower case, '_' for any of the separators '_', '-',
///              '.' and ' '
///   channels   what R, G, B and A hold, a letter each (channel_word); empty: the role's own layout
///   sure       whether the ending, with the marks of its convention, is proof. Other endings count only
///              beside companions that agree, so that band_d.png stays a picture of a band
///   otherwise  what the picture holds where a companion says that it cannot be `role`: T_x_A is the albedo,
///              and opacity where there is T_x_D too
struct NameWord {
  Convention convention = Convention::common;
  std::string_view words;
  FileRole role = FileRole::other;
  std::string_view channels = {};
  bool sure = true;
  GreenAxis green = GreenAxis::unsaid;
  std::optional<FileRole> otherwise = {};
};
std::span<const NameWord> name_words();

/// "roughness" for 'r'; "smoothness" s, "metallic" m, "occlusion" o, "height" h, "opacity" a, "none" -. Empty
/// and nullopt for others.
std::string_view channel_word(char letter);
std::optional<char> channel_letter(std::string_view word);

/// An entry of [names]: `ending` as in NameWord::words.
struct OwnName {
  std::string ending;
  FileRole role = FileRole::other;
  std::string channels;
  friend bool operator==(const OwnName&, const OwnName&) = default;
};

/// What is wrong with a pattern of [sets], in a few words; empty: nothing is. A pattern has {set} and {role} once
/// each, at most two `*`, and other text between these: "{set}/maps/{role}_*".
std::string_view defect_of_set_pattern(std::string_view pattern);

/// An ending as it is compared: in lower case, '_' for each separator, none in front.
std::string normal_ending(std::string_view ending);

/// A name that was understood.
///   set          what is left without the parts below, as written: "Wall" of "Wall_4K-PNG_Color.png"; empty
///                where the name is the word alone ("albedo.png")
///   resolution   "4k", "2048"; format, tile ("1001", "u1_v1") and lod ("lod0") likewise; in lower case
///   version      "v003", "20240131", "final", "copy2": a state of the file. Of two the files of a set are judged by the
///                latest
///   number       "01", "a" behind the word: files of one number belong together
///   sure         false: counts only beside companions that agree
struct ParsedName {
  std::string set;
  Convention convention = Convention::common;
  FileRole role = FileRole::other;
  std::string channels;
  std::string resolution, format, tile, lod, version, number;
  GreenAxis green = GreenAxis::unsaid;
  std::optional<FileRole> otherwise;
  bool sure = true;
};

struct NamePart;
struct NameMarks;

/// Reads names of files. Cheap: some look-ups a name.
class NameReader {
 public:
  /// `own` comes before the built-in words.
  explicit NameReader(std::span<const OwnName> own);
  /// Reads a file's name without its folder; nullopt: no ending is known.
  std::optional<ParsedName> read(std::string_view file_name) const;
  /// Reads the name of a file whose folder is named by the word ("basecolor/wall.png"); nullopt: the folder's name is none.
  std::optional<ParsedName> read_in_folder(std::string_view folder, std::string_view file_name) const;
  /// Reads a path by a pattern of [sets] without a defect, which is held against the end of the path, without the format:
  /// {role} is a word of [names] or of the conventions, {set} and `*` any text without a '/'.
  ///   matched_from   where in the path the pattern begins
  std::optional<ParsedName> read_by_pattern(std::string_view pattern, std::string_view path,
                                            std::size_t& matched_from) const;

 private:
  /// A word that is known: an own ending, or the rows that have it.
  struct Word {
    const OwnName* own = nullptr;
    const std::vector<const NameWord*>* rows = nullptr;
    explicit operator bool() const { return own != nullptr || rows != nullptr; }
  };
  Word word(std::string_view text) const;
  /// What a word means that stands where a person said that the role stands: sure, without a set.
  std::optional<ParsedName> of_word(std::string_view text) const;
  Word take_word(std::vector<NamePart>& parts, NameMarks& marks) const;
  Word take_capital_word(std::vector<NamePart>& parts, NameMarks& marks) const;
  Word take_last_word(std::vector<NamePart>& parts, ParsedName& to, NameMarks& marks) const;
  static void say(const Word& word, const NameMarks& marks, ParsedName& to);
  std::optional<ParsedName> read_front(std::vector<NamePart> parts, const std::string& version) const;

  struct TextHash : std::hash<std::string_view> {
    using is_transparent = void;  // NOLINT(readability-identifier-naming): the name that containers look for
  };
  std::unordered_map<std::string, OwnName, TextHash, std::equal_to<>> own_;
};

}  // namespace etak
