// SPDX-License-Identifier: Apache-2.0
// The rules on normal, occlusion and emissive maps: made-up maps, untouched and with defects of the strength that
// each rule states.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "core/color/srgb.h"
#include "core/judge/engine.h"
#include "core/judge/rules.h"
#include "core/maps/map_survey.h"
#include "tests/core/judge/corpus.h"
#include "tests/core/judge/made_maps.h"
#include "tests/core/validate/checked.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr int side = 256;

/// A normal map with what lies beside it.
struct MapSet {
  Image8 normals, height, gloss;  // the last two may be empty
  GreenAxis green = GreenAxis::opengl;
};

CheckedFile judged(MapEvidence map, const Settings& settings = {}) {
  Evidence evidence;
  map.label = "map.png";
  map.said_by = "its name";
  evidence.maps = {std::move(map)};
  CheckedFile file;
  judge({}, evidence, settings, file);
  return file;
}

CheckedFile judged(const MapSet& set, const Settings& settings = {}) {
  const auto normals = rows_of(set.normals);
  const auto height = set.height.values.empty() ? nullptr : rows_of(set.height);
  const auto gloss = set.gloss.values.empty() ? nullptr : rows_of(set.gloss);
  MapEvidence map = survey_normals(*normals, {height.get(), gloss.get(), {}});
  map.green = set.green;
  return judged(std::move(map), settings);
}

std::string told(const CheckedFile& file) {
  std::string out;
  for (const Finding& finding : file.findings)
    out += finding.rule + " (" + std::string(name(finding.severity)) + ") " + finding.message + "\n";
  return out;
}

void off_length(MapSet& set, Random& random) {
  each_texel(set.normals, [&](auto texel, int, int) {
    if (random.below(20) != 0) return;
    for (std::uint8_t& code : texel) code = to_byte(127.5 + (code - 127.5) * (1 - 4 / 127.5));
  });
}

void point_down(MapSet& set, Random& random) {
  each_texel(set.normals, [&](auto texel, int, int) {
    if (random.below(600) == 0) texel[2] = static_cast<std::uint8_t>(255 - std::max<int>(texel[2], 140));
  });
}

void turn_green(MapSet& set, Random&) {
  each_texel(set.normals, [](auto texel, int, int) { texel[1] = static_cast<std::uint8_t>(255 - texel[1]); });
}

void encode(MapSet& set, Random&) {
  for (std::uint8_t& code : set.normals.values) code = srgb_u8(code / 255.0);
}

}  // namespace

TEST_CASE("defects of normal maps are found from the stated strength on, and clean maps give no error") {
  constexpr int seeds = 12, kinds = 4;
  std::map<std::string, std::array<int, 2>> score;  // planted, found
  std::string missed;
  const auto plant = [&](const std::string& rule, const MapSet& set, int kind, int seed) {
    const CheckedFile file = judged(set);
    ++score[rule][0];
    if (find(file, rule) != nullptr)
      ++score[rule][1];
    else
      missed += rule + " of kind " + std::to_string(kind) + ", seed " + std::to_string(seed) + ": " +
                told(file) + "\n";
  };
  for (int kind = 0; kind < kinds; ++kind)
    for (int seed = 0; seed < seeds; ++seed) {
      const auto origin = static_cast<std::uint64_t>(100 * kind + seed);
      const Heights heights = surface(kind, origin, side);
      const MapSet clean{normals_of(heights), grey_of(heights), {}};
      const CheckedFile untouched = judged(clean);
      INFO("kind " << kind << ", seed " << seed << "\n" << told(untouched));
      CHECK(std::ranges::none_of(untouched.findings,
                                 [](const Finding& f) { return f.severity >= Severity::warning; }));
      Random random(origin);
      const auto with = [&](auto change) {
        MapSet set = clean;
        change(set, random);
        return set;
      };
      plant("ETK701", with(off_length), kind, seed);
      plant("ETK702", with(point_down), kind, seed);
      plant("ETK703", with(turn_green), kind, seed);
      plant("ETK704", with(encode), kind, seed);
      MapSet small = clean;
      small.normals = halved(normals_of(surface(kind, origin, 2 * side)));
      small.height = {};
      plant("ETK706", small, kind, seed);
      MapSet jpeg = clean;
      jpeg.normals = through_jpeg(clean.normals, 85, seed % 2 == 1);
      plant("ETK708", jpeg, kind, seed);
      MapSet grey = clean;
      grey.normals = clean.height;
      plant("ETK710", grey, kind, seed);
      MapSet shiny = clean;
      shiny.normals = normals_of(heights, 4);
      shiny.gloss = Image8(side, side, 1, 60);
      plant("ETK709", shiny, kind, seed);
    }
  UNSCOPED_INFO(missed);
  for (const auto& [rule, counts] : score) {
    INFO(rule << ": " << counts[1] << " of " << counts[0]);
    CHECK(100 * counts[1] >= 98 * counts[0]);
  }
}

