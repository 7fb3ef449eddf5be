// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/material/material.h"

/// Helpers that tests share: folders, small tables, and functions that make optics.
namespace etak::test {

/// The root of the source tree.
std::string source_folder();

/// The folder of reference data beside the checkout ($ETAK_SHARED, else ../shared); none where it is missing.
/// Tests that need it then say so and pass.
std::optional<std::string> shared_folder();

/// A temporary folder; the destructor removes it with everything in it.
class TempFolder {
 public:
  TempFolder();
  ~TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  const std::string& path() const { return path_; }
  std::string file(std::string_view name) const { return path_ + "/" + std::string(name); }

 private:
  std::string path_;
};

std::string slurp(const std::string& path);                  // the bytes of a file
void spit(const std::string& path, std::string_view bytes);  // writes a file

/// The rows of a CSV file, whose fields may be quoted. The header is row 0; lines that begin with '#' are
/// left out.
std::vector<std::vector<std::string>> read_csv(const std::string& path);

/// what() of the Error that `act` throws; empty where it throws none.
std::string error_of(const std::function<void()>& act);
bool contains(std::string_view text, std::string_view part);
/// How often `part`, which is not empty, begins in `text`.
std::size_t count_of(std::string_view text, std::string_view part);

/// The index of the column `name` in `header`; the test fails where there is no such column.
std::size_t column(const std::vector<std::string>& header, std::string_view name);
double to_number(const std::string& text);

/// The wavelengths first, first + step, ..., last.
std::vector<double> wavelengths(double first, double last, double step);

/// A reflectance table with rows at `at_nm` and the values of a function of wavelength.
Optics reflectance(const std::vector<double>& at_nm, const std::function<double(double)>& r);

/// Tables of n and k with rows at `at_nm` and the values of two functions of wavelength.
Optics constants(const std::vector<double>& at_nm, const std::function<double(double)>& n,
                 const std::function<double(double)>& k);

/// Optics with the same n at every wavelength in 300..900 nm and no absorption.
Optics glass(double n);

}  // namespace etak::test
