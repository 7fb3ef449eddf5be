// SPDX-License-Identifier: Apache-2.0
#include "core/scene/uri.h"

#include <catch2/catch.hpp>

#include "tests/core/scene/small_scene.h"
#include "tests/support.h"

using namespace etak;

TEST_CASE("a relative URI names a file with its escapes undone") {
  CHECK(file_of_uri("a%20b/c%2Epng", "x") == "a b/c.png");
  CHECK(file_of_uri("./..a/b..", "x") == "./..a/b..");
  CHECK(file_of_uri(uri_of_file("ö ü%#?.png"), "x") == "ö ü%#?.png");
}

TEST_CASE("a URI that leaves the scene's folder is refused, however it is written") {
  for (const char* uri :
       {"../a.png", "a/../../b", "%2e%2e/a", "%2E%2E%2Fa", "..%5ca", "/etc/passwd", "%2fetc/passwd",
        "\\\\host\\a", "file:a.png", "https://example.org/a.png", "C:/a.png", "", "a%00b", "a%2", "%zz"})
    CHECK(test::error_of([&] {
            file_of_uri(uri, "scene.gltf#/images/0/uri");
          }).starts_with("scene.gltf#/images/0/uri: "));
}

TEST_CASE("data URIs hold any bytes; broken base64 is refused") {
  std::string bytes;
  for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
  for (std::size_t n = 0; n <= bytes.size(); n += 17)
    CHECK(data_of_uri("data:application/octet-stream;base64," + base64(bytes.substr(0, n)), "x") ==
          bytes.substr(0, n));
  CHECK(data_of_uri("data:text/plain,a%20b", "x") == "a b");
  CHECK(!data_of_uri("data.bin", "x"));
  for (const char* uri : {"data:", "data:;base64,A", "data:;base64,AA?A", "data:;base64,A===", "data:,%4"})
    CHECK(test::error_of([&] { data_of_uri(uri, "x"); }).starts_with("x: "));
}
