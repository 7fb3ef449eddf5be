// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/content_kind.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "tests/support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("content tells its kind by its first bytes") {
  CHECK(content_kind("glTF\x02") == ContentKind::gltf);
  CHECK(content_kind(R"({"accessors": [], "asset": {"version": "2.0"}})") == ContentKind::gltf);
  CHECK(content_kind("\xEF\xBB\xBF {\"schema\": \"etak-material/1\", \"datasets\": []}") ==
        ContentKind::json);
  CHECK(content_kind("# a page\nREFERENCES: |\n  x\nDATA:\n") == ContentKind::page);
  CHECK(content_kind("nm,n,k\n400,1,2\n") == ContentKind::table);
  CHECK(content_kind("# comment\r\n400\t1.5\r\n") == ContentKind::table);
  CHECK(content_kind("\x89PNG\r\n\x1A\n") == ContentKind::binary);
  CHECK(content_kind("") == ContentKind::prose);
  CHECK(content_kind(" \n\n") == ContentKind::prose);
}

TEST_CASE("a table that is broken is a table, prose that speaks of one is not") {
  CHECK(content_kind("wavelength (nm) n k\nx y z\n") == ContentKind::table);
  CHECK(content_kind("wavelength_um;n;kk\n") == ContentKind::table);
  CHECK(content_kind("400 1.5 three\n") == ContentKind::table);
  CHECK(content_kind("The wavelength, n and k of 350 pages were checked.\n2024-01-15: 3 added\n") ==
        ContentKind::prose);
  CHECK(content_kind("1.2.0 first release\n\n* n\n* k\n") == ContentKind::prose);
}

TEST_CASE("every material file of the library is told to be JSON") {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder() + "/materials"))
    if (entry.path().extension() == ".json") {
      INFO(entry.path());
      CHECK(content_kind(slurp(entry.path().string())) == ContentKind::json);
    }
}
