// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/output_tree.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <functional>

#include "core/base/error.h"
#include "core/base/files/read_places.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace fs = std::filesystem;

namespace {

// What a commit of a tree says where something happens between its looks and its renames.
std::string error_when(const std::function<void()>& act, OutputTree& tree) {
  struct Late : Output {
    explicit Late(const std::function<void()>& happens) : act(happens) {}
    void prepare() override {}
    void place() override { act(); }
    const std::function<void()>& act;
  };
  Late late(act);
  Output* const both[] = {&tree, &late};
  return error_of([&] { put_in_place(both); });
}

}  // namespace

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

TEST_CASE("a tree does not replace what has appeared since it looked, and undoes what it had placed") {
  const TempFolder folder;
  const std::string target = folder.file("out");
  fs::create_directories(target);
  spit(target + "/a", "old");
  OutputTree tree(target, true);
  tree.write("a", "new");
  tree.write("b", "new");
  tree.write("new/c", "new");
  CHECK(
      contains(error_when([&] { spit(target + "/new/c", "appeared"); }, tree), "out/new/c: exists already"));
  CHECK(slurp(target + "/a") == "old");
  CHECK_FALSE(fs::exists(target + "/b"));
  CHECK(slurp(target + "/new/c") == "appeared");
}

TEST_CASE("a tree undoes what it had placed where one of its folders has gone") {
  const TempFolder folder;
  const std::string target = folder.file("out");
  fs::create_directories(target);
  spit(target + "/a", "old");
  OutputTree tree(target, true);
  for (const char* name : {"a", "b", "first/c", "then/d"}) tree.write(name, "new");
  CHECK(contains(error_when([&] { fs::remove(target + "/then"); }, tree), "out/then: cannot be opened"));
  CHECK(slurp(target + "/a") == "old");
  CHECK(std::distance(fs::directory_iterator(target), fs::directory_iterator()) ==
        1 + 2);  // a, first, temporary
}

TEST_CASE("a tree keeps off the files and folders that the run reads, whatever leads to them") {
  const TempFolder folder;
  const std::string target = folder.file("out");
  fs::create_directories(folder.file("in/wood"));
  fs::create_directories(target);
  const std::vector<std::string> inputs{folder.file("in/wood/a.png")};
  spit(inputs[0], "original");
  fs::create_hard_link(inputs[0], target + "/b.png");
  OutputTree tree(target, true);
  tree.write("b.png", "copy");
  tree.keep_off(std::make_shared<const ReadPlaces>(inputs));
  CHECK(contains(error_of([&] { tree.commit(); }), "out/b.png: is the input"));
  OutputTree inside(folder.file("in"), true);
  inside.write("wood/b.png", "copy");
  inside.keep_off(std::make_shared<const ReadPlaces>(inputs));
  CHECK(contains(error_of([&] { inside.commit(); }), "in/wood/: is or holds"));
  CHECK(slurp(inputs[0]) == "original");
}

TEST_CASE("a file of a tree has the permissions that were asked for, without those of set-user programs") {
  const TempFolder folder;
  OutputTree tree(folder.file("out"), false);
  tree.write("a", "x", 04640);
  tree.write("b", "x", 0604);
  tree.commit();
  CHECK(fs::status(folder.file("out/a")).permissions() == fs::perms(0640));
  CHECK(fs::status(folder.file("out/b")).permissions() == fs::perms(0604));
  const std::vector<std::string> both{folder.file("out/a"), folder.file("out/b"), folder.file("none")};
  CHECK(strictest_mode(both) == 0600);
}
