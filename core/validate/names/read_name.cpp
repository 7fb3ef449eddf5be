// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "core/base/text/ascii.h"
#include "core/validate/names/names.h"

namespace etak {
namespace {

constexpr std::string_view name_separators = "_-. ";
constexpr std::size_t most_joined = 4;  // parts of a name that one word may stand in: "diffuse_alpha"

// The parts of a name between separators.
struct NamePart {
  std::string_view text;
  char before;  // the separator in front of it; '\0': none
};

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

// Words on the encoding, which say nothing of what the picture holds.
bool is_encoding(std::string_view low) {
  constexpr std::array<std::string_view, 7> words{"srgb", "linear", "raw",  "acescg",
                                                  "8bit", "16bit",  "32bit"};
  return std::ranges::find(words, low) != words.end();
}

// Mari's tile numbers: ten in a row from 1001.
bool is_udim(std::string_view text) {
  return text.size() == 4 && all_digits(text) && text >= "1001" && text <= "1999";
}

bool is_numbered(std::string_view low, std::string_view letters) {
  return low.size() <= letters.size() + 2 && low.starts_with(letters) &&
         all_digits(low.substr(letters.size()));
}

// Which parts of a name stood beside the word.
struct NameMarks {
  bool unreal = false;            // "T_" in front
  bool capital = false;           // the word begins with a capital
  bool resolution_left = false;   // of the word
  bool resolution_right = false;  // of the word, with a small k
  bool format = false;
};

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

// Takes a part that tells resolution, format, tile, level of detail or encoding; false: it is another part.
//   parts   the part is the last one; of "_u1_v1" the last two, which are both taken
bool take_part(std::vector<NamePart>& parts, std::size_t at, ParsedName& to, NameMarks& marks, bool left) {
  const NamePart& part = parts[at];
  const std::string low = lower_case(part.text);
  if (is_numbered(low, "v") && at > 1 && is_numbered(lower_case(parts[at - 1].text), "u")) {
    to.tile = lower_case(parts[at - 1].text) + '_' + low;
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(at));
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
  } else if (!is_encoding(low)) {
    return false;
  }
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

// The row whose marks the name bears; else the first, which is not sure then.
std::pair<const NameWord*, bool> best_row(const std::vector<const NameWord*>& rows, const NameMarks& marks) {
  for (const NameWord* row : rows)
    if (bears(marks, row->convention)) return {row, row->sure};
  return {rows.front(), false};
}

}  // namespace

std::string normal_ending(std::string_view ending) {
  std::string out;
  for (const char c : ending) out += name_separators.find(c) != name_separators.npos ? '_' : lower_case(c);
  return out.substr(std::min(out.find_first_not_of('_'), out.size()));
}

NameReader::NameReader(std::span<const OwnName> own) {
  for (const OwnName& entry : own) own_.emplace(entry.ending, entry);
}

std::optional<ParsedName> NameReader::read(std::string_view file_name) const {
  const std::string_view stem = file_name.substr(0, file_name.rfind('.'));
  std::vector<NamePart> parts = parts_of(stem);
  ParsedName out;
  NameMarks marks;
  marks.unreal = parts.size() > 2 && parts.front().text == "T" && parts[1].before == '_';
  while (parts.size() > 1 && take_part(parts, parts.size() - 1, out, marks, false)) parts.pop_back();

  // The longest ending that is a word.
  const OwnName* own = nullptr;
  const std::vector<const NameWord*>* rows = nullptr;
  std::size_t joined = std::min(most_joined, parts.size());
  for (; joined > 0 && own == nullptr && rows == nullptr; --joined) {
    const char* begin = parts[parts.size() - joined].text.data();
    const std::string_view last = parts.back().text;
    const std::string word =
        normal_ending({begin, static_cast<std::size_t>(last.data() + last.size() - begin)});
    if (const auto found = own_.find(word); found != own_.end())
      own = &found->second;
    else if (const auto known = word_index().find(word); known != word_index().end())
      rows = &known->second;
    if (own != nullptr || rows != nullptr) break;
  }
  if (own == nullptr && rows == nullptr) return std::nullopt;
  const char first = parts[parts.size() - joined].text.front();
  marks.capital = first >= 'A' && first <= 'Z';
  parts.resize(parts.size() - joined);
  while (parts.size() > 1 && take_part(parts, parts.size() - 1, out, marks, true)) parts.pop_back();

  if (own != nullptr) {
    out.convention = Convention::own;
    out.role = own->role;
    out.channels = own->channels;
  } else {
    const auto [row, is_sure] = best_row(*rows, marks);
    out.convention = row->convention;
    out.role = row->role;
    out.channels = row->channels;
    out.green = row->green;
    out.otherwise = row->otherwise;
    out.sure = is_sure;
  }
  if (parts.empty())
    out.sure = out.sure && own != nullptr;
  else
    out.set = stem.substr(
        0, static_cast<std::size_t>(parts.back().text.data() + parts.back().text.size() - stem.data()));
  return out;
}

}  // namespace etak
