// SPDX-License-Identifier: Apache-2.0
#include "tests/core/validate/corpus.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/color/srgb.h"
#include "core/validate/nearest.h"

namespace etak::test {

std::uint64_t Random::next() {
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return z ^ z >> 31;
}

double Random::unit() {
  return static_cast<double>(next() >> 11) * 0x1p-53;
}

int Random::below(int count) {
  return static_cast<int>(next() % static_cast<std::uint64_t>(count));
}

namespace {

std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::floor(value + 0.5), 0.0, 255.0));
}

// Smooth noise in [0, 1]: random values on a lattice, smoothstep between them.
class Lattice {
 public:
  Lattice(int cells, Random& random)
      : cells_(cells), values_(static_cast<std::size_t>((cells + 2) * (cells + 2))) {
    for (double& v : values_) v = random.unit();
  }
  double at(double u, double v) const {  // [0, 1)
    const double x = u * cells_, y = v * cells_;
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const double s = smooth(x - i), t = smooth(y - j);
    const auto value = [&](int a, int b) { return values_[static_cast<std::size_t>(b * (cells_ + 2) + a)]; };
    return (value(i, j) * (1 - s) + value(i + 1, j) * s) * (1 - t) +
           (value(i, j + 1) * (1 - s) + value(i + 1, j + 1) * s) * t;
  }

 private:
  static double smooth(double t) { return t * t * (3 - 2 * t); }
  int cells_;
  std::vector<double> values_;
};

void fill_alpha_and_gloss(TextureSet& set, Random& random) {
  const Lattice slow(6, random);
  for (int y = 0; y < set.a.height; ++y)
    for (int x = 0; x < set.a.width; ++x) {
      const double v = slow.at(double{1} * x / set.a.width, double{1} * y / set.a.height);
      set.a.at(x, y)[3] = 255;
      set.b.at(x, y)[3] = to_byte(70 + 110 * v + random.between(-6, 6));
    }
}

// Metals that no rule has anything to say of: bright, and inside of the gamut.
const std::vector<const KnownF0*>& plain_metals() {
  static const auto metals = [] {
    std::vector<const KnownF0*> out;
    for (const KnownF0& entry : known_f0())
      if (entry.conductor && entry.preferred && entry.luminance > 0.5 &&
          *std::ranges::max_element(entry.linear) < 0.98)
        out.push_back(&entry);
    return out;
  }();
  return metals;
}

// The square of `side` texels, drawn with `draw(a, b, metallic)` in every texel.
template <class Draw>
void patch(TextureSet& set, Random& random, int side, Draw draw) {
  const int x0 = random.below(set.b.width - side + 1), y0 = random.below(set.b.height - side + 1);
  for (int y = y0; y < y0 + side; ++y)
    for (int x = x0; x < x0 + side; ++x) {
      // What is drawn is visible and no metal, unless `draw` says so.
      if (set.metallic.width != 0) set.metallic.at(x, y)[0] = 0;
      set.a.at(x, y)[3] = 255;
      draw(set.a.at(x, y), set.b.at(x, y), x, y);
    }
}

void set_rgb(std::span<std::uint8_t> texel, std::array<int, 3> codes) {
  for (std::size_t c = 0; c < 3; ++c) texel[c] = to_byte(codes[c]);
}

template <class Act>
void each_texel(Image8& image, Act act) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) act(image.at(x, y), x, y);
}

double mean_code(const Image8& image) {
  double sum = 0;
  for (std::size_t i = 0; i < image.values.size(); ++i) sum += i % 4 == 3 ? 0 : image.values[i];
  return sum / (0.75 * static_cast<double>(image.values.size()));
}

bool is_metal(std::span<const std::uint8_t> specular) {
  return std::max({specular[0], specular[1], specular[2]}) > 124;
}

}  // namespace

