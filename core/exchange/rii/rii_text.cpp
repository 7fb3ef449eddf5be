// SPDX-License-Identifier: Apache-2.0
// The free text of a page: who measured what, in HTML written by hand in a dozen styles. The code can only
// guess, but it loses nothing: text that is not recognised stays in the title, and `via` names the page in
// any case.
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/exchange/rii/axis_pages.h"
#include "core/exchange/rii/rii_page.h"
#include "core/exchange/rii/sample_name.h"
#include "core/exchange/rii/yaml_lines.h"
#include "core/material/names.h"
#include "core/material/optics/medium.h"
#include "core/material/optics/optics_class.h"

namespace etak {
namespace {

// Characters that are removed around a text, and around an item of a list.
constexpr std::string_view white = " \t\n\r", white_commas = " \t\n\r,", white_stops = " \t\n\r.,",
                           white_dashes = " \t\n\r-";

std::vector<std::string_view> split_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t stop = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, stop));
    text.remove_prefix(std::min(stop + 1, text.size()));
  }
  return lines;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  std::string out;
  std::size_t at = 0;
  for (std::size_t found; (found = text.find(from, at)) != text.npos; at = found + from.size())
    out.append(text, at, found - at).append(to);
  text = out.append(text, at);
}

// With bytes that are no UTF-8, and control bytes, as "\\xNN": what goes into a material must be text.
std::string readable(std::string_view text) {
  return printable(text, text.npos);
}

// Text without tags, its blanks folded to one.
std::string plain(std::string_view html) {
  std::string text;
  for (std::size_t i = 0; i < html.size(); ++i) {
    const char next = i + 1 < html.size() ? html[i + 1] : ' ';
    // "x<0.3" is no tag.
    if (html[i] == '<' && (next == '/' || is_letter(next))) {
      const std::size_t stop = html.find('>', i);
      if (stop == html.npos) break;
      if (html.substr(i, 3) == "<br") text.push_back(' ');
      i = stop;
    } else {
      text.push_back(is_space(html[i]) ? ' ' : html[i]);
    }
  }
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 5> entities{
      {{"&lt;", "<"}, {"&gt;", ">"}, {"&nbsp;", " "}, {"&times;", "×"}, {"&amp;", "&"}}};
  for (const auto& [entity, meaning] : entities) replace_all(text, entity, meaning);
  text.erase(std::unique(text.begin(), text.end(), [](char a, char b) { return a == ' ' && b == ' '; }),
             text.end());
  return readable(trimmed(text, white));
}

// The value of a key as text: a block scalar with its indentation taken off, or a plain or quoted scalar with
// its further lines.
//   value   from behind the colon on; empty: not given
std::string text_value(std::string_view value) {
  if (value.empty()) return {};
  YamlLines lines(value, {});
  const std::string_view head = lines.value();
  const char* first = lines.at;
  lines.skip_block(0);
  const auto block = split_lines({first, static_cast<std::size_t>(lines.at - first)});
  std::string text;
  if (!head.starts_with('|') && !head.starts_with('>')) {
    text = head;
    for (const auto line : block) text.append(" ").append(trimmed(line, white));
    text = unquoted(trimmed(text, white));
    replace_all(text, "\\\"", "\"");
    return text;
  }
  std::size_t indent = std::string_view::npos;
  for (const auto line : block) {
    if (indent == line.npos && !trimmed(line, white).empty()) indent = line.find_first_not_of(' ');
    const std::size_t spaces = std::min(line.find_first_not_of(' '), line.size());
    text.append(line.substr(std::min(spaces, indent))).append("\n");
  }
  return std::string(trimmed(text, white));
}

// "293", "293 K" or "20 °C" in kelvin.
std::optional<double> kelvin(std::string_view text) {
  const std::size_t stop = std::min(text.find_first_not_of("+-.0123456789eE"), text.size());
  double value = 0;
  if (!parse_number(text.substr(0, stop), value)) return {};
  const std::string_view unit = trimmed(text.substr(stop), white);
  if (unit == "°C" || unit == "C")
    value += 273.15;
  else if (!unit.empty() && unit != "K")
    return {};
  return value > 0 ? std::optional(value) : std::nullopt;
}

