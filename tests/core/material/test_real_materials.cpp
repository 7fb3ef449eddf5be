// SPDX-License-Identifier: Apache-2.0
// What the library's materials must show, and the library against the reference data beside the checkout.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <sstream>

#include "core/color/delta_e.h"
#include "core/material/library.h"
#include "tests/core/material/f0_support.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

F0Result solve(const std::string& id, const F0Options& options = {}) {
  return test::solve(material(id).preferred_dataset().optics, options);
}

// The dataset that was taken from a page ("main/Au/nk/Johnson.yml"); none when the material has no such.
const Dataset* from_page(const Material& m, std::string page) {
  if (page.ends_with(".yml")) page.resize(page.size() - 4);
  for (const auto& dataset : m.datasets)
    if (dataset.citation.via.ends_with(" " + page)) return &dataset;
  return nullptr;
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);)
    if (!part.empty()) out.push_back(part);
  return out;
}

}  // namespace

TEST_CASE("gold is out of the sRGB gamut in red only, but for one thin film and one set of 1975") {
  for (const auto& dataset : material("gold").datasets) {
    INFO(dataset.id);
    const F0Result got = solve(dataset.optics);
    if (dataset.id == "ciesielski-2018-35nm" || dataset.id == "hagemann-1975") {
      CHECK(got.linear.r < 1);
      continue;
    }
    CHECK(got.flags.has(Flag::out_of_gamut));
    CHECK(got.linear.r > 1);
    CHECK(got.gamut_excess[0] == Approx(got.linear.r - 1).epsilon(1e-12));
    CHECK(got.gamut_excess[1] == 0);
    CHECK(got.gamut_excess[2] == 0);
    CHECK(got.srgb8.r == 255);
  }
  F0Options wide;
  wide.space = RgbSpace::acescg;
  CHECK(!solve("gold", wide).out_of_gamut());
}

TEST_CASE("gold and titanium lie above the forbidden zone though one channel of each may lie inside") {
  const F0Result gold = solve("gold");
  CHECK(gold.zone == Zone::above);
  CHECK(gold.channel_in_zone == std::array<bool, 3>{false, false, true});
  CHECK(gold.flags.has(Flag::channel_in_zone));
  CHECK(solve("titanium").zone == Zone::above);
}

TEST_CASE("semiconductors lie inside the forbidden zone, dielectrics below it, metals above") {
  CHECK(solve("silicon").zone == Zone::inside);
  CHECK(solve("water").zone == Zone::below);
  CHECK(solve("diamond").zone == Zone::below);
  for (const auto* id : {"gold", "silver", "copper", "aluminum", "iron", "chromium", "nickel", "platinum"})
    CHECK(solve(id).zone == Zone::above);
}

TEST_CASE("glass under water reflects a tenth of what it reflects in air") {
  F0Options water;
  water.outside = {"water", std::get<OpticalConstants>(material("water").preferred_dataset().optics)};
  const F0Result dry = solve("glass_bk7"), wet = solve("glass_bk7", water);
  CHECK(dry.luminance == Approx(0.0424).margin(2e-4));
  const double relative = 1.5185 / 1.3350;  // n of BK7 over n of water at 550 nm
  CHECK(wet.luminance == Approx(std::pow((relative - 1) / (relative + 1), 2)).margin(5e-5));
  CHECK(solve("water", water).luminance < 1e-12);
  CHECK(solve("gold", water).luminance < solve("gold").luminance);
}

TEST_CASE("calcite averaged over its axes lies a third of the way from ordinary to extraordinary") {
  const Material calcite = material("calcite");
  const Dataset* o = calcite.dataset("ghosh-1999-ordinary");
  const Dataset* e = calcite.dataset("ghosh-1999-extraordinary");
  REQUIRE(o != nullptr);
  REQUIRE(e != nullptr);
  const F0Result mixed = F0Solver({}).solve({{&o->optics, 2.0 / 3}, {&e->optics, 1.0 / 3}});
  const double want = (2 * solve(o->optics).luminance + solve(e->optics).luminance) / 3;
  CHECK(mixed.luminance == Approx(want).epsilon(1e-12));
  CHECK(mixed.luminance < solve(o->optics).luminance);
}

