// SPDX-License-Identifier: Apache-2.0
#include "tests/support.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/base/error.h"
#include "core/base/number.h"

namespace etak::test {

std::string source_folder() {
  return ETAK_SOURCE_FOLDER;
}

std::optional<std::string> shared_folder() {
  const char* named = std::getenv("ETAK_SHARED");
  const std::string folder = named != nullptr ? named : source_folder() + "/../shared";
  if (std::filesystem::is_directory(folder + "/data")) return folder;
  return std::nullopt;
}

TempFolder::TempFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "etak-test-XXXXXX").string();
  const char* made = ::mkdtemp(pattern.data());
  REQUIRE(made != nullptr);
  path_ = made;
}

TempFolder::~TempFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string slurp(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  REQUIRE(in);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void spit(const std::string& path, std::string_view bytes) {
  std::ofstream out(path, std::ios::binary);
  out << bytes;
  REQUIRE(out);
}

std::vector<std::vector<std::string>> read_csv(const std::string& path) {
  std::istringstream in(slurp(path));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"')
        quoted = !quoted;
      else if (c == ',' && !quoted)
        fields.emplace_back();
      else
        fields.back().push_back(c);
    }
    rows.push_back(std::move(fields));
  }
  return rows;
}

std::string error_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

std::size_t count_of(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

std::size_t column(const std::vector<std::string>& header, std::string_view name) {
  for (std::size_t i = 0; i < header.size(); ++i)
    if (header[i] == name) return i;
  FAIL("no column " << name);
  return 0;
}

double to_number(const std::string& text) {
  double value = 0;
  if (!parse_number(text, value)) FAIL("no number: " << text);
  return value;
}

std::vector<double> wavelengths(double first, double last, double step) {
  std::vector<double> out;
  for (int i = 0; first + step * i <= last + step * 1e-9; ++i) out.push_back(first + step * i);
  return out;
}

static Spectrum tabulate(const std::vector<double>& at_nm, const std::function<double(double)>& f) {
  Spectrum s;
  for (const double nm : at_nm) {
    s.wavelength_nm.push_back(nm);
    s.value.push_back(f(nm));
  }
  return s;
}

Optics reflectance(const std::vector<double>& at_nm, const std::function<double(double)>& r) {
  return Reflectance{tabulate(at_nm, r)};
}

Optics constants(const std::vector<double>& at_nm, const std::function<double(double)>& n,
                 const std::function<double(double)>& k) {
  return OpticalConstants{tabulate(at_nm, n), tabulate(at_nm, k)};
}

Optics glass(double n) {
  return constants(
      wavelengths(300, 900, 20), [n](double) { return n; }, [](double) { return 0.0; });
}

}  // namespace etak::test

// Tells the leak checker which leaks are not of etak: OpenImageIO 2.4 keeps the text of a thread's last error
// in memory that it does not free at exit.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:ImageInput::geterror\n";
}
