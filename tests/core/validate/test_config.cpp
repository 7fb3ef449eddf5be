// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "core/judge/rules.h"
#include "core/validate/config.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

std::string problem(const std::string& text) {
  return error_of([&] { (void)parse_config(text, "etak.toml"); });
}

Severity severity(const ValidateConfig& config, const char* id) {
  return severity_of(*find_rule(id), config.settings);
}

}  // namespace

TEST_CASE("letters of any alphabet outside of strings are refused, and in strings they are text") {
  for (const char* letter : {"\xC2\xA1", "\xC3\x9F", "\xC6\x92", "\xD0\x96", "\xD2\x99", "\xE4\xB8\x80"}) {
    CHECK(problem("zone" + std::string(letter) + " = 1\n").starts_with("etak.toml:1: "));
    CHECK(problem("[zone]\nlow = 0.2 " + std::string(letter) + "\n").starts_with("etak.toml:2: "));
    CHECK(problem("[zone]\nlow = [1979-05-27T0" + std::string(letter)).starts_with("etak.toml:2: "));
    const ValidateConfig config =
        parse_config("[roles]\ndiffuse = \"" + std::string(letter) + "*\"", "etak.toml");
    CHECK(config.roles.at(0).pattern == letter + std::string("*"));
  }
}

TEST_CASE("a pattern of sets says where set and role stand, or is refused with what is wrong with it") {
  CHECK(parse_config("[sets]\npattern = \"{set}~{role}\"", "etak.toml").sets ==
        std::vector<std::string>{"{set}~{role}"});
  CHECK(parse_config("[sets]\npattern = [\"{role}/{set}\", \"{set}-*-{role}\"]", "etak.toml").sets.size() ==
        2);
  for (const auto& [pattern, complaint] : {std::pair{"{role}_x", "{set} not once"},
                                           {"{set}_{set}_{role}", "{set} not once"},
                                           {"{set}_x", "{role} not once"},
                                           {"{set}{role}", "nothing between"},
                                           {"{set}*_{role}", "nothing between"},
                                           {"*_*_*_{set}_{role}", "more than two"},
                                           {"", "empty pattern"}}) {
    INFO(pattern);
    const std::string text = problem("[sets]\npattern = \"" + std::string(pattern) + "\"");
    CHECK(text.starts_with("etak.toml:2: [sets] pattern"));
    CHECK(contains(text, complaint));
  }
  CHECK(contains(problem("[sets]\npatern = \"{set}_{role}\""), "unknown key"));
}

TEST_CASE("the configuration of the documentation is read whole") {
  const ValidateConfig config = parse_config(R"toml(
profile  = "default"
transfer = "power-2.2"
fail_on  = "warning"
[roles]
diffuse  = "*_diff.*"
specular = ["*_spec.*", "b/*"]
[rules]
ETK202 = { severity = "error", min_byte = 50 }
ETK9   = "off"
[zone]
low = 0.21
high = 0.44
metric = "max"
erode = 5
min_area_px = 16
[[allow]]
rule = "ETK101"
file = "props/solar_*.png"
material = "silicon"
reason = "photovoltaic panel"
expires = "2027-01-01"
[[allow]]
rule = "f0-zero"
reason = "later"
expires = 2027-03-04
)toml",
                                             "etak.toml");
  const Settings& s = config.settings;
  CHECK(s.transfer == TextureTransfer::power_22);
  CHECK(s.transfer_stated);
  CHECK(s.fail_on == Severity::warning);
  CHECK(config.roles == std::vector<RolePattern>{{FileRole::diffuse_alpha, "*_diff.*"},
                                                 {FileRole::specular_gloss, "*_spec.*"},
                                                 {FileRole::specular_gloss, "b/*"}});
  CHECK(severity(config, "ETK202") == Severity::error);
  CHECK(parameter_of(*find_rule("ETK202"), "min_byte", s) == 50);
  CHECK(severity(config, "ETK903") == Severity::off);
  CHECK(s.zone.low == 0.21);
  CHECK(s.zone.metric == ZoneMetric::max);
  CHECK(s.zone.erode == 5);
  CHECK(s.zone.min_area_px == 16);
  REQUIRE(s.allow.size() == 2);
  CHECK(s.allow[0].expires == "2027-01-01");
  CHECK(s.allow[0].material == "silicon");
  CHECK(s.allow[1].rule == "ETK104");
  CHECK(s.allow[1].expires == "2027-03-04");
  CHECK(parse_config("", "etak.toml") == ValidateConfig{});
}

