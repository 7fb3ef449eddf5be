// SPDX-License-Identifier: Apache-2.0
#include "core/pack/blocks/compress_page.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <span>
#include <utility>

#include "core/atlas/texels/page_pixels.h"
#include "core/base/parallel.h"
#include "core/image/blocks/budget.h"
#include "core/pack/blocks/block_codec.h"
#include "core/pack/blocks/level_texels.h"
#include "core/pack/blocks/page_format.h"

namespace etak {
namespace {

using Texel = std::array<std::uint8_t, 4>;

// Differences of a material's texels.
struct Spreads {
  TexelSpread colour, fourth;
  explicit Spreads(const BlockMeasure& measure)
      : colour(measure.colour_budget() / 100), fourth(measure.fourth_budget() / 100) {}
};
using ByMaterial = std::vector<std::optional<Spreads>>;

// Compresses one level, and looks at what became of it.
class LevelInBlocks {
 public:
  LevelInBlocks(const BlockJob& job, const BlockMeasure& measure, int level, const TexelsShown& shown)
      : job_(job),
        codec_(*job.how.format, job.astc),
        texels_(job, measure, level, shown),
        bytes_(codec_.format().block_bytes * texels_.uses.owner.size(), '\0'),
        excess_(texels_.uses.owner.size()) {}

  // Compresses all blocks.
  void encode(const BlockTry& how) {
    timed([&] {
      each_row([&](std::size_t row, unsigned) {
        std::vector<AnyBlock> sources(across());
        for (std::size_t x = 0; x < sources.size(); ++x) sources[x] = texels_.block(row * across() + x);
        codec_.encode(std::move(sources), how, block(row * across()));
      });
    });
  }

  // What the blocks make of the texels, by material. Blocks within the budget stay as they are, and are not looked at again.
  ByMaterial measure() {
    if (measured_) return sum(within_, measure(beyond_));
    measured_ = true;
    std::vector<ByMaterial> within = empty_spreads(), beyond = within;
    each_row([&](std::size_t row, unsigned worker) {
      const std::vector<Texel> decoded = codec_.decode(block(row * across()), across());
      for (std::size_t x = 0; x < across(); ++x) {
        const std::size_t b = row * across() + x;
        if (!texels_.uses.owner[b]) continue;
        BlockDifferences found;
        excess_[b] = texels_.compare(b, &decoded[codec_.texels() * x], found);
        add(found, (excess_[b] > 0 ? beyond : within)[worker][*texels_.uses.owner[b]]);
      }
    });
    for (std::size_t b = 0; b < excess_.size(); ++b)
      if (excess_[b] > 0) beyond_.push_back(b);
    within_ = sum(within);
    return sum(within_, sum(beyond));
  }

  // The blocks that miss the budget, of the materials that do.
  std::vector<std::size_t> bad_blocks(const std::vector<bool>& misses) const {
    std::vector<std::size_t> bad;
    for (std::size_t b = 0; b < excess_.size(); ++b)
      if (excess_[b] > 0 && texels_.uses.owner[b] && misses[*texels_.uses.owner[b]]) bad.push_back(b);
    return bad;
  }

  // Whether a material would have twice the texels above its budget that it may have, whatever its blocks are tried
  // with. Every sixteenth of the bad blocks tells, of very many fewer; they stay as they are.
  bool is_hopeless(const ByMaterial& spreads, const std::vector<bool>& misses,
                   std::span<const BlockTry> tries) {
    constexpr std::size_t least_blocks = 4096, most_tried = 1024;
    std::vector<std::size_t> some = bad_blocks(misses);
    if (some.size() < least_blocks) return false;
    const std::size_t one_of = std::max<std::size_t>(16, some.size() / most_tried);
    for (std::size_t i = 0; i * one_of < some.size(); ++i) some[i] = some[i * one_of];
    some.resize((some.size() + one_of - 1) / one_of);
    const std::string bytes = bytes_;
    const std::vector<double> excess = excess_;
    const ByMaterial before = measure(some);
    for (const BlockTry& how : tries) escalate(some, how);
    const ByMaterial after = measure(some);
    bytes_ = bytes;
    excess_ = excess;
    const auto left = [](const TexelSpread& all, const TexelSpread& was, const TexelSpread& is,
                         double budget) {
      const auto part = static_cast<double>(is.above(budget)) /
                        static_cast<double>(std::max<std::uint64_t>(1, was.above(budget)));
      return part * static_cast<double>(all.above(budget)) > 0.02 * static_cast<double>(all.count());
    };
    for (std::size_t m = 0; m < misses.size(); ++m)
      if (misses[m] && after[m] &&
          (left(spreads[m]->colour, before[m]->colour, after[m]->colour, texels_.measure.colour_budget()) ||
           left(spreads[m]->fourth, before[m]->fourth, after[m]->fourth, texels_.measure.fourth_budget())))
        return true;
    return false;
  }

