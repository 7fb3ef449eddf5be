// SPDX-License-Identifier: Apache-2.0
#include "core/base/text/edit_distance.h"

#include <catch2/catch.hpp>
#include <random>
#include <string>

using etak::edit_distance;

TEST_CASE("two neighbours exchanged are one edit") {
  CHECK(edit_distance("glod", "gold") == 1);
  CHECK(edit_distance("chromuim", "chromium") == 1);
  CHECK(edit_distance("ab", "ba") == 1);
  CHECK(edit_distance("gldo", "gold") == 2);
  // Optimal string alignment: what was exchanged is not edited again, so this is no exchange and an
  // insertion.
  CHECK(edit_distance("ca", "abc") == 3);
}

TEST_CASE("an edit is a letter put in, left out or replaced, whatever its case") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("abc", "") == 3);
  CHECK(edit_distance("Gold", "gOLD") == 0);
  CHECK(edit_distance("gold", "bold") == 1);
  CHECK(edit_distance("gold", "golds") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
}

TEST_CASE("a name of more than 100 bytes is near to none") {
  const std::string longest(100, 'a'), longer(101, 'a');
  CHECK(edit_distance(longest, longest.substr(1)) == 1);
  CHECK(edit_distance(longer, longest) == 101);
  CHECK(edit_distance("gold", longer) == 101);
  CHECK(etak::did_you_mean(longest.substr(1), {longest}) == "; did you mean " + longest + "?");
  CHECK(etak::did_you_mean(longer, {longest}).empty());
}

TEST_CASE("edit distance is symmetric, zero for equal names only, and at most the longer name") {
  std::mt19937 random(7);
  const auto word = [&] {
    std::string out(random() % 7, 'a');
    for (char& c : out) c = static_cast<char>('a' + random() % 3);
    return out;
  };
  for (int i = 0; i < 2000; ++i) {
    const std::string a = word(), b = word();
    INFO(a << ' ' << b);
    const std::size_t distance = edit_distance(a, b);
    CHECK(distance == edit_distance(b, a));
    CHECK((distance == 0) == (a == b));
    CHECK(distance <= std::max(a.size(), b.size()));
    CHECK(distance >= std::max(a.size(), b.size()) - std::min(a.size(), b.size()));
  }
}
