// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/output_tree.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "core/base/error.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace fs = std::filesystem;

TEST_CASE("files below a folder appear together, and nothing is left of a run that ends before") {
  const TempFolder folder;
  const std::string target = folder.file("out");
  {
    OutputTree tree(target, false);
    tree.write("page.html", "page");
    tree.write("wood/oak/a.png", "oak");
    CHECK_FALSE(fs::exists(target + "/page.html"));
  }
  CHECK_FALSE(fs::exists(target));
  OutputTree tree(target, false);
  tree.write("page.html", "page");
  tree.write("wood/oak/a.png", "oak");
  tree.commit();
  CHECK(slurp(target + "/page.html") == "page");
  CHECK(slurp(target + "/wood/oak/a.png") == "oak");
  // Two files, a folder, and no temporary.
  CHECK(std::distance(fs::directory_iterator(target), fs::directory_iterator()) == 2);
}

TEST_CASE("a tree replaces only what it may, and keeps the rest of its folder") {
  const TempFolder folder;
  const std::string target = folder.file("out");
  fs::create_directories(target + "/b");
  spit(target + "/a", "old");
  spit(target + "/stranger", "stays");
  {
    OutputTree tree(target, false);
    tree.write("a", "new");
    CHECK(contains(error_of([&] { tree.commit(); }), "exists already"));
  }
  CHECK(slurp(target + "/a") == "old");
  {
    OutputTree tree(target, true);
    tree.write("b", "a file");
    CHECK(contains(error_of([&] { tree.commit(); }), "is a folder"));
  }
  OutputTree tree(target, true);
  tree.write("a", "new");
  tree.commit();
  CHECK(slurp(target + "/a") == "new");
  CHECK(slurp(target + "/stranger") == "stays");
}

TEST_CASE("a tree follows no link out of its folder") {
  const TempFolder folder;
  const std::string target = folder.file("out");
  fs::create_directories(target);
  fs::create_directories(folder.file("elsewhere"));
  fs::create_directory_symlink(folder.file("elsewhere"), target + "/wood");
  OutputTree tree(target, true);
  tree.write("wood/a.png", "x");
  CHECK(contains(error_of([&] { tree.commit(); }), "is a link"));
  CHECK(fs::is_empty(folder.file("elsewhere")));
  fs::remove(target + "/wood");
  spit(target + "/wood", "a file");
  {
    OutputTree other(target, true);
    other.write("new/a.png", "x");
    other.write("wood/a.png", "x");
    CHECK(contains(error_of([&] { other.commit(); }), "is a file"));
  }
  CHECK_FALSE(fs::exists(target + "/new"));  // an empty folder of a commit that failed
}

TEST_CASE("a tree takes no name that leads out of it, and no name twice") {
  const TempFolder folder;
  OutputTree tree(folder.file("out"), true);
  for (const char* name : {"../a", "/a", "a/../../b", "", "a//b", "a/"})
    CHECK(contains(error_of([&] { tree.write(name, "x"); }), "cannot hold"));
  tree.write("a", "x");
  CHECK(contains(error_of([&] { tree.write("a", "y"); }), "written twice"));
}
