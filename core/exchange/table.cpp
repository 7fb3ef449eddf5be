// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"
#include "core/exchange/table_columns.h"
#include "core/material/limits.h"
#include "core/material/optics/medium.h"

namespace etak {
namespace {

constexpr double least_reflectance = -0.02;  // noise of a spectrophotometer; more is a wrong unit
constexpr double most_reflectance = 1.02;
// A table without a row in this range has the wrong unit, or is of no use.
constexpr double seen_first_nm = 300;
constexpr double seen_last_nm = 900;
constexpr std::string_view known_columns =
    "wavelength (nm|um|A), energy (eV), n, k, R, R (%), or _ for a column to skip";

struct TableRow {
  double axis = 0;  // as in the file, for messages
  double nm = 0;
  std::array<double, 3> value{};  // n, k, reflectance; those that its block has
  std::size_t line = 0;
};

// Rows under one header.
struct Block {
  std::vector<Column> columns;
  std::size_t line = 0;  // of the header
  WavelengthUnit unit = WavelengthUnit::nanometre;
  std::array<bool, 3> has{};  // n, k, reflectance
  std::vector<TableRow> rows;
};

// The quantities of the three places of a row, which other columns take in their order.
constexpr std::array places{Quantity::n, Quantity::k, Quantity::reflectance};
std::size_t place_of(Quantity quantity) {
  return static_cast<std::size_t>(std::ranges::find(places, quantity) - places.begin());
}

bool is_axis(const Column& column) {
  return column.quantity == Quantity::wavelength || column.quantity == Quantity::energy;
}

// Without a comment, which starts at a '#' outside quotes, and without the end of the line.
std::string_view content(std::string_view line) {
  bool inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') inside = !inside;
    if (line[i] == '#' && !inside) line = line.substr(0, i);
  }
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  return line.find_first_not_of(" \t") == line.npos ? std::string_view() : line;
}

// The blocks of a table with their rows as they stand in the file, and what had to be changed in them.
struct TableBlocks {
  std::vector<Block> blocks;
  Flags flags;
};

// From text to rows.
class TableReader {
 public:
  /// others   how many columns of other quantities than n, k and R; 0: of these
  TableReader(std::string_view text, std::string_view file, const TableOptions& options, std::size_t others)
      : text_(text), file_(file), options_(options), others_(others) {}

  TableBlocks read() {
    if (text_.empty()) throw Error::at(file_, "the file is empty");
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    std::size_t at = 0;
    for (line_ = 1; at < text_.size(); ++line_) {
      const std::size_t stop = std::min(text_.find('\n', at), text_.size());
      next_ = std::min(stop + 1, text_.size());
      if (const auto line = content(text_.substr(at, stop - at)); !line.empty()) read_line(line);
      at = next_;
    }
    if (blocks_.empty()) throw Error::at(file_, "no rows", "a header and rows of numbers");
    return {std::move(blocks_), flags_};
  }

 private:
  [[noreturn]] void fail(std::size_t line, std::string_view found, std::string_view expected = {}) const {
    throw Error::at_line(file_, line, found, expected);
  }

  bool is_data(std::string_view line) {
    double value = 0;
    split_fields(line, find_separator(line), fields_);
    return !fields_.empty() && parse_cell(fields_[0], value);
  }

  void read_line(std::string_view line) {
    if (is_data(line) || (blocks_.empty() && !options_.columns.empty())) {
      if (blocks_.empty()) start_without_header();
      read_row(line);
    } else if (!blocks_.empty() &&
               (!options_.columns.empty() || blocks_.back().rows.empty() || !is_header(line))) {
      fail(line_, fields_.empty() ? in_quotes(line) : in_quotes(fields_[0]), "a finite number");
    } else if (blocks_.size() == (others_ > 0 ? 1 : 2)) {
      fail(line_, others_ > 0 ? "a second header" : "a third header",
           others_ > 0 ? "one" : "at most a block with n and one with k");
    } else {
      read_header(line);
    }
  }

