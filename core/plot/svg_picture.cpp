// SPDX-License-Identifier: Apache-2.0
#include "core/plot/svg_picture.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/base/text/text.h"
#include "core/math/functions.h"

namespace etak {
namespace {

using Place = std::complex<double>;  // x + i y
using Line = std::vector<Place>;

double length_of(Place way) {
  return math::hypot(way.real(), way.imag());
}
using Properties = std::map<std::string, std::string, std::less<>>;

// The numbers of a text, whatever stands between them.
std::vector<double> numbers_of(std::string_view text) {
  std::vector<double> out;
  while (!text.empty()) {
    text.remove_prefix(std::min(text.find_first_of("-.0123456789"), text.size()));
    const std::size_t end = std::min(text.find_first_not_of("-.0123456789"), text.size());
    if (double value = 0; parse_number(text.substr(0, end), value)) out.push_back(value);
    text.remove_prefix(end);
  }
  return out;
}

std::string text_of(const Properties& of, std::string_view name) {
  const auto found = of.find(name);
  return found == of.end() ? std::string() : found->second;
}

double number_of(const Properties& of, std::string_view name, double standard = 0) {
  double out = 0;
  return parse_number(text_of(of, name), out) ? out : standard;
}

// A length in units; a share of `all` where it ends in %, and `all` where it is not there.
double length_of(const Properties& of, std::string_view name, double all) {
  const std::string text = text_of(of, name);
  double number = 0;
  if (!parse_number(text.substr(0, text.find('%')), number)) return all;
  return text.ends_with('%') ? all * number / 100 : number;
}

// The text that escape_html() has escaped.
std::string plain(std::string_view text) {
  constexpr std::pair<std::string_view, char> escapes[] = {
      {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&#39;", '\''}};
  std::string out;
  while (!text.empty()) {
    const auto* const found =
        std::ranges::find_if(escapes, [&](const auto& each) { return text.starts_with(each.first); });
    const bool escaped = found != std::end(escapes);
    out += escaped ? found->second : text[0];
    text.remove_prefix(escaped ? found->first.size() : 1);
  }
  return out;
}

// The lines of a path, each of which begins with an M. An arc is half a circle over its two ends.
std::vector<Line> lines_of(std::string_view path) {
  std::vector<Line> out;
  while (!path.empty()) {
    const char command = path[0];
    const std::size_t end = std::min(path.find_first_of("MLHVhA", 1), path.size());
    const std::vector<double> n = numbers_of(path.substr(1, end - 1));
    path.remove_prefix(end);
    if (command == 'M') out.emplace_back();
    Line& line = out.back();
    const Place at = line.empty() ? Place() : line.back();
    if (command == 'H') line.emplace_back(n.at(0), at.imag());
    if (command == 'V') line.emplace_back(at.real(), n.at(0));
    if (command == 'h') line.push_back(at + n.at(0));
    for (int degree = 1; command == 'A' && degree <= 180; ++degree) {
      const double angle = std::numbers::pi * (1 + degree / 180.0);
      line.push_back(at + n.at(0) * Place(1 + math::cos(angle), math::sin(angle)));
    }
    for (std::size_t i = 1; (command == 'M' || command == 'L') && i < n.size(); i += 2)
      line.emplace_back(n[i - 1], n[i]);
  }
  return out;
}

// The line cut into its dashes, which are turns of a length drawn and a length left out.
std::vector<Line> dashes_of(const Line& line, const std::vector<double>& turns) {
  if (turns.empty()) return {line};
  constexpr double step = 0.25;
  std::vector<Line> out;
  double walked = 0, period = 0;
  for (const double turn : turns) period += turn;
  bool drawn = false;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length = length_of(line[i] - line[i - 1]), steps = std::ceil(length / step);
    for (double k = 0; k < steps; ++k, walked += length / steps) {
      double phase = std::fmod(walked, period);
      std::size_t turn = 0;
      while (turn + 1 < turns.size() && phase >= turns[turn]) phase -= turns[turn++];
      if (turn % 2 == 0 && !drawn) out.emplace_back();
      drawn = turn % 2 == 0;
      if (drawn) out.back().push_back(line[i - 1] + (line[i] - line[i - 1]) * (k / steps));
    }
  }
  return out;
}

double distance_to_segment(Place p, Place a, Place b) {
  const double square = std::norm(b - a);
  const double share = square > 0 ? std::clamp(((p - a) * std::conj(b - a)).real() / square, 0.0, 1.0) : 0;
  return length_of(p - a - share * (b - a));
}

// Adds a line with round ends, of which each pixel has its covered part.
void add_segment(Image& coverage, Place a, Place b, double half_width) {
  const auto within = [](double value, int most) { return std::clamp(static_cast<int>(value), 0, most); };
  const double reach = half_width + 1;
  const int last_x = within(std::max(a.real(), b.real()) + reach, coverage.width - 1),
            last_y = within(std::max(a.imag(), b.imag()) + reach, coverage.height - 1);
  for (int y = within(std::min(a.imag(), b.imag()) - reach, last_y); y <= last_y; ++y)
    for (int x = within(std::min(a.real(), b.real()) - reach, last_x); x <= last_x; ++x) {
      const double part = half_width + 0.5 - distance_to_segment({x + 0.5, y + 0.5}, a, b);
      coverage.at(x, y)[0] = std::max(coverage.at(x, y)[0], static_cast<float>(std::clamp(part, 0.0, 1.0)));
    }
}

// Lays a coat of a colour "#rrggbb" over a picture of encoded values.
void cover(Image& picture, const TextPicture& coat, const std::string& color, double opacity = 1) {
  const long code = std::strtol(color.substr(1).c_str(), nullptr, 16);
  const Image& part = coat.coverage;
  for (int y = std::max(0, -coat.top); y < std::min(part.height, picture.height - coat.top); ++y)
    for (int x = std::max(0, -coat.left); x < std::min(part.width, picture.width - coat.left); ++x) {
      const float share = part.at(x, y)[0] * static_cast<float>(opacity);
      const std::span<float> to = picture.at(x + coat.left, y + coat.top);
      for (std::size_t c = 0; c < 3; ++c)
        to[c] += share * (static_cast<float>((code >> (16 - 8 * c)) & 255) / 255 - to[c]);
    }
}

// Names and values: "NAME is VALUE end NAME is VALUE end ...".
std::vector<std::pair<std::string, std::string>> pairs_of(std::string_view text, std::string_view is,
                                                          char end) {
  std::vector<std::pair<std::string, std::string>> out;
  for (std::size_t at = text.find(is); at != text.npos; at = text.find(is)) {
    const std::size_t begin = at + is.size(), last = std::min(text.find(end, begin), text.size());
    out.emplace_back(trimmed(text.substr(0, at), " \n"), trimmed(text.substr(begin, last - begin), " \n"));
    text.remove_prefix(std::min(last + 1, text.size()));
  }
  return out;
}

int whole(double value) {
  return static_cast<int>(std::lround(value));
}

}  // namespace

Image8 svg_picture(std::string_view svg,
                   const std::function<TextPicture(std::string_view text, int size)>& text) {
  std::vector<std::pair<std::string, std::string>> rules;  // of the style sheet: selector and what it sets
  Image picture;
  double scale = 1;  // pixels a unit
  Place moved;       // by the group around the elements
  for (std::size_t at = svg.find('<'); at != svg.npos; at = svg.find('<', at + 1)) {
    const std::size_t end = svg.find('>', at);
    const std::string_view tag = svg.substr(at + 1, end - at - 1),
                           name = tag.substr(0, tag.find_first_of(" /"));
    const std::string_view content = svg.substr(end + 1, svg.find('<', end) - end - 1);
    if (name == "style") rules = pairs_of(content, "{", '}');
    Properties of;
    for (auto& [attribute, value] : pairs_of(tag.substr(name.size()), "=\"", '"')) of[attribute] = value;
    const std::vector<std::string> classes = parts_of(text_of(of, "class"), ' ');
    for (const auto& [selector, sets] : rules)
      if (selector == name || std::ranges::find(classes, selector.substr(1)) != classes.end())
        for (auto& [property, value] : pairs_of(sets, ":", ';')) of[property] = value;
    const Place place = scale * (moved + Place(number_of(of, "x"), number_of(of, "y")));
    if (name == "svg") {
      const std::vector<double> box = numbers_of(text_of(of, "viewBox"));
      scale = number_of(of, "width") / box.at(2);
      picture = Image(whole(scale * box.at(2)), whole(scale * box.at(3)), 3);
    } else if (name == "g") {
      const std::vector<double> by = numbers_of(text_of(of, "transform"));
      moved = {by.at(0), by.at(1)};
    } else if (name == "rect") {
      const int left = whole(place.real()), top = whole(place.imag());
      const int right = whole(place.real() + scale * length_of(of, "width", picture.width / scale)),
                bottom = whole(place.imag() + scale * length_of(of, "height", picture.height / scale));
      cover(picture, {Image(right - left, bottom - top, 1, 1), left, top}, text_of(of, "fill"),
            number_of(of, "fill-opacity", 1));
    } else if (name == "text") {
      TextPicture line = text(plain(content), whole(scale * numbers_of(text_of(of, "font")).at(0)));
      const std::string anchor = text_of(of, "text-anchor");
      const double before = anchor == "middle" ? 0.5 : anchor == "end" ? 1 : 0;  // this share of the width
      line.left += whole(place.real() - before * (line.left + line.coverage.width));
      line.top += whole(place.imag());
      cover(picture, line, text_of(of, "fill"));
    } else if (name == "path") {
      Image coverage(picture.width, picture.height, 1);
      const double half = scale * number_of(of, "stroke-width", 1) / 2;
      for (const Line& line : lines_of(text_of(of, "d")))
        for (const Line& dash : dashes_of(line, numbers_of(text_of(of, "stroke-dasharray"))))
          for (std::size_t i = 0; i < dash.size(); ++i)
            if (i > 0 || dash.size() == 1)
              add_segment(coverage, scale * (dash[i > 0 ? i - 1 : 0] + moved), scale * (dash[i] + moved),
                          half);
      cover(picture, {std::move(coverage)}, text_of(of, "stroke"));
    }
  }
  Image8 out(picture.width, picture.height, 3);
  std::ranges::transform(picture.values, out.values.begin(), to_code);
  return out;
}

}  // namespace etak
