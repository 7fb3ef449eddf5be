// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "core/base/text/ascii.h"
#include "core/names/names.h"

namespace etak {

// A part of a name between separators.
struct NamePart {
  std::string_view text;
  char before;  // the separator in front of it; '\0': none
};

// The parts of a name that stood beside the word.
struct NameMarks {
  bool unreal = false;            // "T_" in front
  bool capital = false;           // the word begins with a capital
  bool resolution_left = false;   // of the word
  bool resolution_right = false;  // of the word, with a small k
  bool format = false;
};

namespace {

constexpr std::size_t most_joined = 4;  // parts of a name that one word may stand in: "diffuse_alpha"

std::vector<NamePart> parts_of(std::string_view stem) {
  std::vector<NamePart> out;
  char before = '\0';
  for (std::size_t begin = 0; begin <= stem.size();) {
    const std::size_t end = std::min(stem.find_first_of(name_separators, begin), stem.size());
    out.push_back({stem.substr(begin, end - begin), before});
    before = end < stem.size() ? stem[end] : '\0';
    begin = end + 1;
  }
  return out;
}

bool all_digits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, is_digit);
}

// "4k", "2048", "1024x1024".
bool is_resolution(std::string_view low) {
  if (const std::size_t by = low.find('x'); by != low.npos)
    return is_resolution(low.substr(0, by)) && low.substr(0, by) == low.substr(by + 1);
  if (low.ends_with('k')) return low.size() <= 3 && all_digits(low.substr(0, low.size() - 1));
  constexpr std::array<std::string_view, 8> sides{"128",  "256",  "512",  "1024",
                                                  "2048", "4096", "8192", "16384"};
  return std::ranges::find(sides, low) != sides.end();
}

bool is_format(std::string_view low) {
  constexpr std::array<std::string_view, 8> formats{"png", "jpg",  "jpeg", "exr",
                                                    "tif", "tiff", "tga",  "webp"};
  return std::ranges::find(formats, low) != formats.end();
}

// Words on the encoding, which say nothing of what the picture holds: spaces of colour as ACES and Maya name them,
// depths, and "map" or "texture" behind the word.
bool is_encoding(std::string_view low) {
  constexpr auto words = std::to_array<std::string_view>(
      {"srgb",   "linear",  "lin",     "raw",   "acescg", "aces",     "aces2065",  "utility",
       "rec709", "bt709",   "rec2020", "p3",    "data",   "noncolor", "noncolour", "map",
       "tex",    "texture", "8bit",    "16bit", "32bit",  "triplanar"});
  return std::ranges::find(words, low) != words.end();
}

// Mari's tile numbers: ten in a row from 1001.
bool is_udim(std::string_view text) {
  return text.size() == 4 && all_digits(text) && text >= "1001" && text <= "1999";
}

bool is_numbered(std::string_view low, std::string_view letters) {
  return low.size() <= letters.size() + 4 && low.starts_with(letters) &&
         all_digits(low.substr(letters.size()));
}

// Words of people who keep several states of one file.
bool is_state(std::string_view low) {
  constexpr auto words =
      std::to_array<std::string_view>({"final", "copy", "kopie", "copie", "copia", "wip", "old", "new",
                                       "latest", "backup", "bak", "approved", "draft"});
  return std::ranges::find(words, low) != words.end();
}

bool in_range(std::string_view digits, std::string_view low, std::string_view high) {
  return low <= digits && digits <= high;
}

// "20240131", "240131".
bool is_date(std::string_view text) {
  if (!all_digits(text) || (text.size() != 6 && text.size() != 8)) return false;
  if (text.size() == 8 && !text.starts_with("19") && !text.starts_with("20")) return false;
  return in_range(text.substr(text.size() - 4, 2), "01", "12") &&
         in_range(text.substr(text.size() - 2), "01", "31");
}

// "v003", "ver3", "rev02", "r03", a date, or a state.
bool is_version(std::string_view low) {
  return is_numbered(low, "v") || is_numbered(low, "ver") || is_numbered(low, "rev") ||
         (low.size() > 2 && is_numbered(low, "r")) || is_date(low) || is_state(low);
}

