// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/output_folder.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <thread>

#include "core/base/error.h"
#include "tests/support.h"

namespace etak {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

// Everything in a folder: names (relative) and contents; folders end in '/'.
Files all_in(const std::string& folder) {
  Files out;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).string();
    if (entry.is_directory())
      out[name + "/"] = "";
    else
      out[name] = test::slurp(entry.path().string());
  }
  return out;
}

void put(const std::string& folder, const Files& files, bool overwrite = true) {
  OutputFolder out(folder, overwrite ? Replace::files : Replace::nothing);
  for (const auto& [name, bytes] : files) out.write(name, bytes);
  out.commit();
}

// Runs `act` in a process of its own; 0 when it ended without an Error.
int in_child(const std::function<void()>& act) {
  const pid_t child = ::fork();
  if (child == 0) {
    try {
      act();
    } catch (const Error&) {
      ::_exit(7);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("nothing is seen before the commit, everything after, and nothing stays beside") {
  const test::TempFolder folder;
  const std::string target = folder.file("out");
  {
    OutputFolder out(target, Replace::nothing);
    out.write("a.png", "aa");
    out.write("b.png", [](const auto& sink) {
      for (int i = 0; i < 100000; ++i) sink("0123456789");
    });
    CHECK(!fs::exists(target));
    out.commit();
  }
  CHECK(all_in(target).at("a.png") == "aa");
  CHECK(all_in(target).at("b.png").size() == 1000000);
  CHECK(all_in(folder.path()).size() == 3);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  struct stat info {};
  REQUIRE(::stat(target.c_str(), &info) == 0);
  CHECK((info.st_mode & 0777) == (0777 & ~mask));
}

TEST_CASE("without a commit the target is as it was") {
  const test::TempFolder folder;
  const std::string target = folder.file("out");
  put(target, {{"a", "1"}});
  {
    OutputFolder out(target, Replace::files);
    out.write("a", "2");
    out.write("b", "2");
  }
  CHECK(all_in(folder.path()) == Files{{"out/", ""}, {"out/a", "1"}});
}

TEST_CASE("strangers move along, links and folders too; old files that are named go") {
  const test::TempFolder folder;
  const std::string target = folder.file("out");
  put(target, {{"layout.json", "1"}, {"page0.png", "1"}, {"page1.png", "1"}});
  test::spit(target + "/notes.txt", "mine");
  fs::create_directories(target + "/inner/deep");
  test::spit(target + "/inner/deep/x", "mine too");
  fs::create_symlink("nowhere", target + "/link");
  struct stat before {
  }, after{};
  REQUIRE(::stat((target + "/notes.txt").c_str(), &before) == 0);
  REQUIRE(::chmod(target.c_str(), 0750) == 0);
  {
    OutputFolder out(target, Replace::files);
    out.write("layout.json", "2");
    out.write("page0.png", "2");
    out.remove_old("page1.png");
    out.remove_old("page0.png");
    out.remove_old("never was");
    out.commit();
  }
  CHECK(fs::is_symlink(target + "/link"));
  fs::remove(target + "/link");
  CHECK(all_in(folder.path()) == Files{{"out/", ""},
                                       {"out/layout.json", "2"},
                                       {"out/page0.png", "2"},
                                       {"out/notes.txt", "mine"},
                                       {"out/inner/", ""},
                                       {"out/inner/deep/", ""},
                                       {"out/inner/deep/x", "mine too"}});
  REQUIRE(::stat((target + "/notes.txt").c_str(), &after) == 0);
  CHECK(before.st_ino == after.st_ino);
  REQUIRE(::stat(target.c_str(), &after) == 0);
  CHECK((after.st_mode & 0777) == 0750);
}

TEST_CASE("a name that leads out of the folder is neither written nor removed") {
  const test::TempFolder folder;
  const std::string target = folder.file("out");
  put(target, {{"layout.json", "1"}});
  test::spit(folder.file("victim"), "precious");
  {
    OutputFolder out(target, Replace::files);
    for (const std::string& name :
         {std::string("../victim"), folder.file("victim"), std::string(".."), std::string()}) {
      CHECK_THROWS_AS(out.remove_old(name), Error);
      CHECK_THROWS_AS(out.write(name, "x"), Error);
    }
    out.write("layout.json", "2");
    out.commit();
  }
  CHECK(all_in(folder.path()) == Files{{"out/", ""}, {"out/layout.json", "2"}, {"victim", "precious"}});
}

TEST_CASE("an existing file is an Error unless it may be overwritten; others are not") {
  const test::TempFolder folder;
  const std::string target = folder.file("out");
  put(target, {{"a", "1"}}, false);
  CHECK(test::error_of([&] {
          put(target, {{"a", "2"}, {"b", "2"}}, false);
        }) == target + "/a: exists already; expected a new name, or force to replace it");
  CHECK(all_in(folder.path()) == Files{{"out/", ""}, {"out/a", "1"}});
  put(target, {{"b", "2"}}, false);
  CHECK(all_in(target) == Files{{"a", "1"}, {"b", "2"}});
}

TEST_CASE("a link to a folder stays, a file or a link to nowhere in the way is an Error") {
  const test::TempFolder folder;
  fs::create_directories(folder.file("elsewhere/real"));
  fs::create_directory_symlink("elsewhere/real", folder.file("link"));
  put(folder.file("link"), {{"a", "1"}});
  put(folder.file("link") + "/", {{"a", "2"}});
  CHECK(fs::is_symlink(folder.file("link")));
  CHECK(all_in(folder.file("elsewhere")) == Files{{"real/", ""}, {"real/a", "2"}});
  test::spit(folder.file("file"), "");
  CHECK(
      test::contains(test::error_of([&] { put(folder.file("file"), {}); }), "is a file; expected a folder"));
  fs::create_symlink("nowhere", folder.file("broken"));
  CHECK(test::contains(test::error_of([&] { put(folder.file("broken"), {}); }), "leads nowhere"));
  CHECK(test::contains(test::error_of([&] { put(folder.file("file/such"), {}); }), "cannot be written"));
  CHECK(test::contains(test::error_of([&] { put("", {}); }), "no folder's name"));
}

TEST_CASE("names stay in the folder, are written once, and do not replace folders") {
  const test::TempFolder folder;
  const std::string target = folder.file("out");
  fs::create_directories(target + "/sub");
  OutputFolder out(target, Replace::files);
  for (const char* name : {"", ".", "..", "a/b", "../a", "/a"})
    CHECK(test::contains(test::error_of([&] { out.write(name, "x"); }), "cannot hold a file named"));
  out.write("a", "1");
  CHECK(test::contains(test::error_of([&] { out.write("a", "2"); }), "is written twice"));
  out.write("sub", "a file");
  CHECK(test::contains(test::error_of([&] { out.commit(); }), "out/sub: is a folder"));
  CHECK(all_in(target) == Files{{"sub/", ""}});
}

TEST_CASE("what the writer of a file throws comes out, and the file can be written again") {
  const test::TempFolder folder;
  OutputFolder out(folder.file("out"), Replace::nothing);
  CHECK_THROWS_AS(out.write("a",
                            [](const auto& sink) {
                              sink("half");
                              throw std::runtime_error("stop");
                            }),
                  std::runtime_error);
  out.write("a", "whole");
  out.commit();
  CHECK(all_in(folder.file("out")) == Files{{"a", "whole"}});
}

TEST_CASE("a file can be written piece by piece, and is gone when it is not closed") {
  const test::TempFolder folder;
  const std::string target = folder.file("out");
  {
    OutputFolder out(target, Replace::nothing);
    const auto kept = out.open("kept");
    const std::string large(200'000, 'x');
    kept->add("head");
    kept->add(large);
    kept->patch(1, "EA");
    kept->add("tail");
    { const auto left = out.open("left"); }
    out.write("left", "again");
    kept->close();
    CHECK_THROWS_AS(out.open("kept"), Error);
    out.commit();
    CHECK(all_in(target) == Files{{"kept", "hEAd" + large + "tail"}, {"left", "again"}});
  }
}

TEST_CASE("files are written from several threads") {
  const test::TempFolder folder;
  OutputFolder out(folder.file("out"), Replace::nothing);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 8; ++i) out.write(std::to_string(t) + "-" + std::to_string(i), std::to_string(t));
    });
  for (auto& thread : threads) thread.join();
  out.commit();
  CHECK(all_in(folder.file("out")).size() == 32);
}

TEST_CASE("a full disk is an Error, and the old set stays") {
  const test::TempFolder folder;
  const std::string target = folder.file("out");
  put(target, {{"a", "old"}});
  // A file size limit fails in the same place as a full disk.
  const int status = in_child([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    put(target, {{"a", "new"}, {"b", std::string(100000, 'x')}});
  });
  CHECK(status == 7);
  CHECK(all_in(folder.path()) == Files{{"out/", ""}, {"out/a", "old"}});
}

TEST_CASE("parents that are not there are made, and removed again where nothing is put in place") {
  const test::TempFolder folder;
  {
    OutputFolder lost(folder.file("a/b/c"), Replace::nothing);
    lost.write("x", "1");
    CHECK(fs::is_directory(folder.file("a/b")));
  }
  CHECK_FALSE(fs::exists(folder.file("a")));
  fs::create_directory(folder.file("a"));
  { OutputFolder lost(folder.file("a/b/c"), Replace::nothing); }
  CHECK(all_in(folder.path()) == Files{{"a/", ""}});
  put(folder.file("a/b/c"), {{"x", "1"}});
  CHECK(all_in(folder.path()) == Files{{"a/", ""}, {"a/b/", ""}, {"a/b/c/", ""}, {"a/b/c/x", "1"}});
  test::spit(folder.file("file"), "");
  CHECK(test::contains(test::error_of([&] { put(folder.file("file/out"), {}); }), "cannot be written"));
}

TEST_CASE("below a parent that cannot be written an old target is filled in place, a new one is an Error") {
  const test::TempFolder folder;
  fs::create_directories(folder.file("parent/out"));
  ::chmod(folder.path().c_str(), 0755);
  ::chmod(folder.file("parent/out").c_str(), 0777);
  ::chmod(folder.file("parent").c_str(), 0555);
  const int status = in_child([&] {
    if (::geteuid() == 0 && ::seteuid(65534) != 0) ::_exit(0);
    const std::string target = folder.file("parent/out");
    put(target, {{"layout.json", "1"}, {"a", "1"}, {"old", "1"}});
    OutputFolder out(target, Replace::files);
    out.write("layout.json", "2");
    out.write("a", "2");
    out.remove_old("old");
    out.commit();
    if (all_in(folder.path()) !=
        Files{{"parent/", ""}, {"parent/out/", ""}, {"parent/out/a", "2"}, {"parent/out/layout.json", "2"}})
      ::_exit(1);
    if (!test::contains(test::error_of([&] { put(folder.file("parent/new"), {}); }), "cannot be written"))
      ::_exit(2);
  });
  CHECK(status == 0);
  ::chmod(folder.file("parent").c_str(), 0755);
}

TEST_CASE("the working folder stays the one its shell is in") {
  const test::TempFolder folder;
  const std::string target = folder.file("out");
  put(target, {{"a", "1"}});
  struct stat before {
  }, after{};
  REQUIRE(::stat(target.c_str(), &before) == 0);
  const int status = in_child([&] {
    if (::chdir(target.c_str()) != 0) ::_exit(1);
    put(".", {{"a", "2"}, {"b", "2"}});
    if (test::slurp("a") != "2") ::_exit(2);
  });
  CHECK(status == 0);
  REQUIRE(::stat(target.c_str(), &after) == 0);
  CHECK(before.st_ino == after.st_ino);
  CHECK(all_in(folder.path()) == Files{{"out/", ""}, {"out/a", "2"}, {"out/b", "2"}});
}

TEST_CASE("remains of killed runs go, those of live runs stay, and folders in them go home") {
  const test::TempFolder folder;
  const std::string target = folder.file("out");
  put(target, {{"a", "1"}});
  fs::create_directories(folder.file(".out.etak-abcdef/inner"));
  test::spit(folder.file(".out.etak-abcdef/a"), "half");
  test::spit(folder.file(".out.etak-abcdef/inner/x"), "a stranger's");
  fs::create_directories(folder.file(".out.etak-not-one-of-ours"));
  fs::create_directories(folder.file(".other.etak-abcdef"));
  OutputFolder alive(target, Replace::files);
  alive.write("a", "alive");
  put(target, {{"a", "2"}});
  CHECK(!fs::exists(folder.file(".out.etak-abcdef")));
  CHECK(all_in(target) == Files{{"a", "2"}, {"inner/", ""}, {"inner/x", "a stranger's"}});
  alive.commit();
  CHECK(all_in(target) == Files{{"a", "alive"}, {"inner/", ""}, {"inner/x", "a stranger's"}});
  CHECK(fs::exists(folder.file(".out.etak-not-one-of-ours")));
  CHECK(fs::exists(folder.file(".other.etak-abcdef")));
}

TEST_CASE("killed at any time, the target holds one whole set") {
  const test::TempFolder folder;
  const std::string target = folder.file("out");
  const auto set = [](int number) {
    Files out;
    for (const char* name : {"a.png", "b.png", "c.png", "layout.json"})
      out[name] = std::string(20000, static_cast<char>('0' + number));
    return out;
  };
  const auto start = std::chrono::steady_clock::now();
  put(target, set(0));
  const auto once = std::chrono::steady_clock::now() - start;
  test::spit(target + "/stranger", "mine");
  fs::create_directory(target + "/folder");
  std::mt19937 random(3);
  std::set<char> seen;
  // More and longer rounds where other work on the machine lets few children come as far as a commit.
  for (unsigned round = 0; round < 60 || (seen.size() < 3 && round < 600); ++round) {
    const unsigned longest = 4000 + 200 * (std::max(round, 60U) - 60);
    const pid_t child = ::fork();
    if (child == 0) {
      try {
        for (unsigned i = round;; ++i) put(target, set(static_cast<int>(i % 9) + 1));
      } catch (...) {
      }
      ::_exit(1);
    }
    std::this_thread::sleep_for(once * (random() % longest) / 1000);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const Files found = all_in(target);
    const char number = found.at("layout.json").front();
    seen.insert(number);
    for (const auto& [name, bytes] : set(number - '0')) REQUIRE(found.at(name) == bytes);
    REQUIRE(found.at("stranger") == "mine");
  }
  CHECK(seen.size() > 2);
  // The next run removes what the killed ones left and brings the folder home.
  put(target, set(0));
  Files expected = set(0);
  expected["stranger"] = "mine";
  expected["folder/"] = "";
  CHECK(all_in(target) == expected);
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 1);
}

}  // namespace etak
