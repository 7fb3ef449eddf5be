// SPDX-License-Identifier: Apache-2.0
// Names of pictures by a pattern of etak.toml that says where the set and the role stand.
#include <algorithm>

#include "core/names/names.h"

namespace etak {
namespace {

constexpr std::string_view set_mark = "{set}", role_mark = "{role}";

// What a pattern begins with: a mark, a star, or a letter of text.
std::string_view first_piece(std::string_view pattern) {
  for (const std::string_view mark : {set_mark, role_mark})
    if (pattern.starts_with(mark)) return mark;
  return pattern.substr(0, 1);
}

bool stands_for_text(std::string_view piece) {
  return piece == set_mark || piece == role_mark || piece == "*";
}

std::size_t slashes(std::string_view text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '/'));
}

// What the marks of a pattern stand for in a name.
struct Marked {
  std::string_view set, role;
};

// Holds a name against a pattern. A set and a star take as little text as they can, so that the role is the
// longest word: of "wall_base_color" by "{set}_{role}" it is base_color. A role that stands before all else takes
// as much as it can, for the same reason.
//   is_role   whether a text is a word for a role
template <class IsRole>
bool matches(std::string_view pattern, std::string_view name, const IsRole& is_role, Marked& out) {
  if (pattern.empty()) return name.empty();
  const std::string_view piece = first_piece(pattern), rest = pattern.substr(piece.size());
  if (!stands_for_text(piece))
    return !name.empty() && name.front() == piece.front() && matches(rest, name.substr(1), is_role, out);
  const std::size_t most = std::min(name.find('/'), name.size());
  if (piece == "*") {
    for (std::size_t taken = 0; taken <= most; ++taken)
      if (matches(rest, name.substr(taken), is_role, out)) return true;
    return false;
  }
  for (std::size_t i = 1; i <= most; ++i) {
    const std::size_t taken = piece == role_mark ? most + 1 - i : i;
    const std::string_view text = name.substr(0, taken);
    if (piece == role_mark && !is_role(text)) continue;
    if (!matches(rest, name.substr(taken), is_role, out)) continue;
    (piece == role_mark ? out.role : out.set) = text;
    return true;
  }
  return false;
}

}  // namespace

std::string_view defect_of_set_pattern(std::string_view pattern) {
  const auto count = [&](std::string_view mark) {
    const std::size_t at = pattern.find(mark);
    return at == pattern.npos ? 0 : pattern.find(mark, at + mark.size()) == pattern.npos ? 1 : 2;
  };
  if (count(set_mark) != 1) return "{set} not once";
  if (count(role_mark) != 1) return "{role} not once";
  if (std::count(pattern.begin(), pattern.end(), '*') > 2) return "more than two *";
  bool open = false;  // the piece before stands for text of any length
  for (std::string_view rest = pattern; !rest.empty();) {
    const std::string_view piece = first_piece(rest);
    if (open && stands_for_text(piece)) return "nothing between {set}, {role} and *";
    open = stands_for_text(piece);
    rest.remove_prefix(piece.size());
  }
  return {};
}

std::optional<ParsedName> NameReader::read_by_pattern(std::string_view pattern, std::string_view path,
                                                      std::size_t& matched_from) const {
  if (pattern.ends_with(".*")) pattern.remove_suffix(2);
  std::string_view stem = path.substr(0, path.rfind('.'));
  if (slashes(stem) < slashes(pattern)) return std::nullopt;
  // A pattern is held against as many folders from the end as it has itself.
  std::size_t from = stem.size();
  for (std::size_t left = slashes(pattern) + 1; left > 0; --left)
    from = stem.rfind('/', from - 1) == stem.npos ? 0 : stem.rfind('/', from - 1);
  if (from < stem.size() && stem[from] == '/') ++from;
  Marked found;
  const auto is_role = [&](std::string_view text) { return static_cast<bool>(word(text)); };
  if (!matches(pattern, stem.substr(from), is_role, found)) return std::nullopt;
  auto out = of_word(found.role);
  out->set = found.set;
  matched_from = from;
  return out;
}

}  // namespace etak
