# SPDX-License-Identifier: Apache-2.0
# Writes the header OUT, which holds what a report says of the build. OUT is written only when that changes.
#   SOURCE   folder of the checkout   VERSION   COMPILER   FLAGS   OUT
cmake_minimum_required(VERSION 3.24)
set(commit "")
find_program(GIT git)
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} describe --always --dirty --tags
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT "// Made by study_build.cmake.
#pragma once

namespace etak::report_build {
inline constexpr const char* version = \"@VERSION@\";
inline constexpr const char* commit = \"@commit@\";
inline constexpr const char* compiler = \"@COMPILER@\";
inline constexpr const char* flags = \"@FLAGS@\";
}  // namespace etak::report_build
" @ONLY)
