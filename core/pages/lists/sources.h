// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/material/library.h"

namespace etak {

/// A printed row of one of the three sources (Schueler, Hoffman, TU Graz), with what etak computes for it: a row of
/// resources/sources.csv, whose column `by` says how.
///   printed, value   as many numbers each where both are there, linear where they are reflectances
///   codes            8-bit codes as printed, and of etak's values: by a power 1/2.2 for Schueler, else by sRGB
struct SourceRow {
  std::string source, table, row, by, reason;
  std::vector<double> printed, value;
  std::vector<int> printed_codes, codes;

  /// The largest difference between a printed number and etak's; NaN where one of them is missing.
  double difference() const;
};

/// All rows in the order of the file. Throws Error where the library lacks a material of them.
std::vector<SourceRow> source_rows(const MaterialLibrary& library);

std::string sources_table(const std::vector<SourceRow>& rows);
std::string sources_csv(const std::vector<SourceRow>& rows);
std::string sources_json(const std::vector<SourceRow>& rows);  // resources/schema/sources.schema.json
/// The page resources/doc/sources.md.
std::string sources_markdown(const std::vector<SourceRow>& rows);

}  // namespace etak
