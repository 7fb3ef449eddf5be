// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/certainty/publications.h"
#include "core/exchange/f0_row.h"
#include "core/material/material.h"

namespace etak {

/// A library material with the results of all its datasets, for pages and `etak show`.
struct MaterialReport {
  Material material;
  std::vector<F0Result> results;  // one per dataset, same order
  bool averaged = false;          // over the axes of crystals; such results have no bands
};

/// The band of the preferred dataset, or why it has none.
MaterialBand band_of(const MaterialReport& report);

/// How far the published datasets of a material disagree: the smallest and the largest F0 per channel over
/// the datasets that were not refused. `count` is the number of these datasets.
struct Spread {
  std::size_t count = 0;
  LinearRgb least, most;
  Srgb8 least8, most8;
};
Spread spread(const MaterialReport& report);

/// The CSV form: `path,coverage,r,g,b,u8_r,u8_g,u8_b,Y,F82_r,F82_g,F82_b,zone,flags,kind`. There is no line
/// with the policy, because programs rely on the columns. Numbers have 9 significant digits. `coverage` is
/// the least of the three weights. F82 is absolute. `zone` is empty for a surface. Flags are joined by ';';
/// out-of-gamut names channel and amount ("out-of-gamut:r+0.0428"). A refused row has empty numbers and
/// "refused: REASON" as its last flag. `kind` is empty where it is not known. Fields are quoted as RFC 4180
/// says where that is needed; lines end in '\n'.
///   coat   with the columns of a coat behind them (CoatedF0): coat_n, and r, g, b of F0 and F82 under it, of F0 and F82
///          of the whole, and of what is left, `left_r`; empty of a row without a coat
///   band   with those of Band behind them: publications, de50, de90; empty of a row without a band
struct F0CsvColumns {
  bool coat = false, band = false;
};
std::string f0_csv_header(F0CsvColumns more = {});
void append_f0_csv(std::string& out, const F0Row& row, F0CsvColumns more = {});

/// The flags field of the CSV, also used by the table.
std::string flags_text(const F0Result& result);

/// A table of fixed width for people. Below a row with a coat stand those of CoatedF0.
///   color        a 24-bit swatch stands before each row
///   line_width   columns of the terminal: wider rows go on in a line below; 0: rows are never broken
std::string f0_table(std::span<const F0Row> rows, const F0Options& options, bool color,
                     std::size_t line_width = 0);

/// The text below a table: the meaning of each flag in it, and the policy as the last line.
std::string f0_legend(std::span<const F0Row> rows, const F0Options& options, std::size_t line_width = 0);

/// The choices that move a result most, in a few words: "D65, 1931-2deg observer, linear srgb".
std::string short_policy(const F0Options& options);

/// {"schema": "etak-f0/1", "policy": {...}, "results": [...]} as resources/schema/f0.schema.json describes,
/// two-space indented, numbers as the shortest text that reads back equal.
std::string f0_json(std::span<const F0Row> rows, const F0Options& options);

/// One result per line, each with its own policy (JSON Lines).
std::string f0_jsonl(std::span<const F0Row> rows, const F0Options& options);

/// One material as text for people: names, spread, and each dataset with its F0, sample, data and source.
///   datasets   ids of the datasets to list; empty: all
///   color      a swatch stands behind each F0, for terminals
std::string record_text(const MaterialReport& report, const F0Solver& solver,
                        std::span<const std::string> datasets, bool color);

/// One material as JSON: {"schema": "etak-show/1", "material": {...}, "spread": {...}, "f0": {...}} with the
/// content of a material file as "material" and that of f0_json() as "f0".
std::string record_json(const MaterialReport& report, const F0Solver& solver);

/// An HTML page of a list of materials: a table with swatches, and for each material its datasets, their
/// spread and sources, and plots of n, k and R. The page is one file that needs nothing from the network.
std::string f0_page(std::span<const MaterialReport> materials, const F0Options& options);

}  // namespace etak
