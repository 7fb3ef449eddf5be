// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/steady_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "core/base/error.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr std::size_t much_of_a_file = std::size_t{64} << 20;

std::string some_bytes(std::size_t count) {
  std::string out(count, '\0');
  for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<char>(i * i / 7 + i);
  return out;
}

// So that a write within a tick of the clock is told from what was there before.
void set_time(const std::string& path, long seconds) {
  const timespec times[2] = {{seconds, 0}, {seconds, 0}};
  REQUIRE(::utimensat(AT_FDCWD, path.c_str(), times, 0) == 0);
}

}  // namespace

TEST_CASE("a file looked at piece by piece, in any order, has the bytes of the whole") {
  const TempFolder folder;
  const std::string path = folder.file("a.bin"), bytes = some_bytes(1000003);
  spit(path, bytes);
  SteadyFile file(path, much_of_a_file);
  REQUIRE(file.size() == bytes.size());
  for (const std::size_t at : {0, 999000, 12, 262143, 262144, 262145, 524000, 1, 1000002, 700000})
    for (const std::size_t count : {0, 1, 8, 65536, 300000})
      if (at + count <= bytes.size()) REQUIRE(file.view(at, count) == bytes.substr(at, count));
  CHECK(file.view(0, bytes.size()) == bytes);
  CHECK(file.all() == bytes);
  CHECK_NOTHROW(file.check_unchanged());
}

TEST_CASE("a file that shrinks between two reads is an error that names it and both sizes") {
  const TempFolder folder;
  const std::string path = folder.file("a.bin");
  spit(path, some_bytes(6000000));
  SteadyFile file(path, much_of_a_file);
  CHECK(file.view(0, 8).size() == 8);
  std::filesystem::resize_file(path, 700000);
  // What lies in the window was read before.
  CHECK(file.view(1000, 8).size() == 8);
  const std::string told = path + ": changed while it was read, found 700000 bytes; expected 6000000 bytes";
  CHECK(error_of([&] { (void)file.view(5000000, 8); }) == told);
  CHECK(error_of([&] { (void)file.view(600000, 200000); }) == told);
  CHECK(error_of([&] { file.check_unchanged(); }) == told);
  CHECK(error_of([&] { (void)file.all(); }) == told);
  CHECK(error_of([&] { file.read_checked([] { throw Error("damaged"); }); }) == told);
  char to[8];
  CHECK(file.read_what_is_there(699996, to, 8) == 4);
}

TEST_CASE("a file that is written or replaced while it is read is told from one that stays") {
  const TempFolder folder;
  const std::string path = folder.file("a.bin");
  spit(path, "0123456789");
  set_time(path, 1000000000);
  const SteadyFile file(path, much_of_a_file);
  CHECK(error_of([&] { file.read_checked([] { throw Error("damaged"); }); }) == "damaged");
  SECTION("other bytes of the same number") {
    spit(path, "0123456780");
    CHECK(error_of([&] { file.check_unchanged(); }) ==
          path + ": changed while it was read; expected a file that stays as it is");
  }
  SECTION("a longer file") {
    spit(path, "0123456789a");
    CHECK(contains(error_of([&] { file.check_unchanged(); }), "found 11 bytes; expected 10 bytes"));
  }
  SECTION("another file of the same size and time") {
    spit(path + ".new", "0123456789");
    set_time(path + ".new", 1000000000);
    std::filesystem::rename(path + ".new", path);
    CHECK(error_of([&] { file.check_unchanged(); }) ==
          path + ": was replaced while it was read; expected a file that stays as it is");
  }
  SECTION("no file any more") {
    std::filesystem::remove(path);
    CHECK(contains(error_of([&] { file.check_unchanged(); }), "was replaced"));
  }
  SECTION("another name for the same file") {
    std::filesystem::create_hard_link(path, path + ".link");
    CHECK_NOTHROW(file.check_unchanged());
  }
}
