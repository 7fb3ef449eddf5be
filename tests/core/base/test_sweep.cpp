// SPDX-License-Identifier: Apache-2.0
#include "core/base/sweep.h"

#include <catch2/catch.hpp>

#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

const SweepForm gloss_form{"NAME=FIRST:LAST:COUNT", 5};

}  // namespace

TEST_CASE("a sweep has even steps with both ends, or the values that are listed") {
  const Sweep steps = parse_sweep("gloss=0:1:5", gloss_form);
  CHECK(steps.name == "gloss");
  CHECK(steps.values == std::vector<std::string>{"0", "0.25", "0.5", "0.75", "1"});
  CHECK(parse_sweep("x=3:1:3", gloss_form).values == std::vector<std::string>{"3", "2", "1"});
  CHECK(parse_sweep("material=gold,Ag", gloss_form).values == std::vector<std::string>{"gold", "Ag"});
}

TEST_CASE("a sweep's form reads numbers in its own unit") {
  SweepForm form = gloss_form;
  form.unit = "mm";
  form.read = [](std::string_view text, double& value) {
    if (!text.ends_with("cm") || !parse_number(text.substr(0, text.size() - 2), value)) return false;
    value *= 10;
    return true;
  };
  CHECK(parse_sweep("1=0cm:2cm:3", form).values == std::vector<std::string>{"0mm", "10mm", "20mm"});
  CHECK(contains(error_of([&] { (void)parse_sweep("1=0:2cm:3", form); }), "expected NAME=FIRST:LAST:COUNT"));
}

TEST_CASE("a sweep of another form is refused with what is there") {
  for (const char* bad :
       {"", "gloss", "=0:1:5", "gloss=", "gloss=0:1", "gloss=0:1:1", "gloss=0:1:6", "gloss=0:1:2.5",
        "gloss=0:1:nan", "gloss=0:1:1e300", "gloss=a:1:3", "gloss=1", "gloss=1,2,3,4,5,6"}) {
    INFO(bad);
    CHECK(contains(error_of([&] { (void)parse_sweep(bad, gloss_form); }), "sweep: "));
  }
}