  // Tries blocks again; keeps what is nearer to the budget.
  void escalate(const std::vector<std::size_t>& bad, const BlockTry& how) {
    escalated_ = std::max(escalated_, bad.size());
    timed([&] {
      constexpr std::size_t chunk = 64;
      parallel_chunks(bad.size(), job_.threads, chunk, [&](std::size_t begin, std::size_t end, unsigned) {
        const std::size_t bytes = codec_.format().block_bytes;
        std::vector<std::uint8_t> tried(bytes * (end - begin));
        std::vector<AnyBlock> sources;
        for (std::size_t i = begin; i < end; ++i) {
          sources.push_back(texels_.block(bad[i]));
          if (!how.settles) continue;
          std::uint8_t* its = &tried[bytes * (i - begin)];
          std::copy_n(block(bad[i]), bytes, its);
          codec_.settle(sources.back(), texels_.forms(bad[i]), *how.settles, its);
        }
        if (!how.settles) codec_.encode(std::move(sources), how, tried.data());
        const std::vector<Texel> decoded = codec_.decode(tried.data(), end - begin);
        for (std::size_t i = begin; i < end; ++i) {
          BlockDifferences found;
          const double excess = texels_.compare(bad[i], &decoded[codec_.texels() * (i - begin)], found);
          if (excess >= excess_[bad[i]]) continue;
          excess_[bad[i]] = excess;
          std::copy_n(&tried[bytes * (i - begin)], bytes, block(bad[i]));
        }
      });
    });
  }

  // What these blocks make of their texels, by material.
  ByMaterial measure(const std::vector<std::size_t>& blocks) {
    std::vector<ByMaterial> by_worker = empty_spreads();
    constexpr std::size_t chunk = 64;
    parallel_chunks(blocks.size(), job_.threads, chunk,
                    [&](std::size_t begin, std::size_t end, unsigned worker) {
                      for (std::size_t i = begin; i < end; ++i) {
                        const std::size_t b = blocks[i];
                        BlockDifferences found;
                        texels_.compare(b, codec_.decode(block(b), 1).data(), found);
                        add(found, by_worker[worker][*texels_.uses.owner[b]]);
                      }
                    });
    return sum(by_worker);
  }

  // A mask is kept exact.
  bool met(std::size_t material, const Spreads& spreads) const {
    return spreads.colour.percentile_99() <= texels_.measure.colour_budget() &&
           (texels_.is_mask(material) ? spreads.fourth.largest() == 0
                                      : spreads.fourth.percentile_99() <= texels_.measure.fourth_budget());
  }
  std::string& bytes() { return bytes_; }
  double seconds() const { return seconds_; }
  std::size_t shared() const { return texels_.uses.shared; }
  std::size_t escalated() const { return escalated_; }
  std::size_t count() const { return excess_.size(); }
  std::size_t texels() const { return texels_.uses.used.size(); }

 private:
  std::vector<ByMaterial> empty_spreads() const {  // by worker
    return std::vector<ByMaterial>(job_.threads, ByMaterial(job_.materials.size()));
  }
  void add(const BlockDifferences& found, std::optional<Spreads>& to) const {
    if (!to) to.emplace(texels_.measure);
    for (std::size_t i = 0; i < found.count; ++i) {
      to->colour.add(found.colour[i], found.share[i]);
      to->fourth.add(found.fourth[i], found.share[i]);
    }
  }
  ByMaterial sum(ByMaterial out, const ByMaterial& more) const {
    for (std::size_t m = 0; m < out.size(); ++m) {
      if (!more[m]) continue;
      if (!out[m]) out[m].emplace(texels_.measure);
      out[m]->colour.add(more[m]->colour);
      out[m]->fourth.add(more[m]->fourth);
    }
    return out;
  }
  ByMaterial sum(const std::vector<ByMaterial>& by_worker) const {
    ByMaterial out(job_.materials.size());
    for (const ByMaterial& each : by_worker) out = sum(std::move(out), each);
    return out;
  }

  std::size_t across() const { return static_cast<std::size_t>(texels_.uses.across); }
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes of a file
  std::uint8_t* block(std::size_t b) {
    return reinterpret_cast<std::uint8_t*>(&bytes_[codec_.format().block_bytes * b]);
  }

