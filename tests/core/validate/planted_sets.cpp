// SPDX-License-Identifier: Apache-2.0
#include "tests/core/validate/planted_sets.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include "core/color/srgb.h"
#include "core/image/files/png.h"
#include "tests/core/judge/corpus.h"
#include "tests/support.h"

namespace etak::test {
namespace {

constexpr int side = 128;

/// A material as the maps that a studio makes of it.
struct Surface {
  Image8 base{side, side, 3}, normal{side, side, 3}, height{side, side, 1};
  Image8 occlusion{side, side, 1, 255}, roughness{side, side, 1}, metallic{side, side, 1, 0};
};

// What differs from one kind of surface to the next.
struct SurfaceKind {
  std::array<int, 3> colour, metal;
  double metal_share;           // 0 none, 1 all, else where the mask of blobs is
  int rough_least, rough_most;  // of what is no metal
  double depth;                 // of the relief, in codes of occlusion
};
constexpr SurfaceKind kinds[] = {
    {{140, 128, 112}, {}, 0, 160, 225, 120},              // stone
    {{}, {255, 226, 155}, 1, 60, 120, 30},                // gold
    {{150, 60, 50}, {196, 199, 199}, 0.5, 90, 140, 60},   // chipped paint on steel
    {{60, 90, 140}, {}, 0, 70, 100, 0},                   // plastic
    {{130, 90, 60}, {}, 0, 120, 190, 70},                 // wood
    {{190, 185, 175}, {}, 0, 205, 248, 90},               // plaster
    {{110, 62, 40}, {250, 208, 192}, 0.5, 170, 230, 80},  // corroded copper
    {{}, {245, 246, 246}, 1, 90, 170, 0},                 // aluminium
};
constexpr int kind_count = static_cast<int>(std::size(kinds));

void add_normals(Surface& out, const Pixels<float>& heights, double strength) {
  const auto at = [&](int x, int y) { return heights.at((x + side) % side, (y + side) % side)[0]; };
  each_texel(out.normal, [&](auto texel, int x, int y) {
    const double right = strength * double{at(x + 1, y) - at(x - 1, y)},
                 down = strength * double{at(x, y + 1) - at(x, y - 1)};
    const double length = std::sqrt(right * right + down * down + 1);
    const std::array<double, 3> n{-right / length, down / length, 1 / length};
    for (std::size_t c = 0; c < 3; ++c) texel[c] = to_byte(127.5 + 127.5 * n[c]);
  });
}

Surface surface(int number, Random& random) {
  const SurfaceKind& kind = kinds[number % kind_count];
  Surface out;
  const Pixels<float> heights = blob_mask(side, 3, random.next()), fine = blob_mask(side, 1.5, random.next()),
                      chips = blob_mask(side, 0.7, random.next());
  const int shift = random.below(20) - 10, metal_rough = 70 + random.below(60);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double h = 0.7 * double{heights.at(x, y)[0]} + 0.3 * double{fine.at(x, y)[0]};
      const double metal = kind.metal_share == 0.5 ? double{chips.at(x, y)[0]} : kind.metal_share;
      const int noise = random.below(9) - 4;
      for (std::size_t c = 0; c < 3; ++c)
        out.base.at(x, y)[c] =
            to_byte((1 - metal) * (kind.colour[c] + shift + 24 * (h - 0.5) + noise) + metal * kind.metal[c]);
      const double rough = kind.rough_least + (kind.rough_most - kind.rough_least) * double{fine.at(x, y)[0]};
      out.roughness.at(x, y)[0] = to_byte((1 - metal) * rough + metal * metal_rough + noise);
      out.metallic.at(x, y)[0] = to_byte(255 * metal);
      out.occlusion.at(x, y)[0] = to_byte(std::min(255.0, 265 - kind.depth * std::max(0.0, 0.7 - h)));
      out.height.at(x, y)[0] = to_byte(255 * h);
    }
  add_normals(out, heights, 1 + 2 * random.unit());
  return out;
}

template <class Value>
std::string png_of(const Pixels<Value>& image) {
  return png_bytes(PngRows(image), {});
}

Image8 packed(const Image8& red, const Image8& green, const Image8& blue) {
  Image8 out(side, side, 3);
  each_texel(out, [&](auto texel, int x, int y) {
    texel[0] = red.at(x, y)[0];
    texel[1] = green.at(x, y)[0];
    texel[2] = blue.at(x, y)[0];
  });
  return out;
}

// The file that OpenImageIO makes of a picture: "a.jpg" with "jpeg:85".
std::string lossy_file(const Image8& image, const std::string& name, const std::string& compression) {
  const TempFolder folder;
  OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeUInt8);
  spec["compression"] = compression;
  const auto output = OIIO::ImageOutput::create(folder.file(name));
  REQUIRE(output);
  REQUIRE(output->open(folder.file(name), spec));
  REQUIRE(output->write_image(OIIO::TypeUInt8, image.values.data()));
  REQUIRE(output->close());
  return slurp(folder.file(name));
}