TEST_CASE("every dataset of the library gives finite numbers or a refusal, under every method") {
  for (const Method method : all_methods) {
    F0Options options;
    options.method = method;
    const F0Solver solver(options);
    for (std::size_t i = 0; i < library().ids().size(); ++i) {
      const Material m = library().at(i);
      for (const auto& dataset : m.datasets) {
        INFO(name(method) << " " << m.id << "/" << dataset.id);
        const F0Result got = solver.solve(dataset.optics, dataset.flags);
        if (got.refused()) continue;
        for (const double v : vec(got.linear)) CHECK(std::isfinite(v));
        CHECK(got.luminance >= 0);
        CHECK(got.luminance <= 1.1);
        CHECK(got.coverage.weight[1] >= 0.95);
      }
    }
  }
}

TEST_CASE("5 nm, 10 nm and folded sums agree with the reference for all that is published smoothly") {
  const F0Solver reference{F0Options{}};
  for (const auto& [method, most] :
       {std::pair{Method::exact, 1e-4}, {Method::nm5, 2e-3}, {Method::e308_10, 3e-3}}) {
    F0Options options;
    options.method = method;
    const F0Solver solver(options);
    for (const auto* id : {"gold", "silver", "copper", "silicon", "glass_bk7", "iron", "diamond"}) {
      const Optics optics = material(id).preferred_dataset().optics;
      const Vec3 a = vec(solver.solve(optics).linear), b = vec(reference.solve(optics).linear);
      INFO(name(method) << " " << id);
      for (std::size_t c = 0; c < 3; ++c) CHECK(std::abs(a[c] - b[c]) < most);
    }
  }
}

TEST_CASE("every wanted material is in the library and gives its reference F0, exact in 8 bit") {
  const auto shared = shared_folder();
  if (!shared) {
    WARN("no reference data beside the checkout; not checked");
    return;
  }
  const auto rows = read_csv(*shared + "/data/materials-wanted.csv");
  const auto& header = rows.at(0);
  const auto field = [&](std::size_t row, const char* name) { return rows[row].at(column(header, name)); };
  F0Options options;
  options.allow_extrapolation = true;
  const F0Solver solver(options);
  CHECK(rows.size() == 158);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::string id = field(i, "id");
    INFO(id);
    const auto found = library().find(id);
    CHECK(found.has_value());
    if (!found) continue;
    CHECK(found->id == id);
    CHECK(found->material_class == field(i, "class"));
    const Dataset* dataset = from_page(*found, field(i, "page"));
    CHECK(dataset != nullptr);
    for (const auto& alternate : split(field(i, "alternates"), ';')) {
      INFO(alternate);
      CHECK(from_page(*found, alternate) != nullptr);
    }
    if (dataset == nullptr || field(i, "F0_r").empty()) continue;
    const F0Result got = solver.solve(dataset->optics, dataset->flags);
    CHECK(got.linear.r == Approx(to_number(field(i, "F0_r"))).margin(2e-5));
    CHECK(got.linear.g == Approx(to_number(field(i, "F0_g"))).margin(2e-5));
    CHECK(got.linear.b == Approx(to_number(field(i, "F0_b"))).margin(2e-5));
    CHECK(got.luminance == Approx(to_number(field(i, "F0_Y"))).margin(2e-5));
    CHECK(std::to_string(got.srgb8.r) == field(i, "u8_r"));
    CHECK(std::to_string(got.srgb8.g) == field(i, "u8_g"));
    CHECK(std::to_string(got.srgb8.b) == field(i, "u8_b"));
    CHECK(got.coverage.least() == Approx(to_number(field(i, "weight_inside"))).margin(0.05));
  }
}

