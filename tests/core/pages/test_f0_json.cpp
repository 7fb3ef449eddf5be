// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

#include "core/material/f0.h"
#include "tests/core/pages/json_schema.h"
#include "tests/core/pages/sample_rows.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;
using Json = nlohmann::json;

namespace {

Json schema_text() {
  return Json::parse(slurp(source_folder() + "/resources/schema/f0.schema.json"));
}

std::vector<F0Options> many_options() {
  std::vector<F0Options> all(1);
  for (const RgbSpace space : all_rgb_spaces) {
    all.emplace_back();
    all.back().space = space;
  }
  for (const Method method : all_methods) {
    all.emplace_back();
    all.back().method = method;
    all.back().viewing = {Observer::cie1964_10deg, Illuminant::a};
    all.back().interpolation = Interpolation::pchip;
  }
  all.emplace_back();
  all.back().method = Method::automatic;
  all.back().integration_bound = 1e-3;
  all.emplace_back();
  all.back().custom_space = CustomSpace{"lin_x \"y\"", [](const Xyz& c, const Xyz&) {
                                          return LinearRgb{c.x, c.y, c.z};
                                        }};
  all.back().outside = {"water", 1.333};
  return all;
}

}  // namespace

TEST_CASE("JSON reports are valid against their schema under every policy") {
  const JsonSchema schema(schema_text());
  for (const F0Options& options : many_options()) {
    INFO(policy(options));
    CHECK(schema.problem(Json::parse(f0_json(sample_rows(), options))) == "");
    CHECK(schema.problem(Json::parse(f0_json({}, options))) == "");
    std::istringstream lines(f0_jsonl(sample_rows(), options));
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line); ++count) CHECK(schema.problem(Json::parse(line)) == "");
    CHECK(count == sample_rows().size());
  }
}

TEST_CASE("the schema refuses a report with a key too many, one too few, or a colour in a refused result") {
  const JsonSchema schema(schema_text());
  const Json good = Json::parse(f0_json(sample_rows(), {}));
  Json bad = good;
  bad["results"][0]["colour"] = 1;
  CHECK(schema.problem(bad) != "");
  bad = good;
  bad["results"][0].erase("Y");
  CHECK(schema.problem(bad) != "");
  bad = good;
  bad["results"][2]["Y"] = 0.5;
  CHECK(schema.problem(bad) != "");
  bad = good;
  bad["results"][0]["Y"] = nullptr;
  CHECK(schema.problem(bad) != "");
}

TEST_CASE("the schema lists every flag, method, observer and illuminant by name and no other") {
  const Json defs = schema_text()["$defs"];
  Json flags = Json::array(), methods = Json::array();
  for (std::size_t i = 0; i < flag_count; ++i) flags.push_back(std::string(name(static_cast<Flag>(i))));
  for (const Method method : all_methods) methods.push_back(std::string(name(method)));
  methods.push_back(std::string(name(Method::automatic)));
  CHECK(defs["result"]["properties"]["flags"]["items"]["enum"] == flags);
  CHECK(defs["policy"]["properties"]["method"]["enum"] == methods);
  // "own" stands for tables of the caller's (core/spectrum/own_viewing.h).
  for (const auto& text : defs["policy"]["properties"]["observer"]["enum"])
    CHECK((text == "own" || observer_named(text.get<std::string>())));
  for (const auto& text : defs["policy"]["properties"]["illuminant"]["enum"])
    CHECK((text == "own" || illuminant_named(text.get<std::string>())));
}

TEST_CASE("JSON numbers read back equal and are the shortest that do") {
  auto rows = sample_rows();
  rows.resize(1);
  rows[0].result.linear = {1.0 / 3, 0.1 + 0.2, 5e-324};
  const std::string text = f0_json(rows, {});
  const Json linear = Json::parse(text)["results"][0]["linear"];
  CHECK(linear["r"].get<double>() == 1.0 / 3);
  CHECK(linear["g"].get<double>() == 0.1 + 0.2);
  CHECK(linear["b"].get<double>() == 5e-324);
  CHECK(contains(text, "\"r\": 0.3333333333333333, \"g\": 0.30000000000000004, \"b\": 5e-324"));
}