TEST_CASE("JPEG is told from its steps at any quality up to 85") {
  for (const int quality : {50, 75, 85})
    for (int kind = 0; kind < 3; ++kind) {
      const Image8 map = through_jpeg(normals_of(surface(kind, 7, side)), quality, true);
      const CheckedFile file = judged(MapSet{map, {}, {}});
      INFO("quality " << quality << ", kind " << kind << "\n" << told(file));
      CHECK(find(file, "ETK708") != nullptr);
      CHECK(find(file, "ETK701") == nullptr);
    }
}

TEST_CASE("green is held against what the name says, and by the height map where the surface has no twist") {
  const Heights heights = surface(0, 3, side);
  MapSet set{normals_of(heights), {}, {}, GreenAxis::directx};
  const CheckedFile wrong = judged(set);
  REQUIRE(find(wrong, "ETK703") != nullptr);
  CHECK(find(wrong, "ETK703")->severity == Severity::error);
  CHECK(find(wrong, "ETK703")->value == "OpenGL (green up)");
  set.green = GreenAxis::unsaid;
  CHECK(find(judged(set), "ETK703") == nullptr);
  // Grooves along both axes that do not cross: no twist.
  Heights grooves(side, side, 1);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      grooves.at(x, y)[0] = static_cast<float>(4 * std::sin((y < side / 2 ? x : y) / 5.0));
  set = {normals_of(grooves), {}, {}, GreenAxis::directx};
  CHECK(find(judged(set), "ETK703") == nullptr);
  set.height = grey_of(grooves);
  const CheckedFile beside = judged(set);
  INFO(told(beside));
  REQUIRE(find(beside, "ETK703") != nullptr);
  CHECK(find(beside, "ETK703")->message.find("height map") != std::string::npos);
  set.green = GreenAxis::opengl;
  CHECK(find(judged(set), "ETK703") == nullptr);
}

TEST_CASE("flat areas in two codes, constant maps and maps of two channels are told apart") {
  MapSet set{normals_of(surface(3, 1, side)), {}, {}};
  CHECK(find(judged(set), "ETK707") == nullptr);
  each_texel(set.normals, [](auto texel, int x, int) {
    if (x < side / 2 && texel[0] == 128) texel[0] = 127;
  });
  CHECK(find(judged(set), "ETK707") != nullptr);
  set.normals = Image8(side, side, 3, 128);
  each_texel(set.normals, [](auto texel, int, int) { texel[2] = 255; });
  const CheckedFile flat = judged(set);
  INFO(told(flat));
  REQUIRE(flat.findings.size() == 1);
  CHECK(flat.findings[0].rule == "ETK705");
  for (const int blue : {0, 255}) {
    set.normals = normals_of(surface(0, 1, side));
    each_texel(set.normals, [&](auto texel, int, int) { texel[2] = static_cast<std::uint8_t>(blue); });
    const CheckedFile two = judged(set);
    INFO(blue << "\n" << told(two));
    for (const char* rule : {"ETK701", "ETK702", "ETK706"}) CHECK(find(two, rule) == nullptr);
  }
}

TEST_CASE("a gentle relief that runs through the flattest codes has no flat areas in two codes") {
  for (const double codes :
       {1.5, 2.0}) {  // amplitudes of which a tenth of the texels have the flattest codes
    MapSet set{normals_of(surface(3, 1, side)), {}, {}};
    each_texel(set.normals, [&](auto texel, int x, int y) {
      const double right = codes / 127.5 * std::sin(0.11 * x + 0.05 * y),
                   down = codes / 127.5 * std::cos(0.09 * y);
      texel[0] = to_byte(127.5 + 127.5 * right);
      texel[1] = to_byte(127.5 + 127.5 * down);
      texel[2] = 255;
    });
    CAPTURE(codes);
    CHECK(find(judged(set), "ETK707") == nullptr);
  }
}

