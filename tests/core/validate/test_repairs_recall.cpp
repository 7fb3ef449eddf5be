// SPDX-License-Identifier: Apache-2.0
// Defects are drawn into right sets, the sets are repaired, and the copies are held against the sets as they
// were before the defect.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "core/findings/output/formats.h"
#include "core/judge/nearest.h"
#include "core/validate/repairs/repair.h"
#include "tests/core/validate/repaired.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

template <class Value>
Planted curve_of_specular(Random& random, double (*curve)(double), const char* rule, double least = 0.03,
                          double most = 0.06) {
  auto b = varied_f0<Value>(random, random.between(least, most), 0.1 * least);
  Planted out;
  out.rule = rule;
  out.repaired = "crate_spec.png";
  out.right = out.wrong = {{"crate_diff.png", noisy_diffuse(random)}, {"crate_spec.png", b}};
  put_through(b, curve);
  out.wrong["crate_spec.png"] = b;
  return out;
}

Planted short_normals(Random& random) {
  auto map = wavy_normals<std::uint8_t>(random);
  Planted out;
  out.rule = "ETK701";
  out.repaired = "crate_normal.png";
  out.right = {{"crate_normal.png", map}};
  for (std::size_t i = 0; i < map.values.size(); i += 3)
    if (random.below(20) == 0)
      for (std::size_t c = 0; c < 3; ++c)
        map.values[i + c] = to_byte(127.5 + (map.values[i + c] - 127.5) * (1 - 4 / 127.5));
  out.wrong = {{"crate_normal.png", map}};
  return out;
}

// Gold with a patch that is half of it, in a set that is said to be gold.
Planted half_gold(Random& random) {
  const KnownF0* gold = nullptr;
  for (const KnownF0* entry : KnownMaterials::builtin().f0_of("gold"))
    if (entry->preferred) gold = entry;
  REQUIRE(gold != nullptr);
  Image8 a(set_edge, set_edge, 4, 0), b(set_edge, set_edge, 4);
  each_texel(a, [](auto texel, int, int) { texel[3] = 255; });
  Planted out;
  out.rule = "ETK101";
  out.repaired = "crate_spec.png";
  out.material = "gold";
  const Patch square{10 + random.below(60), 10 + random.below(60), 24 + random.below(20)};
  each_texel(b, [&](auto texel, int, int) {
    for (std::size_t c = 0; c < 3; ++c) texel[c] = srgb_u8(std::clamp(gold->linear[c], 0.0, 1.0));
    texel[3] = static_cast<std::uint8_t>(100 + random.below(60));
  });
  out.right = {{"crate_diff.png", a}, {"crate_spec.png", b}};
  each_texel(b, [&](auto texel, int x, int y) {
    for (std::size_t c = 0; c < 3 && square.holds(x, y); ++c)
      texel[c] = srgb_u8(0.45 * std::clamp(gold->linear[c], 0.0, 1.0));
  });
  out.wrong = {{"crate_diff.png", a}, {"crate_spec.png", b}};
  return out;
}

// Patches of metallic between 0 and 1 on a sharp mask.
Planted half_metal(Random& random) {
  Image8 base(set_edge, set_edge, 3), roughness(set_edge, set_edge, 1), metallic(set_edge, set_edge, 1, 0);
  each_texel(base, [&](auto texel, int x, int) {
    const int value = x < set_edge / 2 ? 200 + random.below(20) : 60 + random.below(40);
    set_rgb(texel, {value, value, value});
  });
  each_texel(roughness,
             [&](auto texel, int, int) { texel[0] = static_cast<std::uint8_t>(100 + random.below(60)); });
  each_texel(metallic, [&](auto texel, int x, int) { texel[0] = x < set_edge / 2 ? 255 : 0; });
  Planted out;
  out.rule = "ETK113";
  out.repaired = "crate_metallic.png";
  out.right = out.wrong = {
      {"crate_basecolor.png", base}, {"crate_roughness.png", roughness}, {"crate_metallic.png", metallic}};
  const Patch in_metal{10, 20 + random.below(40), 24}, beside{set_edge / 2 + 20, 20 + random.below(40), 24};
  const auto high = static_cast<std::uint8_t>(150 + random.below(60)),
             low = static_cast<std::uint8_t>(40 + random.below(130));
  each_texel(metallic, [&](auto texel, int x, int y) {
    if (in_metal.holds(x, y)) texel[0] = high;
    if (beside.holds(x, y)) texel[0] = low;
  });
  out.wrong["crate_metallic.png"] = metallic;
  return out;
}

