// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/material/f0.h"
#include "core/material/material.h"

namespace etak {

/// One line of an F0 report: what was asked for, where the numbers come from, what came out.
struct F0Row {
  std::string path;  // material id ("gold", "gold/johnson-1972") or the file, relative to the folder given
  std::string name;  // "Gold"; empty for bare files
  std::string material_class;  // empty for bare files
  std::string dataset;         // id; empty for bare files
  std::string source;          // citation in one line; empty when unknown
  F0Result result;
  std::string alias_note = {};  // what must be said of the name that was asked for; may be empty
  std::string kind = {};        // of the dataset: "measured", "fit", "computed"; empty when unknown
  std::string doubt = {};       // why the dataset is doubtful; empty: it is not, or that is unknown
};

/// A library material with the results of all its datasets, for pages and `etak show`.
struct MaterialReport {
  Material material;
  std::vector<F0Result> results;  // one per dataset, same order
};

/// How far the published datasets of a material disagree: least and largest value per channel over the
/// datasets that were not refused. `count` is their number.
struct Spread {
  std::size_t count = 0;
  LinearRgb least, most;
  Srgb8 least8, most8;
};
Spread spread(const MaterialReport& report);

/// `path,coverage,r,g,b,u8_r,u8_g,u8_b,Y,F82_r,F82_g,F82_b,zone,flags,kind` (no policy line: the columns are
/// the interface). Numbers with 9 significant digits; `coverage` is the least of the three weights; F82
/// absolute; zone empty for a surface; flags joined by ';', out-of-gamut with channel and amount
/// ("out-of-gamut:r+0.0428"); a refused row has empty numbers and "refused: REASON" as its last flag; kind
/// empty where it is not known. Fields quoted as RFC 4180 where needed; lines end in '\n'.
std::string f0_csv_header();
void append_f0_csv(std::string& out, std::string_view path, const F0Result& result,
                   std::string_view kind = {});

/// The flags field of the CSV, also used by the table.
std::string flags_text(const F0Result& result);

/// Fixed-width table for people. With `color`, a 24-bit swatch before each row.
///   line_width   columns of the terminal: wider rows go on in a line below; 0: rows are never broken
std::string f0_table(std::span<const F0Row> rows, const F0Options& options, bool color,
                     std::size_t line_width = 0);

/// What a table leaves unsaid: the meaning of the flags that occur, and the policy as the last line.
std::string f0_legend(std::span<const F0Row> rows, const F0Options& options, std::size_t line_width = 0);

/// The choices that move a result most, in a few words: "D65, 1931-2deg observer, linear srgb".
std::string short_policy(const F0Options& options);

/// {"schema": "etak-f0/1", "policy": {...}, "results": [...]} as resources/schema/f0.schema.json describes,
/// two-space indented, numbers as the shortest text that reads back equal.
std::string f0_json(std::span<const F0Row> rows, const F0Options& options);

/// One result per line, each with its own policy (JSON Lines).
std::string f0_jsonl(std::span<const F0Row> rows, const F0Options& options);

/// One material for people: names, spread, and each dataset with its F0, sample, data and source.
///   datasets   ids of those to list; empty: all
///   color      with a swatch behind each F0, for terminals
std::string record_text(const MaterialReport& report, std::span<const std::string> datasets, bool color);

/// The same as {"schema": "etak-show/1", "material": a material file, "spread": {...}, "f0": f0_json()}.
std::string record_json(const MaterialReport& report, const F0Options& options);

/// A self-contained HTML page of the whole library: table with swatches, and per material the record, its
/// datasets with their spread, and inline SVG plots of n, k and R. No script, font or picture from outside.
std::string f0_page(std::span<const MaterialReport> materials, const F0Options& options);

}  // namespace etak