// The value of `name:` among the lines of an indented block; empty when it is not there.
std::string_view nested_value(std::string_view block, std::string_view name) {
  for (auto line : split_lines(block)) {
    line = trimmed(line, white_dashes);
    if (line.starts_with(name) && line.substr(name.size()).starts_with(':'))
      return unquoted(trimmed(line.substr(name.size() + 1), white));
  }
  return {};
}

// The free text of a page.
struct PageText {
  std::string comments;                      // as in the page, HTML tags included
  std::optional<double> temperature_kelvin;  // of CONDITIONS
  std::string direction;                     // of CONDITIONS
};

PageText text_of(const RiiPage& page) {
  return {text_value(page.comments), kelvin(nested_value(page.conditions, "temperature")),
          std::string(nested_value(page.conditions, "direction"))};
}

// ---- citation

// "A.", "J.-P.", "S.C.", "VI.": what stands before a surname.
bool is_initials(std::string_view word) {
  if (word.empty() || word.back() != '.') return false;
  std::size_t letters = 0;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const char c = word[i];
    if (c == '.' || c == '-') {
      letters = 0;
      continue;
    }
    if ((static_cast<unsigned char>(c) & 0xC0) == 0x80) continue;  // within a UTF-8 letter
    if (++letters > 1 && !(letters == 2 && is_upper(c))) return false;
  }
  return true;
}

// Where the authors end and the title begins in "A. Author and B. C. Other. Title" or "A. Author, Title".
std::size_t end_of_authors(std::string_view text) {
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t stop = std::min(text.find(' ', begin), text.size());
    const std::string_view word = text.substr(begin, stop - begin);
    const std::string_view rest = text.substr(std::min(stop + 1, text.size()));
    const std::string_view next = rest.substr(0, rest.find(' '));
    const bool ends =
        word.size() > 1 && (word.back() == '.' || word.back() == ',') && !is_initials(word) && word != "Jr.";
    if (ends && !is_initials(next) && next != "and" && next != "et" && next != "Jr.") return stop;
    begin = stop + 1;
  }
  return text.size();
}

std::vector<std::string> author_list(std::string_view text) {
  std::vector<std::string> authors;
  std::string rest(trimmed(text, white_stops));
  for (const std::string_view between : {", and ", " and ", " & ", "; "}) replace_all(rest, between, ", ");
  for (std::string_view left = rest; !left.empty();) {
    const std::size_t stop = std::min(left.find(", "), left.size());
    if (const auto author = trimmed(left.substr(0, stop), white_commas); !author.empty())
      authors.push_back(std::string(author) + (author.ends_with(" et al") ? "." : ""));
    left.remove_prefix(std::min(stop + 2, left.size()));
  }
  return authors;
}

// A number of four digits that can be a year, standing alone; 0 when there is none. "(1972)" is preferred.
int find_year(std::string_view text) {
  int year = 0;
  for (std::size_t i = 0; i + 4 <= text.size(); ++i) {
    const auto four = text.substr(i, 4);
    if (!std::all_of(four.begin(), four.end(), is_digit)) continue;
    const bool alone = (i == 0 || !is_digit(text[i - 1])) && (i + 4 == text.size() || !is_digit(text[i + 4]));
    const int value = (four[0] - '0') * 1000 + (four[1] - '0') * 100 + (four[2] - '0') * 10 + (four[3] - '0');
    if (!alone || value < 1800 || value > 2099) continue;
    if (i > 0 && text[i - 1] == '(' && i + 4 < text.size() && text[i + 4] == ')') return value;
    const bool behind_comma = text.substr(0, i).ends_with(", ") && i + 4 == text.size();
    if (year == 0 || behind_comma) year = value;
  }
  return year;
}

// Drops "(1972)" or ", 1972" from the end.
std::string without_year(std::string text, int year) {
  if (year == 0) return text;
  const std::string digits = std::to_string(year);
  for (const std::string& tail : {"(" + digits + ")", ", " + digits})
    if (text.ends_with(tail)) text.resize(text.size() - tail.size());
  return std::string(trimmed(text, white_commas));
}

