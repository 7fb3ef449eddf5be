// SPDX-License-Identifier: Apache-2.0
#include "core/judge/pixels/pixel_pass.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "core/base/crew.h"
#include "core/color/luminance.h"
#include "core/color/srgb.h"
#include "core/judge/pixels/tile_frame.h"

namespace etak {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// The latest `kept` strips of rows of one picture: row y stands at y % (kept * strip).
class Strips {
 public:
  Strips(RowSource* source, int width, int strip, int kept, const CodeTables& tables,
         std::uint8_t filler_alpha)
      : source_(source), ring_(strip * kept), stride_(4 * static_cast<std::size_t>(width)), tables_(tables) {
    codes_.resize(stride_ * static_cast<std::size_t>(ring_));
    if (source == nullptr)
      for (std::size_t i = 3; i < codes_.size(); i += 4) codes_[i] = filler_alpha;
    else if (source->header().floating)
      facts.emplace();
  }

  bool has_source() const { return source_ != nullptr; }

  const std::uint8_t* row(int y) const {
    return codes_.data() + static_cast<std::size_t>(y % ring_) * stride_;
  }

  // Reads `count` rows from first_row on, which is a multiple of the strip's height.
  void read(int first_row, int count) {
    if (source_ == nullptr) return;
    std::uint8_t* to = codes_.data() + static_cast<std::size_t>(first_row % ring_) * stride_;
    if (!source_->header().floating) {
      source_->read_rows(to, stride_, count);
      return;
    }
    floats_.resize(stride_ * static_cast<std::size_t>(count));
    source_->read_float_rows(floats_.data(), stride_, count);
    for (int i = 0; i < count; ++i)
      convert(floats_.data() + stride_ * static_cast<std::size_t>(i),
              to + stride_ * static_cast<std::size_t>(i), first_row + i);
  }

  std::optional<FloatFacts> facts;

 private:
  void convert(const float* values, std::uint8_t* codes, int y) {
    FloatFacts& f = *facts;
    for (std::size_t i = 0; i < stride_; i += 4) {
      const std::array<int, 2> place{static_cast<int>(i / 4), y};
      float largest = 0;
      for (std::size_t c = 0; c < 4; ++c) {
        const float v = values[i + c];
        if (!std::isfinite(v)) {
          if (f.nan + f.infinite == 0) f.nan_at = place;
          ++(std::isnan(v) ? f.nan : f.infinite);
        } else if (v < -1e-6f) {
          if (f.negative++ == 0) f.negative_at = place;
          f.most_negative = std::min(f.most_negative, v);
        }
        // Both were counted above; from here on NaN counts as black and infinity as white.
        const double clamped = v > 0 ? std::min(static_cast<double>(v), 1.0) : 0.0;
        if (c == 3)
          codes[i + c] = plain_u8(clamped);
        else
          codes[i + c] = tables_.code_of(static_cast<std::uint32_t>(clamped * linear_one));
        if (c < 3 && std::isfinite(v)) largest = std::max(largest, v);
      }
      // Values slightly above 1 come from rounding to half floats.
      if (largest > 1.0005f) {
        ++f.above_one;
        if (largest > f.largest) {
          f.largest = largest;
          f.above_at = place;
          f.above_value = {values[i], values[i + 1], values[i + 2]};
          f.above_luminance = luminance_of<double>(values[i], values[i + 1], values[i + 2]);
        }
      }
    }
  }

