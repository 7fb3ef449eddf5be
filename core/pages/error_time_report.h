// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/study/error_time.h"

namespace etak {

// Error against run time, for people and programs. Equal values give equal bytes.

/// JSON as resources/schema/error-time.schema.json describes it.
std::string error_time_json(const ReportHeader& header, std::span<const ErrorTimeFamily> families);
/// A line for every metric of every row, below a line of column names; the header is not written.
std::string error_time_csv(const ReportHeader& header, std::span<const ErrorTimeFamily> families);
/// A scatter plot of the metric table.metrics[table.plotted] over run time, both logarithmic, as an SVG
/// element for an HTML page. Empty where no row was timed.
std::string error_time_svg(const ErrorTimeFamily& family, const ErrorTimeTable& table);
/// All families as one HTML page, with plots and tables.
///   stability   table of the stiff and extreme cases from stability_html(); empty: none
std::string error_time_page(const ReportHeader& header, std::span<const ErrorTimeFamily> families,
                            std::string_view stability = {});

}  // namespace etak
