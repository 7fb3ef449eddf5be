// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <set>

#include "core/color/srgb.h"
#include "core/judge/rules.h"
#include "tests/core/judge/corpus.h"

namespace etak::test {

namespace {

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

double mean_code(const Image8& image) {
  double sum = 0;
  for (std::size_t i = 0; i < image.values.size(); ++i) sum += i % 4 == 3 ? 0 : image.values[i];
  return sum / (0.75 * static_cast<double>(image.values.size()));
}

bool is_metal(std::span<const std::uint8_t> specular) {
  return std::max({specular[0], specular[1], specular[2]}) > 124;
}

}  // namespace

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
      {"ETK115", "gold with red and blue exchanged",
       [](TextureSet& s, Random& r) {
         patch(s, r, 12 + r.below(20), [&](auto a, auto b, int x, int y) {
           set_rgb(b, {156, 228, 255});
           set_rgb(a, {0, 0, 0});
           if (s.metallic.width != 0) s.metallic.at(x, y)[0] = 255;
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
      {"ETK406", "F0 in few steps",
       [](TextureSet& s, Random& r) {
         s.metallic = {};  // of pairs only
         const int step = 12 + r.below(6);
         each_texel(s.b, [&](auto b, int x, int) {
           const int code = 40 + 180 * x / s.b.width / step * step;
           set_rgb(b, {code, code, code});
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
       [](TextureSet& s, Random&) { each_texel(s.a, [](auto a, int, int) { a[3] = 0; }); }, 0, nullptr,
       Severity::error},
      {"ETK504", "tiles without gutter",
       [](TextureSet& s, Random&) {
         const int middle = s.a.width / 2 + 1, size = s.a.width;
         for (int y = 0; y < size; ++y)
           for (int x = 0; x < middle; ++x) {
             set_rgb(s.b.at(x, y), {200, 195, 190});
             set_rgb(s.a.at(x, y), {0, 0, 0});
           }
         s.manifest.tiles = {{"left", "", "", {0, 0, middle, size}, 0, {}, {}, {}, {}, {}, {}},
                             {"right", "", "", {middle, 0, size - middle, size}, 0, {}, {}, {}, {}, {}, {}}};
       }},
      {"ETK505", "black gutter",
       [](TextureSet& s, Random&) {
         const int size = s.a.width;
         const PixelBox box{8, 8, size - 16, size - 16};
         each_texel(s.a, [&](auto a, int x, int y) {
           if (x < 8 || y < 8 || x >= size - 8 || y >= size - 8) set_rgb(a, {0, 0, 0});
         });
         s.manifest.tiles = {{"tile", "", "", box, 0, {}, {}, {}, {}, {}, {}}};
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
         s.manifest.tiles = {{"one", "", "", {0, 0, half, s.a.height}, 0, {}, {}, {}, {}, {}, {}},
                             {"two", "", "", {half, 0, half, s.a.height}, 0, {}, {}, {}, {}, {}, {}}};
         s.manifest.mips = 0;
       }},
  };
  return list;
}

Scores score_mutations(const std::vector<TextureSet>& sets,
                       const std::function<TextureSet(std::size_t, int)>& larger) {
  Scores scores;
  std::vector<Mutation> all = mutations();
  all.insert(all.end(), mutations_told().begin(), mutations_told().end());
  std::map<std::string, RuleScore, std::less<>> by_rule;
  for (const Mutation& mutation : all) by_rule[std::string(mutation.rule)].rule = mutation.rule;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const TextureSet& clean = sets[i];
    const CheckedFile untouched = check_set(clean);
    ++scores.untouched;
    scores.untouched_errors += errors(untouched);
    std::set<std::string> hinted;
    for (const Finding& finding : untouched.findings) {
      RuleScore& score = by_rule[finding.rule];
      score.rule = finding.rule;
      scores.untouched_warnings += finding.severity == Severity::warning;
      if (finding.severity >= Severity::warning)
        ++score.false_sets;
      else
        score.hints += hinted.insert(finding.rule).second;
    }
    for (std::size_t number = 0; number < all.size(); ++number) {
      const Mutation& mutation = all[number];
      const Rule& rule = *find_rule(mutation.rule);
      Settings settings;
      if (rule.severity.standard == Severity::off)
        settings.rules[std::string(rule.id)].severity = rule.severity.strict;
      const Severity least =
          mutation.least.value_or(std::clamp(rule.severity.standard, Severity::info, Severity::warning));
      const auto found_in = [&](const CheckedFile& file) { return found(file, mutation.rule, least); };
      const bool small = clean.b.width < mutation.least_size;
      if ((small && !larger) || (mutation.applies && !mutation.applies(clean)) ||
          found_in(settings.rules.empty() ? untouched : check_set(clean, settings)))
        continue;
      TextureSet broken = small ? larger(i, mutation.least_size) : clean;
      Random random((i + 1) * 1000003 + number);
      mutation.inject(broken, random);
      RuleScore& score = by_rule[std::string(mutation.rule)];
      ++score.injected;
      if (found_in(check_set(broken, settings)))
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
