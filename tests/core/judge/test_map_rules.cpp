// SPDX-License-Identifier: Apache-2.0
// The rules on normal, occlusion and emissive maps: made-up maps, untouched and with defects of the strength that
// each rule states.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "core/color/srgb.h"
#include "core/judge/engine.h"
#include "core/judge/maps/map_survey.h"
#include "core/judge/rules.h"
#include "tests/core/judge/corpus.h"
#include "tests/core/validate/checked.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr int side = 256;

/// Heights in texels, wrapped round at the edges.
using Heights = Pixels<float>;

float height_at(const Heights& h, int x, int y) {
  return h.at((x + h.width) % h.width, (y + h.height) % h.height)[0];
}

// Smoothed random values on grids of 1/2, 1/4, ... of the side.
Heights noise(int size, Random& random) {
  Heights out(size, size, 1);
  for (int cell = 32; cell >= 4; cell /= 2) {
    const int cells = size / cell;
    std::vector<float> grid(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
    for (float& value : grid) value = static_cast<float>(random.between(-1, 1));
    const auto at = [&](int x, int y) {
      return grid[static_cast<std::size_t>(y % cells) * static_cast<std::size_t>(cells) +
                  static_cast<std::size_t>(x % cells)];
    };
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const auto smooth = [](float t) { return t * t * (3 - 2 * t); };
        const float u = smooth(static_cast<float>(x % cell) / static_cast<float>(cell)),
                    v = smooth(static_cast<float>(y % cell) / static_cast<float>(cell));
        const float top = at(x / cell, y / cell) * (1 - u) + at(x / cell + 1, y / cell) * u,
                    low = at(x / cell, y / cell + 1) * (1 - u) + at(x / cell + 1, y / cell + 1) * u;
        out.at(x, y)[0] += 0.3f * static_cast<float>(cell) * (top * (1 - v) + low * v);
      }
  }
  return out;
}

// Bricks with bevels of 5 texels, each a little askew (tilt 0: all of them flat).
Heights bricks(int size, Random& random, double tilt) {
  Heights out(size, size, 1);
  const int width = 43, height = 21, bevel = 5;
  std::map<std::array<int, 2>, std::array<double, 2>> tilts;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const int row = y / height, shifted = x + (row % 2) * (width / 2);
      const int u = shifted % width, v = y % height;
      auto [entry, is_new] = tilts.try_emplace({shifted / width, row});
      if (is_new) entry->second = {random.between(-tilt, tilt), random.between(-tilt, tilt)};
      const int edge = std::min({u, width - 1 - u, v, height - 1 - v, bevel});
      out.at(x, y)[0] = static_cast<float>(0.8 * edge + entry->second[0] * u + entry->second[1] * v);
    }
  return out;
}

// Round bumps of 4 to 8 texels.
Heights bumps(int size, Random& random) {
  Heights out(size, size, 1);
  for (int i = 0; i < size * size / 120; ++i) {
    const int x0 = random.below(size), y0 = random.below(size);
    const double radius = random.between(4, 8), high = random.between(-0.5, 0.9) * radius;
    for (int y = -20; y <= 20; ++y)
      for (int x = -20; x <= 20; ++x)
        out.at((x0 + x + size) % size, (y0 + y + size) % size)[0] +=
            static_cast<float>(high * std::exp(-(x * x + y * y) / (radius * radius)));
  }
  return out;
}

// Green points up.
Image8 normals_of(const Heights& h, double strength = 1) {
  Image8 out(h.width, h.height, 3);
  each_texel(out, [&](auto texel, int x, int y) {
    const double right = strength * (height_at(h, x + 1, y) - height_at(h, x - 1, y)) / 2,
                 down = strength * (height_at(h, x, y + 1) - height_at(h, x, y - 1)) / 2;
    const double length = std::sqrt(right * right + down * down + 1);
    const std::array<double, 3> n{-right / length, down / length, 1 / length};
    for (std::size_t c = 0; c < 3; ++c) texel[c] = to_byte(127.5 + 127.5 * n[c]);
  });
  return out;
}

Image8 grey_of(const Heights& h) {
  const auto [least, most] = std::ranges::minmax(h.values);
  Image8 out(h.width, h.height, 1);
  for (std::size_t i = 0; i < out.values.size(); ++i)
    out.values[i] = to_byte(255 * (h.values[i] - least) / std::max(most - least, 1e-6f));
  return out;
}

// Kinds: noise, uneven bricks, bumps, even bricks.
Heights surface(int kind, std::uint64_t seed, int size) {
  Random random(seed);
  if (kind == 0) return noise(size, random);
  if (kind == 1) return bricks(size, random, 0.15);
  if (kind == 2) return bumps(size, random);
  return bricks(size, random, 0);
}

// Means of 2 x 2 texels.
Image8 halved(const Image8& large) {
  Image8 out(large.width / 2, large.height / 2, large.channels);
  each_texel(out, [&](auto texel, int x, int y) {
    for (std::size_t c = 0; c < texel.size(); ++c)
      texel[c] = to_byte((large.at(2 * x, 2 * y)[c] + large.at(2 * x + 1, 2 * y)[c] +
                          large.at(2 * x, 2 * y + 1)[c] + large.at(2 * x + 1, 2 * y + 1)[c]) /
                         4.0);
  });
  return out;
}

