// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/links.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "core/base/error.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

void link_to(const std::string& target, const std::string& path) {
  REQUIRE(::symlink(target.c_str(), path.c_str()) == 0);
}

}  // namespace

TEST_CASE("links that lead out of a document's folder are told with their target") {
  const TempFolder outer;
  std::filesystem::create_directories(outer.file("scene/maps"));
  std::filesystem::create_directories(outer.file("near"));
  spit(outer.file("secret.png"), "x");
  spit(outer.file("scene/a.png"), "x");
  const std::string scene = outer.file("scene"), whole = std::filesystem::canonical(outer.path()).string();
  link_to("../secret.png", scene + "/leak.png");
  link_to(whole + "/near", scene + "/far");
  link_to("a.png", scene + "/other.png");
  link_to("../a.png", scene + "/maps/up.png");
  link_to("leak.png", scene + "/twice.png");
  link_to("nowhere.png", scene + "/dead.png");
  link_to("../scene", outer.file("near/back"));
  link_to(scene, outer.file("typed"));
  const auto refused = [](const std::string& folder, const std::string& name) {
    return error_of([&] { (void)path_beside(folder, name); });
  };
  CHECK(refused(scene, "leak.png") ==
        scene + "/leak.png: is a link to " + whole +
            "/secret.png, out of its folder; expected a file of that folder, or follow links");
  CHECK(contains(refused(scene, "twice.png"), "/twice.png: is a link to " + whole + "/secret.png"));
  CHECK(contains(refused(scene, "far/b.png"), "/far: is a link to " + whole + "/near"));
  CHECK(contains(refused(scene, "maps/../leak.png"), "leak.png: is a link"));
  CHECK(contains(refused(scene, "../near/back/a.png"), "back: is a link to " + whole + "/scene") == false);
  for (const char* name :
       {"a.png", "other.png", "maps/up.png", "dead.png", "none.png", "maps/../a.png", "./a.png"})
    CHECK(path_beside(scene, name) == scene + "/" + name);
  // What the user typed may be a link; so may a file that a name with ".." leads to, but not out from there.
  CHECK(path_beside(outer.file("typed"), "a.png") == outer.file("typed") + "/a.png");
  CHECK(contains(refused(outer.file("typed"), "leak.png"), "is a link to"));
  CHECK(path_beside(scene, "../secret.png") == scene + "/../secret.png");
  CHECK(contains(refused(outer.file("near"), "../scene/leak.png"), "is a link to"));
  CHECK(path_beside(scene, outer.file("scene/leak.png")) == outer.file("scene/leak.png"));
  CHECK(path_beside("", "a.png") == "a.png");

  CHECK_FALSE(follows_links());
  set_follow_links(true);
  CHECK(refused(scene, "leak.png").empty());
  set_follow_links(false);
}