// A square of metal whose diffuse should be black.
Planted diffuse_under_metal(Random& random) {
  Image8 a = noisy_diffuse(random), b(set_edge, set_edge, 4, 56);
  const Patch square{10 + random.below(60), 10 + random.below(60), 24 + random.below(20)};
  each_texel(b, [&](auto texel, int x, int y) {
    if (square.holds(x, y)) set_rgb(texel, {250, 229, 158});
    texel[3] = static_cast<std::uint8_t>(100 + random.below(60));
  });
  Planted out;
  out.rule = "ETK108";
  out.repaired = "crate_diff.png";
  out.wrong = {{"crate_diff.png", a}, {"crate_spec.png", b}};
  each_texel(a, [&](auto texel, int x, int y) {
    if (square.holds(x, y)) set_rgb(texel, {0, 0, 0});
  });
  out.right = {{"crate_diff.png", a}, {"crate_spec.png", b}};
  return out;
}

// A disk of metal with a soft edge, whose diffuse should be dark by as much of metal as there is.
Planted diffuse_under_soft_metal(Random& random) {
  Image8 right = noisy_diffuse(random), b(set_edge, set_edge, 4);
  const int x0 = 40 + random.below(40), y0 = 40 + random.below(40), radius = 20 + random.below(10);
  const double soft = random.between(1, 4);
  const auto share = [&](int x, int y) {
    return std::clamp(0.5 + (radius - std::hypot(x - x0, y - y0)) / soft, 0.0, 1.0);
  };
  Planted out;
  out.rule = "ETK108";
  out.repaired = "crate_diff.png";
  const std::array<double, 3> gold{0.96, 0.78, 0.34};
  each_texel(b, [&](auto texel, int x, int y) {
    for (std::size_t c = 0; c < 3; ++c) texel[c] = srgb_u8(0.04 + share(x, y) * (gold[c] - 0.04));
    texel[3] = static_cast<std::uint8_t>(100 + random.below(60));
  });
  out.wrong = {{"crate_diff.png", right}, {"crate_spec.png", b}};
  each_texel(right, [&](auto texel, int x, int y) {
    for (std::size_t c = 0; c < 3; ++c) texel[c] = srgb_u8((1 - share(x, y)) * srgb_decode(texel[c] / 255.0));
  });
  out.right = {{"crate_diff.png", right}, {"crate_spec.png", b}};
  return out;
}

// The same cut-out with metal on a half of it, whose hidden texels are no metal.
Planted hidden_black_of_metal(Random& random) {
  const int shade = 120 + random.below(80), radius = 20 + random.below(30);
  Image8 base(set_edge, set_edge, 4), orm(set_edge, set_edge, 3);
  const auto is_metal = [](int x) { return x < set_edge / 2; };
  const auto is_seen = [&](int x, int y) { return std::hypot(x - set_edge / 2, y - set_edge / 2) < radius; };
  each_texel(base, [&](auto texel, int x, int y) {
    set_rgb(texel, is_metal(x) ? std::array{230, 220, 200} : std::array{shade, shade - 15, shade - 40});
    texel[3] = is_seen(x, y) ? 255 : 0;
  });
  each_texel(orm, [&](auto texel, int x, int) {
    set_rgb(texel, {255, 100 + random.below(60), is_metal(x) ? 255 : 0});
  });
  Planted out;
  out.rule = "ETK502";
  out.repaired = "crate_basecolor.png";
  out.right = {{"crate_basecolor.png", base}, {"crate_orm.png", orm}};
  for (int y = 0; y < set_edge; ++y)
    for (int x = 0; x < set_edge; ++x)
      if (!is_seen(x, y)) {
        for (std::size_t c = 0; c < 3; ++c) base.at(x, y)[c] = 0;
        orm.at(x, y)[2] = 0;
      }
  out.wrong = {{"crate_basecolor.png", base}, {"crate_orm.png", orm}};
  return out;
}

