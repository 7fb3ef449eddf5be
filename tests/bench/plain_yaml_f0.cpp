// SPDX-License-Identifier: Apache-2.0
// The job of `etak f0 DIR --format csv` as one would write it in an afternoon: yaml-cpp reads the page, an
// istringstream splits the rows, std::stod reads the numbers. A peer to time ours against, not part of the
// product.
//
//   plain_yaml_f0 DIR OUT.csv      DIR: *.yml pages with tabulated n, k or formula 1
//
// Other formulas are passed over: the one page with `formula 5` beside `tabulated nk` gets n from the table.
// Of etak it uses the CIE tables only; policy as in etak: n and k linear, 1 nm sums, white = 1, piecewise
// sRGB.
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/spectrum/cie.h"

namespace {

using Row = std::vector<double>;

/// Values over wavelength in micrometres.
struct Table {
  std::vector<double> wavelength, value;

  double at(double where) const {
    if (where <= wavelength.front()) return value.front();
    if (where >= wavelength.back()) return value.back();
    const auto next = std::upper_bound(wavelength.begin(), wavelength.end(), where);
    const auto i = static_cast<std::size_t>(next - wavelength.begin());
    const double t = (where - wavelength[i - 1]) / (wavelength[i] - wavelength[i - 1]);
    return value[i - 1] + t * (value[i] - value[i - 1]);
  }
};

Row numbers(const std::string& text) {
  Row out;
  std::istringstream in(text);
  for (std::string word; in >> word;) try {
      out.push_back(std::stod(word));
    } catch (const std::out_of_range&) {
      out.push_back(0);  // std::stod refuses subnormal numbers, and three pages hold some (k of 1e-320)
    }
  return out;
}

/// Rows in ascending order, those of one wavelength joined to their mean.
Table table(std::vector<Row> rows, std::size_t column) {
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a[0] < b[0]; });
  Table out;
  for (std::size_t i = 0; i < rows.size();) {
    std::vector<double> same;
    const double wavelength = rows[i][0];
    for (; i < rows.size() && rows[i][0] == wavelength; ++i)
      if (std::find(same.begin(), same.end(), rows[i].at(column)) == same.end())
        same.push_back(rows[i].at(column));
    double sum = 0;
    for (const double value : same) sum += value;
    out.wavelength.push_back(wavelength);
    out.value.push_back(sum / static_cast<double>(same.size()));
  }
  return out;
}

struct YamlPage {
  std::optional<Table> n, k;
  Row sellmeier, range;  // formula 1

  double n_at(double micrometres) const {
    if (n) return n->at(micrometres);
    const double w = std::clamp(micrometres, range.at(0), range.at(1)), w2 = w * w;
    double square = 1 + sellmeier.at(0);
    for (std::size_t i = 1; i + 1 < sellmeier.size(); i += 2)
      square += sellmeier[i] * w2 / (w2 - sellmeier[i + 1] * sellmeier[i + 1]);
    return std::sqrt(square);
  }
  double k_at(double micrometres) const { return k ? k->at(micrometres) : 0.0; }
};

YamlPage read_page(const std::string& file) {
  YamlPage page;
  for (const auto& entry : YAML::LoadFile(file)["DATA"]) {
    const auto type = entry["type"].as<std::string>();
    if (type == "formula 1") {
      page.sellmeier = numbers(entry["coefficients"].as<std::string>());
      page.range = numbers(entry["wavelength_range"].as<std::string>());
    } else if (type.starts_with("tabulated")) {
      std::vector<Row> rows;
      std::istringstream lines(entry["data"].as<std::string>());
      for (std::string line; std::getline(lines, line);)
        if (Row row = numbers(line); !row.empty()) rows.push_back(std::move(row));
      if (type != "tabulated k") page.n = table(rows, 1);
      if (type == "tabulated k") page.k = table(rows, 1);
      if (type == "tabulated nk") page.k = table(rows, 2);
      if (page.k)
        for (double& k : page.k->value) k = std::max(k, 0.0);
    }
  }
  if (!page.n && page.sellmeier.empty()) throw std::runtime_error("no n");
  return page;
}

/// XYZ to linear sRGB with the white of the weights: R = 1 gives (1, 1, 1).
class Srgb {
 public:
  explicit Srgb(const std::array<double, 3>& white) {
    const double xy[3][2] = {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}};
    for (std::size_t c = 0; c < 3; ++c) {
      to_xyz_[0][c] = xy[c][0] / xy[c][1];
      to_xyz_[1][c] = 1;
      to_xyz_[2][c] = (1 - xy[c][0] - xy[c][1]) / xy[c][1];
    }
    const auto scale = solve(to_xyz_, white);
    for (auto& row : to_xyz_)
      for (std::size_t c = 0; c < 3; ++c) row[c] *= scale[c];
  }
  std::array<double, 3> from_xyz(const std::array<double, 3>& xyz) const { return solve(to_xyz_, xyz); }

 private:
  using Matrix = std::array<std::array<double, 3>, 3>;
  static double determinant(const Matrix& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  }
  static std::array<double, 3> solve(const Matrix& m, const std::array<double, 3>& right) {  // Cramer's rule
    std::array<double, 3> out{};
    for (std::size_t c = 0; c < 3; ++c) {
      Matrix replaced = m;
      for (std::size_t r = 0; r < 3; ++r) replaced[r][c] = right[r];
      out[c] = determinant(replaced) / determinant(m);
    }
    return out;
  }
  Matrix to_xyz_{};
};

int code(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  return static_cast<int>(
      std::floor(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055) + 0.5));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: plain_yaml_f0 DIR OUT.csv\n");
    return 2;
  }
  const auto matching = etak::matching_functions(etak::Observer::cie1931_2deg);
  const auto power = etak::relative_power(etak::Illuminant::d65);
  std::array<double, 3> white{};
  for (std::size_t i = 0; i < etak::grid_size; ++i)
    for (std::size_t c = 0; c < 3; ++c) white[c] += matching[i][c] * power[i];
  const double scale = 1 / white[1];
  const Srgb srgb({white[0] * scale, 1, white[2] * scale});

  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1]))
    if (entry.path().extension() == ".yml") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());

  std::ofstream out(argv[2]);
  out.precision(9);
  out << "name,R,G,B,r8,g8,b8\n";
  for (const auto& file : files) {
    try {
      const YamlPage page = read_page(file);
      std::array<double, 3> xyz{};
      for (std::size_t i = 0; i < etak::grid_size; ++i) {
        const double micrometres = (etak::grid_first_nm + static_cast<double>(i)) / 1000;
        const double n = page.n_at(micrometres), k = page.k_at(micrometres);
        const double reflectance = ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
        for (std::size_t c = 0; c < 3; ++c) xyz[c] += reflectance * matching[i][c] * power[i] * scale;
      }
      const auto rgb = srgb.from_xyz(xyz);
      out << std::filesystem::path(file).stem().string();
      for (const double channel : rgb) out << ',' << channel;
      for (const double channel : rgb) out << ',' << code(channel);
      out << '\n';
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s: %s\n", file.c_str(), error.what());
    }
  }
  return 0;
}
