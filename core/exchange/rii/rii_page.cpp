// SPDX-License-Identifier: Apache-2.0
// Based on the description in the doc folder of the refractiveindex.info database, and on all of its pages.
#include "core/exchange/rii/rii_page.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/spares.h"
#include "core/exchange/rii/rii_rows.h"
#include "core/exchange/rii/yaml_lines.h"
#include "core/material/dispersion.h"
#include "core/material/optics/medium.h"

namespace etak {
namespace {

// One element of the DATA list. The pointers point to a value in the text; null: not given.
struct Entry {
  enum class Type { unknown, table, n2_table, formula };
  const char* where = nullptr;
  Type type = Type::unknown;
  RowKind rows = RowKind::nk;  // of a table
  int formula = 0;             // its number
  const char* range = nullptr;
  const char* coefficients = nullptr;
  const char* data = nullptr;
  const char* unread_rows = nullptr;  // of data that came before its type
};

// Whether the comments say that the numbers come from theory alone. "Ellipsometry and DFT calculations" is a
// measurement, so that the method's name is not enough.
bool tells_of_theory(std::string_view comments) {
  if (comments.find("llipsomet") != comments.npos) return false;
  for (const std::string_view words : {"Theoretical density", "Ab initio calculations", "DFT calculations"})
    if (comments.find(words) != comments.npos) return true;
  return false;
}

// Why n of a table is not positive where it is used, 360..830 nm; empty: it is. A row is used between its neighbours;
// the first and the last one also beyond the table, where their values are held.
std::string sign_refusal(const OpticalConstants& optics, Flags& flags) {
  const auto& n = std::get<Spectrum>(optics.n);
  for (std::size_t i = 0; i < n.size(); ++i) {
    if (n.value[i] > 0 || (n.value[i] == 0 && !no_medium_in_row(optics, i))) continue;
    flags.set(Flag::n_not_positive);
    const bool ends_before = i + 1 < n.size() && n.wavelength_nm[i + 1] <= grid_first_nm;
    const bool starts_behind = i > 0 && n.wavelength_nm[i - 1] >= grid_last_nm;
    if (ends_before || starts_behind) continue;
    return "n = " + number(n.value[i], 6) + " at " + number(n.wavelength_nm[i], 9) +
           " nm is used inside 360..830 nm; n must be positive";
  }
  return {};
}

class PageReader {
 public:
  PageReader(std::string_view text, std::string_view file, RiiPage& page, Rows& rows)
      : text_(text),
        lines_(text, file),
        page_(page),
        optics_(page.optics.index() == 0 ? page.constants() : page.optics.emplace<OpticalConstants>()),
        rows_(rows) {}

  void read() {
    page_.kind = PageKind::other;
    page_.flags = {};
    page_.refusal.clear();
    page_.references = page_.comments = page_.conditions = {};
    bool any_key = false, has_data = false, needs_data = false;
    std::string_view key;
    while (lines_.next_top_key(key)) {
      any_key = true;
      if (key == "DATA") {
        has_data = true;
        read_data();
      } else {
        const char* begin = lines_.at;
        lines_.skip_block(0);
        const std::string_view value(begin, lines_.at);
        if (key == "REFERENCES") page_.references = value;
        if (key == "COMMENTS") page_.comments = value;
        if (key == "CONDITIONS" || key == "SPECS") page_.conditions = value;
        if (key == "COMMENTS" && tells_of_theory(value)) page_.flags.set(Flag::computed);
        needs_data = needs_data || key == "REFERENCES" || key == "COMMENTS" || key == "CONDITIONS" ||
                     key == "PROPERTIES";
      }
    }
    if (has_data) return finish();
    // "About" pages have none of these keys, so the file is a page that was cut short.
    if (needs_data) lines_.fail(lines_.end, "the text ends without DATA", "DATA with tables or formulas");
    if (!any_key && !lines_.is_list()) lines_.fail(lines_.end, "the text ends without a key", "DATA");
    if (const auto zero = text_.find('\0'); zero != text_.npos)
      lines_.fail(text_.data() + zero, "a zero byte", "text");
  }

