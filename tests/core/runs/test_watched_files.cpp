// SPDX-License-Identifier: Apache-2.0
#include "core/runs/watched_files.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <filesystem>
#include <thread>

#include "tests/support.h"

namespace etak {
namespace {

namespace fs = std::filesystem;

// Whether a change is seen, within some seconds, and none before it. The change must be one step: the watch may look
// between two of them, and would see the second one as a change of its own.
bool sees(WatchedFiles& watched, const std::function<void()>& change) {
  std::atomic<bool> seen{false};
  std::thread waiting([&] {
    watched.wait_for_change();
    seen = true;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  const bool early = seen;
  change();
  waiting.join();
  return !early;
}

}  // namespace

TEST_CASE("a watched folder sees changed, replaced, new and removed files and folders") {
  const test::TempFolder folder, aside;
  test::spit(folder.file("a"), "one");
  test::spit(aside.file("new"), "new");
  fs::create_directories(aside.file("sub/deep"));
  WatchedFiles watched;
  watched.add_folder(folder.path(), true);
  watched.leave_out(folder.file("own"));
  watched.wait_for_change();  // the first call returns at once
  CHECK(sees(watched, [&] { fs::resize_file(folder.file("a"), 5); }));
  CHECK(sees(watched, [&] { fs::rename(aside.file("new"), folder.file("a")); }));
  CHECK(sees(watched, [&] { fs::rename(aside.file("sub"), folder.file("sub")); }));
  CHECK(sees(watched, [&] { test::spit(folder.file("sub/deep/b"), ""); }));
  CHECK(sees(watched, [&] { fs::rename(folder.file("sub"), aside.file("sub")); }));
  // What is left out, and files on their way, are no change.
  CHECK(sees(watched, [&] {
    test::spit(folder.file("own"), "written by the program");
    test::spit(folder.file(".own.etak-abcdef"), "half");
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    fs::remove(folder.file(".own.etak-abcdef"));
    test::spit(folder.file("c"), "c");
  }));
}

TEST_CASE("a watched file may be missing at first, and a change between two calls is not lost") {
  const test::TempFolder folder;
  WatchedFiles watched;
  watched.add_file(folder.file("later"));
  watched.wait_for_change();
  test::spit(folder.file("later"), "here");
  watched.clear();
  watched.add_file(folder.file("later"));
  watched.wait_for_change();
  CHECK(sees(watched, [&] { fs::remove(folder.file("later")); }));
}

}  // namespace etak