// The first of the references, as HTML.
std::string_view first_reference(std::string_view references) {
  if (references.starts_with("1)")) references.remove_prefix(2);
  for (const std::string_view mark : {"<br>", "\n2)", "\n(", "\n[", "\n*"})
    references = references.substr(0, references.find(mark));
  return trimmed(references, white);
}

void read_address(std::string_view tag, Citation& citation) {
  const std::size_t begin = tag.find("http");
  if (begin == tag.npos) return;
  tag.remove_prefix(begin);
  const std::string_view address = trimmed(tag.substr(0, tag.find_first_of("\"'>")), white);
  static constexpr std::string_view resolver = "doi.org/";
  const std::size_t doi = address.find(resolver);
  if (doi == address.npos)
    citation.url = readable(address);
  else
    citation.doi = readable(address.substr(doi + resolver.size()));
}

Citation parse_citation(std::string_view references) {
  Citation citation;
  const std::string_view reference = first_reference(references);
  const std::size_t tag = reference.find("<a ");
  const std::size_t tag_end =
      std::min(reference.find('>', std::min(tag, reference.size())), reference.size());
  std::vector<std::string> before;
  for (const auto line : split_lines(reference.substr(0, tag)))
    if (auto text = plain(line); !trimmed(text, white_stops).empty()) before.push_back(std::move(text));
  if (tag != reference.npos) {
    const std::size_t close = std::min(reference.find("</a>", tag_end), reference.size());
    read_address(reference.substr(tag, tag_end - tag), citation);
    if (tag_end < reference.size())
      citation.published_in = plain(reference.substr(tag_end + 1, close - tag_end - 1));
  } else if (before.size() > 2) {
    citation.published_in = before.back();
    before.pop_back();
  }
  citation.year = find_year(citation.published_in);
  if (citation.year == 0) citation.year = find_year(plain(reference));
  citation.published_in = without_year(citation.published_in, citation.year);

  if (before.empty()) {
    // A maker's catalogue: "SCHOTT Zemax catalog 2017-01-20b" is title and, in its first word, author.
    citation.title = std::exchange(citation.published_in, {});
    const std::size_t maker = citation.title.find(" Zemax");
    if (maker != citation.title.npos) citation.authors.push_back(citation.title.substr(0, maker));
  } else if (before.size() == 1) {
    const std::size_t stop = end_of_authors(before[0]);
    citation.authors = author_list(std::string_view(before[0]).substr(0, stop));
    citation.title = trimmed(std::string_view(before[0]).substr(stop), white_stops);
  } else {
    citation.authors = author_list(before[0]);
    for (std::size_t i = 1; i < before.size(); ++i) citation.title.append(i > 1 ? " " : "").append(before[i]);
    citation.title = std::string(trimmed(citation.title, white_stops));
  }
  return citation;
}

// ---- names

// The page's place in the database: what follows "data/", or the whole path when that is not in it.
std::string_view page_path(std::string_view path) {
  static constexpr std::string_view root = "database/data/";
  const std::size_t at = path.rfind(root);
  return at == path.npos ? path : path.substr(at + root.size());
}

// The page's name in a citation, from its place. Of a path from the root of the file system only the file's
// name is used, because the folders are those of this machine.
std::string page_name(std::string_view place) {
  if (place.starts_with('/')) place.remove_prefix(place.rfind('/') + 1);
  return readable(place.substr(0, place.rfind(".yml")));
}

// The folder of the material ("Ag" of main/Ag/nk/Johnson.yml); pages of makers have none, and their file's
// name takes its place.
std::string_view book(std::string_view path) {
  const std::size_t nk = path.rfind("/nk/");
  if (nk == path.npos) return file_stem(path);
  path = path.substr(0, nk);
  return path.substr(path.rfind('/') + 1);
}

