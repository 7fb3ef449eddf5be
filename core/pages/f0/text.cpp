// SPDX-License-Identifier: Apache-2.0
// The text forms of an F0 report, CSV for programs and a table for people, and the spread between datasets.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/base/number.h"
#include "core/base/text/csv.h"
#include "core/base/text/text.h"
#include "core/color/srgb.h"
#include "core/pages/f0/report.h"
#include "core/pages/swatch.h"

namespace etak {
namespace {

constexpr int csv_digits = 9;
constexpr int excess_digits = 3;
constexpr std::array channel_letters{'r', 'g', 'b'};

// ---- CSV

// Appends `value` with 9 significant digits: the same text as append_number() gives, in less time, because a
// run over a folder prints eight such numbers a page. Values of common magnitudes are scaled and rounded to a
// whole number of nine digits. Where the scaled value lies nearer to a tie than its own rounding error (below
// 1e-6), the rounding is not certain: then, and for all other magnitudes, append_number() is called.
void append_csv_number(std::string& out, double value) {
  constexpr std::array<double, 5> least{1, 0.1, 0.01, 0.001, 0.0001};
  constexpr std::array<double, 5> scale{1e8, 1e9, 1e10, 1e11, 1e12};
  const double magnitude = std::abs(value);
  if (!(magnitude >= least.back() && magnitude < 10)) return append_number(out, value, csv_digits);
  std::size_t decade = 0;
  while (magnitude < least[decade]) ++decade;
  const double scaled = magnitude * scale[decade];
  const double whole = std::floor(scaled), rest = scaled - whole;
  auto digits = static_cast<std::uint64_t>(whole) + (rest > 0.5 ? 1u : 0u);
  if (std::abs(rest - 0.5) < 1e-6 || digits >= 1'000'000'000) return append_number(out, value, csv_digits);

  std::array<char, 9> text;
  for (std::size_t i = text.size(); i-- > 0; digits /= 10) text[i] = static_cast<char>('0' + digits % 10);
  std::size_t length = text.size();
  while (length > 1 && text[length - 1] == '0') --length;
  if (value < 0) out += '-';
  if (decade == 0) {
    out += text[0];
    if (length > 1) out.append(1, '.').append(text.data() + 1, length - 1);
  } else {
    out.append("0.").append(decade - 1, '0').append(text.data(), length);
  }
}

void append_code(std::string& out, std::uint8_t code) {
  if (code >= 100) out += static_cast<char>('0' + code / 100);
  if (code >= 10) out += static_cast<char>('0' + code / 10 % 10);
  out += static_cast<char>('0' + code % 10);
}

// ---- flags

void append_gamut(std::string& out, const F0Result& result) {
  bool any = false;
  for (std::size_t c = 0; c < 3; ++c) {
    const double excess = result.gamut_excess[c];
    if (excess == 0) continue;
    if (any) out += ';';
    append(out, name(Flag::out_of_gamut), ':', channel_letters[c]);
    if (excess > 0) out += '+';
    append_number(out, excess, excess_digits);
    any = true;
  }
  if (!any) out += name(Flag::out_of_gamut);
}

// ---- table

struct Column {
  std::string title;
  bool right = false;
};

using Cells = std::vector<std::string>;

// "1nm, 3.1e-06"
std::string integration_text(const IntegrationStep& step) {
  std::string out(name(step.method));
  out += ", " + number(step.error, 2);
  return step.within_bound ? out : out + ", above the bound";
}

// The columns that only some tables have, and whether they are there.
struct Extra {
  bool integration = false, kind = false, band = false;
};

void append_last_cells(Cells& cells, const F0Row& row, Extra extra) {
  if (extra.band) cells.push_back(row.band ? fixed(row.band->de90, 1) : "-");
  if (extra.kind) cells.push_back(row.kind.empty() ? "-" : row.kind);
  cells.push_back(line_text(flags_text(row.result)));
}

Cells cells_of(const F0Row& row, Extra extra) {
  const F0Result& r = row.result;
  Cells cells{line_text(row.path)};
  if (r.refused()) {
    cells.resize(extra.integration ? 11 : 10, "-");
    append_last_cells(cells, row, extra);
    return cells;
  }
  for (const double value : vec(r.linear)) cells.push_back(fixed(value, 4));
  cells.push_back(hex(r.srgb8));
  std::string codes;
  for (const int code : {r.srgb8.r, r.srgb8.g, r.srgb8.b}) {
    const std::string text = std::to_string(code);
    codes.append(codes.empty() ? 0 : 1, ' ').append(3 - text.size(), ' ').append(text);
  }
  cells.push_back(codes);
  cells.push_back(fixed(r.luminance, 4));
  std::string edge = "-";
  if (r.f82) edge = fixed(r.f82->r, 4) + " " + fixed(r.f82->g, 4) + " " + fixed(r.f82->b, 4);
  cells.push_back(edge);
  cells.emplace_back(r.zone ? name(*r.zone) : "-");
  cells.push_back(fixed(r.coverage.least(), 4));
  if (extra.integration) cells.push_back(r.integration ? integration_text(*r.integration) : "-");
  append_last_cells(cells, row, extra);
  return cells;
}

// The rows as a table has them: below a row with a coat those of the coat, with names of their own.
std::vector<F0Row> with_coats(std::span<const F0Row> rows) {
  std::vector<F0Row> out;
  for (const F0Row& row : rows) {
    out.push_back(row);
    if (!row.coat) continue;
    const std::pair<const char*, const F0Result&> parts[] = {{"  under the coat", row.coat->under},
                                                             {"  with the coat", row.coat->whole},
                                                             {"  energy left", row.coat->energy_left}};
    for (const auto& [name, result] : parts) {
      F0Row& part = out.emplace_back();
      part.path = name;
      part.result = result;
      part.result.coverage = row.result.coverage;
    }
  }
  return out;
}

constexpr std::size_t swatch_width = 6;  // with the blanks behind it
constexpr std::size_t fold_indent = 4;

// Appends a row, whose first `at` columns are taken by a swatch. A row that is wider than `most` columns (0:
// any width) goes on in an indented line below. All rows break before the same cells, except for the last
// cell, which is not padded and breaks only where its own text does not fit.
void append_line(std::string& out, const Cells& cells, std::span<const Column> columns,
                 std::span<const std::size_t> width, std::size_t most, std::size_t at) {
  std::size_t owed = 0;  // blanks are written only before something, so that no line ends in them
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t taken = i + 1 < cells.size() ? width[i] : display_width(cells[i]);
    if (i > 0 && most > 0 && at + 2 + taken > most && at > fold_indent && taken > 0) {
      out += '\n';
      owed = at = fold_indent;
    } else if (i > 0) {
      owed += 2;
      at += 2;
    }
    at += taken;
    const std::size_t padding = width[i] - display_width(cells[i]);
    if (columns[i].right) owed += padding;
    if (!cells[i].empty()) {
      out.append(owed, ' ').append(cells[i]);
      owed = 0;
    }
    if (!columns[i].right) owed += padding;
  }
  out += '\n';
}

template <class Color, class Value>
void widen(Color& least, Color& most, const Color& value, Value Color::*channel) {
  least.*channel = std::min(least.*channel, value.*channel);
  most.*channel = std::max(most.*channel, value.*channel);
}

}  // namespace

Spread spread(const MaterialReport& report) {
  Spread s;
  for (const F0Result& result : report.results) {
    if (result.refused()) continue;
    if (s.count++ == 0) {
      s.least = s.most = result.linear;
      s.least8 = s.most8 = result.srgb8;
    }
    for (const auto channel : {&LinearRgb::r, &LinearRgb::g, &LinearRgb::b})
      widen(s.least, s.most, result.linear, channel);
    for (const auto channel : {&Srgb8::r, &Srgb8::g, &Srgb8::b})
      widen(s.least8, s.most8, result.srgb8, channel);
  }
  return s;
}

std::string f0_csv_header(F0CsvColumns more) {
  std::string out = "path,coverage,r,g,b,u8_r,u8_g,u8_b,Y,F82_r,F82_g,F82_b,zone,flags,kind";
  if (more.coat) {
    out += ",coat_n";
    for (const char* part : {"under", "under_F82", "coated", "coated_F82", "left"})
      for (const char channel : channel_letters) append(out, ',', part, '_', channel);
  }
  if (more.band) out += ",publications,de50,de90";
  return out + '\n';
}

std::string flags_text(const F0Result& result) {
  std::string out;
  result.flags.for_each([&](Flag flag) {
    if (!out.empty()) out += ';';
    if (flag == Flag::out_of_gamut)
      append_gamut(out, result);
    else
      out += name(flag);
  });
  if (result.refused()) append(out, out.empty() ? "" : ";", "refused: ", result.refusal);
  return out;
}

namespace {

// Appends three fields, empty ones where there is no colour.
void append_numbers(std::string& out, const std::optional<LinearRgb>& color) {
  for (std::size_t c = 0; c < 3; ++c) {
    out += ',';
    if (color) append_csv_number(out, vec(*color)[c]);
  }
}

// All fields but those of a coat and a band.
void append_fields(std::string& out, const F0Row& row) {
  const F0Result& result = row.result;
  append_csv_field(out, row.path);
  if (result.refused()) {
    out += ",,,,,,,,,,,,,";
    append_csv_field(out, flags_text(result));
    append(out, ',', row.kind);
    return;
  }
  const auto add = [&](double value) {
    out += ',';
    append_csv_number(out, value);
  };
  add(result.coverage.least());
  for (const double value : vec(result.linear)) add(value);
  for (const std::uint8_t code : {result.srgb8.r, result.srgb8.g, result.srgb8.b}) {
    out += ',';
    append_code(out, code);
  }
  add(result.luminance);
  append_numbers(out, result.f82);
  append(out, ',', result.zone ? name(*result.zone) : "", ',');
  if (!result.flags.none()) append_csv_field(out, flags_text(result));
  append(out, ',', row.kind);
}

}  // namespace

void append_f0_csv(std::string& out, const F0Row& row, F0CsvColumns more) {
  append_fields(out, row);
  if (more.coat && !row.coat) out.append(16, ',');
  if (more.coat && row.coat) {
    out += ',';
    append_csv_number(out, row.coat->n);
    for (const F0Result* part : {&row.coat->under, &row.coat->whole}) {
      append_numbers(out, part->linear);
      append_numbers(out, part->f82);
    }
    append_numbers(out, row.coat->energy_left.linear);
  }
  if (more.band && !row.band) out += ",,,";
  if (more.band && row.band) {
    append(out, ',', std::to_string(row.band->publications));
    for (const double radius : {row.band->de50, row.band->de90}) {
      out += ',';
      append_csv_number(out, radius);
    }
  }
  out += '\n';
}

std::string f0_table(std::span<const F0Row> given, const F0Options& options, bool color,
                     std::size_t line_width) {
  const std::vector<F0Row> rows = with_coats(given);
  const bool is_xyz = !options.custom_space && options.space == RgbSpace::xyz;
  const std::array<std::string, 3> channel =
      is_xyz ? std::array<std::string, 3>{"X", "Y", "Z"} : std::array<std::string, 3>{"r", "g", "b"};
  // Bare tables and pages of the database do not say of which kind they are: the column may be missing.
  const Extra extra{
      options.method == Method::automatic,
      std::any_of(rows.begin(), rows.end(), [](const F0Row& row) { return !row.kind.empty(); }),
      std::any_of(rows.begin(), rows.end(), [](const F0Row& row) { return row.band.has_value(); })};
  std::vector<Column> columns{{"id"},   {channel[0], true}, {channel[1], true}, {channel[2], true},
                              {"hex"},  {"8 bit", true},    {"Y", true},        {"F82"},
                              {"zone"}, {"coverage", true}, {"flags"}};
  if (extra.integration) columns.insert(columns.end() - 1, {"integration, error"});
  if (extra.band) columns.insert(columns.end() - 1, {"dE 90 %", true});
  if (extra.kind) columns.insert(columns.end() - 1, {"kind"});
  std::vector<Cells> lines{{}};
  for (const Column& column : columns) lines.front().push_back(column.title);
  for (const F0Row& row : rows) lines.push_back(cells_of(row, extra));
  std::vector<std::size_t> width(columns.size(), 0);
  for (const Cells& cells : lines)
    for (std::size_t i = 0; i < cells.size(); ++i) width[i] = std::max(width[i], display_width(cells[i]));

  std::string out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (color && i == 0) out += "      ";
    if (color && i > 0)
      out += rows[i - 1].result.refused() ? "      " : swatch(rows[i - 1].result.srgb8, 4) + "  ";
    append_line(out, lines[i], columns, width, line_width, color ? swatch_width : 0);
  }
  return out;
}

}  // namespace etak