// Quantises the cosines of an 8 x 8 block as JPEG does: ITU-T T.81, annex K.
void quantise(std::array<double, 64>& block, bool chroma, int quality) {
  constexpr std::array<int, 64> luma_steps{
      16, 11,  10,  16, 24, 40, 51, 61, 12,  12,  14,  19,  26, 58, 60, 55,  14,  13,  16,  24, 40, 57,
      69, 56,  14,  17, 22, 29, 51, 87, 80,  62,  18,  22,  37, 56, 68, 109, 103, 77,  24,  35, 55, 64,
      81, 104, 113, 92, 49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98,  112, 100, 103, 99};
  const double scale = quality < 50 ? 5000.0 / quality : 200.0 - 2 * quality;
  static const auto basis = [] {
    std::array<std::array<double, 8>, 8> out{};
    for (std::size_t u = 0; u < 8; ++u)
      for (std::size_t x = 0; x < 8; ++x)
        out[u][x] =
            (u == 0 ? std::sqrt(0.125) : 0.5) *
            std::cos((2.0 * static_cast<double>(x) + 1) * static_cast<double>(u) * std::numbers::pi / 16);
    return out;
  }();
  std::array<double, 64> half{}, cosines{};
  for (std::size_t y = 0; y < 8; ++y)
    for (std::size_t u = 0; u < 8; ++u)
      for (std::size_t x = 0; x < 8; ++x) half[8 * y + u] += basis[u][x] * (block[8 * y + x] - 128);
  for (std::size_t v = 0; v < 8; ++v)
    for (std::size_t u = 0; u < 8; ++u) {
      for (std::size_t y = 0; y < 8; ++y) cosines[8 * v + u] += basis[v][y] * half[8 * y + u];
      constexpr std::array<int, 4> chroma_corner{17, 18, 24, 47};  // of its table; 99 beyond
      const int table = !chroma ? luma_steps[8 * v + u] : u + v < 4 ? chroma_corner[u + v] : 99;
      const double step = std::max(1.0, std::floor((table * scale + 50) / 100));
      cosines[8 * v + u] = step * std::round(cosines[8 * v + u] / step);
    }
  half.fill(0);
  for (std::size_t v = 0; v < 8; ++v)
    for (std::size_t x = 0; x < 8; ++x)
      for (std::size_t u = 0; u < 8; ++u) half[8 * v + x] += basis[u][x] * cosines[8 * v + u];
  for (std::size_t y = 0; y < 8; ++y)
    for (std::size_t x = 0; x < 8; ++x) {
      block[8 * y + x] = 128;
      for (std::size_t v = 0; v < 8; ++v) block[8 * y + x] += basis[v][y] * half[8 * v + x];
    }
}

// What a JPEG leaves of a picture; with `subsampled` chroma has half the side, as most programs write it.
Image8 through_jpeg(const Image8& image, int quality, bool subsampled) {
  std::array<Pixels<double>, 3> planes;
  for (auto& plane : planes) plane = Pixels<double>(image.width, image.height, 1);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto t = image.at(x, y);
      planes[0].at(x, y)[0] = 0.299 * t[0] + 0.587 * t[1] + 0.114 * t[2];
      planes[1].at(x, y)[0] = 128 - 0.168736 * t[0] - 0.331264 * t[1] + 0.5 * t[2];
      planes[2].at(x, y)[0] = 128 + 0.5 * t[0] - 0.418688 * t[1] - 0.081312 * t[2];
    }
  for (std::size_t p = 0; p < 3; ++p) {
    const int step = p > 0 && subsampled ? 2 : 1;
    Pixels<double> part(image.width / step, image.height / step, 1);
    const auto each = [&](auto act) {
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) act(planes[p].at(x, y)[0], part.at(x / step, y / step)[0]);
    };
    each([&](double whole, double& mean) { mean += std::round(whole) / (step * step); });
    for (int y = 0; y + 8 <= part.height; y += 8)
      for (int x = 0; x + 8 <= part.width; x += 8) {
        std::array<double, 64> block{};
        for (int i = 0; i < 64; ++i) block[static_cast<std::size_t>(i)] = part.at(x + i % 8, y + i / 8)[0];
        quantise(block, p > 0, quality);
        for (int i = 0; i < 64; ++i)
          part.at(x + i % 8, y + i / 8)[0] =
              std::clamp(std::round(block[static_cast<std::size_t>(i)]), 0.0, 255.0);
      }
    each([](double& whole, double mean) { whole = mean; });
  }
  Image8 out = image;
  each_texel(out, [&](auto t, int x, int y) {
    const double luma = planes[0].at(x, y)[0], blue = planes[1].at(x, y)[0] - 128,
                 red = planes[2].at(x, y)[0] - 128;
    t[0] = to_byte(luma + 1.402 * red);
    t[1] = to_byte(luma - 0.344136 * blue - 0.714136 * red);
    t[2] = to_byte(luma + 1.772 * blue);
  });
  return out;
}

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
