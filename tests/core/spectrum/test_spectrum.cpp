// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <limits>

#include "core/spectrum/spectrum.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {
std::string complaint(const Spectrum& s) {
  return error_of([&] { validate(s, "n of test"); });
}
}  // namespace

TEST_CASE("a spectrum of finite numbers and strictly ascending positive wavelengths is valid") {
  CHECK(complaint({{400, 500, 600}, {1, 2, 3}}).empty());
  CHECK(complaint({{589.3}, {1.5}}).empty());
  CHECK(complaint({{1e-3, 1e9}, {-1, 0}}).empty());  // sign and size of values depend on the use
}

TEST_CASE("an invalid spectrum is refused with its name and the first offending wavelength") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  CHECK(contains(complaint({}), "n of test"));
  CHECK(!complaint({{400, 500}, {1}}).empty());
  CHECK(contains(complaint({{400, 500, 500, 600}, {1, 2, 3, 4}}), "500"));
  CHECK(contains(complaint({{400, 550, 500}, {1, 2, 3}}), "500"));
  CHECK(contains(complaint({{400, 500, 600}, {1, nan, 3}}), "500"));
  CHECK(contains(complaint({{400, 500, 600}, {1, 2, inf}}), "600"));
  CHECK(!complaint({{400, nan, 600}, {1, 2, 3}}).empty());
  CHECK(!complaint({{nan}, {1}}).empty());
  CHECK(!complaint({{400, inf}, {1, 2}}).empty());
  CHECK(!complaint({{0, 500}, {1, 2}}).empty());
  CHECK(!complaint({{-400, 500}, {1, 2}}).empty());
}
