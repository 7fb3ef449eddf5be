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
/// The CSV of one table.
std::string error_time_csv(const ErrorTimeFamily& family, const ErrorTimeTable& table);
/// A scatter plot of the metric table.metrics[table.plotted] over run time, both logarithmic, as an SVG
/// element for an HTML page. Each dot has the number of its row, from 1, and its name where there is room
/// beside it. Empty where no row was timed.
std::string error_time_svg(const ErrorTimeFamily& family, const ErrorTimeTable& table);
/// The CSS rules that error_time_svg() needs in the style sheet of the page.
std::string_view error_time_plot_css();
/// The plot of a table as a file that needs no page: with its colours, a light background and the names of all
/// numbers. Empty where no row was timed.
std::string error_time_svg_file(const ErrorTimeFamily& family, const ErrorTimeTable& table);
/// Strips of a family as an HTML figure, and its CSS rules.
std::string strips_html(const ErrorTimeStrips& strips);
std::string_view strips_css();
/// All families as one HTML page, with plots and tables.
///   stability   table of the stiff and extreme cases from stability_html(); empty: none
std::string error_time_page(const ReportHeader& header, std::span<const ErrorTimeFamily> families,
                            std::string_view stability = {});

}  // namespace etak