CheckedFile check_set(const TextureSet& set, const Settings& settings, unsigned threads) {
  CheckTarget target;
  target.label = "set";
  target.manifest = set.manifest;
  target.files = {
      {set.metallic.width != 0 ? FileRole::base_color : FileRole::diffuse_alpha, "", "a.png", false},
      {set.metallic.width != 0 ? FileRole::metal_rough : FileRole::specular_gloss, "", "b.png", false}};
  return check_pictures(target, {&set.a, &set.b, set.metallic.width != 0 ? &set.metallic : nullptr}, settings,
                        threads);
}

bool found(const CheckedFile& file, std::string_view rule, Severity at_least) {
  return std::ranges::any_of(file.findings,
                             [&](const Finding& f) { return f.rule == rule && f.severity >= at_least; });
}

std::size_t errors(const CheckedFile& file) {
  return static_cast<std::size_t>(
      std::ranges::count_if(file.findings, [](const Finding& f) { return f.severity == Severity::error; }));
}

TextureSet flat_set(int size, std::array<int, 3> specular, std::array<int, 3> diffuse, std::uint64_t seed) {
  Random random(seed);
  TextureSet set{Image8(size, size, 4), Image8(size, size, 4), {}, {}, {}};
  each_texel(set.a, [&](auto texel, int, int) { set_rgb(texel, diffuse); });
  each_texel(set.b, [&](auto texel, int, int) { set_rgb(texel, specular); });
  fill_alpha_and_gloss(set, random);
  return set;
}

Pixels<float> blob_mask(int size, double sigma, std::uint64_t seed) {
  Random random(seed);
  const Lattice field(6, random);
  Pixels<float> mask(size, size, 1);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      float sum = 0;
      for (int i = 0; i < 4; ++i)
        sum += field.at((2 * x + i % 2 + 0.5) / (2.0 * size), (2 * y + i / 2 + 0.5) / (2.0 * size)) > 0.55
                   ? 0.25f
                   : 0.0f;
      mask.at(x, y)[0] = sum;
    }
  if (sigma <= 0) return mask;
  const int reach = static_cast<int>(std::ceil(4 * sigma));
  std::vector<double> weight;
  double total = 0;
  for (int i = -reach; i <= reach; ++i)
    total += weight.emplace_back(std::exp(-0.5 * i * i / (sigma * sigma)));
  Pixels<float> across(size, size, 1);
  for (const bool vertical : {false, true}) {
    const Pixels<float>& from = vertical ? across : mask;
    Pixels<float> to(size, size, 1);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        double sum = 0;
        for (int i = -reach; i <= reach; ++i) {
          const int u = vertical ? x : std::clamp(x + i, 0, size - 1),
                    v = vertical ? std::clamp(y + i, 0, size - 1) : y;
          sum += weight[static_cast<std::size_t>(i + reach)] * static_cast<double>(from.at(u, v)[0]);
        }
        to.at(x, y)[0] = static_cast<float>(sum / total);
      }
    (vertical ? mask : across) = std::move(to);
  }
  return mask;
}

TextureSet blended_set(const Pixels<float>& mask, double low, double high, Blend blend) {
  TextureSet set{Image8(mask.width, mask.height, 4), Image8(mask.width, mask.height, 4), {}, {}, {}};
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      const double m = static_cast<double>(mask.at(x, y)[0]);
      const std::uint8_t code = blend == Blend::linear
                                    ? srgb_u8(low * (1 - m) + high * m)
                                    : to_byte(255 * (srgb_encode(low) * (1 - m) + srgb_encode(high) * m));
      set_rgb(set.b.at(x, y), {code, code, code});
      const int diffuse = static_cast<int>(std::lround(120 * (1 - m)));
      set_rgb(set.a.at(x, y), {diffuse, diffuse, diffuse});
    }
  Random random(7);
  fill_alpha_and_gloss(set, random);
  return set;
}

