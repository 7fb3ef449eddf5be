// SPDX-License-Identifier: Apache-2.0
#include "core/material/optics/optics_class.h"

#include <catch2/catch.hpp>

#include "core/material/json.h"
#include "core/material/library.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

Material decided(Optics optics, std::string_view formula = {}) {
  Material out;
  out.datasets.emplace_back().optics = std::move(optics);
  decide_class(out, formula);
  return out;
}

OpticalConstants flat(double n, std::optional<double> k, double last_nm = 900) {
  OpticalConstants out{Spectrum{{300, last_nm}, {n, n}}, {}};
  if (k) out.k = Spectrum{{300, last_nm}, {*k, *k}};
  return out;
}

std::string class_of(Optics optics, std::string_view formula = {}) {
  return decided(std::move(optics), formula).material_class;
}

ClassBy who(Optics optics) {
  return decided(std::move(optics)).class_by;
}

}  // namespace

TEST_CASE("n and k at 550 nm tell metals, semiconductors and dielectrics") {
  CHECK(class_of(flat(0.4, 2.4)) == "conductor");
  CHECK(class_of(flat(0.4, 2.4), "Au") == "metal");
  CHECK(class_of(flat(3.5, 2.7), "W") == "metal");
  CHECK(class_of(flat(3.5, 2.7)) == "semiconductor");
  CHECK(class_of(flat(4.08, 0.028), "Si") == "semiconductor");
  CHECK(class_of(flat(1.5, 0.0)) == "solid");
  for (const double n : {0.4, 1.5, 4.0})
    for (const double k : {0.01, 2.4}) CHECK(who(flat(n, k)) == ClassBy::numbers);
  CHECK(who(flat(1.5, std::nullopt)) == ClassBy::numbers);
  CHECK(who(flat(2.8, 1e-5)) == ClassBy::numbers);  // rutile
}

TEST_CASE("where the numbers do not tell the class, nobody does, and the remark says so") {
  for (const Optics& optics :
       {Optics(flat(0.4, std::nullopt)), Optics(flat(4, std::nullopt)), Optics(flat(4, 1e-5)),
        Optics(flat(0.4, 2.4, 500)), Optics(Reflectance{Spectrum{{300, 900}, {0.9, 0.9}}})}) {
    const Material m = decided(optics);
    CHECK(m.material_class == "solid");
    CHECK(m.class_by == ClassBy::nobody);
    CHECK(contains(class_remark(m), "do not tell it: taken as a dielectric"));
  }
  CHECK(contains(class_remark(decided(flat(0.4, 2.4))), "tell a conductor"));
  CHECK(class_remark(*MaterialLibrary::builtin().find("gold")).empty());
}

TEST_CASE("a material file without class and origin is decided by its numbers, and is written without them") {
  const std::string file = R"({"schema": "etak-material/1", "id": "m", "name": "M", "aliases": [],
    "preferred": "a", "preferred_reason": "", "datasets": [{"id": "a", "quantity": "n,k", "sample": "",
    "citation": {"authors": [], "title": "", "published_in": "", "licence": "", "via": ""}, "unit": "nm",
    "valid_range": [300, 900], "columns": ["wavelength", "n", "k"],
    "rows": [[300, N, K], [900, N, K]]}]})";
  const auto read = [&](const std::string& n, const std::string& k) {
    std::string text = file;
    for (const auto& [key, value] : {std::pair("N,", n + ","), {"K]", k + "]"}})
      for (std::size_t at = 0; (at = text.find(key, at)) != text.npos;) text.replace(at, 2, value);
    return parse_material(text, "m.json");
  };
  const Material gold = read("0.4", "2.4"), gap = read("3.5", "0");
  CHECK(gold.material_class == "conductor");
  CHECK(gold.datasets[0].origin == Origin::unknown);
  CHECK(!contains(format_material(gold), "\"class\""));
  CHECK(gap.class_by == ClassBy::nobody);
  CHECK(!contains(format_material(gap), "\"class\""));
  for (const Material& each : {gold, gap}) CHECK(parse_material(format_material(each), "m.json") == each);
}