bool bears(const NameMarks& marks, Convention convention) {
  switch (convention) {
    case Convention::unreal:
      return marks.unreal;
    case Convention::ambient_cg:
      return marks.format && marks.resolution_left;
    case Convention::poly_haven:
      return marks.resolution_right && !marks.capital;
    case Convention::quixel:
      return marks.resolution_left;
    case Convention::substance:
      return marks.capital;
    case Convention::unity:
    case Convention::common:
    case Convention::own:
      break;
  }
  return true;
}

// Takes the last part of a name where it tells resolution, format, tile, level of detail, version, number or
// encoding, with the parts before it that belong to it ("_u1_v1", "2024-01-31"); false: it is another part.
//   left   the part stands in front of the word, where versions and numbers belong to the name of the set
bool take_part(std::vector<NamePart>& parts, ParsedName& to, NameMarks& marks, bool left) {
  const std::size_t last = parts.size() - 1;
  const NamePart& part = parts[last];
  const std::string low = lower_case(part.text);
  const auto before = [&](std::size_t steps) {
    return last > steps ? lower_case(parts[last - steps].text) : std::string();
  };
  std::size_t taken = 1;
  if (is_numbered(low, "v") && is_numbered(before(1), "u")) {
    to.tile = before(1) + '_' + low;
    taken = 2;
  } else if (is_udim(low) && (part.before == '.' || low != "1024")) {
    to.tile = low;
  } else if (is_resolution(low)) {
    to.resolution = low;
    if (left)
      marks.resolution_left = low.ends_with('k');
    else
      marks.resolution_right = part.text.ends_with('k');
  } else if (is_format(low)) {
    to.format = low;
    marks.format = true;
  } else if (is_numbered(low, "lod")) {
    to.lod = low;
  } else if (low.empty()) {  // of "__" and " - "
  } else if (!left && low.size() == 2 && before(1).size() == 2 && is_date(before(2) + before(1) + low)) {
    to.version = before(2) + before(1) + low;
    taken = 3;
  } else if (!left && is_version(low)) {
    to.version = low + (to.version.empty() ? "" : "_" + to.version);
  } else if (!left && low.size() <= 3 && all_digits(low)) {
    to.number = low;
  } else if (!is_encoding(low)) {
    return false;
  }
  parts.resize(parts.size() - taken);
  return true;
}

using WordIndex = std::unordered_map<std::string_view, std::vector<const NameWord*>>;

const WordIndex& word_index() {
  static const WordIndex index = [] {
    WordIndex out;
    for (const NameWord& row : name_words())
      for (std::string_view rest = row.words; !rest.empty();) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        out[rest.substr(0, end)].push_back(&row);
        rest.remove_prefix(std::min(end + 1, rest.size()));
      }
    return out;
  }();
  return index;
}

// The plain letter of a letter of Latin-1 whose second byte in UTF-8 is given: "e" of the last byte of "é".
char without_accent(char second) {
  constexpr std::string_view letters = "aaaaaaaceeeeiiiidnooooo_ouuuuytsaaaaaaaceeeeiiiidnooooo_ouuuuyty";
  static_assert(letters.size() == 64);
  return letters[static_cast<unsigned char>(second) & 63];
}

// The row whose marks the name bears; else the first, which is not sure then.
std::pair<const NameWord*, bool> best_row(const std::vector<const NameWord*>& rows, const NameMarks& marks) {
  for (const NameWord* row : rows)
    if (bears(marks, row->convention)) return {row, row->sure};
  return {rows.front(), false};
}

}  // namespace

std::string normal_ending(std::string_view ending) {
  std::string out;
  for (std::size_t i = 0; i < ending.size(); ++i) {
    const char c = ending[i];
    // In UTF-8 a letter of Latin-1 with its accent is 0xC3 and a second byte, and an accent that stands behind its
    // letter, as macOS writes it, is 0xCC or 0xCD and a second byte.
    if (c == '\xC3' && i + 1 < ending.size())
      out += without_accent(ending[++i]);
    else if ((c == '\xCC' || c == '\xCD') && i + 1 < ending.size())
      ++i;
    else
      out += name_separators.find(c) != name_separators.npos ? '_' : lower_case(c);
  }
  return out.substr(std::min(out.find_first_not_of('_'), out.size()));
}

