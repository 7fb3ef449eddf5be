// SPDX-License-Identifier: Apache-2.0
#include "core/pack/pages.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/atlas/texels/compose_floats.h"
#include "core/atlas/texels/page_stream.h"
#include "core/base/error.h"
#include "core/base/files/read_places.h"
#include "core/base/setting.h"
#include "core/image/files/containers.h"
#include "core/pack/blocks/compress_page.h"
#include "core/pack/blocks/page_format.h"
#include "core/pack/blocks/shaded.h"
#include "core/pack/identity.h"
#include "core/pack/pack.h"
#include "core/pack/progress.h"
#include "core/pack/table.h"

namespace etak {
namespace {

// The layout says which pages there are: their files are known before their texels.
void refuse_strangers(const PackOptions& options, const EarlierAtlas& earlier, const PackDecision& decision) {
  for (int p = 0; p < static_cast<int>(decision.plan.pages.size()); ++p)
    for (const Texture texture : both_textures)
      for (const std::string& name : page_files(p, texture, decision.levels[static_cast<std::size_t>(p)].kept,
                                                options.output.write.formats))
        refuse_stranger(earlier, name, options.output.overwrite);
}

void check_memory(const PackOptions& options, const PlannedPage& page, int levels) {
  std::size_t bytes = 0;
  const std::size_t texel = writes_floats(options.output.write) ? 8 + 32 : 8;
  for (int l = 0; l < levels; ++l)
    bytes += texel * static_cast<std::size_t>(std::max(1, page.width >> l)) *
             static_cast<std::size_t>(std::max(1, page.height >> l));
  if (options.run.memory != 0 && bytes > options.run.memory)
    throw Error::at(setting("memory"),
                    "a page of " + std::to_string(page.width) + " x " + std::to_string(page.height) +
                        " takes " + std::to_string((bytes >> 20) + 1) + " MiB",
                    "more memory, or a smaller " + setting("page"));
}

// Where pages can be made slab by slab: what else is written of them, and the check, need them whole.
bool may_be_cut(const PackOptions& options, const PackSource& source) {
  if (options.check.page && (!options.check.written_page || options.output.dry_run)) return false;
  const WriteOptions& write = options.output.write;
  if (!write.png_level) return false;  // which samples of the whole page tell
  return !source.scene && write.formats == std::vector<std::string>{"png"};
}

// Textures that stay RGBA8 beside textures in blocks are at least compressed as files.
constexpr int zstd_of_fallback = 3;

// A texture in the format that fits what it holds, where that keeps to the budget, else in the format that was asked for,
// else its colour in that and its fourth channel apart.
//   apart   parts of materials lie apart, and no page has those of fewer channels alone
CompressedTexture blocks_of(const BlockJob& job, bool apart) {
  const BlockFormat* fitting = job.how.fits && !apart && job.texture == Texture::specular_gloss
                                   ? fitting_format(job.decision, job.page)
                                   : nullptr;
  if (fitting != nullptr) {
    CompressOptions narrow = job.how;
    narrow.format = fitting;
    BlockJob first{job.decision, job.materials, job.page, job.texture, job.pixels,
                   job.shown,    job.gloss,     narrow,   job.astc,    job.threads};
    if (CompressedTexture out = compress_texture(first); out.blocks) return out;
  }
  BlockJob whole = job;
  whole.may_end = !apart;
  CompressedTexture out = compress_texture(whole);
  if (out.blocks || apart || !reads_fourth(job.decision, job.materials, job.page, job.texture)) return out;
  BlockJob colour = whole;
  colour.fourth_apart = true;
  CompressedTexture halves = compress_texture(colour);
  return halves.blocks ? halves : out;
}

void write_files(const WholePage& page, const PackOptions& options, const PackSource& source,
                 const PackStages& stages, MadePages& to) {
  const std::array<bool, 2>& has = page.decision.plan.pages[static_cast<std::size_t>(page.number)].has;
  const CompressOptions& compress = options.output.compress;
  const TexelsShown shown =
      compress.format != nullptr ? texels_shown(source, page.decision, page.number) : TexelsShown();
  const auto job_of = [&](Texture texture) {
    return BlockJob{page.decision,
                    source.inputs.materials,
                    page.number,
                    texture,
                    page.pixels,
                    shown,
                    source.inputs.gloss,
                    compress,
                    options.input.pictures.door.astc,
                    options.run.threads};
  };
  std::array<CompressedTexture, 2> made;
  for (const Texture texture : both_textures) {
    stages.stop_if_cancelled();
    if (!has[index_of(texture)]) continue;
    CompressedTexture& its = made[index_of(texture)];
    WriteOptions write = page.options;
    if (compress.format != nullptr) {
      its = blocks_of(job_of(texture), source.one_page != nullptr);
      if (!its.blocks && write.zstd_level == 0 && has_zstd()) write.zstd_level = zstd_of_fallback;
    }
    write_page(*to.folder, page.number, texture, page.pixels, write, its.blocks ? &*its.blocks : nullptr);
    if (!its.blocks) continue;
    if (write.zstd_level == 0 && has_zstd()) write.zstd_level = zstd_of_fallback;
    if (its.blocks->fourth_apart) write_fourth(*to.folder, page.number, texture, page.pixels, write);
    if (const int held = static_cast<int>(its.blocks->levels.size()); held < page.pixels.levels())
      write_tail(*to.folder, page.number, texture, page.pixels, held, write);
  }
  // Parts that lie apart are not those of one material.
  if (compress.format != nullptr && source.one_page == nullptr)
    tell_shaded(job_of(Texture::diffuse_alpha), made, options.run.block_pictures, to.block_pictures);
  for (const CompressedTexture& each : made)
    to.blocks.insert(to.blocks.end(), each.report.begin(), each.report.end());
  if (source.scene) to.scene_pictures.merge(write_page(*to.folder, page, *source.scene, to.scene));
}

void write_floats(OutputFolder& folder, int p, const FloatPage& page, const PackOptions& options) {
  for (const std::string& format : options.output.write.formats)
    if (holds_floats(format)) write_float_page(folder, p, page, format, options.input.pictures.door);
}

WriteOptions write_options(const PackOptions& options, const PackStages& stages, PackProgress& progress) {
  WriteOptions out = options.output.write;
  out.threads = options.run.threads;
  out.written = [&](std::size_t texels) {
    stages.stop_if_cancelled();
    progress.written(texels);
  };
  return out;
}

// Weighs the files that all pages would become.
void weigh_pages(const PackOptions& options, PackSource& source, PackDecision& decision,
                 const PackStages& stages) {
  const ComposeOptions compose{options.run.threads, source.inputs.gloss, options.output.bleed};
  Composer composer(source.inputs.materials, decision.regions, decision.plan, compose);
  std::vector<Learned> learned(source.inputs.materials.size());
  PagePixels pixels;
  PackProgress progress(options.run.progress, decision.plan, decision.regions.size(), options.output.write,
                        true);
  const WriteOptions write = write_options(options, stages, progress);
  for (int p = 0; p < static_cast<int>(decision.plan.pages.size()); ++p) {
    const PlannedPage& page = decision.plan.pages[static_cast<std::size_t>(p)];
    check_memory(options, page, 1);
    pixels.start(page, 1);
    composer.texels(p, pixels, learned, [&] {
      stages.stop_if_cancelled();
      progress.region();
    });
    composer.mips(p, pixels);
    weigh_page(*source.scene, p, pixels, decision, write);
    progress.written(2 * PackProgress::texels_of(page));
  }
}

// Compressing pages takes most of the time of a scene. Ways hold the same texels, but for what some of them leave out,
// so that pages of many more texels are larger as files too.
void leave_those_that_may_win(std::vector<PackDecision>& ways) {
  constexpr double most_area = 1.05;  // of the least
  std::uint64_t least = ways.front().plan.page_texels();
  for (const PackDecision& way : ways) least = std::min(least, way.plan.page_texels());
  std::erase_if(ways, [&](const PackDecision& way) {
    return static_cast<double>(way.plan.page_texels()) > most_area * static_cast<double>(least);
  });
}

}  // namespace

PackDecision lightest(const PackOptions& options, PackSource& source, std::vector<PackDecision> ways,
                      PackStages& stages) {
  if (!weighs_files(options, source)) return std::move(ways.front());
  leave_those_that_may_win(ways);
  std::optional<std::pair<double, std::uint64_t>> least;
  std::size_t best = 0;
  for (std::size_t i = 0; i < ways.size(); ++i)
    stages.timed("weighing", [&] {
      ways[i].sizes.emplace();
      weigh_pages(options, source, ways[i], stages);
      const std::pair weight(choose_pictures(*source.scene, ways[i], options.output.goal).weight,
                             ways[i].plan.page_texels());
      if (!least || weight < *least) least = weight, best = i;
    });
  ways[best].other_goals = other_goals(*source.scene, ways);
  return std::move(ways[best]);
}

std::optional<MadePages> make_pages(const PackOptions& options, PackSource& source,
                                    const EarlierAtlas& earlier, PackDecision& decision,
                                    std::vector<Learned>& learned, PackStages& stages) {
  const std::vector<Region>& regions = decision.regions;
  const PackingPlan& plan = decision.plan;
  const std::vector<PackInput>& materials = source.inputs.materials;
  MadePages made;
  if (!options.output.dry_run) {
    made.folder = std::make_unique<OutputFolder>(earlier.folder, may_replace(options.output.overwrite));
    made.folder->limit_mode(strictest_mode(input_files(options, source)));
    refuse_strangers(options, earlier, decision);
  }
  if (source.scene) made.scene = choose_pictures(*source.scene, decision, options.output.goal);
  const ComposeOptions compose{options.run.threads, source.inputs.gloss, options.output.bleed};
  Composer composer(materials, regions, plan, compose);
  PagePixels pixels;
  PackProgress progress(options.run.progress, plan, regions.size(), options.output.write,
                        made.folder != nullptr);
  const std::function<void()> region_done = [&] {
    stages.stop_if_cancelled();
    progress.region();
  };
  const WriteOptions write = write_options(options, stages, progress);
  const auto table = [&] { return layout_table(options, source, decision); };
  const auto check = [&](int p) {
    if (!options.check.page) return;
    stages.timed("validate", [&] { made.good = options.check.page(table(), p, pixels) && made.good; });
  };
  const auto path_of = [&](int p) {
    return [&, p](Texture texture) { return made.folder->path_until_commit(page_file(p, texture, "png")); };
  };
  const int pages = static_cast<int>(plan.pages.size());
  // Where texels of a page teach that other regions are needed, those of the other pages are still looked at:
  // the next layout then knows what all of them teach.
  bool settled = true;
  for (int p = 0; p < pages; ++p) {
    const PlannedPage& page = plan.pages[static_cast<std::size_t>(p)];
    const int levels = decision.levels[static_cast<std::size_t>(p)].kept;
    check_memory(options, page, levels);
    std::vector<int> cuts;
    if (may_be_cut(options, source))
      cuts = page_cuts(composer, regions, plan, p, levels, options.output.bleed);
    if (cuts.size() > 2) {
      pixels.release();
      stages.timed("texels, mips and files", [&] {
        stream_page(composer, {regions, plan, p, levels, cuts, made.folder.get(), write, region_done},
                    learned);
      });
      progress.written(2 * PackProgress::texels_of(page));
      settled = learn(learned, options, source, decision) && settled;
      if (settled && options.check.page && made.folder)
        stages.timed("validate",
                     [&] { made.good = options.check.written_page(table(), p, path_of(p)) && made.good; });
      continue;
    }
    pixels.start(page, levels);
    stages.timed("texels", [&] { composer.texels(p, pixels, learned, region_done); });
    settled = learn(learned, options, source, decision) && settled;
    if (!settled) continue;
    stages.timed("gutters and mips", [&] { composer.mips(p, pixels); });
    check(p);
    if (!made.folder) continue;
    stages.timed("write", [&] { write_files({p, pixels, decision, write}, options, source, stages, made); });
    if (!writes_floats(write)) continue;
    stages.timed("floats", [&] {
      write_floats(*made.folder, p, compose_floats(p, levels, materials, regions, plan, compose), options);
    });
  }
  if (!settled) return std::nullopt;
  check(pages);
  return made;
}

}  // namespace etak
