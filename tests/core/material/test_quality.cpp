// SPDX-License-Identifier: Apache-2.0
#include "core/material/quality.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/material/embedded/blob.h"
#include "core/material/json.h"
#include "core/material/library.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// A reflectance of `level` at every wavelength, on `rows` samples in 400..700 nm and one far on either side.
Dataset flat_dataset(const std::string& id, double level, std::size_t rows = 31) {
  Dataset d;
  d.id = id;
  d.citation = {{"A. Author"}, "Title", "J. 1, 2", 2000, "", "", "CC0-1.0", "nowhere"};
  Spectrum table;
  table.wavelength_nm.push_back(350);
  for (std::size_t i = 0; i < rows; ++i)
    table.wavelength_nm.push_back(400 + 300.0 * static_cast<double>(i) / static_cast<double>(rows - 1));
  table.wavelength_nm.push_back(840);
  table.value.assign(table.wavelength_nm.size(), level);
  d.optics = Reflectance{table};
  return d;
}

Material metal(std::vector<Dataset> datasets) {
  Material m;
  m.id = "testium";
  m.name = "Testium";
  m.material_class = "metal";
  m.datasets = std::move(datasets);
  return m;
}

bool is_doubtful(const Material& m, std::size_t dataset) {
  return quality_flags(m, m.datasets[dataset]).has(Flag::doubtful);
}

F0Result f0_of(const Material& m, const Dataset& d) {
  return solve(F0Solver({}), m, d);
}

}  // namespace

TEST_CASE("a table of fewer than ten samples in 400-700 nm is sparse, a formula never") {
  CHECK(quality_flags(metal({flat_dataset("a", 0.5, 9)}), flat_dataset("a", 0.5, 9)).has(Flag::sparse));
  CHECK_FALSE(
      quality_flags(metal({flat_dataset("a", 0.5, 10)}), flat_dataset("a", 0.5, 10)).has(Flag::sparse));
  Dataset formula = flat_dataset("f", 0.5);
  formula.optics = OpticalConstants{DispersionFormula{1, {0, 1.2, 0.1}, 300, 900}, {}};
  CHECK(quality_flags(metal({formula}), formula).none());
  // Bare optics as of a table of one's own are told the same.
  CHECK(F0Solver({}).solve(flat_dataset("a", 0.5, 9).optics).flags.has(Flag::sparse));
  CHECK_FALSE(F0Solver({}).solve(flat_dataset("a", 0.5, 10).optics).flags.has(Flag::sparse));
  CHECK_FALSE(F0Solver({}).solve(formula.optics).flags.has(Flag::sparse));
}

TEST_CASE("what theory gave is computed") {
  Dataset theory = flat_dataset("t", 0.5);
  theory.origin = Origin::computed;
  const Material m = metal({theory});
  CHECK(f0_of(m, m.datasets[0]).flags.has(Flag::computed));
  theory.origin = Origin::fit;
  CHECK_FALSE(f0_of(m, theory).flags.has(Flag::computed));
  CHECK(quality_text(Origin::fit, {}) == "fit");
  CHECK(quality_text(Origin::computed, Flags::from_bits(~0u)) == "computed; sparse; doubtful");
}

TEST_CASE("a dataset more than 0.1 off the median of two others is doubtful") {
  const Material m = metal({flat_dataset("a", 0.50), flat_dataset("b", 0.52), flat_dataset("c", 0.65)});
  CHECK_FALSE(is_doubtful(m, 0));  // the median of the others is 0.585
  CHECK_FALSE(is_doubtful(m, 1));
  CHECK(is_doubtful(m, 2));
  CHECK(median_of_others(m, m.datasets[2]).value() == Approx(0.51));
  const Material near = metal({flat_dataset("a", 0.50), flat_dataset("b", 0.52), flat_dataset("c", 0.60)});
  for (std::size_t i = 0; i < 3; ++i) CHECK_FALSE(is_doubtful(near, i));
}

