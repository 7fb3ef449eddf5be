// SPDX-License-Identifier: Apache-2.0
// Defects that are one only beside something said: a layout names materials, gloss or surfaces; a float file
// holds what no code can.
#include <limits>

#include "core/color/srgb.h"
#include "core/judge/nearest.h"
#include "core/judge/pixels/code_tables.h"
#include "tests/core/judge/corpus.h"

namespace etak::test {

namespace {

CheckTile tile_of(std::string name, std::string material, PixelBox box) {
  CheckTile tile;
  tile.name = std::move(name);
  tile.material = std::move(material);
  tile.box = box;
  return tile;
}

// Equal columns of the picture, one tile each; bleeding is not what is asked.
void name_columns(TextureSet& set, const std::vector<std::string>& materials) {
  const int count = static_cast<int>(materials.size());
  for (int i = 0; i < count; ++i) {
    const int x0 = set.b.width * i / count, x1 = set.b.width * (i + 1) / count;
    set.manifest.tiles.push_back(tile_of("column " + std::to_string(i),
                                         materials[static_cast<std::size_t>(i)],
                                         {x0, 0, x1 - x0, set.b.height}));
  }
  set.manifest.mips = 0;
}

std::array<int, 3> codes_of(const KnownF0& entry) {
  std::array<int, 3> codes{};
  for (std::size_t c = 0; c < 3; ++c) codes[c] = srgb_u8(std::clamp(entry.linear[c], 0.0, 1.0));
  return codes;
}

const KnownF0& any_known(Random& random, bool conductor) {
  std::vector<const KnownF0*> entries;
  for (const KnownF0& entry : KnownMaterials::builtin().f0())
    if (entry.preferred && entry.conductor == conductor) entries.push_back(&entry);
  return *entries[static_cast<std::size_t>(random.below(static_cast<int>(entries.size())))];
}

void make_floats(TextureSet& set) {
  const CodeTables& tables = code_tables(TextureTransfer::srgb);
  set.b_floats = Pixels<float>(set.b.width, set.b.height, 4);
  for (std::size_t i = 0; i < set.b.values.size(); ++i)
    set.b_floats.values[i] =
        static_cast<float>(i % 4 == 3 ? set.b.values[i] / 255.0 : tables.decoded[set.b.values[i]]);
}

void put_float(TextureSet& set, Random& random, float value) {
  make_floats(set);
  const int count = 1 + random.below(3);
  for (int i = 0; i < count; ++i)
    set.b_floats.at(random.below(set.b.width),
                    random.below(set.b.height))[static_cast<std::size_t>(random.below(4))] = value;
}

}  // namespace

const std::vector<Mutation>& mutations_told() {
  static const std::vector<Mutation> list{
      {"ETK007", "one to three NaN or Inf of a float file",
       [](TextureSet& s, Random& r) {
         using Limits = std::numeric_limits<float>;
         put_float(s, r, r.below(2) == 0 ? Limits::quiet_NaN() : Limits::infinity());
       }},
      {"ETK008", "one to three negative values of a float file",
       [](TextureSet& s, Random& r) { put_float(s, r, static_cast<float>(-r.between(0.00001, 2))); }},
      {"ETK102", "metal painted with a soft brush",
       [](TextureSet& s, Random& r) {
         const double period = r.between(28, 44), metal = r.between(0.85, 0.95);
         each_texel(s.b, [&](auto b, int x, int y) {
           const double phase = std::fmod(x + 0.3 * y, period) / period;
           const double m = phase < 0.5 ? 2 * phase : 2 - 2 * phase;
           const int code = srgb_u8(0.04 * (1 - m) + metal * m);
           set_rgb(b, {code, code, code});
         });
       },
       0, nullptr, Severity::warning},
      {"ETK110", "noise on the F0 of one material",
       [](TextureSet& s, Random& r) {
         const int middle = 56 + r.below(20);
         const double noise = r.between(6, 14);
         each_texel(s.b, [&](auto b, int, int) {
           const int code = static_cast<int>(middle + r.between(-noise, noise));
           set_rgb(b, {code, code, code});
         });
         name_columns(s, {"varnish"});
       }},
      {"ETK111", "patch of an F0 that nothing has",
       [](TextureSet& s, Random& r) {
         std::array<int, 3> codes{};
         double distance = 0;
         while (distance <= 8) {
           std::array<double, 3> linear{};
           for (std::size_t c = 0; c < 3; ++c) {
             codes[c] = 40 + r.below(200);
             linear[c] = srgb_decode(codes[c] / 255.0);
           }
           distance =
               nearest_materials(KnownMaterials::builtin(), linear, TextureTransfer::srgb, 1).front().bytes;
         }
         const int side = 12 + r.below(20), x0 = r.below(s.b.width - side), y0 = r.below(s.b.height - side);
         for (int y = y0; y < y0 + side; ++y)
           for (int x = x0; x < x0 + side; ++x) set_rgb(s.b.at(x, y), codes);
       }},
      {"ETK112", "a metal under the name of another",
       [](TextureSet& s, Random& r) {
         const KnownF0* named = nullptr;
         const KnownF0* drawn = nullptr;
         double distance = 0;
         while (distance <= 4) {
           named = &any_known(r, true);
           drawn = &any_known(r, true);
           distance = 255;
           for (const KnownF0* entry : KnownMaterials::builtin().f0_of(named->id))
             distance = std::min(distance, code_distance(drawn->linear, *entry, TextureTransfer::srgb));
         }
         each_texel(s.b, [&](auto b, int, int) { set_rgb(b, codes_of(*drawn)); });
         name_columns(s, {named->id});
       }},
      {"ETK205", "snow as dark as sand",
       [](TextureSet& s, Random& r) {
         const int code = srgb_u8(r.between(0.2, 0.7));
         each_texel(s.a, [&](auto a, int, int) {
           const int grey = code + r.below(9) - 4;
           set_rgb(a, {grey, grey, grey});
         });
         s.manifest.surface_class = "snow";
       }},
      {"ETK206", "white and glossy plastic",
       [](TextureSet& s, Random& r) {
         s.manifest.specular_weighs_diffuse = false;
         const int white = srgb_u8(r.between(0.7, 0.9)), f0 = srgb_u8(r.between(0.04, 0.08));
         each_texel(s.a, [&](auto a, int, int) { set_rgb(a, {white, white, white}); });
         each_texel(s.b, [&](auto b, int, int) {
           set_rgb(b, {f0, f0, f0});
           b[3] = to_byte(r.between(232, 252));
         });
       }},
      {"ETK303", "roughness of three materials in place of gloss",
       [](TextureSet& s, Random& r) {
         name_columns(s, {"one", "two", "three"});
         for (CheckTile& tile : s.manifest.tiles) {
           const int gloss = r.below(2) == 0 ? 30 + r.below(80) : 145 + r.below(80);
           tile.typical_gloss = gloss / 255.0;
           for (int y = 0; y < tile.box.height; ++y)
             for (int x = tile.box.x; x < tile.box.x + tile.box.width; ++x)
               s.b.at(x, y)[3] = to_byte(255 - gloss + r.between(-6, 6));
         }
       }},
      {"ETK403", "two dielectrics by exponent 1/2.2",
       [](TextureSet& s, Random& r) {
         std::vector<std::string> names;
         std::vector<int> codes;
         while (names.size() < 2) {
           const KnownF0& entry = any_known(r, false);
           const int code = code_tables(TextureTransfer::power_22).encode(entry.luminance);
           // Where the two curves, or the sources of the material, say nearly the same nobody can tell.
           bool clear = entry.luminance < 0.1;
           for (const KnownF0* other : KnownMaterials::builtin().f0_of(entry.id))
             clear = clear && std::abs(srgb_u8(other->luminance) - code) >= 3;
           if (!clear || std::ranges::find(names, entry.id) != names.end()) continue;
           names.push_back(entry.id);
           codes.push_back(code);
         }
         each_texel(s.b, [&](auto b, int x, int) {
           const int code = codes[2 * x < s.b.width ? 0 : 1];
           set_rgb(b, {code, code, code});
         });
         name_columns(s, names);
       }},
  };
  return list;
}

}  // namespace etak::test
