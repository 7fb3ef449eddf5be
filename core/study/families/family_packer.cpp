// SPDX-License-Identifier: Apache-2.0
// Family i: how much effort to spend on packing rectangles, and on compressing their pages.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "core/base/number.h"
#include "core/image/files/png.h"
#include "core/rects/rects.h"
#include "core/study/families/families.h"
#include "core/study/made_pages.h"
#include "core/study/measure.h"

namespace etak {
namespace {

using Sizes = std::vector<RectSize>;

constexpr int efforts[] = {1, 3, 10, 30, 100, 300, 1000, 3000};
constexpr int most_quick_effort = 300, default_effort = 100;
constexpr int page_side = most_page_side, quick_page_side = 512;
// Sides of the smallest squares known for the sets below. Effort 200,000 has found the first three; the
// fourth set is made from a square of this side.
constexpr int best_sides[] = {822, 1247, 535, page_side};

int between(Random& random, int low, int high) {
  return low + static_cast<int>(random.uniform() * (high - low + 1));
}

// ---- sets of rectangles

Sizes uniform_set(std::size_t count) {
  Random random(11);
  Sizes out;
  for (std::size_t i = 0; i < count; ++i) out.push_back({between(random, 4, 96), between(random, 4, 96)});
  return out;
}

// Squares with a power of two as their side, of which a transparent border was cut off.
Sizes trimmed_set(std::size_t count) {
  Random random(12);
  Sizes out;
  for (std::size_t i = 0; i < count; ++i) {
    const int side = 16 << between(random, 0, 4);
    const auto trimmed = [&] { return std::max(1, static_cast<int>(side * random.uniform(0.35, 1))); };
    const int width = trimmed();
    out.push_back({width, trimmed()});
  }
  return out;
}

Sizes thin_set(std::size_t count) {
  Random random(13);
  Sizes out;
  for (std::size_t i = 0; i < count; ++i) {
    const int narrow = between(random, 2, 14), wide = between(random, 40, 220);
    out.push_back(random.uniform() < 0.5 ? RectSize{narrow, wide} : RectSize{wide, narrow});
  }
  return out;
}

// A page of 1024 x 1024 that was cut in two again and again, so that a layout without loss exists.
Sizes guillotine_set(std::size_t count) {
  Random random(14);
  Sizes out{{page_side, page_side}};
  while (out.size() < count) {
    const auto largest = std::max_element(out.begin(), out.end(), [](const RectSize& a, const RectSize& b) {
      return a.width * a.height < b.width * b.height;
    });
    RectSize rest = *largest;
    int& longer = rest.width >= rest.height ? rest.width : rest.height;
    int& cut = rest.width >= rest.height ? largest->width : largest->height;
    cut = std::clamp(static_cast<int>(longer * random.uniform(0.2, 0.8)), 1, longer - 1);
    longer -= cut;
    out.push_back(rest);
  }
  return out;
}

struct RectSet {
  const char* id;
  const char* title;
  Sizes sizes;
  std::size_t best_side;  // of the smallest square known
  double area = 0;
};

std::vector<RectSet> rect_sets() {
  constexpr std::size_t count = 250;
  std::vector<RectSet> out{
      {"uniform", "sides 4 to 96", uniform_set(count), std::size_t(best_sides[0])},
      {"trimmed", "trimmed sprites", trimmed_set(count), std::size_t(best_sides[1])},
      {"thin", "thin strips", thin_set(count), std::size_t(best_sides[2])},
      {"guillotine", "a page cut up", guillotine_set(count), std::size_t(best_sides[3])}};
  for (RectSet& set : out)
    for (const RectSize& size : set.sizes) set.area += double(size.width) * size.height;
  return out;
}

RectLayout packed(const RectSet& set, int effort, unsigned threads) {
  RectOptions options;
  options.form = PageForm::square;
  options.effort = effort;
  options.threads = threads;
  return pack_rects(set.sizes, options);
}

// ---- tables

std::string png_of(const MadePage& page, PngLevel level, unsigned threads) {
  PngOptions options;
  options.level = level;
  options.threads = threads;
  return png_bytes(page.pixels, options);
}

// The set that times the table's rows. Etak packs and compresses on all threads it is given.
TimedSet timed_set(const ErrorTimeTable& table, std::vector<TimedCase> cases, const ReportOptions& options) {
  return {{table.id}, std::move(cases), ms_of_ns, options.threads > 1};
}

ErrorTimeTable effort_table(const ReportOptions& options, std::vector<TimedSet>& timings) {
  auto sets = std::make_shared<std::vector<RectSet>>(rect_sets());
  ErrorTimeTable table;
  table.id = "effort";
  table.title = "Rectangles: effort of etak pack";
  table.metrics = {{"mean_lost", "density lost, mean of the sets", "points"}};
  for (const RectSet& set : *sets)
    table.metrics.push_back({std::string("lost_") + set.id, set.title, "points"});
  table.time_unit = "ms per layout";
  std::vector<TimedCase> cases;
  std::vector<std::vector<std::size_t>> page_sides;  // of each row's layouts
  for (const int effort : efforts) {
    if (!options.full && effort > most_quick_effort) break;
    ErrorTimeRow row;
    row.id = "effort_" + std::to_string(effort);
    row.title = "effort " + std::to_string(effort);
    table.rows.push_back(row);
    auto& own = page_sides.emplace_back();
    for (RectSet& set : *sets) {
      own.push_back(static_cast<std::size_t>(packed(set, effort, options.threads).pages[0].width));
      set.best_side = std::min(set.best_side, own.back());
    }
    cases.push_back({row.id, sets->size(), [sets, effort, threads = options.threads] {
                       for (const RectSet& set : *sets) {
                         const RectLayout layout = packed(set, effort, threads);
                         keep(layout.places.data());
                       }
                     }});
  }
  table.base = table.rows.front().id;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    double mean = 0;
    std::vector<double> lost;
    for (std::size_t s = 0; s < sets->size(); ++s) {
      const RectSet& set = (*sets)[s];
      const double best = double(set.best_side), own = double(page_sides[r][s]);
      lost.push_back(100 * set.area * (1 / (best * best) - 1 / (own * own)));
      mean += lost.back() / double(sets->size());
    }
    table.rows[r].errors = {mean};
    table.rows[r].errors.insert(table.rows[r].errors.end(), lost.begin(), lost.end());
  }
  timings.push_back(timed_set(table, std::move(cases), options));
  return table;
}

struct Level {
  const char* id;
  const char* title;
  PngLevel level;
};
constexpr std::array levels{Level{"fast", "fast", PngLevel::fast}, Level{"small", "small", PngLevel::small},
                            Level{"smallest", "smallest", PngLevel::smallest}};

ErrorTimeTable codec_table(const ReportOptions& options, std::vector<TimedSet>& timings) {
  const int side = options.full ? page_side : quick_page_side;
  const auto pages = std::make_shared<const std::vector<MadePage>>(made_pages(side));
  ErrorTimeTable table;
  table.id = "png";
  table.title = "Pages: levels of PNG";
  table.metrics = {{"bytes_ratio", "bytes against smallest, mean", ""}};
  for (const MadePage& page : *pages)
    table.metrics.push_back({std::string("ratio_") + page.id, page.title, ""});
  for (const MadePage& page : *pages)
    table.metrics.push_back({std::string("bits_") + page.id, page.title, "bits per pixel"});
  table.time_unit = "ms per page";
  table.title += " (" + std::to_string(side) + " x " + std::to_string(side) + ")";
  table.base = levels.front().id;
  std::vector<TimedCase> cases;
  std::array<std::vector<double>, levels.size()> bytes;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    for (const MadePage& page : *pages)
      bytes[i].push_back(double(png_of(page, levels[i].level, options.threads).size()));
    cases.push_back(
        {levels[i].id, pages->size(), [pages, level = levels[i].level, threads = options.threads] {
           for (const MadePage& page : *pages) {
             const std::string png = png_of(page, level, threads);
             keep(png.data());
           }
         }});
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    ErrorTimeRow row;
    row.id = levels[i].id;
    row.title = levels[i].title;
    row.errors = {0};
    for (std::size_t p = 0; p < pages->size(); ++p) {
      row.errors.push_back(bytes[i][p] / bytes.back()[p]);
      row.errors[0] += row.errors.back() / double(pages->size());
    }
    for (std::size_t p = 0; p < pages->size(); ++p)
      row.errors.push_back(8 * bytes[i][p] / (double(side) * side));
    table.rows.push_back(row);
  }
  timings.push_back(timed_set(table, std::move(cases), options));
  return table;
}

}  // namespace