std::uint32_t crc_of(std::string_view bytes) {
  std::uint32_t crc = ~0U;
  for (const char c : bytes) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? 0xEDB88320U ^ crc >> 1U : crc >> 1U;
  }
  return ~crc;
}

std::string number_of_four_bytes(std::uint32_t value) {
  std::string out;
  for (int shift = 24; shift >= 0; shift -= 8)
    out += static_cast<char>(value >> static_cast<unsigned>(shift) & 255U);
  return out;
}

// A PNG with a chunk behind its header.
std::string with_chunk(std::string png, const std::string& type, const std::string& data) {
  constexpr std::size_t behind_header = 8 + 25;
  const std::string body = type + data;
  return png.insert(behind_header, number_of_four_bytes(static_cast<std::uint32_t>(data.size())) + body +
                                       number_of_four_bytes(crc_of(body)));
}

// Primaries and white as a cHRM chunk has them.
std::string chromaticities(const std::array<double, 8>& xy) {
  std::string out;
  for (const double value : xy)
    out += number_of_four_bytes(static_cast<std::uint32_t>(std::lround(1e5 * value)));
  return out;
}

using Files = std::map<std::string, std::string>;

Files single_files(const Surface& s) {
  return {{"wall_basecolor.png", png_of(s.base)},
          {"wall_roughness.png", png_of(s.roughness)},
          {"wall_metallic.png", png_of(s.metallic)},
          {"wall_normal.png", png_of(s.normal)}};
}

Files packed_files(const Surface& s, const std::string& word, const Image8& codes) {
  return {{"wall_basecolor.png", png_of(s.base)},
          {"wall_normal.png", png_of(s.normal)},
          {"wall_" + word + ".png", png_of(codes)}};
}

// The three channels of ORM, or of MRAO, of which two were exchanged: 0 and 1, 1 and 2, or 0 and 2.
Files exchanged(const Surface& s, int one, int other, bool metal_first) {
  std::array<const Image8*, 3> parts{&s.occlusion, &s.roughness, &s.metallic};
  if (metal_first) std::swap(parts[0], parts[2]);
  std::swap(parts[static_cast<std::size_t>(one)], parts[static_cast<std::size_t>(other)]);
  return packed_files(s, metal_first ? "mrao" : "orm", packed(*parts[0], *parts[1], *parts[2]));
}

Image8 encoded_normals(Image8 map) {
  for (std::uint8_t& code : map.values) code = srgb_u8(code / 255.0);
  return map;
}

struct Maker {
  std::string kind, rule;
  Severity severity;
  int status;
  Files (*make)(int number, const Surface&, Random&);
};

constexpr auto exchange = [](int number, const Surface& s, int one, int other) {
  return exchanged(s, one, other, number % 3 == 2);
};

