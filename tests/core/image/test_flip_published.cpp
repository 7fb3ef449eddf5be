// SPDX-License-Identifier: Apache-2.0
// FLIP against the mean that its authors publish for their pair of pictures; skipped where the pair is
// missing.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>

#include "core/base/files/file.h"
#include "core/image/files/png.h"
#include "core/image/flip.h"
#include "tests/core/image/png_of.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// The folder of reference.png and test.png: $ETAK_FLIP, else data/flip of the shared folder; nullopt where
// there is none.
std::optional<std::string> pictures_folder() {
  std::string folder;
  if (const char* named = std::getenv("ETAK_FLIP"))
    folder = named;
  else if (const auto shared = shared_folder())
    folder = *shared + "/data/flip";
  if (folder.empty() || !std::ifstream(folder + "/reference.png") || !std::ifstream(folder + "/test.png"))
    return {};
  return folder;
}

FlipView seen(const std::string& path) {
  const auto codes = test::read_png8(read_file(path), path);
  REQUIRE(codes);
  return flip_view(*codes);
}

}  // namespace

TEST_CASE("FLIP's mean of its authors' pictures is the published one") {
  const auto folder = pictures_folder();
  if (!folder) {
    WARN("skipped: no reference.png and test.png of FLIP's repository in $ETAK_FLIP or shared data/flip");
    return;
  }
  // The mean is published with six decimals of float arithmetic, the last of which differ between
  // implementations.
  CHECK(flip(seen(*folder + "/reference.png"), seen(*folder + "/test.png")).mean ==
        Approx(0.159691).margin(2e-5));
}
