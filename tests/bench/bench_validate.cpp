// SPDX-License-Identifier: Apache-2.0
// bench_validate [SETS] [DIFFUSE.png SPECULAR.png]
//   Recall of every pixel rule on SETS (200) made-up texture sets with one defect each, false positives on
//   the same sets untouched, and the edge matrix; then, with a pair of files, the time of decoding alone, of
//   the byte rules and of all.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include "core/base/parallel.h"
#include "core/image/image_io.h"
#include "core/image/load.h"
#include "core/judge/rules.h"
#include "core/scene/gltf.h"
#include "core/validate/files/check.h"
#include "core/validate/files/load.h"
#include "core/validate/files/metal_rough.h"
#include "tests/core/judge/corpus.h"

using namespace etak;
using namespace etak::test;

namespace {

void print_scores(const Scores& scores) {
  std::printf(
      "| rule | slug | injected | found | recall | untouched sets with a finding | with a hint |\n|---|---|---|---|---|---|---|\n");
  for (const RuleScore& score : scores.rules) {
    std::printf("| %s | %s | ", score.rule.c_str(), std::string(find_rule(score.rule)->slug).c_str());
    if (score.injected == 0)
      std::printf("- | - | - |");
    else
      std::printf("%zu | %zu | %.1f %% |", score.injected, score.found,
                  100.0 * static_cast<double>(score.found) / static_cast<double>(score.injected));
    std::printf(" %zu | %zu |\n", score.false_sets, score.hints);
  }
  std::printf("\n%zu untouched sets: %zu errors, %zu warnings\n", scores.untouched, scores.untouched_errors,
              scores.untouched_warnings);
  for (const std::string& missed : scores.missed) std::printf("missed: %s\n", missed.c_str());
}

void print_edges() {
  std::printf(
      "\n| sigma | metal | blend | ETK101 without patch | with a hidden patch of 10 x 10 | px in the zone |\n|---|---|---|---|---|---|\n");
  for (const double sigma : {0.0, 1.0, 2.0, 4.0, 8.0})
    for (const double metal : {0.55, 0.95})
      for (const Blend blend : {Blend::linear, Blend::encoded}) {
        const Pixels<float> mask = blob_mask(1024, sigma, 21);
        TextureSet set = blended_set(mask, 0.04, metal, blend);
        const CheckedFile clean = check_set(set);
        const auto [x0, y0] = emptiest_place(mask);
        for (int y = y0 - 5; y < y0 + 5; ++y)
          for (int x = x0 - 5; x < x0 + 5; ++x)
            for (std::size_t c = 0; c < 3; ++c) set.b.at(x, y)[c] = 149;
        std::printf("| %g | %g | %s | %s | %s | %zu |\n", sigma, metal,
                    blend == Blend::linear ? "linear" : "sRGB", found(clean, "ETK101") ? "fires" : "-",
                    found(check_set(set), "ETK101") ? "found" : "missed", clean.transition_px);
      }
}

Image8 middle(const Image8& image, int side) {
  const int width = std::min(side, image.width), height = std::min(side, image.height);
  Image8 out(width, height, image.channels);
  paste(image, -(image.width - width) / 2, -(image.height - height) / 2, out);
  return out;
}

// The materials of scenes, as check() converts them.
void print_real(const std::vector<std::string>& paths) {
  const PictureDoor door = picture_door();
  std::vector<TextureSet> sets;
  for (const std::string& path : paths) {
    const GltfScene scene = read_gltf(path, GltfOptions{});
    ScenePictures pictures(scene.images, door);
    for (const GltfMaterial& material : scene.materials) {
      if (!scene.material_used[static_cast<std::size_t>(material.index)]) continue;
      const Pictures loaded = convert_material(material, pictures);
      TextureSet& set = sets.emplace_back();
      set.a = middle(loaded.a, 512);
      set.b = middle(loaded.b, 512);
      if (loaded.metallic.width != 0) set.metallic = middle(loaded.metallic, 512);
      set.manifest.specular_weighs_diffuse = true;
      // Pictures of two sizes, or of a few texels, have no room for the defects.
      const bool fits = set.a.width == set.b.width && set.a.height == set.b.height &&
                        std::min(set.b.width, set.b.height) >= 128;
      if (!fits) sets.pop_back();
    }
  }
  std::printf("\n%zu real materials\n", sets.size());
  print_scores(score_mutations(sets, nullptr));
}

void print_speed(const char* diffuse, const char* specular) {
  const PictureDoor door = picture_door();
  CheckTarget target;
  target.files = {{FileRole::diffuse_alpha, diffuse, diffuse, false},
                  {FileRole::specular_gloss, specular, specular, false}};
  Settings all, bytes;
  for (const Rule* rule : rules())
    if (rule->needs.has(Need::regions)) bytes.rules[std::string(rule->id)].severity = Severity::off;
  const auto seconds = [](auto act) {
    const auto start = std::chrono::steady_clock::now();
    act();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  for (const unsigned threads : {1u, std::max(2u, std::thread::hardware_concurrency())}) {
    std::array<double, 3> best{1e9, 1e9, 1e9};
    for (int round = 0; round < 5; ++round) {  // in turn, so that a busy machine is busy for all
      best[0] = std::min(best[0], seconds([&] {
                           parallel_chunks(2, threads, 1, [&](std::size_t i, std::size_t, unsigned) {
                             const auto source = open_picture(i == 0 ? diffuse : specular, door);
                             const PictureHeader& h = source->header();
                             const std::size_t stride = 4 * static_cast<std::size_t>(h.width);
                             std::vector<std::uint8_t> rows(16 * stride);
                             for (int y = 0; y < h.height; y += 16)
                               source->read_rows(rows.data(), stride, std::min(16, h.height - y));
                           });
                         }));
      best[1] = std::min(best[1], seconds([&] { check(target, door, bytes, threads); }));
      best[2] = std::min(best[2], seconds([&] { check(target, door, all, threads); }));
    }
    std::printf(
        "%u threads: decoding %.3f s, byte rules %.3f s (%.2fx), all rules %.3f s (%.2fx; %.2fx of byte rules)\n",
        threads, best[0], best[1], best[1] / best[0], best[2], best[2] / best[0], best[2] / best[1]);
  }
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> words(arguments + 1, arguments + count);
  const std::size_t sets = words.empty() ? 200 : std::strtoul(words[0].c_str(), nullptr, 10);
  if (sets > 0) {
    print_scores(score_natural_sets(sets, 128));
    print_edges();
  }
  std::vector<std::string> scenes;
  for (const std::string& word : words)
    if (word.ends_with(".gltf") || word.ends_with(".glb")) scenes.push_back(word);
  if (!scenes.empty()) print_real(scenes);
  if (words.size() > 2 && words[1].ends_with(".png")) print_speed(words[1].c_str(), words[2].c_str());
}
