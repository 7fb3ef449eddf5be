// SPDX-License-Identifier: Apache-2.0
#include "f0_output.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace bench {
namespace {

/// The fields of one CSV line; a quoted field may hold commas and doubled quotes, not line ends.
std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> out(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"')
      out.back() += line[i++];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      out.emplace_back();
    else if (c != '\r')
      out.back() += c;
  }
  return out;
}

std::size_t column(const std::vector<std::string>& header, const std::string& file, const char* ours,
                   const char* theirs) {
  for (const char* name : {ours, theirs}) {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found != header.end()) return static_cast<std::size_t>(found - header.begin());
  }
  throw std::runtime_error(file + ": no column " + ours + " or " + theirs);
}

}  // namespace

F0Output read_f0_csv(const std::string& file) {
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line)) throw std::runtime_error(file + ": missing or empty");
  const auto header = fields(line);
  const std::size_t name = column(header, file, "path", "name");
  const std::array linear{column(header, file, "r", "R"), column(header, file, "g", "G"),
                          column(header, file, "b", "B")};
  const std::array codes{column(header, file, "u8_r", "r8"), column(header, file, "u8_g", "g8"),
                         column(header, file, "u8_b", "b8")};
  F0Output out;
  while (std::getline(in, line)) {
    const auto row = fields(line);
    if (row.size() != header.size() || row[linear[0]].empty()) continue;
    std::string page = row[name];
    if (page.ends_with(".yml")) page.resize(page.size() - 4);
    F0Values values;
    for (std::size_t c = 0; c < 3; ++c) {
      values.linear[c] = std::strtod(row[linear[c]].c_str(), nullptr);
      values.codes[c] = std::atoi(row[codes[c]].c_str());
    }
    out.emplace(std::move(page), values);
  }
  return out;
}

Deviation deviation(const F0Output& reference, const F0Output& other) {
  Deviation out;
  for (const auto& [page, truth] : reference) {
    const auto found = other.find(page);
    if (found == other.end()) {
      ++out.missing;
      continue;
    }
    ++out.compared;
    int codes = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      codes = std::max(codes, std::abs(found->second.codes[c] - truth.codes[c]));
      const double linear = std::abs(found->second.linear[c] - truth.linear[c]);
      if (linear > out.linear) {
        out.linear = linear;
        out.worst_page = page;
      }
    }
    if (codes > 0) ++out.codes_changed;
    out.codes = std::max(out.codes, codes);
  }
  return out;
}

std::string text(const Deviation& deviation) {
  char out[120];
  std::snprintf(out, sizeof out, "%zu rows%s, |dlin| %.1e, u8 %zu", deviation.compared,
                deviation.missing > 0 ? (" (" + std::to_string(deviation.missing) + " missing)").c_str() : "",
                deviation.linear, deviation.codes_changed);
  return out;
}

}  // namespace bench