std::array<int, 2> emptiest_place(const Pixels<float>& mask) {
  // Side of the largest square of texels without metal that ends in each texel, row by row.
  std::vector<int> above(static_cast<std::size_t>(mask.width)), here(above);
  int best = 0;
  std::array<int, 2> place{};
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      const auto i = static_cast<std::size_t>(x);
      here[i] = mask.at(x, y)[0] > 0.02f ? 0
                : x == 0 || y == 0       ? 1
                                         : 1 + std::min({above[i], here[i - 1], above[i - 1]});
      if (here[i] > best) {
        best = here[i];
        place = {x - best / 2, y - best / 2};
      }
    }
    above = here;
  }
  return place;
}

TextureSet natural_set(int size, std::uint64_t seed) {
  Random random(seed * 7919 + 13);
  struct Look {
    std::array<double, 3> f0, diffuse;
    double noise;
    bool metal;
  };
  std::vector<Look> looks;
  const int count = 1 + random.below(4);
  for (int i = 0; i < count; ++i) {
    Look look{};
    // The first one is a dielectric: sets of metal alone are rare, and half of the defects need a dielectric.
    look.metal = i > 0 && random.unit() < 0.5;
    if (look.metal) {
      look.f0 =
          plain_metals()[static_cast<std::size_t>(random.below(static_cast<int>(plain_metals().size())))]
              ->linear;
    } else {
      const double f0 = random.between(0.022, 0.07);
      look.f0 = {f0, f0, f0};
      const double level = random.between(0.06, 0.6);
      for (double& c : look.diffuse) c = std::clamp(level * random.between(0.75, 1.25), 0.04, 0.75);
    }
    look.noise = random.between(1, 9);
    looks.push_back(look);
  }
  TextureSet set{Image8(size, size, 4), Image8(size, size, 4), {}, {}, {}};
  std::vector<Pixels<float>> masks;
  for (int i = 1; i < count; ++i) masks.push_back(blob_mask(size, random.between(0, 1.2), random.next()));
  const Lattice shade(10, random);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      std::array<double, 3> f0 = looks[0].f0, diffuse = looks[0].diffuse;
      double noise = looks[0].noise;
      for (int i = 1; i < count; ++i) {
        const double m = static_cast<double>(masks[static_cast<std::size_t>(i - 1)].at(x, y)[0]);
        const Look& look = looks[static_cast<std::size_t>(i)];
        for (std::size_t c = 0; c < 3; ++c) {
          f0[c] = f0[c] * (1 - m) + look.f0[c] * m;
          diffuse[c] = diffuse[c] * (1 - m) + look.diffuse[c] * m;
        }
        noise = noise * (1 - m) + (look.metal ? 0 : look.noise) * m;
      }
      const double light = 0.8 + 0.4 * shade.at((x + 0.5) / size, (y + 0.5) / size);
      const double grain = random.between(-noise, noise);
      for (std::size_t c = 0; c < 3; ++c) {
        set.b.at(x, y)[c] = srgb_u8(f0[c]);
        set.a.at(x, y)[c] = to_byte(srgb_u8(diffuse[c] * light) + grain * (diffuse[c] > 0.02 ? 1 : 0));
      }
    }
  fill_alpha_and_gloss(set, random);
  return set;
}