NameReader::NameReader(std::span<const OwnName> own) {
  for (const OwnName& entry : own) own_.emplace(entry.ending, entry);
}

NameReader::Word NameReader::word(std::string_view text) const {
  const std::string low = normal_ending(text);
  if (const auto found = own_.find(low); found != own_.end()) return {&found->second, nullptr};
  if (const auto known = word_index().find(low); known != word_index().end())
    return {nullptr, &known->second};
  return {};
}

namespace {

std::string_view text_between(std::string_view first, std::string_view last) {
  return {first.data(), static_cast<std::size_t>(last.data() + last.size() - first.data())};
}

// Where a word of a name may begin by its case alone: before "Base" and "Color" of "wallBaseColor".
std::vector<std::size_t> case_boundaries(std::string_view text) {
  std::vector<std::size_t> out;
  for (std::size_t i = 1; i < text.size(); ++i)
    if (is_upper(text[i]) &&
        (!is_upper(text[i - 1]) || (i + 1 < text.size() && !is_upper(text[i + 1]) && !is_digit(text[i + 1]))))
      out.push_back(i);
  return out;
}

// The name without the number of a copy, as file managers write it: "wall" of "wall (1)".
std::string_view without_copy_number(std::string_view stem, ParsedName& to) {
  const std::size_t open = stem.rfind('(');
  if (!stem.ends_with(')') || open == stem.npos || open == 0) return stem;
  const std::string_view digits = stem.substr(open + 1, stem.size() - open - 2);
  if (!all_digits(digits) || digits.size() > 3) return stem;
  to.version = "copy" + std::string(digits);
  return stem.substr(0, open);
}

// What stands behind a word without a separator: digits, or a capital behind a small letter.
std::size_t number_behind(std::string_view text) {
  std::size_t digits = 0;
  while (digits < std::min<std::size_t>(text.size(), 3) && is_digit(text[text.size() - 1 - digits])) ++digits;
  if (digits > 0 || text.size() < 2) return digits;
  const char last = text.back(), before = text[text.size() - 2];
  return is_upper(last) && is_lower(before) ? 1 : 0;
}

}  // namespace

// The longest ending of the parts that is a word, which is taken off them.
NameReader::Word NameReader::take_word(std::vector<NamePart>& parts, NameMarks& marks) const {
  for (std::size_t joined = std::min(most_joined, parts.size()); joined > 0; --joined) {
    const std::string_view first = parts[parts.size() - joined].text;
    const Word found = word(text_between(first, parts.back().text));
    if (!found) continue;
    marks.capital = !first.empty() && is_upper(first.front());
    parts.resize(parts.size() - joined);
    return found;
  }
  return {};
}

// The longest end of the last part that is a word and begins with a capital: "BaseColor" of "wallBaseColor".
NameReader::Word NameReader::take_capital_word(std::vector<NamePart>& parts, NameMarks& marks) const {
  std::string_view& last = parts.back().text;
  for (const std::size_t at : case_boundaries(last)) {
    const std::string_view end = last.substr(at);
    const Word found = end.size() < 3 && end != "AO" ? Word{} : word(end);
    if (!found) continue;
    marks.capital = true;
    last = last.substr(0, at);
    return found;
  }
  return {};
}

NameReader::Word NameReader::take_last_word(std::vector<NamePart>& parts, ParsedName& to,
                                            NameMarks& marks) const {
  for (;;) {
    if (const Word found = take_word(parts, marks)) return found;
    const NamePart last = parts.back();
    // A single letter with digits is a version or a number ("r03"), not a word with a number.
    const std::size_t digits = number_behind(last.text);
    if (digits > 0 && digits + 1 < last.text.size() && !is_version(lower_case(last.text))) {
      parts.back().text.remove_suffix(digits);
      Word found = take_word(parts, marks);
      if (!found) found = take_capital_word(parts, marks);
      if (found) {
        to.number = lower_case(last.text.substr(last.text.size() - digits));
        return found;
      }
      parts.back().text = last.text;
    }
    if (const Word found = take_capital_word(parts, marks)) return found;
    if (parts.size() < 2 || !take_part(parts, to, marks, false)) return {};
  }
}

