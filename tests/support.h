// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/material/material.h"

/// What the tests share: folders, small tables, and ways to build optics.
namespace etak::test {

/// The root of the source tree.
std::string source_folder();

/// The folder of reference data beside the checkout ($ETAK_SHARED, else ../shared); none when it is absent:
/// tests that need it then say so and pass.
std::optional<std::string> shared_folder();

/// A folder of its own, removed with everything in it.
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

std::string slurp(const std::string& path);
void spit(const std::string& path, std::string_view bytes);

/// Rows of a CSV file with quoted fields; lines that begin with '#' are left out, the header is row 0.
std::vector<std::vector<std::string>> read_csv(const std::string& path);

/// what() of the Error that `act` throws; "" when it throws none.
std::string error_of(const std::function<void()>& act);
bool contains(std::string_view text, std::string_view part);

/// Column `name` of `header`; fails the test when absent.
std::size_t column(const std::vector<std::string>& header, std::string_view name);
double to_number(const std::string& text);

/// first, first + step, ..., last.
std::vector<double> wavelengths(double first, double last, double step);

/// A reflectance over `at_nm` given by a function of wavelength.
Optics reflectance(const std::vector<double>& at_nm, const std::function<double(double)>& r);

/// n and k over `at_nm` given by functions of wavelength.
Optics constants(const std::vector<double>& at_nm, const std::function<double(double)>& n,
                 const std::function<double(double)>& k);

/// The same n at every wavelength in 300..900 nm, no absorption.
Optics glass(double n);

}  // namespace etak::test