  // True when any field is the name of a column: below rows a header starts the second block, all else is an
  // error.
  static bool is_header(std::string_view line) {
    const auto names = header_names(line, find_separator(line));
    return std::any_of(names.begin(), names.end(), [](const std::string& text) {
      Column column;
      std::string problem;
      return parse_column(text, column, problem);
    });
  }

  // A header has the separator of the numbers below it, which the first line of numbers shows.
  void read_header(std::string_view line) {
    char separator = find_separator(line);
    for (std::size_t at = next_; at < text_.size();) {
      const std::size_t stop = std::min(text_.find('\n', at), text_.size());
      const auto below = content(text_.substr(at, stop - at));
      if (!below.empty()) {
        if (is_data(below)) separator = find_separator(below);
        break;
      }
      at = stop + 1;
    }
    auto names = header_names(line, separator);
    if (names.size() != fields_.size()) names = header_names(line, find_separator(line));
    start_block(names, file_line(), known_columns);
  }

  void start_without_header() {
    if (options_.columns.empty())
      fail(line_, "numbers without a header",
           "a header line without '#', or the columns' names given by " + setting("columns"));
    start_block(options_.columns, setting("columns"), known_columns);
  }

  std::string file_line() const { return std::string(file_) + ":" + std::to_string(line_); }

  void start_block(const std::vector<std::string>& names, std::string_view place, std::string_view expected) {
    Block block;
    block.line = line_;
    std::optional<WavelengthUnit> unit;
    std::size_t axes = 0, others = 0;
    for (const auto& name : names) {
      Column column;
      std::string problem;
      const bool known = parse_column(name, column, problem);
      if (others_ > 0 && !is_axis(column) && name != "_") {
        if (++others == 1 + others_) break;
        column = {places[others - 1], {}, 1};
      } else if (!known) {
        throw Error::at(place, problem, expected);
      }
      block.columns.push_back(column);
      if (column.quantity == Quantity::skipped) continue;
      if (is_axis(column)) {
        ++axes;
        unit = column.unit;
        continue;
      }
      bool& has = block.has[place_of(column.quantity)];
      if (has) throw Error::at(place, "the column " + in_quotes(name) + " twice");
      has = true;
    }
    if (others != others_)
      throw Error::at(place, others < others_ ? "too few columns" : "more columns",
                      "one of wavelength and " + std::to_string(others_) + " more");
    if (axes != 1)
      throw Error::at(place,
                      axes == 0 ? "no column of wavelength or energy" : "more than one column of wavelength",
                      "one");
    if (options_.unit) unit = options_.unit;
    if (!unit)
      throw Error::at(place, "no unit of wavelength",
                      "a header such as \"wavelength (nm)\", or " + setting("unit") + " nm|um|A|eV");
    block.unit = *unit;
    if (block.has == std::array<bool, 3>{}) throw Error::at(place, "no column of n, k or R", expected);
    blocks_.push_back(std::move(block));
  }

  void read_row(std::string_view line) {
    Block& block = blocks_.back();
    split_fields(line, find_separator(line), fields_);
    if (fields_.size() != block.columns.size())
      fail(line_, std::to_string(fields_.size()) + " columns", std::to_string(block.columns.size()));
    TableRow row;
    row.line = line_;
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const Column& column = block.columns[i];
      if (column.quantity == Quantity::skipped) continue;
      double value = 0;
      if (!parse_cell(fields_[i], value)) fail(line_, in_quotes(fields_[i]), "a finite number");
      check_decimal_sign(fields_[i]);
      take(block, column, value, row);
    }
    block.rows.push_back(row);
  }

  // A comma beside numbers with a point would separate thousands.
  void check_decimal_sign(std::string_view field) {
    const std::size_t at = field.find_first_of(".,");
    if (at == field.npos) return;
    if (decimal_sign_ == 0) decimal_sign_ = field[at];
    if (decimal_sign_ != field[at])
      fail(line_, in_quotes(field),
           std::string("a number with '") + decimal_sign_ + "' as those above, or without decimals");
  }