TEST_CASE("endings of a project's own are read with their role or their channels") {
  const ValidateConfig config = parse_config(R"toml(
[names]
_Alb = "base_color"
"base color" = "base-color"
_pbr = { channels = ["roughness", "none", "metallic"] }
_prev = "ignore"
)toml",
                                             "etak.toml");
  CHECK(config.names == std::vector<OwnName>{{"alb", FileRole::base_color, ""},
                                             {"pbr", FileRole::metal_rough, "r-m-"},
                                             {"prev", FileRole::ignored, ""},
                                             {"base_color", FileRole::base_color, ""}});
}

TEST_CASE("what is wrong in a configuration is refused with file and line") {
  struct Row {
    const char* text;
    const char* told;
  };
  const Row rows[] = {
      {"profil = \"strict\"", "etak.toml:1: unknown key \"profil\""},
      {"\nprofile = \"loose\"", "etak.toml:2: profile"},
      {"profile = 3", "default, strict, film or custom"},
      {"transfer = \"rec709\"", "srgb, power-2.2 or linear"},
      {"fail_on = \"off\"", "error, warning or info"},
      {"[rules]\nETK999 = \"off\"", "etak.toml:2: ETK904 unknown-rule"},
      {"[rules]\nETK101 = \"fatal\"", "off, info, warning, error or on"},
      {"[rules]\nETK101 = 3", "off, info, warning, error or on"},
      {"[rules]\nETK202 = { min_bite = 50 }", "has no parameter \"min_bite\"; expected one of severity"},
      {"[rules]\nETK202 = { min_byte = \"50\" }", "a number"},
      {"[rules]\nETK202 = { min_byte = nan }", "a number"},
      {"[rules]\nETK001 = \"off\"", "it tells what was not checked"},
      {"[roles]\nnormal = \"*_n.*\"", "unknown role \"normal\""},
      {"[roles]\ndiffuse = [1]", "a pattern"},
      {"[names]\n_x = \"colour\"", "etak.toml:2: [names] _x: "},
      {"[names]\n_x = 3", "{ channels = ["},
      {"[names]\n_x = { role = \"normal\" }", "{ channels = ["},
      {"[names]\n_x = { channels = [\"gold\"] }", "one to four of roughness"},
      {"[names]\n_x = { channels = [] }", "one to four of roughness"},
      {"[names]\n_x = { channels = [\"occlusion\"] }", "no roughness, smoothness or metallic"},
      {"[names]\n_x = { channels = [\"metallic\", \"metallic\"] }", "a channel twice"},
      {"[names]\n_x = \"normal\"\n-X = \"height\"", "etak.toml:"},
      {"[names]\n\"\" = \"normal\"", "no ending"},
      {"names = \"_x\"", "a table"},
      {"[zone]\nlow = 0.5\nhigh = 0.4", "low 0.5 is not below high 0.4"},
      {"[zone]\nerode = 4", "1, 3 or 5"},
      {"[zone]\nmin_area_px = 1.5", "a whole number"},
      {"[[allow]]\nrule = \"ETK101\"", "no reason"},
      {"[[allow]]\nrule = \"ETK101\"\nreason = \"  \"", "no reason"},
      {"[[allow]]\nreason = \"x\"", "no rule"},
      {"[[allow]]\nrule = \"ETKX\"\nreason = \"x\"", "etak.toml:2: ETK904"},
      {"[[allow]]\nrule = \"ETK101\"\nreason = \"x\"\nexpires = \"soon\"", "a date"},
      {"[[allow]]\nrule = \"ETK101\"\nreason = \"x\"\nowner = \"me\"", "unknown key \"owner\""},
      {"[allow]\nrule = \"ETK101\"", "tables [[allow]]"},
      {"zone = 3", "a table"},
      {"profile = \"strict\"\nprofile = \"strict\"", "etak.toml:2:"},
      {"profile = ", "a TOML document"},
      {"\xff\xfe", "a TOML document"}};
  for (const Row& row : rows) {
    INFO(row.text);
    CHECK(contains(problem(row.text), row.told));
  }
  CHECK(problem(std::string(100000, '[')) != "");
}