// A cut-out of one colour whose hidden texels have another.
Planted hidden_black(Random& random) {
  const int shade = 120 + random.below(80), radius = 20 + random.below(30);
  Image8 a(set_edge, set_edge, 4), b = varied_f0<std::uint8_t>(random, 0.045, 0.002);
  each_texel(a, [&](auto texel, int x, int y) {
    set_rgb(texel, {shade, shade - 15, shade - 40});
    texel[3] = std::hypot(x - set_edge / 2, y - set_edge / 2) < radius ? 255 : 0;
  });
  Planted out;
  out.rule = "ETK502";
  out.repaired = "crate_diff.png";
  out.right = {{"crate_diff.png", a}, {"crate_spec.png", b}};
  each_texel(a, [](auto texel, int, int) {
    if (texel[3] == 0) set_rgb(texel, {0, 0, 0});
  });
  out.wrong = {{"crate_diff.png", a}, {"crate_spec.png", b}};
  return out;
}

// A soft cut-out multiplied by its alpha: no repair, because little is left of colour under little alpha.
Planted premultiplied(Random& random) {
  Image8 a = noisy_diffuse(random);
  each_texel(a, [](auto texel, int x, int y) {
    texel[3] = to_byte(255 * std::abs(std::sin(x / 20.0) * std::sin(y / 20.0)));
  });
  Planted out;
  out.rule = "ETK501";
  out.repaired = "crate_diff.png";
  out.right =
      out.wrong = {{"crate_diff.png", a}, {"crate_spec.png", varied_f0<std::uint8_t>(random, 0.045, 0.004)}};
  each_texel(a, [](auto texel, int, int) {
    for (std::size_t c = 0; c < 3; ++c) texel[c] = to_byte(texel[c] * texel[3] / 255.0);
  });
  out.wrong["crate_diff.png"] = a;
  return out;
}

// The 99th percentile, over the texels, of the largest difference of a channel in 8-bit codes.
double percentile_99(const PictureCodes& one, const PictureCodes& other) {
  REQUIRE(one.index() == other.index());
  std::vector<double> differences;
  std::visit(
      [&](const auto& a) {
        const auto& b = std::get<std::decay_t<decltype(a)>>(other);
        REQUIRE(a.values.size() == b.values.size());
        const auto channels = static_cast<std::size_t>(a.channels);
        const double step = sizeof(a.values[0]) == 1 ? 1 : 257;
        for (std::size_t i = 0; i < a.values.size(); i += channels) {
          double most = 0;
          for (std::size_t c = 0; c < channels; ++c)
            most = std::max(most, std::abs(double{1} * a.values[i + c] - b.values[i + c]) / step);
          differences.push_back(most);
        }
      },
      one);
  const auto at = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() * 99 / 100);
  std::nth_element(differences.begin(), at, differences.end());
  return *at;
}

struct BackShare {
  int planted = 0, back = 0;
};

// Plants a defect, repairs it, and counts whether the file is back within 2 codes.
void plant_and_repair(BackShare& share, const Planted& planted) {
  const TempFolder folder;
  const std::string from = folder.file("in"), to = folder.file("out");
  put_pictures(from, planted.wrong);
  ++share.planted;
  const RepairedFolder repaired = repair_folder(from, to, planted.material);
  INFO(planted.rule << "\n" << validation_text(repaired.before) << repairs_text(repaired.report, {}));
  REQUIRE(has_rule(repaired.before, planted.rule));
  for (const auto& [file, codes] : planted.wrong) CHECK(slurp(from + "/" + file) == file_of_codes(codes));
  const auto file = std::ranges::find(repaired.report.files, planted.repaired, &RepairedFile::copy);
  if (file == repaired.report.files.end() || file->steps.empty()) return;
  CHECK_FALSE(has_rule(repaired.after, planted.rule));
  share.back +=
      percentile_99(planted.right.at(planted.repaired), loaded_codes(to + "/" + planted.repaired)) <= 2;
}