ErrorTimeFamily packer_family(const ReportOptions& options) {
  ErrorTimeFamily family;
  family.id = "packer";
  family.letter = "i";
  family.title = "Packing and compressing";
  family.reference =
      "the smallest page known for each set of rectangles (for the page cut up: the page); the bytes of PNG level smallest";
  family.grid = "four sets of 250 rectangles, one square page, no rotation; three pages of " +
                std::string(options.full ? "1024 x 1024" : "512 x 512") +
                " pixels with four channels, made by formula";
  family.tables = {effort_table(options, family.timed), codec_table(options, family.timed)};
  const auto error = [&](std::size_t table, std::string_view id) {
    const auto& rows = family.tables[table].rows;
    return std::find_if(rows.begin(), rows.end(), [&](const ErrorTimeRow& row) { return row.id == id; })
        ->errors[0];
  };
  const std::string usual = "effort_" + std::to_string(default_effort);
  family.advice = "Keep effort " + std::to_string(default_effort) + " while working (" +
                  number(error(0, usual), 2) + " points of density short of the best known, effort 1 by " +
                  number(error(0, "effort_1"), 2) + ") with PNG level fast, and ship with effort 300 (" +
                  number(error(0, "effort_300"), 2) +
                  ") and level small: smallest takes several times as long for the last " +
                  number(100 * (1 - 1 / error(1, "small")), 2) + " % of the bytes.";
  family.picks = {{"an atlas while working", "effort", usual, "the default of etak pack"},
                  {"an atlas to ship", "effort", "effort_300", "paid for once"},
                  {"its files to ship", "png", "small", "smallest takes several times as long"}};
  family.notes = {"Both on " + std::to_string(options.threads) +
                  (options.threads == 1 ? " thread" : " threads") +
                  "; layouts and bytes are the same on any number."};
  return family;
}

}  // namespace etak
