// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/temporary.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <optional>

#include "core/base/files/file.h"
#include "core/base/files/output_file.h"
#include "core/base/files/output_folder.h"
#include "tests/support.h"

namespace etak {
namespace {

namespace fs = std::filesystem;

Descriptor opened(const std::string& folder) {
  return Descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
}

}  // namespace

TEST_CASE("a temporary has a random name beside its target and goes with its object") {
  const test::TempFolder folder;
  const Descriptor open = opened(folder.path());
  {
    const Temporary one(open.get(), "a.json", Temporary::Kind::file);
    const Temporary two(open.get(), "a.json", Temporary::Kind::file);
    const Temporary both(open.get(), "a.json", Temporary::Kind::folder);
    REQUIRE(one);
    REQUIRE(two);
    REQUIRE(both);
    CHECK(one.name() != two.name());
    for (const std::string& name : {one.name(), two.name(), both.name()}) {
      CHECK(name.starts_with(".a.json.etak-"));
      CHECK(name.size() == std::string(".a.json.etak-").size() + 6);
    }
    CHECK(names_in(open.get()).size() == 3);
  }
  CHECK(names_in(open.get()).empty());
}

TEST_CASE("what a killed run left goes with the next run to the same target") {
  const test::TempFolder folder;
  test::spit(folder.file(".a.json.etak-abcdef"), "half");
  test::spit(folder.file(".b.json.etak-abcdef"), "of another target");
  test::spit(folder.file(".a.json.etak-abcdefg"), "not one of ours");
  test::spit(folder.file(".a.json.etak-abc.de"), "nor this one");
  test::spit(folder.file("precious"), "precious");
  fs::create_symlink("precious", folder.file(".a.json.etak-abcdeg"));
  const Descriptor live(::open(folder.file(".a.json.etak-abcdeh").c_str(), O_CREAT | O_WRONLY, 0600));
  REQUIRE(::flock(live.get(), LOCK_EX) == 0);
  write_file(folder.file("a.json"), "new", false);
  const Descriptor open = opened(folder.path());
  CHECK(names_in(open.get()) == std::vector<std::string>{".a.json.etak-abc.de", ".a.json.etak-abcdefg",
                                                         ".a.json.etak-abcdeg", ".a.json.etak-abcdeh",
                                                         ".b.json.etak-abcdef", "a.json", "precious"});
  CHECK(test::slurp(folder.file("precious")) == "precious");
}

TEST_CASE("names up to the longest that the file system takes") {
  const test::TempFolder folder;
  for (const std::size_t length : {200U, 242U, 243U, 246U, 255U}) {
    const std::string name(length, 'n');
    write_file(folder.file(name), "a file", false);
    CHECK(test::slurp(folder.file(name)) == "a file");
    const std::string target = folder.file(std::string(length, 'f'));
    OutputFolder out(target, Replace::nothing);
    out.write("a", "in a folder");
    out.commit();
    CHECK(test::slurp(target + "/a") == "in a folder");
  }
  CHECK(names_in(opened(folder.path()).get()).size() == 10);
  // Two long names with the same beginning do not remove each other's temporaries.
  const Descriptor open = opened(folder.path());
  const Temporary one(open.get(), std::string(254, 'x') + "1", Temporary::Kind::file);
  const Temporary two(open.get(), std::string(254, 'x') + "2", Temporary::Kind::file);
  CHECK(one.name().substr(0, 240) != two.name().substr(0, 240));
}

TEST_CASE("a lock is a file of one's own, which goes with it, and nobody waits without a limit") {
  const test::TempFolder folder;
  const Descriptor open = opened(folder.path()), stranger = opened(folder.path());
  REQUIRE(::flock(stranger.get(), LOCK_EX) == 0);  // whoever may read the folder can
  std::optional<FolderLock> lock(std::in_place, open.get(), std::chrono::milliseconds(30), "a");
  CHECK(lock->held());
  struct stat info {};
  REQUIRE(::stat(folder.file(".a.etak-lock").c_str(), &info) == 0);
  CHECK((info.st_mode & 0777) == 0600);
  const FolderLock late(open.get(), std::chrono::milliseconds(30), "a");
  CHECK(!late.held());
  CHECK(late.is_taken());
  CHECK(FolderLock(open.get(), std::chrono::milliseconds(30), "b").held());
  lock.reset();
  CHECK(names_in(open.get()).empty());
  // What a kill left is taken over; what another user has made and holds is not waited for.
  test::spit(folder.file(".a.etak-lock"), "");
  if (::chown(folder.file(".a.etak-lock").c_str(), 65534, 65534) == 0) {
    const Descriptor held(::open(folder.file(".a.etak-lock").c_str(), O_RDONLY | O_CLOEXEC));
    REQUIRE(::flock(held.get(), LOCK_EX) == 0);
    const FolderLock passed(open.get(), std::chrono::hours(1), "a", open.get());
    CHECK(!passed.held());
    CHECK(!passed.is_taken());
    CHECK(fs::exists(folder.file(".a.etak-lock")));
  }
  lock.emplace(open.get(), std::chrono::milliseconds(30), "a");
  CHECK(lock->held());
  CHECK(!lock->is_taken());
  lock.reset();
  // Where something else has the name, there is no lock, and the work goes on.
  fs::create_directory(folder.file(".a.etak-lock"));
  const FolderLock none(open.get(), std::chrono::milliseconds(30), "a");
  CHECK(!none.held());
  CHECK(!none.is_taken());
}

TEST_CASE("remains are removed by their exact form and their owner, whoever holds the folder's own lock") {
  const test::TempFolder folder;
  const Descriptor stranger = opened(folder.path());
  REQUIRE(::flock(stranger.get(), LOCK_EX) == 0);
  test::spit(folder.file(".a.etak-abcdef"), "half");
  test::spit(folder.file(".a.etak-ab.def"), "not one of ours");
  test::spit(folder.file(".a.etak-abcdeg"), "of another user");
  const bool other = ::chown(folder.file(".a.etak-abcdeg").c_str(), 65534, 65534) == 0;
  write_file(folder.file("a"), "whole", false);
  CHECK(test::slurp(folder.file("a")) == "whole");
  CHECK(!fs::exists(folder.file(".a.etak-abcdef")));
  CHECK(fs::exists(folder.file(".a.etak-ab.def")));
  CHECK(fs::exists(folder.file(".a.etak-abcdeg")) == other);
}

TEST_CASE("outputs of one run are put in place together or not at all") {
  const test::TempFolder folder;
  write_file(folder.file("report"), "old", false);
  {
    OutputFile report(folder.file("report"), "new", true);
    OutputFolder set(folder.file("set"), Replace::nothing);
    set.write("a", "1");
    CHECK(test::slurp(folder.file("report")) == "old");
    CHECK(!fs::exists(folder.file("set")));
    // Somebody else is faster.
    fs::create_directory(folder.file("set"));
    test::spit(folder.file("set/a"), "a stranger's");
    Output* const both[] = {&report, &set};
    CHECK(test::contains(test::error_of([&] { put_in_place(both); }), "set/a: exists already"));
  }
  CHECK(test::slurp(folder.file("report")) == "old");
  CHECK(test::slurp(folder.file("set/a")) == "a stranger's");
  {
    OutputFile report(folder.file("report"), "new", true);
    OutputFolder set(folder.file("set"), Replace::files);
    set.write("a", "2");
    Output* const both[] = {&report, nullptr, &set};
    put_in_place(both);
  }
  CHECK(test::slurp(folder.file("report")) == "new");
  CHECK(test::slurp(folder.file("set/a")) == "2");
  CHECK(names_in(opened(folder.path()).get()) == std::vector<std::string>{"report", "set"});
}

TEST_CASE("a file that appears while another is made for its name is not replaced") {
  const test::TempFolder folder;
  OutputFile late(folder.file("a"), "late", false);
  test::spit(folder.file("a"), "early");
  CHECK(test::contains(test::error_of([&] { late.commit(); }), "exists already"));
  CHECK(test::slurp(folder.file("a")) == "early");
}

TEST_CASE("a folder that nobody may write is replaced by force alone") {
  const test::TempFolder folder;
  const std::string target = folder.file("set");
  fs::create_directory(target);
  test::spit(target + "/a", "kept");
  REQUIRE(::chmod(target.c_str(), 0555) == 0);
  for (const Replace replace : {Replace::nothing, Replace::files})
    CHECK(test::contains(test::error_of([&] { OutputFolder(target, replace); }),
                         "is read-only; expected a folder that may be written, or force"));
  CHECK(test::slurp(target + "/a") == "kept");
  OutputFolder out(target, Replace::anything);
  out.write("a", "replaced");
  out.commit();
  CHECK(test::slurp(target + "/a") == "replaced");
  struct stat info {};
  REQUIRE(::stat(target.c_str(), &info) == 0);
  CHECK((info.st_mode & 0777) == 0555);
  REQUIRE(::chmod(target.c_str(), 0755) == 0);
}

}  // namespace etak
