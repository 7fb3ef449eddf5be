// SPDX-License-Identifier: Apache-2.0
// The text below a table of F0: what its flags mean, and how its numbers were computed.
#include <algorithm>

#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/base/text/wrap.h"
#include "core/pages/f0/report.h"

namespace etak {
namespace {

void append_meanings(std::string& out, std::span<const F0Row> rows, std::size_t line_width) {
  Flags seen;
  for (const F0Row& row : rows) seen |= row.result.flags;
  if (seen.none()) return;
  std::size_t width = 0;
  seen.for_each([&](Flag flag) { width = std::max(width, name(flag).size()); });
  out += '\n';
  seen.for_each([&](Flag flag) {
    // The name of the flag replaces the indentation of the first line.
    std::string lines = wrapped(meaning(flag), width + 2, line_width);
    lines.replace(0, name(flag).size(), name(flag));
    out += lines;
  });
}

constexpr std::string_view band_text =
    "dE 90 %: nine of ten new publications of the material would have an F0 within this CIEDE2000 of the one in the table.";

// A line for each row that has something to tell, and `head` before the first one.
//   told   what stands behind the path of a row; empty: nothing
void append_lines(std::string& out, std::span<const F0Row> rows, std::size_t line_width,
                  std::string_view head, std::string (*told)(const F0Row& row)) {
  bool any = false;
  for (const F0Row& row : rows) {
    const std::string line = told(row);
    if (line.empty()) continue;
    if (!any) append(out, '\n', head);
    any = true;
    out += wrapped(line_text(row.path) + line, 0, line_width);
  }
}

std::string told_body(const F0Row& row) {
  return row.clear ? ", a clear body: " + clear_body_text(*row.clear) : "";
}

// How far new publications would lie from F0.
std::string told_band(const F0Row& row) {
  return row.band ? ": " + words(*row.band) : "";
}

// The share that the material reflects on average.
std::string told_mean(const F0Row& row) {
  if (!row.result.mean) return {};
  const auto text = [](const LinearRgb& c) {
    return joined(vec(c), " ", [](double value) { return fixed(value, 4); });
  };
  const std::string line = ", mean F over a diffuse hemisphere: " + text(*row.result.mean);
  const auto closed = mean_of_f82(row.result);
  return closed ? line + "; of F82's curve through F0 and F82, in closed form: " + text(*closed) : line;
}

constexpr std::string_view coat_text =
    "Under the coat: what the base reflects of light in the coat, F82 at cosine 1/7 in it. With the coat: all that is seen from outside, F82 at cosine 1/7 outside. Energy left: the share of what the base reflects head on that gets out of the coat.";

}  // namespace

std::string f0_legend(std::span<const F0Row> rows, const F0Options& options, std::size_t line_width) {
  std::string out;
  append_meanings(out, rows, line_width);
  append_lines(out, rows, line_width, "", told_body);
  append_lines(out, rows, line_width, "", told_mean);
  append_lines(out, rows, line_width, wrapped(band_text, 0, line_width), told_band);
  if (std::any_of(rows.begin(), rows.end(), [](const F0Row& row) { return row.coat.has_value(); }))
    append(out, '\n', wrapped(coat_text, 0, line_width));
  if (!rows.empty()) out += '\n';
  return out + wrapped(policy(options), 0, line_width);
}

std::string short_policy(const F0Options& options) {
  std::string out(name(options.viewing.illuminant));
  append(out, ", ", name(options.viewing.observer), " observer, ", options.custom_space ? "" : "linear ",
         space_name(options));
  return out;
}

}  // namespace etak