TEST_CASE("JSON carries zone, gamut, F82 and the reason of a refusal") {
  const Json results = Json::parse(f0_json(sample_rows(), {}))["results"];
  CHECK(results[0]["gamut"] == Json::parse(R"({"in": false, "excess": {"r": 0.0428, "g": 0, "b": 0}})"));
  CHECK(results[0]["zone"]["channels_inside"] == Json::array({"g", "b"}));
  CHECK(results[0]["zone"]["verdict"] == "above");
  CHECK(results[0]["f82"]["absolute"]["g"] == 0.9);
  CHECK(results[0]["f82"]["tint"]["g"] == 0.95);
  CHECK(results[0]["source"] == "S. Somebody, Optics of \"gold\", J. 1, 2 (1972)");
  CHECK(results[1]["f82"].is_null());
  CHECK(results[1]["refused"].is_null());
  CHECK(results[2]["refused"] == "data cover 0.3 of the Y weight, 0.95 needed");
  CHECK(results[2]["coverage"]["y"] == 0.3);
  CHECK(results[2]["linear"].is_null());
}

TEST_CASE("JSON tells the kind of a dataset and why it is doubtful") {
  auto rows = sample_rows();
  rows[0].kind = "computed";
  rows[0].doubt = "a guess";
  const Json results = Json::parse(f0_json(rows, {}))["results"];
  CHECK(results[0]["kind"] == "computed");
  CHECK(results[0]["doubtful"] == "a guess");
  CHECK(results[1]["kind"].is_null());
  CHECK(results[1]["doubtful"].is_null());
  const JsonSchema schema(schema_text());
  CHECK(schema.problem(Json::parse(f0_json(rows, {}))) == "");
  rows[0].kind = "guessed";
  CHECK(schema.problem(Json::parse(f0_json(rows, {}))) != "");
}

TEST_CASE("the zone of a surface is null in JSON, of nothing else that has an F0") {
  std::vector<F0Row> rows{{"paper", "Paper", "surface", "sheet", "", surface_result({0.3, 0.3, 0.3})},
                          {"gold", "Gold", "metal", "x", "", gold_result()}};
  const JsonSchema schema(schema_text());
  const Json good = Json::parse(f0_json(rows, {}));
  CHECK(good["results"][0]["zone"].is_null());
  CHECK(schema.problem(good) == "");
  Json bad = good;
  bad["results"][0]["zone"] = good["results"][1]["zone"];
  CHECK(schema.problem(bad) != "");
  bad = good;
  bad["results"][1]["zone"] = nullptr;
  CHECK(schema.problem(bad) != "");
}

TEST_CASE("a file name of any bytes gives valid JSON") {
  auto rows = sample_rows();
  rows[0].path = "a\x01\"\\\n\xff";
  CHECK(Json::parse(f0_json(rows, {}))["results"][0]["path"] == "a\x01\"\\\n\uFFFD");
}

TEST_CASE("the policy's matrix takes its white to (1, 1, 1)") {
  for (const F0Options& options : many_options()) {
    const Json p = Json::parse(f0_json({}, options))["policy"];
    if (p["xyz_to_linear"].is_null() || p["space"] == "xyz") continue;
    INFO(policy(options));
    for (const auto& row : p["xyz_to_linear"]) {
      const double sum = row[0].get<double>() * p["white"]["x"].get<double>() +
                         row[1].get<double>() * p["white"]["y"].get<double>() +
                         row[2].get<double>() * p["white"]["z"].get<double>();
      CHECK(std::abs(sum - 1) < 1e-12);
    }
  }
}

TEST_CASE("with the method auto, JSON says which step was taken and what it is estimated to miss") {
  F0Options options;
  options.method = Method::automatic;
  F0Row row{"glass", "", "", "", "", F0Solver(options).solve(glass(1.5))};
  const Json whole = Json::parse(f0_json({&row, 1}, options));
  CHECK(JsonSchema(schema_text()).problem(whole) == "");
  CHECK(whole["policy"]["integration_bound"] == 1e-5);
  const Json step = whole["results"][0]["integration"];
  CHECK(step["method"] == "20nm");
  CHECK(step["estimated_error"].get<double>() == row.result.integration->error);
  CHECK(step["within_bound"] == true);
  F0Row plain{"glass", "", "", "", "", F0Solver({}).solve(glass(1.5))};
  const Json without = Json::parse(f0_json({&plain, 1}, {}));
  CHECK(!without["results"][0].contains("integration"));
  CHECK(!without["policy"].contains("integration_bound"));
}

TEST_CASE("results of the solver pass through JSON unchanged") {
  const F0Solver solver({});
  F0Row row{"glass", "", "", "", "", solver.solve(glass(1.5))};
  const Json result = Json::parse(f0_json({&row, 1}, {}))["results"][0];
  CHECK(result["linear"]["r"].get<double>() == row.result.linear.r);
  CHECK(result["Y"].get<double>() == row.result.luminance);
  CHECK(result["Y"].get<double>() == Approx(0.04));
  CHECK(JsonSchema(schema_text()).problem(Json::parse(f0_json({&row, 1}, {}))) == "");
}
