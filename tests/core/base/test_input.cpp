// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/input.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr std::size_t much = std::size_t{1} << 20;

// Each test has a name of its own: what the user has named stays named as long as the process lives, and
// folders of other tests may have had the same path.
std::string named_pipe(const TempFolder& folder, const char* name) {
  const std::string path = folder.file(name);
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  return path;
}

// Writes `bytes` to a named pipe from another thread, as another program would.
std::thread writer(const std::string& path, std::string bytes) {
  return std::thread([path, bytes = std::move(bytes)] {
    const Descriptor pipe(::open(path.c_str(), O_WRONLY));
    (void)write_all(pipe.get(), bytes);
  });
}

}  // namespace

TEST_CASE("a pipe that the user named is read as often as a file, by any spelling of its path") {
  const TempFolder folder;
  const std::string path = named_pipe(folder, "named.csv");
  CHECK(accept_input(path) == path);
  CHECK(is_pipe_input(path));
  std::string bytes(300000, 'x');
  bytes += "end";
  std::thread other = writer(path, bytes);
  CHECK(read_head(path, 5) == "xxxxx");
  CHECK(read_head(folder.path() + "/./named.csv", 5) == "xxxxx");
  CHECK(read_file(path) == bytes);
  CHECK(read_file(folder.path() + "/../" + folder.path().substr(folder.path().rfind('/') + 1) +
                  "/named.csv") == bytes);
  const OpenedInput opened = open_input(path, much);
  CHECK(opened.size == bytes.size());
  CHECK(::lseek(opened.file.get(), 0, SEEK_CUR) == 0);
  CHECK(contains(error_of([&] { (void)open_input(path, 1000); }), "does not end"));
  other.join();
}

TEST_CASE("a pipe that nobody named is refused without being opened") {
  const TempFolder folder;
  const std::string path = named_pipe(folder, "unnamed.csv");
  CHECK_FALSE(is_pipe_input(path));
  const std::string message = error_of([&] { (void)read_file(path); });
  CHECK(contains(message, path + ": is a pipe"));
  CHECK(contains(message, "command line"));
  CHECK(contains(error_of([&] { (void)read_head(path, 4); }), "is a pipe"));
  // Nobody reads: a writer that does not wait finds no other end.
  CHECK(::open(path.c_str(), O_WRONLY | O_NONBLOCK) == -1);
}

TEST_CASE("a pipe without a writer is waited for no longer than asked") {
  const TempFolder folder;
  const std::string path = named_pipe(folder, "silent.csv");
  (void)accept_input(path);
  set_input_timeout(0.1);
  const auto begin = std::chrono::steady_clock::now();
  const std::string message = error_of([&] { (void)read_file(path); });
  const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - begin;
  set_input_timeout(60);
  CHECK(contains(message, "nothing came from this pipe in 0.1 s"));
  CHECK(contains(message, "or more time by input timeout"));
  CHECK(waited.count() >= 0.1);
  CHECK(waited.count() < 10);
  // A writer that leaves without a word is an empty file.
  std::thread other = writer(path, "");
  CHECK(read_file(path).empty());
  other.join();
}

TEST_CASE("devices, sockets and folders are refused, named by the user or not") {
  const TempFolder folder;
  CHECK(contains(error_of([] { (void)read_file(accept_input("/dev/zero")); }), "/dev/zero: is a device"));
  CHECK(contains(error_of([&] { (void)read_file(folder.path()); }), "is a folder"));
  CHECK(contains(error_of([&] { (void)read_file(folder.file("none")); }), "cannot be opened: No such file"));
  const Descriptor socket(::socket(AF_UNIX, SOCK_STREAM, 0));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string path = folder.file("s");
  REQUIRE(path.size() < sizeof address.sun_path);
  path.copy(&address.sun_path[0], path.size());
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): how the call takes addresses of all kinds
  REQUIRE(::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  CHECK(contains(error_of([&] { (void)read_file(accept_input(path)); }), "s: is a socket"));
}

TEST_CASE("a descriptor has a name that lies in no folder, and is refused where nobody named it") {
  int ends[2] = {-1, -1};
  REQUIRE(::pipe(ends) == 0);
  const Descriptor read_end(ends[0]);
  Descriptor write_end(ends[1]);
  const std::string typed = "/dev/fd/" + std::to_string(read_end.get());
  CHECK(contains(error_of([&] { (void)read_file(typed); }), "is a pipe"));
  REQUIRE(write_all(write_end.get(), "nm n k\n"));
  REQUIRE(write_end.close());
  const std::string path = accept_input(typed);
  CHECK(path == "<fd " + std::to_string(read_end.get()) + ">");
  CHECK(typed_input(path) == typed);
  CHECK(is_pipe_input(path));
  CHECK(read_file(path) == "nm n k\n");
  // The descriptor itself gives the bytes again: to the program that takes this one's place.
  CHECK(read_file(typed) == "nm n k\n");
  CHECK(contains(error_of([] { (void)read_file("<fd 4000>"); }), "cannot be opened"));
}

TEST_CASE("the head of a file is all of it where it is short") {
  const TempFolder folder;
  spit(folder.file("a"), "abc");
  CHECK(read_head(folder.file("a"), 2) == "ab");
  CHECK(read_head(folder.file("a"), 20) == "abc");
  CHECK(contains(error_of([&] { (void)open_input(folder.file("a"), 2); }), "at most 2 bytes"));
}