TEST_CASE("the closer name wins, wherever it stands, and on is the profile's severity") {
  const ValidateConfig config =
      parse_config("[rules]\nETK101 = \"warning\"\nETK1 = \"off\"\nETK = \"info\"\n", "etak.toml");
  CHECK(severity(config, "ETK101") == Severity::warning);
  CHECK(severity(config, "ETK103") == Severity::off);
  CHECK(severity(config, "ETK201") == Severity::info);
  const ValidateConfig custom =
      parse_config("profile = \"custom\"\n[rules]\nETK101 = \"on\"\nETK111 = \"on\"\n", "etak.toml");
  CHECK(severity(custom, "ETK101") == Severity::error);
  CHECK(severity(custom, "ETK111") != Severity::off);
  CHECK(severity(custom, "ETK103") == Severity::off);
}

TEST_CASE("select, only, extend-select and ignore choose rules") {
  const auto chosen = [](const RuleChoice& choice, const std::string& config = {}) {
    ValidateConfig out = parse_config(config, "etak.toml");
    apply_choice(choice, out.settings);
    return out;
  };
  const ValidateConfig select =
      chosen({{}, {"ETK1"}, {}, {"ETK103"}}, "[rules]\nETK101 = \"off\"\nETK104 = \"info\"");
  CHECK(severity(select, "ETK101") == Severity::off);
  CHECK(severity(select, "ETK103") == Severity::off);
  CHECK(severity(select, "ETK104") == Severity::info);
  CHECK(severity(select, "ETK202") == Severity::off);
  CHECK(severity(select, "ETK001") == Severity::error);
  const ValidateConfig only = chosen({{"ETK101"}, {}, {}, {}}, "[rules]\nETK101 = \"off\"");
  CHECK(severity(only, "ETK101") == Severity::error);
  CHECK(severity(only, "ETK104") == Severity::off);
  CHECK(severity(chosen({{}, {}, {"ETK111"}, {}}), "ETK111") != Severity::off);
  CHECK(severity(chosen({{}, {}, {"f0-not-in-database"}, {}}), "ETK111") != Severity::off);
  CHECK(contains(error_of([&] { (void)chosen({{}, {}, {}, {"ETK777"}}); }), "ignore: ETK904"));
}

TEST_CASE("the settings' hash changes with whatever changes findings, and with nothing else") {
  const auto hash = [](const std::string& text) {
    return settings_hash(parse_config(text, "etak.toml").settings);
  };
  const std::string plain = hash("");
  CHECK(plain.size() == 32);
  CHECK(hash("fail_on = \"info\"") == plain);
  CHECK(hash("[[allow]]\nrule = \"ETK101\"\nreason = \"x\"") == plain);
  CHECK(hash("[rules]\nETK202 = \"warning\"") == plain);
  for (const char* text :
       {"transfer = \"power-2.2\"", "transfer = \"srgb\"", "alpha = \"transparency\"", "profile = \"strict\"",
        "[rules]\nETK202 = \"error\"", "[rules]\nETK202 = { min_byte = 31 }", "[zone]\nlow = 0.21",
        "[zone]\nmetric = \"max\"", "[zone]\nerode = 5", "[zone]\nmin_area_px = 31"})
    CHECK(hash(text) != plain);
}

TEST_CASE("an [[allow]] entry is written so that it reads the same") {
  const AllowEntry entry{"ETK108",    {}, "Umlaut \xc3\xbc \"quoted\" \\", {}, "a toy,\nnot a car",
                         "2031-05-01"};
  const std::string before = "profile = \"strict\"\n# the end";
  CHECK(parse_config(before + allow_text(entry), "etak.toml").settings.allow ==
        std::vector<AllowEntry>{entry});
}
