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

// What is known of each clear body.
void append_bodies(std::string& out, std::span<const F0Row> rows, std::size_t line_width) {
  bool any = false;
  for (const F0Row& row : rows) {
    if (!row.clear) continue;
    if (!any) out += '\n';
    any = true;
    out += wrapped(line_text(row.path) + ", a clear body: " + clear_body_text(*row.clear), 0, line_width);
  }
}

// How far new publications would lie from each F0.
void append_bands(std::string& out, std::span<const F0Row> rows, std::size_t line_width) {
  bool any = false;
  for (const F0Row& row : rows) {
    if (!row.band) continue;
    if (!any) append(out, '\n', wrapped(band_text, 0, line_width));
    any = true;
    out += wrapped(line_text(row.path) + ": " + words(*row.band), 0, line_width);
  }
}

// What each material reflects on average.
void append_means(std::string& out, std::span<const F0Row> rows, std::size_t line_width) {
  const auto text = [](const LinearRgb& c) {
    return joined(vec(c), " ", [](double value) { return fixed(value, 4); });
  };
  bool any = false;
  for (const F0Row& row : rows) {
    const F0Result& r = row.result;
    if (!r.mean) continue;
    if (!any) out += '\n';
    any = true;
    std::string line = line_text(row.path) + ", mean F over a diffuse hemisphere: " + text(*r.mean);
    if (const auto closed = mean_of_f82(r))
      line += "; of F82's curve through F0 and F82, in closed form: " + text(*closed);
    out += wrapped(line, 0, line_width);
  }
}

constexpr std::string_view coat_text =
    "Under the coat: what the base reflects of light in the coat, F82 at cosine 1/7 in it. With the coat: all that is seen from outside, F82 at cosine 1/7 outside. Energy left: the share of what the base reflects head on that gets out of the coat.";

}  // namespace

std::string f0_legend(std::span<const F0Row> rows, const F0Options& options, std::size_t line_width) {
  std::string out;
  append_meanings(out, rows, line_width);
  append_bodies(out, rows, line_width);
  append_means(out, rows, line_width);
  append_bands(out, rows, line_width);
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