  void take(const Block& block, const Column& column, double value, TableRow& row) {
    const auto shown = [&] { return number(value, 9); };
    if (others_ > 0 && !is_axis(column)) {
      row.value[place_of(column.quantity)] = value;
      return;
    }
    switch (column.quantity) {
      case Quantity::wavelength:
      case Quantity::energy:
        if (value <= 0) fail(line_, "wavelength " + shown(), "a positive number");
        row.axis = value;
        row.nm = to_nm(value, block.unit);
        if (!(row.nm > 0 && row.nm < most_wavelength_nm))
          fail(line_, "wavelength " + shown() + " " + std::string(name(block.unit)),
               "less than a kilometre, not 0");
        break;
      case Quantity::n:
        if (value < 0 || value > most_n) fail(line_, "n = " + shown(), "0 <= n <= 10000");
        row.value[0] = value;
        break;
      case Quantity::k:
        if (value < 0 || value > most_k) fail(line_, "k = " + shown(), "0 <= k <= 1000000");
        row.value[1] = value;
        break;
      case Quantity::reflectance: {
        const double r = value * column.scale;
        if (r < least_reflectance || r > most_reflectance)
          fail(line_, "R = " + shown(),
               column.scale == 1 ? "0 to 1 (in percent: name the column \"R (%)\")" : "0 to 100");
        if (r < 0 || r > 1) flags_.set(Flag::reflectance_clamped);
        row.value[2] = std::clamp(r, 0.0, 1.0);
        break;
      }
      case Quantity::skipped:
        break;
    }
  }

  std::string_view text_, file_;
  const TableOptions& options_;
  std::size_t others_;
  std::size_t line_ = 0, next_ = 0;
  char decimal_sign_ = 0;  // of the first number with decimals
  std::vector<Block> blocks_;
  std::vector<std::string_view> fields_;
  Flags flags_;
};

// From the rows of a file to spectra: sorted, and one row for each wavelength.
class TableRows {
 public:
  TableRows(TableBlocks read, std::string_view file, const TableOptions& options)
      : file_(file), options_(options), blocks_(std::move(read.blocks)), flags_(read.flags) {
    for (Block& block : blocks_) finish(block);
  }

  Table table() const {
    std::array<const Block*, 3> source{};
    for (const Block& block : blocks_)
      for (std::size_t c = 0; c < source.size(); ++c) {
        if (!block.has[c]) continue;
        if (source[c] != nullptr)
          fail(block.line, "the same column in both blocks", "n in one and k in the other");
        source[c] = &block;
      }
    Table table;
    table.flags = flags_;
    if (source[2] != nullptr) {
      if (source[0] != nullptr || source[1] != nullptr)
        fail(source[2]->line, "both R and n or k", "either of them (\"_\" skips a column)");
      table.optics = Reflectance{spectrum(*source[2], 2)};
      return table;
    }
    if (source[0] == nullptr) fail(blocks_[0].line, "k without n", "a column of n");
    OpticalConstants constants;
    constants.n = spectrum(*source[0], 0);
    if (source[1] != nullptr) constants.k = spectrum(*source[1], 1);
    if (const auto nm = no_medium_at(constants))
      for (const TableRow& row : source[0]->rows)
        if (row.nm == *nm) fail(row.line, "n = 0 with k = 0", "n above 0, or k above 0");
    table.optics = std::move(constants);
    return table;
  }

  std::vector<Spectrum> columns(std::size_t count) const {
    std::vector<Spectrum> out;
    for (std::size_t c = 0; c < count; ++c) out.push_back(spectrum(blocks_.front(), c));
    return out;
  }

 private:
  [[noreturn]] void fail(std::size_t line, std::string_view found, std::string_view expected = {}) const {
    throw Error::at_line(file_, line, found, expected);
  }