  template <class Work>
  void timed(const Work& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  template <class Work>
  void each_row(const Work& work) {
    parallel_chunks(static_cast<std::size_t>(texels_.uses.down), job_.threads, 1,
                    [&](std::size_t begin, std::size_t end, unsigned worker) {
                      for (std::size_t row = begin; row < end; ++row) work(row, worker);
                    });
  }

  const BlockJob& job_;
  BlockCodec codec_;
  LevelTexels texels_;
  std::string bytes_;
  // By block: the differences beyond the budget, in budgets, summed by how much of the texels is read.
  std::vector<double> excess_;
  bool measured_ = false;
  ByMaterial within_;                // of the blocks that were within the budget at first
  std::vector<std::size_t> beyond_;  // the others
  double seconds_ = 0;
  std::size_t escalated_ = 0;
};

// The last tries take the most time, and where most blocks miss the budget they are spared.
constexpr std::size_t longest_tries = 2;

// What blocks are tried with in turn: more effort, then, step by step, what brings most texels within the budget.
std::vector<BlockTry> tries_of(const CompressOptions& how) {
  // Channels of BC4 and BC5 are apart, and neither weights nor effort change them.
  if (how.once || is_fitting(*how.format)) return {{how.effort}};
  std::vector<BlockTry> out;
  for (int effort = how.effort; effort <= most_block_effort; ++effort) out.push_back({effort});
  if (how.format->code == BlockCode::bc7) {
    for (const std::size_t starts : std::array<std::size_t, 3>{0, 4, 16}) out.push_back({.settles = starts});
    return out;
  }
  for (const float fourth : {4.0f, 16.0f, 0.25f})
    out.push_back({std::min(most_block_effort, how.effort + 1), {1, 1, 1, fourth}});
  return out;
}

std::vector<bool> missing(const LevelInBlocks& level, const ByMaterial& spreads) {
  std::vector<bool> out(spreads.size());
  for (std::size_t m = 0; m < spreads.size(); ++m) out[m] = spreads[m] && !level.met(m, *spreads[m]);
  return out;
}

// Compresses a level and takes its bytes.
BlockLevel compressed(const BlockJob& job, const BlockMeasure& measure, int number, const TexelsShown& shown,
                      std::string& bytes) {
  LevelInBlocks level(job, measure, number, shown);
  std::vector<BlockTry> tries = tries_of(job.how);
  level.encode(tries[0]);
  ByMaterial spreads = level.measure();
  std::vector<bool> misses = missing(level, spreads);
  const auto any_misses = [&] { return std::ranges::find(misses, true) != misses.end(); };
  if (tries.size() > 1 && any_misses() && level.is_hopeless(spreads, misses, std::span(tries).subspan(1)))
    tries.resize(job.how.falls_back ? 1 : tries.size() - longest_tries);
  for (std::size_t t = 1; t < tries.size() && any_misses(); ++t) {
    level.escalate(level.bad_blocks(misses), tries[t]);
    spreads = level.measure();
    misses = missing(level, spreads);
  }
  BlockLevel out;
  out.page = job.page;
  out.texture = job.texture;
  out.level = number;
  out.tried = out.format = job.how.format->name;
  out.bytes = level.bytes().size() + (job.fourth_apart ? level.texels() : 0);
  out.fourth_apart = job.fourth_apart;
  out.texels = level.texels();
  out.seconds = level.seconds();
  out.blocks = level.count();
  out.escalated = level.escalated();
  out.shared = level.shared();
  for (std::size_t m = 0; m < spreads.size(); ++m) {
    if (!spreads[m]) continue;
    const auto& [colour, fourth] = *spreads[m];
    out.materials.push_back({m,
                             job.materials[m].name,
                             colour.percentile_99(),
                             colour.largest(),
                             fourth.percentile_99(),
                             fourth.largest(),
                             level.met(m, *spreads[m]),
                             {}});
  }
  bytes = std::move(level.bytes());
  return out;
}

}  // namespace

CompressedTexture compress_texture(const BlockJob& job) {
  const BlockMeasure measure(job.texture, job.gloss, job.how.budget);
  CompressedTexture out;
  out.blocks.emplace();
  out.blocks->format = job.how.format;
  out.blocks->fourth_apart = job.fourth_apart;
  TexelsShown shown = job.shown;
  const auto as_it_is = [](BlockLevel& level) {
    level.format = "RGBA8";
    level.bytes = 4 * level.texels;
  };
  for (int l = 0; l < job.pixels.levels(); ++l) {
    const ConstPixelsView8 view = job.pixels.view(job.texture, l);
    if (l > 0 && out.report.back().tail) {
      BlockLevel& level = out.report.emplace_back();
      level.page = job.page;
      level.texture = job.texture;
      level.level = l;
      level.tried = job.how.format->name;
      level.texels = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
      level.blocks =
          texture_level_bytes(job.how.format, view.width, view.height) / job.how.format->block_bytes;
      level.fourth_apart = job.fourth_apart;
      level.tail = true;
      as_it_is(level);
      continue;
    }
    if (l > 0) {
      const ConstPixelsView8 above = job.pixels.view(job.texture, l - 1);
      shown = next_level(shown, above.width, above.height);
    }
    out.report.push_back(compressed(job, measure, l, shown, out.blocks->levels.emplace_back()));
    const bool met = std::ranges::all_of(out.report.back().materials, &BlockMaterial::met);
    if (met || !job.how.falls_back) continue;
    if (l > 0 && job.may_end) {
      as_it_is(out.report.back());
      out.report.back().tail = true;
      out.blocks->levels.pop_back();
      continue;
    }
    out.blocks.reset();
    for (BlockLevel& level : out.report) {
      as_it_is(level);
      level.fallback = true;
    }
    break;
  }
  return out;
}

}  // namespace etak