const Maker makers[] = {
    {"first and second channel of a packed picture exchanged", "ETK116", Severity::error, 1,
     [](int n, const Surface& s, Random&) { return exchange(n, s, 0, 1); }},
    {"second and third channel of a packed picture exchanged", "ETK116", Severity::error, 1,
     [](int n, const Surface& s, Random&) { return exchange(n, s, 1, 2); }},
    {"first and third channel of a packed picture exchanged", "ETK116", Severity::error, 1,
     [](int n, const Surface& s, Random& random) {
       // On a metal all over, occlusion and metallic are both about 255: there is nothing to be told apart.
       const bool metal = kinds[n % kind_count].metal_share == 1;
       return exchange(n, metal ? surface(n + 1, random) : s, 0, 2);
     }},
    {"normals encoded to sRGB in a JPEG", "ETK704", Severity::error, 1,
     [](int, const Surface& s, Random& random) {
       return Files{{"wall_normal.jpg", lossy_file(encoded_normals(s.normal), "a.jpg",
                                                   "jpeg:" + std::to_string(78 + random.below(21)))}};
     }},
    {"normals encoded to sRGB in a lossy WebP", "ETK704", Severity::error, 1,
     [](int, const Surface& s, Random& random) {
       return Files{{"wall_normal.webp", lossy_file(encoded_normals(s.normal), "a.webp",
                                                    "webp:" + std::to_string(70 + random.below(26)))}};
     }},
    {"the base colour as roughness", "ETK004", Severity::error, 1,
     [](int n, const Surface& s, Random& random) {
       // Aluminium is grey: its picture may be of roughness.
       Files out = single_files(n % kind_count == kind_count - 1 ? surface(n + 1, random) : s);
       out["wall_roughness.png"] = out["wall_basecolor.png"];
       return out;
     }},
    {"the normal map as roughness", "ETK004", Severity::error, 1,
     [](int, const Surface& s, Random&) {
       Files out = single_files(s);
       out["wall_roughness.png"] = out["wall_normal.png"];
       return out;
     }},
    {"the normal map as metallic", "ETK004", Severity::error, 1,
     [](int, const Surface& s, Random&) {
       Files out = single_files(s);
       out["wall_metallic.png"] = out["wall_normal.png"];
       return out;
     }},
    {"roughness of another aspect", "ETK003", Severity::warning, 0,
     [](int, const Surface& s, Random& random) {
       Files out = single_files(s);
       const int rows = 40 + random.below(60);
       Image8 cut(side, rows, 1);
       each_texel(cut, [&](auto texel, int x, int y) { texel[0] = s.roughness.at(x, y)[0]; });
       out["wall_roughness.png"] = png_of(cut);
       return out;
     }},
    {"cICP says Display P3 or PQ", "ETK006", Severity::warning, 0,
     [](int n, const Surface& s, Random&) {
       Files out = single_files(s);
       const std::string codes =
           n % 2 == 0 ? std::string("\x0c\x0d\x00\x01", 4) : std::string("\x09\x10\x00\x01", 4);
       out["wall_basecolor.png"] = with_chunk(out["wall_basecolor.png"], "cICP", codes);
       return out;
     }},
    {"cHRM says the primaries of Adobe RGB or Rec.2020", "ETK006", Severity::warning, 0,
     [](int n, const Surface& s, Random&) {
       Files out = single_files(s);
       const std::string xy =
           n % 2 == 0 ? chromaticities({0.3127, 0.3290, 0.64, 0.33, 0.21, 0.71, 0.15, 0.06})
                      : chromaticities({0.3127, 0.3290, 0.708, 0.292, 0.170, 0.797, 0.131, 0.046});
       out["wall_basecolor.png"] = with_chunk(out["wall_basecolor.png"], "cHRM", xy);
       return out;
     }},
    {"a constant normal map that leans", "ETK705", Severity::warning, 0,
     [](int, const Surface& s, Random& random) {
       Files out = single_files(s);
       Image8 map(side, side, 3, 255);
       const auto red = static_cast<std::uint8_t>(160 + random.below(60));
       each_texel(map, [&](auto texel, int, int) {
         texel[0] = red;
         texel[1] = 128;
       });
       out["wall_normal.png"] = png_of(map);
       return out;
     }},
    {"normals that are hollow where the height map stands out", "ETK714", Severity::warning, 0,
     [](int, const Surface& s, Random&) {
       Files out = single_files(s);
       Image8 map = s.normal;
       each_texel(map, [](auto texel, int, int) {
         for (std::size_t c = 0; c < 2; ++c) texel[c] = static_cast<std::uint8_t>(255 - texel[c]);
       });
       out["wall_normal.png"] = png_of(map);
       out["wall_height.png"] = png_of(s.height);
       return out;
     }},
    {"metallic of 0.9 where metal is 1", "ETK113", Severity::warning, 0,
     [](int n, const Surface&, Random& random) {
       const int metals[] = {1, 7};  // gold, aluminium
       const Surface s = surface(metals[n % 2], random);
       Files out = single_files(s);
       Image8 map(side, side, 1, static_cast<std::uint8_t>(230 + random.below(12)));
       out["wall_metallic.png"] = png_of(map);
       return out;
     }},
    {"roughness of four steps", "ETK304", Severity::info, 0,
     [](int, const Surface&, Random& random) {
       const Surface s = surface(4, random);  // wood, whose roughness has many codes
       Files out = single_files(s);
       Image8 map = s.roughness;
       const int first = 60 + random.below(30), step = 20 + random.below(20);
       for (std::uint8_t& code : map.values)
         code = static_cast<std::uint8_t>(first + step * std::clamp((code - 120) * 4 / 70, 0, 3));
       out["wall_roughness.png"] = png_of(map);
       return out;
     }},
    {"16 bits that hold 8", "ETK715", Severity::info, 0,
     [](int n, const Surface& s, Random&) {
       Files out = single_files(s);
       const Image8& from = n % 2 == 0 ? s.roughness : s.base;
       Image16 wide(side, side, from.channels);
       for (std::size_t i = 0; i < from.values.size(); ++i)
         wide.values[i] = static_cast<std::uint16_t>((n % 3 == 0 ? 256 : 257) * from.values[i]);
       out[n % 2 == 0 ? "wall_roughness.png" : "wall_basecolor.png"] = png_of(wide);
       return out;
     }},
    {"the base colour as normal map", "ETK702", Severity::error, 1,
     [](int n, const Surface&, Random& random) {
       const int dark[] = {2, 4,
                           6};  // what is bluer than the middle looks like a normal map that is not unit
       const Surface s = surface(dark[n % 3], random);
       Files out = single_files(s);
       out["wall_normal.png"] = out["wall_basecolor.png"];
       return out;
     }},
    {"the base colour as roughness in a JPEG", "ETK004", Severity::error, 1,
     [](int n, const Surface& s, Random& random) {
       Files out = single_files(n % kind_count == kind_count - 1 ? surface(n + 1, random) : s);
       out.erase("wall_roughness.png");
       const Image8 colours = n % kind_count == kind_count - 1 ? surface(n + 1, random).base : s.base;
       out["wall_roughness.jpg"] =
           lossy_file(colours, "a.jpg", "jpeg:" + std::to_string(80 + random.below(19)));
       return out;
     }},
    {"second and third channel exchanged in a JPEG", "ETK116", Severity::error, 1,
     [](int, const Surface& s, Random& random) {
       Files out{{"wall_basecolor.png", png_of(s.base)}, {"wall_normal.png", png_of(s.normal)}};
       out["wall_orm.jpg"] = lossy_file(packed(s.occlusion, s.metallic, s.roughness), "a.jpg",
                                        "jpeg:" + std::to_string(85 + random.below(14)));
       return out;
     }},
    {"an empty file without its companions", "ETK001", Severity::error, 2,
     [](int n, const Surface&, Random&) {
       return Files{{n % 2 == 0 ? "wall_basecolor.png" : "wall_orm.png", ""}};
     }},
    {"a pointer of Git LFS without its companions", "ETK011", Severity::error, 2,
     [](int n, const Surface&, Random&) {
       return Files{{n % 2 == 0 ? "wall_basecolor.png" : "wall_roughness.png",
                     "version https://git-lfs.github.com/spec/v1\noid sha256:" + std::string(64, 'a') +
                         "\nsize " + std::to_string(1000 + n) + "\n"}};
     }},
    {"a packed picture in a format that is not read", "ETK002", Severity::error, 1,
     [](int n, const Surface& s, Random&) {
       return Files{{"wall_basecolor.png", png_of(s.base)},
                    {n % 2 == 0 ? "wall_orm.psd" : "wall_orm.avif", "8BPS"}};
     }},
    {"the base colour as occlusion", "ETK004", Severity::error, 1,
     [](int n, const Surface& s, Random& random) {
       const Surface coloured = n % kind_count == kind_count - 1 ? surface(n + 1, random) : s;
       Files out = single_files(coloured);
       if (n % 2 == 0)
         out["wall_ao.png"] = out["wall_basecolor.png"];
       else
         out["wall_ao.jpg"] =
             lossy_file(coloured.base, "a.jpg", "jpeg:" + std::to_string(80 + random.below(19)));
       return out;
     }},
    {"the normal map as occlusion", "ETK004", Severity::error, 1,
     [](int, const Surface& s, Random&) {
       Files out = single_files(s);
       out["wall_ao.png"] = out["wall_normal.png"];
       return out;
     }},
    {"the normal map as base colour", "ETK004", Severity::error, 1,
     [](int n, const Surface& s, Random& random) {
       Files out = n % 3 == 0 ? packed_files(s, "orm", packed(s.occlusion, s.roughness, s.metallic))
                              : single_files(s);
       out.erase("wall_basecolor.png");
       if (n % 2 == 0)
         out["wall_basecolor.png"] = png_of(s.normal);
       else
         out["wall_basecolor.jpg"] =
             lossy_file(s.normal, "a.jpg", "jpeg:" + std::to_string(80 + random.below(19)));
       return out;
     }},
    {"the normal map as diffuse", "ETK004", Severity::error, 1,
     [](int, const Surface& s, Random&) {
       return Files{{"wall_diffuse.png", png_of(s.normal)},
                    {"wall_specular.png", png_of(Image8(side, side, 3, 56))},
                    {"wall_glossiness.png", png_of(s.roughness)},
                    {"wall_normal.png", png_of(s.normal)}};
     }},
};

}  // namespace

std::vector<PlantedSet> right_sets(int count, std::uint64_t seed) {
  std::vector<PlantedSet> out;
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const Surface s = surface(i, random);
    PlantedSet& set = out.emplace_back();
    set.status = 0;
    const int form = i / kind_count % 3;
    set.files = form == 0   ? single_files(s)
                : form == 1 ? packed_files(s, "orm", packed(s.occlusion, s.roughness, s.metallic))
                            : packed_files(s, "mrao", packed(s.metallic, s.roughness, s.occlusion));
    if (i % 2 == 1) set.files["wall_height.png"] = png_of(s.height);
    if (form == 0 && i % 3 == 0) set.files["wall_ao.jpg"] = lossy_file(s.occlusion, "a.jpg", "jpeg:80");
  }
  return out;
}

std::vector<PlantedSet> planted_sets(int count, std::uint64_t seed) {
  std::vector<PlantedSet> out;
  Random random(seed);
  for (const Maker& maker : makers)
    for (int i = 0; i < count; ++i)
      out.push_back(
          {maker.kind, maker.rule, maker.severity, maker.status, maker.make(i, surface(i, random), random)});
  return out;
}

}  // namespace etak::test