  // Brings the rows of a block into ascending order of wavelength and merges those of equal wavelength.
  void finish(Block& block) {
    auto& rows = block.rows;
    if (rows.empty()) fail(block.line, "a header without rows", "rows of numbers below it");
    const auto ascends = [](const TableRow& a, const TableRow& b) { return a.nm < b.nm; };
    // A table in ascending energy is in order too.
    if (block.unit == WavelengthUnit::electronvolt && rows.front().nm > rows.back().nm)
      std::reverse(rows.begin(), rows.end());
    if (!std::is_sorted(rows.begin(), rows.end(), ascends)) {
      flags_.set(Flag::unsorted);
      std::stable_sort(rows.begin(), rows.end(), [](const TableRow& a, const TableRow& b) {
        return a.nm < b.nm || (a.nm == b.nm && a.line < b.line);
      });
    }
    check_range(block);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < rows.size();) {
      std::size_t stop = i + 1;
      while (stop < rows.size() && rows[stop].nm == rows[i].nm) ++stop;
      rows[kept++] = stop - i > 1 ? merge(block, i, stop) : rows[i];
      i = stop;
    }
    rows.resize(kept);
  }

  TableRow merge(const Block& block, std::size_t begin, std::size_t end) {
    // The reversal of a table in energies has also reversed the order of equal rows.
    const auto from = block.rows.begin() + static_cast<std::ptrdiff_t>(begin);
    std::vector<TableRow> same(from, from + static_cast<std::ptrdiff_t>(end - begin));
    std::sort(same.begin(), same.end(), [](const TableRow& a, const TableRow& b) { return a.line < b.line; });
    TableRow row = same[0];
    const bool identical = std::all_of(same.begin(), same.end(),
                                       [&](const TableRow& other) { return other.value == row.value; });
    if (!identical && options_.duplicates == Duplicates::refuse)
      fail(same[1].line, "wavelength " + number(row.axis, 9) + " " + std::string(name(block.unit)) + " again",
           "one row for it (the other is in line " + std::to_string(row.line) + "), or " +
               setting("duplicates") + " first|mean");
    flags_.set(identical ? Flag::duplicate_dropped : Flag::duplicate_wavelength);
    if (identical || options_.duplicates == Duplicates::first) return row;
    for (std::size_t c = 0; c < row.value.size(); ++c) {
      double sum = 0;
      for (const TableRow& other : same) sum += other.value[c];
      row.value[c] = sum / static_cast<double>(same.size());
    }
    return row;
  }

  void check_range(const Block& block) const {
    const auto seen = [](double nm) { return nm >= seen_first_nm && nm <= seen_last_nm; };
    const auto& rows = block.rows;
    if (std::any_of(rows.begin(), rows.end(), [&](const TableRow& row) { return seen(row.nm); })) return;
    std::string hint;
    for (const auto unit : {WavelengthUnit::nanometre, WavelengthUnit::micrometre, WavelengthUnit::angstrom,
                            WavelengthUnit::electronvolt}) {
      const bool fits = std::any_of(rows.begin(), rows.end(),
                                    [&](const TableRow& row) { return seen(to_nm(row.axis, unit)); });
      if (fits) hint.append(hint.empty() ? " (they would fit in " : " or ").append(name(unit));
    }
    if (!hint.empty()) hint.append(")");
    fail(block.line,
         "no wavelength inside 300..900 nm: " + number(rows.front().nm, 6) + ".." +
             number(rows.back().nm, 6) + " nm, read in " + std::string(name(block.unit)),
         "visible wavelengths" + hint);
  }

  static Spectrum spectrum(const Block& block, std::size_t place) {
    Spectrum out;
    for (const TableRow& row : block.rows) {
      out.wavelength_nm.push_back(row.nm);
      out.value.push_back(row.value[place]);
    }
    return out;
  }

  std::string_view file_;
  const TableOptions& options_;
  std::vector<Block> blocks_;
  Flags flags_;
};

}  // namespace

Table parse_table(std::string_view text, std::string_view file, const TableOptions& options) {
  return TableRows(TableReader(text, file, options, 0).read(), file, options).table();
}

std::vector<Spectrum> parse_columns(std::string_view text, std::string_view file, std::size_t count,
                                    const TableOptions& options) {
  return TableRows(TableReader(text, file, options, count).read(), file, options).columns(count);
}

}  // namespace etak