  RowSource* source_;
  int ring_;  // rows
  std::size_t stride_;
  const CodeTables& tables_;
  std::vector<std::uint8_t> codes_;
  std::vector<float> floats_;
};

// The number of rows that are read at a time: about a megabyte of both pictures, which stays in the
// second-level cache.
int strip_height(int width, int height) {
  const int wanted = (1 << 20) / (8 * std::max(1, width));
  return std::clamp(wanted, RegionAnalysis::rows_kept,
                    std::max<int>(RegionAnalysis::rows_kept, std::min(height, 256)));
}

// A tile that the strips have reached.
struct Active {
  std::size_t index = 0;
  std::unique_ptr<TilePass> pass;
  std::unique_ptr<TileFrame> frame;
  int first = 0, last = 0;  // rows of the picture that pass and frame need
};

// A strip with the tiles that need its rows. It is read, then counted, then followed (TilePass).
struct Strip {
  int top = 0, rows = 0;
  std::vector<std::shared_ptr<Active>> tiles;
};

class Pass {
 public:
  Pass(PictureRows& pictures, std::span<const CheckTile> tiles, const std::vector<bool>& every_row,
       const PassPlan& plan)
      : pictures_(pictures),
        tiles_(tiles),
        every_row_(every_row),
        plan_(plan),
        header_((pictures.b   ? pictures.b
                 : pictures.a ? pictures.a
                              : pictures.metallic)
                    ->header()),
        strip_(strip_height(header_.width, header_.height)),
        kept_(plan.workers > 1 ? 4 : 2),
        a_(pictures.a.get(), header_.width, strip_, kept_, *plan.tables, 255),
        b_(pictures.b.get(), header_.width, strip_, kept_, *plan.tables, 0),
        metallic_(pictures.metallic.get(), pictures.metallic ? header_.width : 0, strip_, kept_, *plan.tables,
                  255),
        crew_(plan.workers),
        seconds_(3 * plan.workers) {}

  PassResult run() {
    result_.tiles.resize(tiles_.size());
    prepare_tiles();
    const int strips = (header_.height + strip_ - 1) / strip_;
    // One worker finishes a strip while it is in the cache; with several workers three strips are under way.
    const int lag = plan_.workers > 1 ? 1 : 0;
    std::vector<Strip> under_way(static_cast<std::size_t>(strips));
    for (int round = 0; round < strips + 2 * lag; ++round) {
      std::vector<Crew::Task> tasks;
      if (round < strips) {
        Strip& strip = under_way[static_cast<std::size_t>(round)];
        strip.top = round * strip_;
        strip.rows = std::min(strip_, header_.height - strip.top);
        add_reading(tasks, strip);
      }
      if (lag == 0) {
        crew_.run(tasks);
        tasks.clear();
      }
      if (round - 2 * lag >= 0 && lag != 0)
        add_following(tasks, under_way[static_cast<std::size_t>(round - 2 * lag)]);
      if (round - lag >= 0 && round - lag < strips) {
        Strip& strip = under_way[static_cast<std::size_t>(round - lag)];
        take_tiles(strip);
        add_counting(tasks, strip);
      }
      if (lag == 0) add_following(tasks, under_way[static_cast<std::size_t>(round)]);
      crew_.run(tasks);
      const int done = round - 2 * lag;
      if (done >= 0) under_way[static_cast<std::size_t>(done)].tiles.clear();
    }
    result_.a_floats = a_.facts;
    result_.b_floats = b_.facts;
    CheckStats& stats = result_.stats;
    stats.pictures_decoded =
        (pictures_.a ? 1u : 0u) + (pictures_.b ? 1u : 0u) + (pictures_.metallic ? 1u : 0u);
    stats.texels = static_cast<std::size_t>(header_.width) * static_cast<std::size_t>(header_.height);
    stats.passes = 1;
    for (unsigned worker = 0; worker < plan_.workers; ++worker) {
      stats.decode_seconds += seconds_[3 * worker];
      stats.byte_seconds += seconds_[3 * worker + 1];
      stats.region_seconds += seconds_[3 * worker + 2];
    }
    return std::move(result_);
  }

 private:
  void prepare_tiles() {
    if (plan_.frames)
      for (const CheckTile& tile : tiles_)
        reach_ =
            std::max({reach_, plan_.gutter_of(tile), plan_.mips_of(tile) > 0 ? 1 << plan_.mips_of(tile) : 0});
    waiting_.resize(tiles_.size());
    for (std::size_t i = 0; i < tiles_.size(); ++i) waiting_[i] = i;
    // The lowest tile comes first, so that the next tile is taken from the end.
    std::stable_sort(waiting_.begin(), waiting_.end(),
                     [&](std::size_t x, std::size_t y) { return tiles_[x].box.y > tiles_[y].box.y; });
  }

  RowPointers pointers(int y, int x) const {
    return {a_.row(y) + 4 * x, b_.row(y) + 4 * x, pictures_.metallic ? metallic_.row(y) + 4 * x : nullptr};
  }

