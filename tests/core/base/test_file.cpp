// SPDX-License-Identifier: Apache-2.0
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <thread>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;
namespace fs = std::filesystem;

namespace {
std::size_t entries(const std::string& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}
}  // namespace

TEST_CASE("what was written is read back, bytes of any value") {
  const TempFolder folder;
  std::string bytes;
  for (int i = 0; i < 4096; ++i) bytes.push_back(static_cast<char>(i % 256));
  write_file(folder.file("a"), bytes, false);
  CHECK(read_file(folder.file("a")) == bytes);
  std::string reused = "longer than nothing";
  read_file(folder.file("a"), reused);
  CHECK(reused == bytes);
  write_file(folder.file("empty"), "", false);
  read_file(folder.file("empty"), reused);
  CHECK(reused.empty());
  CHECK(entries(folder.path()) == 2);
}

TEST_CASE("an existing file is replaced only on request") {
  const TempFolder folder;
  write_file(folder.file("a"), "old", false);
  const std::string message = error_of([&] { write_file(folder.file("a"), "new", false); });
  CHECK(contains(message, folder.file("a")));
  CHECK(slurp(folder.file("a")) == "old");
  write_file(folder.file("a"), "new", true);
  CHECK(slurp(folder.file("a")) == "new");
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("a reader sees the old file or the new one and never a part") {
  const TempFolder folder;
  const std::string old(200000, 'o'), fresh(300000, 'n');
  write_file(folder.file("a"), old, false);
  std::atomic<bool> done{false};
  std::thread writer([&] {
    for (int i = 0; i < 20; ++i) write_file(folder.file("a"), i % 2 ? old : fresh, true);
    done = true;
  });
  bool whole = true;
  while (!done) {
    const std::string seen = read_file(folder.file("a"));
    whole = whole && (seen == old || seen == fresh);
  }
  writer.join();
  CHECK(whole);
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("a failed write leaves nothing behind and names the path") {
  const TempFolder folder;
  const std::string message = error_of([&] { write_file(folder.file("absent/a"), "x", true); });
  CHECK(contains(message, folder.file("absent/a")));
  CHECK(!error_of([&] { write_file(folder.path(), "x", true); }).empty());  // a folder
  CHECK(entries(folder.path()) == 0);
}

TEST_CASE("a write that breaks off half-way leaves the old file and no temporary") {
  const TempFolder folder;
  write_file(folder.file("a"), "old", false);
  rlimit before{};
  REQUIRE(::getrlimit(RLIMIT_FSIZE, &before) == 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &small) == 0);
  const std::string message = error_of([&] { write_file(folder.file("a"), std::string(100000, 'x'), true); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  CHECK(contains(message, folder.file("a")));
  CHECK(slurp(folder.file("a")) == "old");
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("writing to a full device is an error") {
  if (!fs::exists("/dev/full")) {
    WARN("no /dev/full here");
    return;
  }
  CHECK(contains(error_of([] { write_file("/dev/full", "x", true); }), "/dev/full"));
  CHECK(fs::is_character_file("/dev/full"));
}

TEST_CASE("a device is written to and never replaced by a file") {
  write_file("/dev/null", "x", false);
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("writing through a symbolic link replaces its target and keeps the link") {
  const TempFolder folder;
  write_file(folder.file("target"), "old", false);
  fs::create_symlink(folder.file("target"), folder.file("link"));
  CHECK(!error_of([&] { write_file(folder.file("link"), "new", false); }).empty());
  write_file(folder.file("link"), "new", true);
  CHECK(fs::is_symlink(folder.file("link")));
  CHECK(slurp(folder.file("target")) == "new");
}

TEST_CASE("reading names what stands in the way") {
  const TempFolder folder;
  SECTION("no such file") {
    CHECK(contains(error_of([&] { read_file(folder.file("absent")); }), folder.file("absent")));
  }
  SECTION("a folder") {
    const std::string message = error_of([&] { read_file(folder.path()); });
    CHECK(contains(message, folder.path()));
    CHECK(contains(message, "folder"));
  }
  SECTION("a FIFO, without waiting for a writer") {
    const std::string path = folder.file("fifo");
    REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
    CHECK(contains(error_of([&] { read_file(path); }), path));
  }
  SECTION("an unreadable file") {
    const std::string path = folder.file("secret");
    spit(path, "x");
    REQUIRE(::chmod(path.c_str(), 0) == 0);
    if (::geteuid() == 0)
      WARN("root may read anything; not checked");
    else
      CHECK(contains(error_of([&] { read_file(path); }), path));
  }
  SECTION("more bytes than allowed") {
    const std::string path = folder.file("large");
    spit(path, std::string(1001, 'x'));
    CHECK(read_file(path, 1001).size() == 1001);
    CHECK(contains(error_of([&] { read_file(path, 1000); }), path));
  }
  SECTION("a gigabyte, refused by its size before it is read") {
    const std::string path = folder.file("giant");
    spit(path, "");
    fs::resize_file(path, std::uintmax_t{1} << 30);  // sparse
    CHECK(contains(error_of([&] { read_file(path); }), path));
  }
}

TEST_CASE("errors are one line: place, what was found, what was expected") {
  CHECK(std::string(Error::at("a.csv", "no rows", "wavelength,n,k").what()) ==
        "a.csv: no rows; expected wavelength,n,k");
  CHECK(std::string(Error::at("--ocio", "empty").what()) == "--ocio: empty");
  CHECK(std::string(Error::at_line("a.csv", 12, "\"x\"", "a number").what()) ==
        "a.csv:12: \"x\"; expected a number");
}

TEST_CASE("foreign bytes are quoted so that a message stays one readable line") {
  CHECK(printable("gold") == "gold");
  CHECK(printable("µm Å") == "µm Å");
  CHECK(printable("a\nb") == "a\\x0ab");
  CHECK(printable(std::string_view("\0\x1b[31m", 6)) == "\\x00\\x1b[31m");
  CHECK(printable("\xff\xc3") == "\\xff\\xc3");
  CHECK(printable(std::string(100, 'x'), 40).size() <= 43);
  CHECK(contains(printable(std::string(100, 'x'), 40), "..."));
}