 private:
  void read_data() {
    const char* where = lines_.at;
    if (!lines_.value().empty())
      lines_.fail(where, "a value behind DATA:", "a list of \"- type: ...\" below it");
    int dash = -1;
    for (;;) {
      const int indent = lines_.next_line();
      if (indent < 0) break;
      const char* item = lines_.at + indent;
      if (!is_dash(item, lines_.end)) {
        if (indent == 0) break;
        lines_.fail_token(item, "\"- type: ...\"");
      }
      if (dash >= 0 && indent != dash) lines_.fail(item, "a list item indented otherwise than the first one");
      dash = indent;
      read_entry(item);
    }
    if (dash < 0) lines_.fail(where, "DATA is empty", "a list of \"- type: ...\" below it");
  }

  // `item` is at the dash.
  void read_entry(const char* item) {
    const char* first = item + 1;
    while (first < lines_.end && *first == ' ') ++first;
    const auto column = static_cast<int>(first - lines_.at);
    Entry entry;
    entry.where = item;
    formula_.coefficients.clear();
    lines_.at = first;
    for (;;) {
      read_entry_key(entry, column);
      const int indent = lines_.next_line();
      if (indent < column) break;
      if (indent > column) lines_.fail_token(lines_.at + indent, "a key in line with \"type:\"");
      lines_.at += indent;
    }
    finish_entry(entry, column);
  }

  void read_entry_key(Entry& entry, int column) {
    const char* where = lines_.at;
    const std::string_view key = lines_.key();
    const char* value_at = lines_.at;
    const auto once = [&](bool given) {
      if (given) lines_.fail(where, std::string(key) + " twice in one entry of DATA");
    };
    if (key == "type") {
      once(entry.type != Entry::Type::unknown);
      set_type(entry, unquoted(lines_.value()), where);
    } else if (key == "wavelength_range" || key == "range") {
      once(entry.range != nullptr);
      entry.range = value_at;
      read_range(value_at);
    } else if (key == "coefficients") {
      once(entry.coefficients != nullptr);
      entry.coefficients = value_at;
      read_numbers(value_at, formula_.coefficients);
    } else if (key == "data") {
      once(entry.data != nullptr);
      entry.data = value_at;
      const std::string_view style = lines_.value();
      if (!style.starts_with('|') || style.find_first_not_of("|+-0123456789") != style.npos)
        lines_.fail(value_at, "data: " + in_quotes(style), "\"data: |\" and rows below it");
      if (entry.type == Entry::Type::table) {
        read_table(entry, column);
      } else {
        entry.unread_rows = lines_.at;
        lines_.skip_block(column);
      }
    } else {
      lines_.fail(where, "the key " + in_quotes(key), "type, wavelength_range, coefficients or data");
    }
  }

  void set_type(Entry& entry, std::string_view type, const char* where) {
    entry.type = Entry::Type::table;
    if (type == "tabulated nk") {
      entry.rows = RowKind::nk;
    } else if (type == "tabulated k") {
      entry.rows = RowKind::k;
    } else if (type == "tabulated n") {
      entry.rows = RowKind::n;
    } else if (type == "tabulated n2") {
      entry.type = Entry::Type::n2_table;
    } else if (type.size() == 9 && type.starts_with("formula ") && type[8] >= '1' && type[8] <= '9') {
      entry.type = Entry::Type::formula;
      entry.formula = type[8] - '0';
    } else {
      lines_.fail(where, "type " + in_quotes(type), "tabulated nk, n, k or n2, or formula 1 to 9");
    }
  }

  void read_numbers(const char* where, std::vector<double>& out) {
    std::string_view text = unquoted(lines_.value());
    out.clear();
    while (!text.empty()) {
      const std::size_t stop = std::min(text.find_first_of(" \t"), text.size());
      double value = 0;
      if (!parse_number(text.substr(0, stop), value))
        lines_.fail(where, in_quotes(text.substr(0, stop)), "a number");
      out.push_back(value);
      text.remove_prefix(std::min(text.find_first_not_of(" \t", stop), text.size()));
    }
  }

  void read_range(const char* where) {
    read_numbers(where, range_um_);
    if (range_um_.size() != 2)
      lines_.fail(where, std::to_string(range_um_.size()) + " numbers",
                  "first and last wavelength in micrometres");
    formula_.first_nm = range_um_[0] * 1000.0;
    formula_.last_nm = range_um_[1] * 1000.0;
  }