TEST_CASE("the median needs two others that are accepted") {
  CHECK_FALSE(is_doubtful(metal({flat_dataset("a", 0.5), flat_dataset("b", 0.9)}), 0));
  Material m = metal({flat_dataset("a", 0.5), flat_dataset("b", 0.9), flat_dataset("c", 0.9)});
  CHECK(is_doubtful(m, 0));
  CHECK(doubt(m, m.datasets[0]) == "F0 luminance 0.5 is 0.4 below the median of the other datasets, 0.9");

  SECTION("a dataset named doubtful is none") {
    m.datasets[2].doubtful = "a film";
    CHECK_FALSE(is_doubtful(m, 0));
    CHECK(is_doubtful(m, 2));
    CHECK(doubt(m, m.datasets[2]) == "a film");
  }
  SECTION("theory is none, but is judged") {
    m.datasets[2].origin = Origin::computed;
    CHECK_FALSE(is_doubtful(m, 0));
    m.datasets[0].origin = Origin::computed;
    m.datasets[2].origin = Origin::fit;
    CHECK(is_doubtful(m, 0));
  }
  SECTION("another axis is none") {
    m.datasets[2].axis = "extraordinary";
    CHECK_FALSE(is_doubtful(m, 0));
  }
  SECTION("one without F0 is none") {
    m.datasets[2].optics = Reflectance{Spectrum{{700, 900}, {0.9, 0.9}}};
    CHECK_FALSE(is_doubtful(m, 0));
  }
  SECTION("surfaces are things of many kinds, and have no F0") {
    m.material_class = "surface";
    CHECK_FALSE(is_doubtful(m, 0));
  }
}

TEST_CASE("whether a dataset is doubtful does not depend on how F0 is asked for") {
  const Material m = material("titanium");
  const Dataset& palm = *m.dataset("palm-2018");
  F0Options water;
  water.outside = {"1.33", 1.33};
  water.viewing.illuminant = Illuminant::a;
  CHECK(f0_of(m, palm).flags.has(Flag::doubtful));
  CHECK(solve(F0Solver(water), m, palm).flags.has(Flag::doubtful));
}