TEST_CASE("the SOPRA tables of the library are the reference figures") {
  const auto shared = shared_folder();
  if (!shared) {
    WARN("no reference data beside the checkout; not checked");
    return;
  }
  std::map<std::string, std::vector<std::array<double, 3>>> tables;
  const auto rows = read_csv(*shared + "/data/seed-metals-nk.csv");
  for (std::size_t i = 1; i < rows.size(); ++i)
    tables[rows[i][0]].push_back({to_number(rows[i][1]), to_number(rows[i][2]), to_number(rows[i][3])});
  CHECK(tables.size() == 4);
  for (const auto& [symbol, table] : tables) {
    INFO(symbol);
    const Material m = material(symbol);
    const Dataset* dataset = m.dataset("sopra-via-pbrt");
    REQUIRE(dataset != nullptr);
    const auto& optics = std::get<OpticalConstants>(dataset->optics);
    const auto& n = std::get<Spectrum>(optics.n);
    REQUIRE(n.size() == table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
      CHECK(n.wavelength_nm[i] == Approx(table[i][0]).epsilon(1e-12));
      CHECK(n.value[i] == table[i][1]);
      CHECK(optics.k->value[i] == table[i][2]);
    }
  }
}

TEST_CASE("the measured reflectances of the library are the reference figures") {
  const auto shared = shared_folder();
  if (!shared) {
    WARN("no reference data beside the checkout; not checked");
    return;
  }
  const auto rows = read_csv(*shared + "/data/reflectance-measured.csv");
  CHECK(rows.size() == 19);
  std::vector<std::vector<double>> surfaces;
  for (std::size_t i = 0; i < library().ids().size(); ++i) {
    const Material m = library().at(i);
    for (const auto& dataset : m.datasets)
      if (const auto* r = std::get_if<Reflectance>(&dataset.optics)) surfaces.push_back(r->spectrum.value);
  }
  for (std::size_t i = 1; i < rows.size(); ++i) {
    std::vector<double> values;
    for (std::size_t c = 4; c < rows[i].size(); ++c) values.push_back(to_number(rows[i][c]));
    INFO(rows[i][0]);
    CHECK(values.size() == 31);
    CHECK(std::find(surfaces.begin(), surfaces.end(), values) != surfaces.end());
  }
}

TEST_CASE("the everyday reflectances of the library are the reference figures, in colour too") {
  const auto shared = shared_folder();
  if (!shared) {
    WARN("no reference data beside the checkout; not checked");
    return;
  }
  std::map<std::string, Spectrum> spectra;
  const auto rows = read_csv(*shared + "/data/everyday-reflectance.csv");
  const std::size_t nm = column(rows[0], "wavelength_nm"), value = column(rows[0], "reflectance");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    Spectrum& s = spectra[rows[i][0]];
    s.wavelength_nm.push_back(to_number(rows[i][nm]));
    s.value.push_back(to_number(rows[i][value]));
  }
  CHECK(spectra.size() == 152);
  for (const auto& [id, spectrum] : spectra) {
    INFO(id);
    const auto found = library().find(id);
    REQUIRE(found);
    CHECK(found->id == id);
    CHECK(found->material_class == "surface");
    CHECK(!found->group.empty());
    CHECK(std::get<Reflectance>(found->preferred_dataset().optics).spectrum == spectrum);
  }
  // The colours that were worked out beside the data, by another program.
  const auto sources = read_csv(*shared + "/data/everyday-reflectance-sources.csv");
  const std::size_t luminance = column(sources[0], "Y_d65"), licence = column(sources[0], "licence");
  CHECK(sources.size() == 153);
  for (std::size_t i = 1; i < sources.size(); ++i) {
    INFO(sources[i][0]);
    const Material m = material(sources[i][0]);
    const Dataset& dataset = m.preferred_dataset();
    CHECK(solve(dataset.optics).luminance == Approx(to_number(sources[i][luminance])).margin(2e-4));
    const bool second_hand = contains(sources[i][licence], "as stated by the redistributor");
    CHECK(contains(dataset.citation.licence, "on the redistributor's word alone") == second_hand);
    CHECK(!dataset.note.empty());
    CHECK(!dataset.sample.empty());
  }
}
