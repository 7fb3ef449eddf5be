// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "core/base/bytes/decimal_bytes.h"

using namespace etak;

namespace {

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
  return true;
}

bool comes_back(const std::vector<double>& values) {
  std::vector<double> read;
  return read_decimal_bytes(decimal_bytes(values), read) && same_bits(values, read);
}

// So many bytes for each number, without the four of the count and the one of the form.
double bytes_each(const std::vector<double>& values) {
  return (static_cast<double>(decimal_bytes(values).size()) - 5) / static_cast<double>(values.size());
}

}  // namespace

TEST_CASE("every double comes back from its decimal bytes bit for bit") {
  using Limits = std::numeric_limits<double>;
  CHECK(comes_back({}));
  CHECK(comes_back({0}));
  CHECK(comes_back({-0.0}));
  CHECK(comes_back({0, 1, -1, 0.1, 1e22, 1e23, 1e-22, 1e-23, 9007199254740993.0}));
  CHECK(comes_back({Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), Limits::denorm_min()}));
  CHECK(comes_back({Limits::max(), Limits::lowest(), Limits::min(), 1.0 / 3}));
  std::mt19937_64 random(5);
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> any, decimal;
    for (std::uint64_t count = random() % 30; count-- > 0;) {
      any.push_back(std::bit_cast<double>(random()));
      decimal.push_back(static_cast<double>(static_cast<std::int64_t>(random() % 2000001) - 1000000) /
                        std::pow(10, random() % 12));
    }
    REQUIRE(comes_back(any));
    REQUIRE(comes_back(decimal));
  }
}

TEST_CASE("a column of a table takes one to three bytes for each number") {
  std::vector<double> grid, smooth, absorption;
  for (int i = 0; i < 400; ++i) {
    grid.push_back(300 + 5 * i);
    smooth.push_back(std::round((1.5 + 0.2 * std::sin(i / 50.0)) * 1000) / 1000);
    absorption.push_back((100 + i % 900) /
                         std::array{1e3, 1e4, 1e6, 1e7, 1e9}[static_cast<std::size_t>(i % 5)]);
  }
  CHECK(bytes_each(grid) <= 1.02);
  CHECK(bytes_each(smooth) <= 1.02);
  CHECK(bytes_each(absorption) <= 3.1);
  CHECK(comes_back(absorption));
}

TEST_CASE("bytes that are no decimal bytes are refused, and nothing is read beyond their end") {
  const std::string whole = decimal_bytes({1.5, 2.25, 1e-9, 3});
  std::vector<double> read;
  for (std::size_t size = 0; size < whole.size(); ++size)
    CHECK_FALSE(read_decimal_bytes(whole.substr(0, size), read));
  CHECK_FALSE(read_decimal_bytes(whole + "x", read));
  std::string form = whole;
  form[4] = 5;
  CHECK_FALSE(read_decimal_bytes(form, read));
  std::mt19937 random(9);
  for (int i = 0; i < 20000; ++i) {
    std::string bytes = whole;
    for (int change = 0; change < 3; ++change) bytes[random() % bytes.size()] = static_cast<char>(random());
    if (read_decimal_bytes(bytes, read)) REQUIRE(read.size() < bytes.size());
  }
}