TEST_CASE("the reason is read, written and kept in the built-in library") {
  Material m = metal({flat_dataset("a", 0.5)});
  m.datasets[0].doubtful = "read from a \"small\" figure";
  m.preferred_reason = "the only one";
  const std::string text = format_material(m);
  CHECK(contains(text, R"("doubtful": "read from a \"small\" figure",)"));
  CHECK((parse_material(text, "m.json") == m));
  const std::string blob = encode_library({m}, {}, {});
  CHECK(decode_material(blob, decode_index(blob).materials.at(0).offset).datasets[0].doubtful ==
        m.datasets[0].doubtful);
  std::string empty = text;
  empty.replace(empty.find("read from"), std::string("read from a \\\"small\\\" figure").size(), "");
  CHECK(contains(error_of([&] { (void)parse_material(empty, "m.json"); }),
                 "m.json#/datasets/0/doubtful: \"\"; expected the reason"));
}

TEST_CASE("a surface has no zone verdict, and no channel in the zone") {
  for (const char* id : {"cardboard", "terracotta", "brick"}) {
    const Material m = material(id);
    INFO(id);
    CHECK_FALSE(gives_f0(m.material_class));
    const F0Result result = f0_of(m, m.preferred_dataset());
    REQUIRE_FALSE(result.refused());
    CHECK_FALSE(result.zone);
    CHECK(result.channel_in_zone == std::array<bool, 3>{});
    CHECK_FALSE(result.flags.has(Flag::channel_in_zone));
  }
  const Material silicon = material("silicon");
  CHECK(f0_of(silicon, silicon.preferred_dataset()).zone == Zone::inside);
}

// ---- the library

TEST_CASE("no preferred dataset is doubtful where another one is not") {
  for (const std::string& id : library().ids()) {
    const Material m = material(id);
    INFO(id);
    if (!is_doubtful(m, m.preferred)) continue;
    for (const Dataset& other : m.datasets) {
      INFO(other.id);
      const F0Result result = f0_of(m, other);
      CHECK((result.refused() || result.flags.has(Flag::doubtful)));
    }
    CHECK(contains(m.preferred_reason, "doubtful"));
  }
}

TEST_CASE("a sparse or computed dataset is preferred for want of a better one, or says why") {
  for (const std::string& id : library().ids()) {
    const Material m = material(id);
    const auto is_weak = [&](const Dataset& d) {
      const Flags flags = quality_flags(m, d);
      return flags.has(Flag::sparse) || flags.has(Flag::computed) || flags.has(Flag::doubtful);
    };
    if (!is_weak(m.preferred_dataset())) continue;
    for (const Dataset& other : m.datasets) {
      if (is_weak(other) || f0_of(m, other).refused()) continue;
      INFO(id << ", " << other.id);
      CHECK(contains(m.preferred_reason, "sparse"));
    }
  }
}

TEST_CASE("every table of Werner 2009 from electron energy loss is named doubtful, with the reason") {
  std::size_t tables = 0;
  for (const std::string& id : library().ids())
    for (const Dataset& d : material(id).datasets) {
      if (d.citation.doi != "10.1063/1.3243762" || d.origin == Origin::computed) continue;
      INFO(id);
      ++tables;
      CHECK(contains(d.doubtful, "electron energy loss"));
      CHECK(contains(d.doubtful, "0.27"));
    }
  CHECK(tables >= 2);
}

TEST_CASE("zinc reflects at 82 degrees like a metal, and its measured tables are doubtful") {
  const Material zinc = material("zinc");
  CHECK(zinc.preferred_dataset().id == "werner-2009-dft");
  const F0Result best = f0_of(zinc, zinc.preferred_dataset());
  CHECK(best.flags.has(Flag::computed));
  CHECK(best.flags.has(Flag::sparse));
  CHECK_FALSE(best.flags.has(Flag::doubtful));
  REQUIRE(best.f82);
  for (const double channel : vec(*best.f82)) CHECK(channel > 0.68);
  CHECK(best.linear.b > best.linear.r);  // the blue tint of Hoffman's row
  const F0Result querry = f0_of(zinc, *zinc.dataset("querry-1987"));
  CHECK(querry.flags.has(Flag::doubtful));
  CHECK(querry.f82->g < 0.56);
  CHECK(f0_of(zinc, *zinc.dataset("werner-2009-reels")).flags.has(Flag::doubtful));
}

TEST_CASE("tantalum is the least of doubtful tables and says so") {
  const Material tantalum = material("tantalum");
  const Flags flags = quality_flags(tantalum, tantalum.preferred_dataset());
  CHECK(flags.has(Flag::computed));
  CHECK(flags.has(Flag::sparse));
  CHECK(flags.has(Flag::doubtful));
  CHECK(contains(tantalum.preferred_reason, "least"));
  // The only optical measurement begins at 667 nm: it gives no F0, but what the others are judged by.
  const auto at_667 = [&](const char* id) {
    const auto& optics = std::get<OpticalConstants>(tantalum.dataset(id)->optics);
    const auto at = [](const Spectrum& s) {
      const double nm = 667;
      double out = 0;
      resample(s, Interpolation::linear, {&nm, 1}, {&out, 1});
      return out;
    };
    const double n = at(std::get<Spectrum>(optics.n)), k = at(*optics.k);
    return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
  };
  CHECK(at_667("ordal-1988") == Approx(0.493).margin(5e-4));
  CHECK(at_667("werner-2009-dft") == Approx(0.613).margin(5e-4));
  CHECK(at_667("werner-2009-reels") == Approx(0.897).margin(5e-4));
  CHECK(f0_of(tantalum, *tantalum.dataset("ordal-1988")).refused());
}

TEST_CASE("the preferred dataset is the better one where quality decides") {
  const std::pair<const char*, const char*> chosen[] = {{"sodium", "inagaki-1976"},
                                                        {"gallium_nitride", "lin-1993-ordinary"},
                                                        {"graphite", "song-2018-hopg-ordinary"},
                                                        {"silicon_amorphous", "karaman-2025-20c"},
                                                        {"chromium", "johnson-1974"},
                                                        {"titanium", "johnson-1974"}};
  for (const auto& [id, dataset] : chosen) CHECK(material(id).preferred_dataset().id == dataset);
  CHECK(material("titanium").dataset("mash-1973") != nullptr);
  CHECK(material("cesium").dataset("ives-1937") != nullptr);
  CHECK(is_doubtful(material("titanium"), 1));  // Palm's film, 0.17 below the median of the other three
}