const std::vector<Mutation>& mutations() {
  static const std::vector<Mutation> list{
      {"ETK101", "patch of F0 0.21 to 0.44",
       [](TextureSet& s, Random& r) {
         const int code = srgb_u8(r.between(0.21, 0.44)), side = 10 + r.below(20);
         patch(s, r, side, [&](auto, auto b, int, int) { set_rgb(b, {code, code, code}); });
       }},
      {"ETK103", "patch of F0 0.003 to 0.015",
       [](TextureSet& s, Random& r) {
         const int code = srgb_u8(r.between(0.003, 0.015)), side = 12 + r.below(20);
         patch(s, r, side, [&](auto, auto b, int, int) { set_rgb(b, {code, code, code}); });
       }},
      {"ETK104", "patch of F0 0",
       [](TextureSet& s, Random& r) {
         patch(s, r, 12 + r.below(20), [&](auto, auto b, int, int) { set_rgb(b, {0, 0, 0}); });
       }},
      {"ETK105", "patch of F0 0.09 to 0.19",
       [](TextureSet& s, Random& r) {
         const int code = srgb_u8(r.between(0.09, 0.19)), side = 12 + r.below(20);
         patch(s, r, side, [&](auto, auto b, int, int) { set_rgb(b, {code, code, code}); });
       }},
      {"ETK106", "coloured dielectric",
       [](TextureSet& s, Random& r) {
         const int low = 40 + r.below(20), high = low + 8 + r.below(20);
         patch(s, r, 12 + r.below(20), [&](auto, auto b, int, int) { set_rgb(b, {high, low, low}); });
       }},
      {"ETK107", "gold clipped at 255",
       [](TextureSet& s, Random& r) {
         const int side = s.b.width / 4 + r.below(10);
         patch(s, r, side, [&](auto a, auto b, int, int) {
           set_rgb(b, {255, 228, 156});
           set_rgb(a, {0, 0, 0});
         });
       },
       0,
       [](const TextureSet& s) {  // white metal hides gold's red
         std::size_t white = 0;
         for (std::size_t i = 2; i < s.b.values.size(); i += 4) white += s.b.values[i] == 255;
         return 200 * white < s.b.values.size() / 4;
       }},
      {"ETK108", "metal with diffuse",
       [](TextureSet& s, Random& r) {
         s.metallic = {};  // of pairs only
         const int diffuse = 60 + r.below(120);
         patch(s, r, 12 + r.below(20), [&](auto a, auto b, int, int) {
           set_rgb(b, {200, 195, 190});
           set_rgb(a, {diffuse, diffuse, diffuse});
         });
       }},
      {"ETK109", "dielectric without diffuse",
       [](TextureSet& s, Random& r) {
         patch(s, r, 12 + r.below(20), [&](auto a, auto b, int, int) {
           set_rgb(b, {56, 56, 56});
           set_rgb(a, {0, 0, 0});
         });
       }},
      {"ETK113", "half metal",
       [](TextureSet& s, Random& r) {
         s.metallic = Image8(s.b.width, s.b.height, 1);
         each_texel(s.metallic, [&](auto m, int x, int y) { m[0] = is_metal(s.b.at(x, y)) ? 255 : 0; });
         const int value = 40 + r.below(170);
         patch(s, r, 12 + r.below(20),
               [&](auto, auto, int x, int y) { s.metallic.at(x, y)[0] = to_byte(value); });
       }},
      {"ETK114", "metal of F0 0.03 to 0.18",
       [](TextureSet& s, Random& r) {
         s.metallic = Image8(s.b.width, s.b.height, 1);
         each_texel(s.metallic, [&](auto m, int x, int y) { m[0] = is_metal(s.b.at(x, y)) ? 255 : 0; });
         const int code = srgb_u8(r.between(0.03, 0.18));
         patch(s, r, 12 + r.below(20), [&](auto a, auto b, int x, int y) {
           set_rgb(b, {code, code, code});
           set_rgb(a, {0, 0, 0});
           s.metallic.at(x, y)[0] = 255;
         });
       }},
      {"ETK201", "more light than arrives",
       [](TextureSet& s, Random& r) {
         s.manifest.specular_weighs_diffuse = false;
         patch(s, r, 12 + r.below(20), [&](auto a, auto b, int, int) {
           set_rgb(a, {255, 254, 255});
           set_rgb(b, {70, 70, 70});
         });
       }},
      {"ETK202", "albedo too dark",
       [](TextureSet& s, Random& r) {
         const int code = 6 + r.below(18);
         patch(s, r, 12 + r.below(20), [&](auto a, auto b, int, int) {
           set_rgb(a, {code, code, code});
           set_rgb(b, {56, 56, 56});
         });
       }},
      {"ETK203", "albedo too bright",
       [](TextureSet& s, Random& r) {
         patch(s, r, 12 + r.below(20), [&](auto a, auto b, int, int) {
           set_rgb(a, {253, 253, 253});
           set_rgb(b, {56, 56, 56});
         });
       }},
      {"ETK204", "pure red",
       [](TextureSet& s, Random& r) {
         patch(s, r, 12 + r.below(20), [&](auto a, auto b, int, int) {
           set_rgb(a, {220, 30, 0});
           set_rgb(b, {56, 56, 56});
         });
       }},
      {"ETK301", "constant gloss",
       [](TextureSet& s, Random& r) {
         const int gloss = 20 + r.below(200);
         each_texel(s.b, [&](auto b, int, int) { b[3] = to_byte(gloss); });
       }},
      {"ETK302", "gloss clipped",
       [](TextureSet& s, Random& r) {
         const double gain = r.between(350, 600);
         each_texel(s.b, [&](auto b, int x, int) { b[3] = to_byte(b[3] + gain * x / s.b.width - gain / 2); });
       }},
      {"ETK304", "gloss in six steps",
       [](TextureSet& s, Random&) {
         each_texel(s.b, [&](auto b, int x, int) { b[3] = to_byte(20 + 36 * (6 * x / s.b.width)); });
       },
       264},
      {"ETK401", "F0 stored linear",
       [](TextureSet& s, Random&) {
         each_texel(s.b, [&](auto b, int, int) {
           for (std::size_t c = 0; c < 3; ++c) b[c] = to_byte(255 * srgb_decode(b[c] / 255.0));
         });
       },
       0,
       [](const TextureSet& s) {  // of metals the value does not tell
         std::size_t metals = 0;
         for (std::size_t i = 0; i < s.b.values.size(); i += 4)
           metals += is_metal({s.b.values.data() + i, 4});
         return 2 * metals < s.b.values.size() / 4;
       }},
      {"ETK402", "F0 encoded twice",
       [](TextureSet& s, Random&) {
         each_texel(s.b, [&](auto b, int, int) {
           for (std::size_t c = 0; c < 3; ++c) b[c] = srgb_u8(b[c] / 255.0);
         });
       },
       0,
       // Under black diffuse it may be a metal stored linear.
       [](const TextureSet& s) { return mean_code(s.a) > 14; }},
      {"ETK404", "diffuse through 8-bit linear",
       [](TextureSet& s, Random&) {
         each_texel(s.a, [&](auto a, int, int) {
           for (std::size_t c = 0; c < 3; ++c)
             a[c] = srgb_u8(std::floor(255 * srgb_decode(a[c] / 510.0) + 0.5) /
                            255);  // darkened: into the comb's range
         });
       },
       0,
       // A comb has several teeth, and enough values on them.
       [](const TextureSet& s) {
         std::set<std::uint8_t> dark;
         std::size_t count = 0;
         for (std::size_t i = 0; i < s.a.values.size(); ++i)
           if (i % 4 != 3 && s.a.values[i] < 170) {
             dark.insert(s.a.values[i]);
             ++count;
           }
         return dark.size() > 60 && *dark.rbegin() > 120 && count > 6000;
       }},
      {"ETK406", "gradient in few steps",
       [](TextureSet& s, Random& r) {
         const int step = 12 + r.below(6);
         each_texel(s.a, [&](auto a, int x, int) {
           const int code = 40 + 180 * x / s.a.width / step * step;
           set_rgb(a, {code, code, code});
         });
       }},
      {"ETK501", "premultiplied alpha",
       [](TextureSet& s, Random& r) {
         const double phase = r.unit() * 6;
         each_texel(s.a, [&](auto a, int x, int y) {
           const double alpha = 0.5 + 0.5 * std::sin(phase + 0.05 * x + 0.03 * y);
           a[3] = to_byte(255 * alpha);
           const double level = 0.9 * alpha;
           for (std::size_t c = 0; c < 3; ++c) a[c] = to_byte((200 + a[c] % 16) * level);
         });
       }},
      {"ETK502", "black under alpha 0",
       [](TextureSet& s, Random& r) {
         patch(s, r, 12 + r.below(20), [&](auto a, auto b, int, int) {
           set_rgb(a, {255, 0, 255});
           b[0] = b[1] = b[2] = 56;
           a[3] = 0;
         });
       }},
      {"ETK503", "alpha 0 everywhere",
       [](TextureSet& s, Random&) { each_texel(s.a, [](auto a, int, int) { a[3] = 0; }); }},
      {"ETK504", "tiles without gutter",
       [](TextureSet& s, Random&) {
         const int middle = s.a.width / 2 + 1, size = s.a.width;
         for (int y = 0; y < size; ++y)
           for (int x = 0; x < middle; ++x) {
             set_rgb(s.b.at(x, y), {200, 195, 190});
             set_rgb(s.a.at(x, y), {0, 0, 0});
           }
         s.manifest.tiles = {{"left", "", "", {0, 0, middle, size}, 0, {}, {}, {}},
                             {"right", "", "", {middle, 0, size - middle, size}, 0, {}, {}, {}}};
       }},
      {"ETK505", "black gutter",
       [](TextureSet& s, Random&) {
         const int size = s.a.width;
         const PixelBox box{8, 8, size - 16, size - 16};
         each_texel(s.a, [&](auto a, int x, int y) {
           if (x < 8 || y < 8 || x >= size - 8 || y >= size - 8) set_rgb(a, {0, 0, 0});
         });
         s.manifest.tiles = {{"tile", "", "", box, 0, {}, {}, {}}};
         s.manifest.gutter = 4;
         s.manifest.mips = 0;
       }},
      {"ETK507", "two equal tiles",
       [](TextureSet& s, Random&) {
         const int half = s.a.width / 2;
         for (int y = 0; y < s.a.height; ++y)
           for (int x = 0; x < half; ++x) {
             std::ranges::copy(s.a.at(x, y), s.a.at(x + half, y).begin());
             std::ranges::copy(s.b.at(x, y), s.b.at(x + half, y).begin());
           }
         s.manifest.tiles = {{"one", "", "", {0, 0, half, s.a.height}, 0, {}, {}, {}},
                             {"two", "", "", {half, 0, half, s.a.height}, 0, {}, {}, {}}};
         s.manifest.mips = 0;
       }},
  };
  return list;
}