void NameReader::say(const Word& word, const NameMarks& marks, ParsedName& to) {
  if (word.own != nullptr) {
    to.convention = Convention::own;
    to.role = word.own->role;
    to.channels = word.own->channels;
    return;
  }
  const auto [row, is_sure] = best_row(*word.rows, marks);
  to.convention = row->convention;
  to.role = row->role;
  to.channels = row->channels;
  to.green = row->green;
  to.otherwise = row->otherwise;
  to.sure = is_sure;
}

std::optional<ParsedName> NameReader::of_word(std::string_view text) const {
  const Word found = word(text);
  if (!found) return std::nullopt;
  ParsedName out;
  say(found, NameMarks{}, out);
  out.convention = Convention::own;
  out.sure = true;
  return out;
}

std::optional<ParsedName> NameReader::read(std::string_view file_name) const {
  ParsedName out;
  const std::string_view stem = without_copy_number(file_name.substr(0, file_name.rfind('.')), out);
  std::vector<NamePart> parts = parts_of(stem);
  NameMarks marks;
  marks.unreal = parts.size() > 2 && parts.front().text == "T" && parts[1].before == '_';
  const std::vector<NamePart> whole = parts;
  Word found = take_last_word(parts, out, marks);
  if (!found) return read_front(whole, out.version);
  // Poliigon names the kind of the set behind the resolution: "Metal01_COL_2K_METALNESS".
  const std::string_view kind = whole.back().text;
  if (parts.size() > 2 && is_resolution(lower_case(parts.back().text)) &&
      (kind == "METALNESS" || kind == "SPECULAR")) {
    std::vector<NamePart> front(parts.begin(), parts.end() - 1);
    if (const Word other = take_word(front, marks)) {
      out.resolution = lower_case(parts.back().text);
      parts = std::move(front);
      found = other;
    }
  }
  while (parts.size() > 1 && take_part(parts, out, marks, true)) {
  }
  say(found, marks, out);
  if (parts.empty())
    out.sure = out.sure && found.own != nullptr;
  else
    out.set = text_between(stem, parts.back().text);
  return out;
}

// A name that begins with its word, as "basecolor_wall": no proof without companions.
std::optional<ParsedName> NameReader::read_front(std::vector<NamePart> parts,
                                                 const std::string& version) const {
  ParsedName out;
  out.version = version;
  NameMarks marks;
  while (parts.size() > 1 && take_part(parts, out, marks, false)) {
  }
  for (std::size_t joined = std::min(most_joined, parts.size() - 1); joined > 0; --joined) {
    const std::string_view text = text_between(parts.front().text, parts[joined - 1].text);
    const Word found = text.size() < 3 ? Word{} : word(text);
    if (!found) continue;
    say(found, marks, out);
    out.sure = false;
    out.set = text_between(parts[joined].text, parts.back().text);
    return out;
  }
  return std::nullopt;
}

std::optional<ParsedName> NameReader::read_in_folder(std::string_view folder,
                                                     std::string_view file_name) const {
  if (folder.ends_with('/')) folder.remove_suffix(1);
  const Word found = folder.size() < 3 ? Word{} : word(folder);
  if (!found) return std::nullopt;
  ParsedName out;
  std::vector<NamePart> parts = parts_of(without_copy_number(file_name.substr(0, file_name.rfind('.')), out));
  NameMarks marks;
  marks.capital = is_upper(folder.front());
  while (parts.size() > 1 && take_part(parts, out, marks, false)) {
  }
  say(found, marks, out);
  out.sure = false;
  out.set = text_between(parts.front().text, parts.back().text);
  return out;
}

}  // namespace etak
