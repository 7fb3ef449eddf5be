// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/study/error_time.h"

namespace etak {

// Error against run time for people and machines: deterministic for equal values.

std::string error_time_json(const ReportHeader& header, std::span<const ErrorTimeFamily> families);
std::string error_time_csv(const ReportHeader& header, std::span<const ErrorTimeFamily> families);
std::string error_time_svg(const ErrorTimeFamily& family, const ErrorTimeTable& table);
/// One HTML file.
///   stability   a table of the stiff and extreme cases (stability_html); empty: none
std::string error_time_page(const ReportHeader& header, std::span<const ErrorTimeFamily> families,
                            std::string_view stability = {});

}  // namespace etak