  // Adds a task whose time is added to the worker's time of that kind: 0 reading, 1 counting, 2 following.
  template <class Act>
  void add(std::vector<Crew::Task>& tasks, std::size_t kind, Act act) {
    tasks.push_back([this, kind, act](unsigned worker) {
      const auto start = Clock::now();
      act(worker);
      seconds_[3 * worker + kind] += seconds_since(start);
    });
  }

  void add_reading(std::vector<Crew::Task>& tasks, const Strip& strip) {
    for (Strips* picture : {&a_, &b_, &metallic_})
      if (picture->has_source())
        add(tasks, 0, [picture, top = strip.top, rows = strip.rows](unsigned) { picture->read(top, rows); });
  }

  void take_tiles(Strip& strip) {
    const int end = strip.top + strip.rows;
    while (!waiting_.empty() && tiles_[waiting_.back()].box.y - reach_ < end) {
      auto tile = std::make_shared<Active>();
      tile->index = waiting_.back();
      waiting_.pop_back();
      const CheckTile& what = tiles_[tile->index];
      tile->pass = std::make_unique<TilePass>(what, plan_, strip_, every_row_[tile->index]);
      tile->first = what.box.y;
      tile->last = what.box.y + what.box.height - 1;
      if (plan_.frames) {
        tile->frame = std::make_unique<TileFrame>(what, header_.width, header_.height, plan_);
        tile->first = tile->frame->first_row();
        tile->last = tile->frame->last_row();
      }
      active_.push_back(std::move(tile));
    }
    strip.tiles = active_;
    std::erase_if(active_, [&](const auto& tile) { return tile->last < end; });
  }

  void add_counting(std::vector<Crew::Task>& tasks, const Strip& strip) {
    const int pieces = plan_.workers > 1 ? 4 : 1;
    for (int piece = 0; piece < pieces; ++piece) {
      const int begin = strip.top + strip.rows * piece / pieces,
                end = strip.top + strip.rows * (piece + 1) / pieces;
      add(tasks, 1, [this, &strip, begin, end](unsigned worker) {
        for (int y = begin; y < end; ++y)
          for (const auto& tile : strip.tiles) {
            const PixelBox& box = tile->pass->box();
            if (y >= box.y && y < box.y + box.height) tile->pass->count_row(worker, y, pointers(y, box.x));
          }
      });
    }
  }

  void add_following(std::vector<Crew::Task>& tasks, const Strip& strip) {
    add(tasks, 2, [this, &strip](unsigned) {
      const int end = strip.top + strip.rows;
      for (const auto& tile : strip.tiles) {
        const PixelBox& box = tile->pass->box();
        const auto at_tile = [&](int y) { return pointers(y, box.x); };
        for (int y = std::max(strip.top, tile->first); y < end && y <= tile->last; ++y) {
          if (y >= box.y && y < box.y + box.height) tile->pass->follow_row(y, at_tile);
          if (tile->frame) tile->frame->push(y, pointers(y, 0));
        }
        if (tile->last >= end) continue;
        result_.tiles[tile->index] = tile->pass->finish();
        if (tile->frame) tile->frame->finish(result_.tiles[tile->index]);
      }
    });
  }

  PictureRows& pictures_;
  std::span<const CheckTile> tiles_;
  const std::vector<bool>& every_row_;
  const PassPlan& plan_;
  const PictureHeader header_;
  const int strip_;
  // The strips that are kept of each picture. Several workers read one strip, count the one before, and
  // follow the one before that, which looks back into a fourth. One worker finishes a strip before it reads
  // the next.
  const int kept_;
  Strips a_, b_, metallic_;
  std::vector<std::size_t> waiting_;
  std::vector<std::shared_ptr<Active>> active_;
  int reach_ = 0;
  Crew crew_;
  std::vector<double> seconds_;  // for each worker: reading, counting, following
  PassResult result_;
};

}  // namespace

PassResult pixel_pass(PictureRows& pictures, std::span<const CheckTile> tiles,
                      const std::vector<bool>& every_row, const PassPlan& plan) {
  return Pass(pictures, tiles, every_row, plan).run();
}

}  // namespace etak