// Plants a defect, repairs it, and asks that no error or warning is left.
void leaves_nothing(const Planted& planted) {
  const TempFolder folder;
  const std::string from = folder.file("in"), to = folder.file("out");
  put_pictures(from, planted.wrong);
  const RepairedFolder repaired = repair_folder(from, to, planted.material);
  INFO(planted.rule << "\n"
                    << validation_text(repaired.before) << repairs_text(repaired.report, {})
                    << validation_text(repaired.after));
  REQUIRE(has_rule(repaired.before, planted.rule));
  CHECK(repaired.after.errors + repaired.after.warnings == 0);
}

}  // namespace

TEST_CASE("a soft edge of metal is darkened by as much metal as there is, and nothing is left to find") {
  for (int seed = 0; seed < 8; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    leaves_nothing(diffuse_under_soft_metal(random));
  }
}

TEST_CASE("hidden texels of a set with metal get the colour and the metal of their neighbours") {
  for (int seed = 0; seed < 8; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    leaves_nothing(hidden_black_of_metal(random));
  }
}

TEST_CASE("nine of ten planted defects whose inverse lies within 2 codes are back within 2 codes") {
  constexpr int seeds = 8;
  std::map<std::string, BackShare> within, beyond;
  for (int seed = 0; seed < seeds; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    plant_and_repair(within["F0 encoded twice"],
                     curve_of_specular<std::uint8_t>(random, srgb_encode, "ETK402"));
    plant_and_repair(within["F0 encoded twice, 16 bits"],
                     curve_of_specular<std::uint16_t>(random, srgb_encode, "ETK402"));
    plant_and_repair(within["F0 stored linear, 16 bits"],
                     curve_of_specular<std::uint16_t>(random, srgb_decode, "ETK401"));
    plant_and_repair(within["normals encoded"], curve_of_normals<std::uint8_t>(random, srgb_encode));
    plant_and_repair(within["normals encoded, 16 bits"],
                     curve_of_normals<std::uint16_t>(random, srgb_encode));
    plant_and_repair(within["normals decoded, 16 bits"],
                     curve_of_normals<std::uint16_t>(random, srgb_decode));
    plant_and_repair(within["short normals"], short_normals(random));
    plant_and_repair(within["a patch encoded twice"], doubled_patch(random));
    plant_and_repair(within["a patch of a named material"], half_gold(random));
    plant_and_repair(within["half metal"], half_metal(random));
    plant_and_repair(within["diffuse under metal"], diffuse_under_metal(random));
    plant_and_repair(within["hidden colour"], hidden_black(random));
    plant_and_repair(within["F0 stored linear"],
                     curve_of_specular<std::uint8_t>(random, srgb_decode, "ETK401"));
    plant_and_repair(within["normals decoded"], curve_of_normals<std::uint8_t>(random, srgb_decode));
    // Where the curve is steepest, half a code of rounding comes back as more than 2.
    plant_and_repair(beyond["F0 below 0.022 stored linear"],
                     curve_of_specular<std::uint8_t>(random, srgb_decode, "ETK401", 0.018, 0.021));
    plant_and_repair(beyond["steep normals decoded"], curve_of_normals<std::uint8_t>(random, srgb_decode, 4));
    plant_and_repair(beyond["premultiplied colour"], premultiplied(random));
  }
  BackShare sum, rest;
  for (const auto& [what, share] : within) {
    UNSCOPED_INFO(what << ": " << share.back << " of " << share.planted);
    sum.planted += share.planted;
    sum.back += share.back;
  }
  for (const auto& [what, share] : beyond) {
    UNSCOPED_INFO("beyond 2 codes, " << what << ": " << share.back << " of " << share.planted);
    rest.planted += share.planted;
    rest.back += share.back;
  }
  CHECK(100 * sum.back >= 90 * sum.planted);
  CHECK(rest.planted == 3 * seeds);
}