Scores score_mutations(const std::vector<TextureSet>& sets,
                       const std::function<TextureSet(std::size_t, int)>& larger) {
  Scores scores;
  std::map<std::string, RuleScore, std::less<>> by_rule;
  for (const Mutation& mutation : mutations()) by_rule[std::string(mutation.rule)].rule = mutation.rule;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const TextureSet& clean = sets[i];
    const CheckedFile untouched = check_set(clean);
    ++scores.untouched;
    scores.untouched_errors += errors(untouched);
    for (const Finding& finding : untouched.findings) {
      if (finding.severity < Severity::warning) continue;
      scores.untouched_warnings += finding.severity == Severity::warning;
      RuleScore& score = by_rule[finding.rule];
      ++score.false_sets;
      score.rule = finding.rule;
    }
    for (const Mutation& mutation : mutations()) {
      const bool small = clean.b.width < mutation.least_size;
      if ((small && !larger) || found(untouched, mutation.rule, Severity::warning)) continue;
      if (mutation.applies && !mutation.applies(clean)) continue;
      TextureSet broken = small ? larger(i, mutation.least_size) : clean;
      Random random((i + 1) * 1000003 + static_cast<std::uint64_t>(&mutation - mutations().data()));
      mutation.inject(broken, random);
      RuleScore& score = by_rule[std::string(mutation.rule)];
      ++score.injected;
      if (found(check_set(broken), mutation.rule))
        ++score.found;
      else
        scores.missed.push_back(std::string(mutation.rule) + " in set " + std::to_string(i + 1));
    }
  }
  for (auto& [rule, score] : by_rule) scores.rules.push_back(score);
  return scores;
}

Scores score_natural_sets(std::size_t count, int size) {
  std::vector<TextureSet> sets;
  for (std::size_t i = 0; i < count; ++i) sets.push_back(natural_set(size, i + 1));
  return score_mutations(sets, [](std::size_t i, int larger) { return natural_set(larger, i + 1); });
}

}  // namespace etak::test
