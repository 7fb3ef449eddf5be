// SPDX-License-Identifier: Apache-2.0
// Nine tenths of a database's bytes are rows of numbers, and reading them is most of the run time: a row goes
// from the text into its columns in one pass, without an allocation, and is judged while it is in registers.
#include "core/exchange/rii/rii_rows.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/material/limits.h"

namespace etak {
namespace {

constexpr double nm_per_um = 1000.0;
constexpr double most_wavelength_um = most_wavelength_nm / nm_per_um;

void grow(Rows& rows, std::size_t least) {
  for (auto& column : rows.values) column.resize(std::max<std::size_t>(1024, 2 * least));
}

// The powers of ten that a double holds exactly.
constexpr std::array<double, 23> exact_powers = [] {
  std::array<double, 23> out{1};
  for (std::size_t i = 1; i < out.size(); ++i) out[i] = out[i - 1] * 10;
  return out;
}();

// Reads a decimal number as pages have them, faster than from_chars and with its result: a product or quotient of
// two numbers that a double holds exactly is rounded once. Returns false, with `at` as it was, for all others.
inline bool read_decimal(const char*& at, const char* end, double& value) {
  const char* here = at;
  const bool negative = *here == '-';
  here += negative;
  std::uint64_t digits = 0;
  const auto take_digits = [&](auto& number) {  // returns how many
    const char* const first = here;
    for (; here < end && is_digit(*here); ++here) number = 10 * number + static_cast<unsigned>(*here - '0');
    return here - first;
  };
  std::ptrdiff_t count = take_digits(digits), power = 0;
  if (here < end && *here == '.') {
    ++here;
    power = -take_digits(digits);
    count -= power;
  }
  if (here + 2 < end && (*here | 32) == 'e') {
    ++here;
    const bool below = *here == '-';
    here += below || *here == '+';
    std::int64_t exponent = 0;
    const std::ptrdiff_t length = take_digits(exponent);
    if (length < 1 || length > 3) return false;
    power += below ? -exponent : exponent;
  }
  const auto steps = static_cast<std::size_t>(std::abs(power));
  constexpr std::ptrdiff_t most_digits = 19;  // of 64 bits
  if (count < 1 || count > most_digits || digits > std::uint64_t{1} << 53 || steps >= exact_powers.size() ||
      here == end || !is_space(*here))
    return false;
  value = static_cast<double>(digits);
  value = power < 0 ? value / exact_powers[steps] : value * exact_powers[steps];
  if (negative) value = -value;
  at = here;
  return true;
}

// One number; `at` stands on its first character and is left behind it.
inline double read_number(const YamlLines& lines, const char*& at) {
  double value = 0;
  if (read_decimal(at, lines.end, value)) return value;
  const char* first = at;
  if (*first == '+') ++first;  // from_chars knows no plus sign
  const auto [stop, status] = std::from_chars(first, lines.end, value);
  if (status != std::errc() || (first != at && *first == '-')) lines.fail_token(at, "a number");
  at = stop;
  return value;
}

// The columns of one row; `at` stands on its first character and is left at the start of the next line.
template <std::size_t columns>
inline std::array<double, columns> read_row(const YamlLines& lines, const char*& at) {
  std::array<double, columns> cell;
  const char* const row = at;
  for (std::size_t c = 0; c < columns; ++c) {
    if (c > 0 && (at == lines.end || *at == '\n'))
      lines.fail(row, "a row of " + std::to_string(c), std::to_string(columns) + " numbers");
    cell[c] = read_number(lines, at);
    if (at == lines.end || *at == '\n') continue;
    if (!is_blank_in_line(*at)) lines.fail_token(at, "a blank behind the number");
    do ++at;
    while (at < lines.end && is_blank_in_line(*at));
  }
  if (at < lines.end) {
    if (*at != '\n') lines.fail_token(at, "the end of a row of " + std::to_string(columns) + " numbers");
    ++at;
  }
  return cell;
}

// Returns whether the wavelengths ascend strictly.
template <RowKind kind>
bool read_all(YamlLines& lines, int indent, Rows& rows, Flags& flags) {
  constexpr std::size_t columns = kind == RowKind::nk ? 3 : 2;
  const char* const end = lines.end;
  const char* at = lines.at;
  std::size_t count = 0;
  std::size_t room = std::min({rows.values[0].size(), rows.values[1].size(), rows.values[2].size()});
  std::array<double*, 3> out{rows.values[0].data(), rows.values[1].data(), rows.values[2].data()};
  double previous = 0, least_n = 1, least_k = 0;
  bool ascending = true;
  while (at < end) {
    const char* const line = at;
    while (at < end && *at == ' ') ++at;
    const auto spaces = at - line;
    while (at < end && is_blank_in_line(*at)) ++at;
    if (at == end) break;
    if (*at == '\n') {
      ++at;
      continue;
    }
    if (spaces <= indent) {
      at = line;
      break;
    }
    auto cell = read_row<columns>(lines, at);
    if (!(cell[0] > 0 && cell[0] <= most_wavelength_um))
      lines.fail(line, "wavelength " + number(cell[0], 9), "a positive number of micrometres");
    if constexpr (kind != RowKind::k) {
      if (!(std::abs(cell[1]) <= most_n)) lines.fail(line, "n = " + number(cell[1], 9), "n up to 10000");
      least_n = std::min(least_n, cell[1]);
    }
    if constexpr (kind != RowKind::n) {
      double& k = cell[columns - 1];
      if (!(std::abs(k) <= most_k)) lines.fail(line, "k = " + number(k, 9), "k up to 1000000");
      least_k = std::min(least_k, k);
      k = std::max(k, 0.0);
    }
    if (count == room) {
      grow(rows, count);
      room = rows.values[0].size();
      for (std::size_t c = 0; c < out.size(); ++c) out[c] = rows.values[c].data();
    }
    cell[0] *= nm_per_um;
    ascending = ascending && cell[0] > previous;
    previous = cell[0];
    for (std::size_t c = 0; c < columns; ++c) out[c][count] = cell[c];
    ++count;
  }
  lines.at = at;
  rows.count = count;
  rows.least_n = least_n;
  if (least_k < 0) flags.set(Flag::negative_k);
  return ascending;
}

// The slow way to strictly ascending wavelengths; one page in a hundred needs it.
void sort_and_merge(Rows& rows, std::size_t columns, Flags& flags) {
  const auto& w = rows.values[0];
  std::vector<std::size_t> order(rows.count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto before = [&](std::size_t a, std::size_t b) { return w[a] < w[b]; };
  if (!std::is_sorted(order.begin(), order.end(), before)) {
    flags.set(Flag::unsorted);
    std::stable_sort(order.begin(), order.end(), before);
  }
  Rows merged;
  grow(merged, rows.count);
  for (std::size_t i = 0; i < rows.count;) {
    std::size_t stop = i + 1;
    while (stop < rows.count && w[order[stop]] == w[order[i]]) ++stop;
    merged.values[0][merged.count] = w[order[i]];
    bool identical = true;
    for (std::size_t c = 1; c < columns; ++c) {
      const auto& from = rows.values[c];
      bool same = true;
      double sum = 0;
      for (std::size_t j = i; j < stop; ++j) {
        sum += from[order[j]];
        same = same && from[order[j]] == from[order[i]];
      }
      merged.values[c][merged.count] = same ? from[order[i]] : sum / static_cast<double>(stop - i);
      identical = identical && same;
    }
    if (stop - i > 1) flags.set(identical ? Flag::duplicate_dropped : Flag::duplicate_wavelength);
    ++merged.count;
    i = stop;
  }
  merged.least_n = rows.least_n;
  rows = std::move(merged);
}

}  // namespace

void read_rows(YamlLines& lines, int indent, RowKind kind, Rows& rows, Flags& flags) {
  const bool ascending = kind == RowKind::nk  ? read_all<RowKind::nk>(lines, indent, rows, flags)
                         : kind == RowKind::n ? read_all<RowKind::n>(lines, indent, rows, flags)
                                              : read_all<RowKind::k>(lines, indent, rows, flags);
  if (!ascending) sort_and_merge(rows, kind == RowKind::nk ? 3 : 2, flags);
}

}  // namespace etak
