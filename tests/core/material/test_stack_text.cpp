// SPDX-License-Identifier: Apache-2.0
#include "core/material/stack_text.h"

#include <catch2/catch.hpp>

#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

std::string text_refusal(const std::string& text) {
  return error_of([&] { (void)parse_stack(text, "stack"); });
}

}  // namespace

TEST_CASE("a stack is read from the outside to its base, whatever '/' its names hold") {
  const StackText plain = parse_stack("anatase:40nm/titanium", "stack");
  REQUIRE(plain.layers.size() == 1);
  CHECK(plain.layers[0].name == "anatase");
  CHECK(plain.layers[0].thickness_nm == 40);
  CHECK(plain.layers[0].coherent);
  CHECK(plain.base == "titanium");
  const StackText named =
      parse_stack("anatase/jolivet-2023:0.04um//home/a.b/ti.yml:2e-3mm/titanium/palm-2018", "stack");
  REQUIRE(named.layers.size() == 2);
  CHECK(named.layers[0].name == "anatase/jolivet-2023");
  CHECK(named.layers[0].thickness_nm == 40);
  CHECK(named.layers[1].name == "/home/a.b/ti.yml");
  CHECK(named.layers[1].thickness_nm == 2000);
  CHECK(named.base == "titanium/palm-2018");
}

TEST_CASE("layers of 10 um and more are incoherent unless the text says otherwise") {
  const auto coherent = [](const std::string& rest) {
    return parse_stack("water:" + rest + "/copper", "stack").layers[0].coherent;
  };
  CHECK(coherent("9999.9nm"));
  CHECK_FALSE(coherent("10um"));
  CHECK_FALSE(coherent("2mm"));
  CHECK(coherent("12um:coherent"));
  CHECK_FALSE(coherent("40nm:incoherent"));
}

TEST_CASE("only a thickness makes a text that of a stack") {
  for (const char* text :
       {"gold", "gold/johnson-1972", "C:/tables/gold.csv", "a:b/c", "a:infrared/c", "http://x/y"})
    CHECK_FALSE(is_stack_text(text));
  for (const char* text : {"a:1nm/b", "a:1/b", "a:.5um/b", "a:-1nm/b", "a:+1nm/b", "a:?nm/b", "a:nan/b",
                           "a:inf nm", "a:infnm/b", "a:NaNnm:coherent/b"})
    CHECK(is_stack_text(text) == (std::string_view(text) != "a:inf nm"));
}

TEST_CASE("each fault of a stack's text has its own message with the layer") {
  CHECK(text_refusal("anatase:40/titanium") ==
        "stack layer 1: thickness 40 has no unit; expected a thickness such as 40nm, 1.5um or 2mm");
  for (const char* bad : {"-40nm", "infnm", "nannm", "inf", "1e305mm"})
    CHECK(contains(text_refusal(std::string("water:1nm/anatase:") + bad + "/titanium"),
                   std::string(bad) == "inf" ? "stack layer 2: thickness inf has no unit"
                                             : "stack layer 2: thickness " + std::string(bad) +
                                                   "; expected a finite one of at least 0"));
  CHECK(contains(text_refusal("anatase:4o0nm/titanium"),
                 "stack layer 1: thickness 4o0nm; expected a thickness such as"));
  CHECK(contains(text_refusal("anatase:40nm"), "stack: a stack without a base"));
  CHECK(contains(text_refusal("anatase:40nm/"), "stack: a stack without a base"));
  CHECK(contains(text_refusal(":40nm/titanium"), "stack layer 1: has no material"));
  CHECK(contains(text_refusal("anatase:40nm:thick/titanium"),
                 "expected coherent or incoherent behind the thickness"));
  CHECK(contains(text_refusal("gold"), "stack: a stack without layers"));
  std::string many;
  for (int i = 0; i < 1000; ++i) many += "water:1nm/";
  CHECK(parse_stack(many + "gold", "stack").layers.size() == 1000);
  CHECK(contains(text_refusal(many + "water:1nm/gold"), "stack: more than 1000 layers"));
}

TEST_CASE("an unknown thickness is read, and is none") {
  const StackText text = parse_stack("polystyrene:?nm/silicon", "stack");
  CHECK_FALSE(text.layers[0].thickness_nm);
}