// The name of the page is more reliable than its comments, in which o and e are sometimes confused.
std::string find_axis(std::string_view page, const PageText& text) {
  if (const CrystalAxis* axis = axis_of_page(page)) return std::string(axis->name);
  if (const CrystalAxis* axis = axis_named(text.direction)) return std::string(axis->name);
  const std::string_view comments = text.comments;
  if (comments.find("xtraordinary ray") != comments.npos) return "extraordinary";
  if (comments.find("rdinary ray") != comments.npos) return "ordinary";
  return {};
}

// Whether the comments say that the numbers were measured, by a word or by a method.
bool tells_of_measurement(std::string_view comments) {
  for (const std::string_view words :
       {"easure", "xperiment", "llipsomet", "pectrophotomet", "eflectomet", "efractomet", "nterferomet"})
    if (comments.find(words) != comments.npos) return true;
  return false;
}

// Removes rows of no medium (n below 0, or n = k = 0), which no material may hold. parse_rii_page() accepts
// them because they are not used in 360..830 nm.
void drop_no_medium(OpticalConstants& optics) {
  const Spectrum& all = std::get<Spectrum>(optics.n);
  Spectrum kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all.value[i] < 0 || no_medium_in_row(optics, i)) continue;
    kept.wavelength_nm.push_back(all.wavelength_nm[i]);
    kept.value.push_back(all.value[i]);
  }
  optics.n = std::move(kept);
}

}  // namespace

Citation citation_of_page(const RiiPage& page, std::string_view path) {
  Citation out = parse_citation(text_value(page.references));
  out.licence = "CC0-1.0";
  out.via = "refractiveindex.info " + page_name(page_path(path));
  if (out.title.empty()) out.title = out.via;
  return out;
}

Material material_from_rii_page(std::string_view text, std::string_view path, std::string_view id) {
  RiiPage page;
  parse_rii_page(text, path, page);
  if (page.kind != PageKind::constants)
    throw Error::at(path, "no linear optical constants", "a page with n and k");
  if (!page.refusal.empty()) throw Error::at(path, page.refusal);
  return material_of_page(std::move(page), path, id);
}

Material material_of_page(RiiPage page, std::string_view path, std::string_view id) {
  OpticalConstants& constants = page.constants();
  const PageText words = text_of(page);
  const std::string_view place = page_path(path);

  Dataset dataset;
  dataset.origin = page.flags.has(Flag::computed)                           ? Origin::computed
                   : std::holds_alternative<DispersionFormula>(constants.n) ? Origin::fit
                   : tells_of_measurement(words.comments)                   ? Origin::measured
                                                                            : Origin::unknown;
  if (std::holds_alternative<Spectrum>(constants.n)) {
    drop_no_medium(constants);
    if (std::get<Spectrum>(constants.n).empty())
      throw Error::at(path, "no row with n above 0", "at least one");
  }
  dataset.optics = std::move(page.optics);
  dataset.flags = page.flags;
  dataset.flags.clear(Flag::computed);  // the origin says it
  dataset.temperature_kelvin = words.temperature_kelvin;
  dataset.axis = find_axis(place, words);
  dataset.note = plain(words.comments);
  dataset.citation = citation_of_page(page, path);
  dataset.id = identifier(file_stem(place), '-', "material");
  const std::string year = std::to_string(dataset.citation.year);
  if (dataset.citation.year != 0 && dataset.id.find(year) == dataset.id.npos) dataset.id += "-" + year;

  Material material;
  std::string_view name = book(place);
  material.id = id.empty() ? identifier(name, '_', "material") : std::string(id);
  if (const std::size_t dash = name.find(" - "); dash != name.npos) name.remove_prefix(dash + 3);
  material.preferred_reason = "the only dataset";
  const int year_of_data = dataset.citation.year;
  material.datasets.push_back(std::move(dataset));
  decide_class(material, name);
  // Samples of one metal differ: in a project each has a name of its own.
  const bool differs =
      optical_kind(material.material_class) == "conductor" && place.find("/nk/") != place.npos;
  material.name = readable(differs ? sample_name(name, file_stem(place), year_of_data) : std::string(name));
  return material;
}

}  // namespace etak