  void finish_entry(const Entry& entry, int column) {
    if (entry.type == Entry::Type::unknown) lines_.fail(entry.where, "an entry of DATA without type");
    if (entry.type == Entry::Type::formula) {
      if (entry.data != nullptr) lines_.fail(entry.where, "a formula with data", "coefficients");
      return take_formula(entry);
    }
    if (entry.data == nullptr) lines_.fail(entry.where, "a table without data");
    if (entry.coefficients != nullptr) lines_.fail(entry.where, "a table with coefficients", "data");
    if (entry.unread_rows == nullptr || entry.type == Entry::Type::n2_table) return;
    const char* after = lines_.at;
    lines_.at = entry.unread_rows;
    read_table(entry, column);
    lines_.at = after;
  }

  void read_table(const Entry& entry, int column) {
    read_rows(lines_, column, entry.rows, rows_, page_.flags);
    if (rows_.count == 0) lines_.fail(entry.data, "a table without rows");
    const bool gives_k = entry.rows != RowKind::n;
    // Beside a formula a table of n and k gives k only, wherever in the list it stands.
    const bool gives_n =
        entry.rows == RowKind::n || (entry.rows == RowKind::nk && n_from_ != Source::formula);
    if (gives_k) {
      if (has_k_) lines_.fail(entry.where, "k given twice");
      has_k_ = true;
      if (!optics_.k) optics_.k.emplace();
      rows_.copy(0, optics_.k->wavelength_nm);
      rows_.copy(entry.rows == RowKind::nk ? 2 : 1, optics_.k->value);
    }
    if (gives_n) {
      if (n_from_ != Source::none) lines_.fail(entry.where, "n given twice");
      n_from_ = gives_k ? Source::nk_table : Source::n_table;
      least_n_ = rows_.least_n;
      if (!std::holds_alternative<Spectrum>(optics_.n)) optics_.n.emplace<Spectrum>();
      auto& n = std::get<Spectrum>(optics_.n);
      rows_.copy(0, n.wavelength_nm);
      rows_.copy(1, n.value);
    }
  }

  void take_formula(const Entry& entry) {
    if (n_from_ == Source::formula || n_from_ == Source::n_table) lines_.fail(entry.where, "n given twice");
    if (entry.coefficients == nullptr) lines_.fail(entry.where, "a formula without coefficients");
    if (entry.range == nullptr) lines_.fail(entry.where, "a formula without wavelength_range");
    n_from_ = Source::formula;
    formula_.number = entry.formula;
    // Behind the first coefficient (the ninth of formula 4) they go in pairs; a last one alone has no
    // meaning.
    const std::size_t size = formula_.coefficients.size();
    const bool in_pairs = entry.formula <= 6 && (entry.formula != 4 || size > 9);
    if (in_pairs && size > 0 && size % 2 == 0) {
      formula_.coefficients.pop_back();
      page_.flags.set(Flag::unpaired_coefficient);
    }
    if (const auto found = defect(formula_); !found.empty()) lines_.fail(entry.where, found);
    optics_.n = formula_;
  }

  void finish() {
    if (!has_k_) optics_.k.reset();
    page_.kind = has_k_ || n_from_ != Source::none ? PageKind::constants : PageKind::nonlinear;
    if (n_from_ == Source::none) {
      page_.refusal = has_k_ ? "no n given" : "nonlinear index (n2) only";
      optics_.n.emplace<Spectrum>();
    } else if (n_from_ != Source::formula && least_n_ <= 0) {
      page_.refusal = sign_refusal(optics_, page_.flags);
    }
  }

  enum class Source { none, n_table, nk_table, formula };

  std::string_view text_;
  YamlLines lines_;
  RiiPage& page_;
  OpticalConstants& optics_;  // of page_
  Rows& rows_;
  DispersionFormula formula_;     // the one being read
  std::vector<double> range_um_;  // the same
  Source n_from_ = Source::none;
  bool has_k_ = false;
  double least_n_ = 1;
};

}  // namespace

void parse_rii_page(std::string_view text, std::string_view file, RiiPage& page) {
  // Working memory: how long a table is shows only at its end.
  static Spares<Rows> spares;
  const Spares<Rows>::Taken rows(spares);
  PageReader(text, file, page, *rows).read();
}

}  // namespace etak