TEST_CASE("what several mistakes may have made is told with all of these as possible causes") {
  const Heights heights = surface(2, 5, side);
  MapSet red{normals_of(heights), grey_of(heights), {}};
  each_texel(red.normals, [](auto texel, int, int) { texel[0] = static_cast<std::uint8_t>(255 - texel[0]); });
  const CheckedFile inverted = judged(red);
  const Finding* const hollow = find(inverted, "ETK714");
  REQUIRE(hollow != nullptr);
  CHECK(contains(hollow->message, "with the other sign"));
  for (const char* cause : {"possible cause: ", "red and green", "red alone", "depths"})
    CHECK(contains(hollow->cause, cause));
  const CheckedFile small = judged(MapSet{halved(normals_of(surface(2, 5, 2 * side))), {}, {}});
  const Finding* const shrunk = find(small, "ETK706");
  REQUIRE(shrunk != nullptr);
  CHECK(contains(shrunk->cause, "possible cause: the map was scaled down or blurred"));
}

TEST_CASE("rough relief asks for wide highlights, and gloss that answers is left alone") {
  MapSet set{normals_of(surface(2, 5, side), 4), {}, Image8(side, side, 1, 60)};
  CHECK(find(judged(set), "ETK709") != nullptr);
  set.gloss = Image8(side, side, 1, 230);
  CHECK(find(judged(set), "ETK709") == nullptr);
  set.gloss = Image8(side, side, 1, 60);
  set.normals = normals_of(surface(2, 5, side), 0.1);
  CHECK(find(judged(set), "ETK709") == nullptr);
}

TEST_CASE("occlusion that is constant or inverted and emission beyond its mask are found") {
  const auto survey = [](const Image8& map, FileRole role, const Image8* alpha = nullptr) {
    const auto rows = rows_of(map);
    const auto beside = alpha == nullptr ? nullptr : rows_of(*alpha);
    return judged(survey_grey(*rows, role, beside.get()));
  };
  Random random(4);
  for (int seed = 0; seed < 20; ++seed) {
    // Open but for crevices.
    Image8 occlusion(side, side, 1, 255), inverted = occlusion;
    const Image8 heights = grey_of(surface(seed % 3, static_cast<std::uint64_t>(seed), side));
    for (std::size_t i = 0; i < occlusion.values.size(); ++i) {
      occlusion.values[i] = to_byte(std::min(255.0, 178 + 0.9 * heights.values[i]));
      inverted.values[i] = static_cast<std::uint8_t>(255 - occlusion.values[i]);
    }
    const CheckedFile clean = survey(occlusion, FileRole::occlusion);
    INFO(seed << "\n" << told(clean));
    CHECK(clean.findings.empty());
    CHECK((find(survey(inverted, FileRole::occlusion), "ETK712") != nullptr));
    // A lamp on black.
    Image8 emissive(side, side, 3, 0);
    each_texel(emissive, [](auto texel, int x, int y) {
      if (x > 60 && x < 120 && y > 60 && y < 90) std::ranges::fill(texel, std::uint8_t{220});
    });
    CHECK(survey(emissive, FileRole::emissive).findings.empty());
    Image8 veiled = emissive;
    const auto veil = static_cast<std::uint8_t>(1 + random.below(16));
    for (std::uint8_t& code : veiled.values) code = std::max(code, veil);
    CHECK(find(survey(veiled, FileRole::emissive), "ETK713") != nullptr);
    Image8 alpha(side, side, 4, 255);
    each_texel(alpha, [](auto texel, int x, int) {
      if (x < 90) texel[3] = 0;
    });
    CHECK(find(survey(emissive, FileRole::emissive, &alpha), "ETK713") != nullptr);
  }
  const CheckedFile white = survey(Image8(side, side, 1, 255), FileRole::occlusion);
  REQUIRE(find(white, "ETK711") != nullptr);
  CHECK(find(white, "ETK711")->severity == Severity::info);
  CHECK(find(survey(Image8(side, side, 1, 128), FileRole::occlusion), "ETK711")->severity ==
        Severity::warning);
}
