// SPDX-License-Identifier: Apache-2.0
// Speed and error of mip chains of a texture pair, beside the obvious other ways.
//   bench_mips [SIDE [ROUNDS]]   default 4096 5
// Prints a table: MB of level 0 (both textures) a second, median of the rounds; the largest difference in
// codes from the reference in double over all levels, and the share of codes that differ, for colour, opacity
// and gloss. The reference's own time is given too. Last row: bleed_under_alpha on 1024 x 1024, in ms.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>

#include "core/image/dilate.h"
#include "core/image/mips.h"
#include "tests/core/image/mip_reference.h"

using namespace etak;

namespace {

double seconds(const std::function<void()>& act) {
  const auto start = std::chrono::steady_clock::now();
  act();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Octaves of waves with grain on top: smooth parts, edges and noise, as textures have.
Image8 picture(int side, std::uint64_t seed) {
  test::Noise noise{seed};
  Image8 out(side, side, 4);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (int c = 0; c < 4; ++c) {
        const double wave =
            std::sin(x * 0.013 * (c + 1)) * std::cos(y * 0.021) + 0.4 * std::sin((x + y) * 0.17);
        const double grain = (noise.code() - 128) / 128.0;
        out.at(x, y)[static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>(std::clamp(128 + 70 * wave + 25 * grain, 0.0, 255.0));
      }
  return out;
}

// What many tools do: the mean of the codes.
MipPair box_of_codes(const Image8& a, const Image8& b) {
  MipPair pair{{a}, {b}, 0};
  for (std::vector<Image8>* levels : {&pair.diffuse_alpha, &pair.specular_gloss})
    while (levels->back().width > 1) {
      const Image8& above = levels->back();
      const int side = above.width / 2;
      Image8 next(side, side, 4);
      for (int y = 0; y < side; ++y) {
        const std::uint8_t *upper = above.at(0, 2 * y).data(), *lower = above.at(0, 2 * y + 1).data();
        std::uint8_t* out = next.at(0, y).data();
        for (int i = 0; i < 4 * side; ++i) {
          const int at = i / 4 * 8 + i % 4;
          out[i] = static_cast<std::uint8_t>((upper[at] + upper[at + 4] + lower[at] + lower[at + 4] + 2) / 4);
        }
      }
      levels->push_back(std::move(next));
    }
  return pair;
}

struct Errors {
  int largest[3] = {};
  std::size_t wrong[3] = {}, all[3] = {};
};

Errors errors_of(const MipPair& pair, const std::vector<std::vector<std::array<int, 8>>>& reference) {
  Errors out;
  for (std::size_t l = 1; l < reference.size(); ++l)
    for (std::size_t i = 0; i < reference[l].size(); ++i)
      for (std::size_t c = 0; c < 8; ++c) {
        const Image8& image = c < 4 ? pair.diffuse_alpha[l] : pair.specular_gloss[l];
        const int off = std::abs(int{image.values[4 * i + c % 4]} - reference[l][i][c]);
        const int kind = c == 3 ? 1 : c == 7 ? 2 : 0;
        out.largest[kind] = std::max(out.largest[kind], off);
        out.wrong[kind] += off != 0 ? 1 : 0;
        ++out.all[kind];
      }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const int side = argc > 1 ? std::atoi(argv[1]) : 4096, rounds = argc > 2 ? std::atoi(argv[2]) : 5;
  if (side < 2 || (side & (side - 1)) != 0 || rounds < 1) {
    std::fprintf(stderr, "bench_mips [SIDE, a power of two [ROUNDS]]\n");
    return 2;
  }
  const Image8 a = picture(side, 1), b = picture(side, 2);
  Image8 opaque = a;
  for (std::size_t i = 3; i < opaque.values.size(); i += 4) opaque.values[i] = 255;
  Image8 mask = a;
  for (std::size_t i = 3; i < mask.values.size(); i += 4) mask.values[i] = a.values[i] < 100 ? 0 : 255;
  const double megabytes = 2 * static_cast<double>(a.values.size()) / 1e6;

  std::vector<std::vector<std::array<int, 8>>> reference;
  const double reference_time = seconds([&] {
    test::ReferenceLevel level = test::reference_base(a, b);
    for (;;) {
      auto& codes = reference.emplace_back();
      if (reference.size() > 1)
        for (const auto& texel : level.texels) codes.push_back(test::reference_codes(texel));
      if (level.width == 1) break;
      level = test::reference_next(level, true);
    }
  });

  MipOptions coverage;
  coverage.alpha_cutoff = 0.5;
  const struct {
    const char* name;
    std::function<MipPair()> make;
    bool compare;
  } rows[] = {
      {"etak, 1 thread", [&] { return mip_pair(a, b, {}, 1); }, true},
      {"etak, 2 threads", [&] { return mip_pair(a, b, {}, 2); }, true},
      {"etak, opaque, 1 thread", [&] { return mip_pair(opaque, b, {}, 1); }, false},
      {"etak, mask with coverage, 1 thread", [&] { return mip_pair(mask, b, coverage, 1); }, false},
      {"box of codes", [&] { return box_of_codes(a, b); }, true},
  };
  std::printf("%d x %d pair, %.0f MB\n\n", side, side, megabytes);
  std::printf("| way | MB/s | colour: most, share | opacity | gloss |\n|---|---|---|---|---|\n");
  for (const auto& row : rows) {
    std::vector<double> times;
    MipPair pair;
    for (int i = 0; i < rounds; ++i) times.push_back(seconds([&] { pair = row.make(); }));
    std::sort(times.begin(), times.end());
    std::printf("| %s | %.0f |", row.name, megabytes / times[times.size() / 2]);
    const Errors e = row.compare ? errors_of(pair, reference) : Errors{};
    for (int kind = 0; kind < 3; ++kind)
      if (row.compare)
        std::printf(" %d, %.4f %% |", e.largest[kind],
                    100 * static_cast<double>(e.wrong[kind]) / static_cast<double>(e.all[kind]));
      else
        std::printf(" - |");
    std::printf("\n");
  }
  std::printf("| reference in double | %.1f | 0 | 0 | 0 |\n", megabytes / reference_time);

  const Image8 small = picture(1024, 3), small_b = picture(1024, 4);
  std::vector<double> times;
  for (int i = 0; i < rounds; ++i) {
    Image8 fill_a = small, fill_b = small_b;
    for (std::size_t t = 3; t < fill_a.values.size(); t += 4)
      fill_a.values[t] = small.values[t] < 100 ? 0 : 255;
    times.push_back(seconds([&] { bleed_under_alpha(fill_a, fill_b); }));
  }
  std::sort(times.begin(), times.end());
  std::printf("\nbleed_under_alpha, 1024 x 1024: %.1f ms\n", 1000 * times[times.size() / 2]);
}
