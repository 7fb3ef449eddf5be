// SPDX-License-Identifier: Apache-2.0
#include "tests/core/judge/corpus.h"

#include <algorithm>
#include <cmath>

#include "core/color/srgb.h"
#include "core/judge/nearest.h"

namespace etak::test {

int Random::below(int count) {
  return static_cast<int>(next() % static_cast<std::uint64_t>(count));
}

namespace {

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
    for (const KnownF0& entry : KnownMaterials::builtin().f0())
      if (entry.conductor && entry.preferred && entry.luminance > 0.5 &&
          *std::ranges::max_element(entry.linear) < 0.98)
        out.push_back(&entry);
    return out;
  }();
  return metals;
}

}  // namespace

namespace {

class FloatRows final : public RowSource {
 public:
  explicit FloatRows(const Pixels<float>& image) : RowSource(header_of(image)), image_(image) {
    header_.format = "openexr";
  }
  void read_rows(std::uint8_t*, std::size_t, int) override {}
  void read_float_rows(float* rgba, std::size_t stride, int count) override {
    for (int i = 0; i < count; ++i, ++y_)
      for (int x = 0; x < image_.width; ++x)
        std::ranges::copy(image_.at(x, y_),
                          rgba + static_cast<std::size_t>(i) * stride + 4 * static_cast<std::size_t>(x));
  }

 private:
  const Pixels<float>& image_;
  int y_ = 0;
};

}  // namespace

CheckedFile check_set(const TextureSet& set, const Settings& settings, unsigned threads) {
  CheckTarget target;
  target.label = "set";
  target.manifest = set.manifest;
  target.files = {
      {set.metallic.width != 0 ? FileRole::base_color : FileRole::diffuse_alpha, "", "a.png", false},
      {set.metallic.width != 0 ? FileRole::metal_rough : FileRole::specular_gloss, "", "b.png", false}};
  if (set.b_floats.width != 0) {
    target.files[1].label = "b.exr";
    const auto open = [&](Needs) {
      PictureRows rows;
      rows.a = rows_of(set.a);
      rows.b = std::make_unique<FloatRows>(set.b_floats);
      if (set.metallic.width != 0) rows.metallic = rows_of(set.metallic);
      return rows;
    };
    return check_rows(target, open, settings, threads);
  }
  return check_pictures(target, {set.a, set.b, set.metallic}, settings, threads);
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
  TextureSet set{Image8(size, size, 4), Image8(size, size, 4), {}, {}};
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
  TextureSet set{Image8(mask.width, mask.height, 4), Image8(mask.width, mask.height, 4), {}, {}};
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
  TextureSet set{Image8(size, size, 4), Image8(size, size, 4), {}, {}};
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

}  // namespace etak::test
