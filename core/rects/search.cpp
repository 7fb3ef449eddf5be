// SPDX-License-Identifier: Apache-2.0
#include "core/rects/search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

#include "core/base/parallel.h"
#include "core/rects/index.h"

namespace etak::rects {
namespace {

// With fewer rectangles than these, a try takes no longer than the start of a thread.
constexpr int least_for_threads = 700;

}  // namespace

struct Search::Worker {
  Worker(const Set& set, const Set& turned, bool rotate)
      : skyline{{set, rotate}, {turned, rotate}}, maxrects{{set, rotate}, {turned, rotate}} {}
  Skyline skyline[2];
  MaxRects maxrects[2];
};

/// One try with its outcome.
struct Search::Step {
  Try how;
  int target = 0;           // side of the page
  std::uint64_t print = 0;  // of the try in the page of side `target`
  const Outcome* known = nullptr;
  Outcome outcome;
  std::vector<Spot> spots;
};

Search::Search(const Set& set, bool rotate, unsigned threads, Budget& budget)
    : set_(set),
      turned_(set.turned()),
      rotate_(rotate),
      threads_(set.size() < least_for_threads ? 1 : std::max(1u, threads)),
      budget_(budget),
      portfolio_(portfolio(set.size(), rotate)) {
  workers_.push_back(std::make_unique<Worker>(set_, turned_, rotate));
  all_.resize(set.items.size());
  std::iota(all_.begin(), all_.end(), 0);
  if (!set.items.empty() && set.items.front() != set.items.back()) return;
  for (Try& how : portfolio_) {  // the first in the window is as good as any
    how.rule.window = 1;
    how.rule.late = 0;
  }
}

Search::~Search() = default;

const std::vector<int>& Search::order(const Try& how) {
  // When all rectangles are turned, only the keys height and width give other orders.
  Key key = how.key;
  if (how.transposed && (key == Key::height || key == Key::width))
    key = key == Key::height ? Key::width : Key::height;
  std::vector<int>& out = orders_[static_cast<int>(key)];
  if (out.empty()) out = ordered(set_, all_, key);
  return out;
}

Outcome Search::evaluate(const Try& how, std::span<const int> order, int width, int height, bool partial,
                         unsigned worker) {
  const int side = how.transposed ? 1 : 0;
  if (how.transposed) std::swap(width, height);
  Outcome out = how.skyline ? workers_[worker]->skyline[side].pack(width, height, order, how.rule, partial)
                            : workers_[worker]->maxrects[side].pack(width, height, order, how.fit, partial);
  if (how.transposed) std::swap(out.width, out.height);
  return out;
}

namespace {

void mix(std::uint64_t& print, std::uint64_t value) {
  print = (print ^ value) * 0x9e3779b97f4a7c15u;
  print ^= print >> 32;
}

}  // namespace

std::uint64_t Search::print_of(const Try& how, std::span<const int> order) const {
  std::uint64_t out = how.skyline ? 1 : 2;
  const SkylineRule& r = how.rule;
  for (const int part : {r.window, r.exact, r.flush, r.ceiling, r.sliver, r.late, r.left_over, r.side,
                         static_cast<int>(how.fit), how.transposed ? 1 : 0})
    mix(out, static_cast<std::uint64_t>(part));
  for (const int i : order) mix(out, static_cast<std::uint64_t>(i));
  return out;
}

std::uint64_t Search::print_in(std::uint64_t print, int width, int height) {
  mix(print, static_cast<std::uint64_t>(width) << 32 | static_cast<std::uint32_t>(height));
  return print;
}

const Outcome* Search::known(std::uint64_t print) const {
  const auto found = failed_.find(print);
  return found == failed_.end() ? nullptr : &found->second;
}

void Search::learn(std::uint64_t print, const Outcome& outcome) {
  constexpr std::size_t most = 1 << 16;
  if (outcome.all) return;
  if (failed_.size() >= most) failed_.clear();
  failed_.emplace(print, outcome);
}

void Search::spots_of(const Try& how, unsigned worker, std::vector<Spot>& out) const {
  const int side = how.transposed ? 1 : 0;
  out = how.skyline ? workers_[worker]->skyline[side].spots() : workers_[worker]->maxrects[side].spots();
  if (!how.transposed) return;
  for (Spot& spot : out)
    if (spot.x >= 0) std::swap(spot.x, spot.y);
}

// The side to try next, `depth` pages below the best; less than family.least where there is none.
int Search::target(const Family& family, const Best& best, int depth) const {
  int side = best.any ? family.smaller(side_of(family, best)) : family.most;
  if (family.below != INT_MAX) side = std::min(side, family.smaller(family.below));
  for (int i = 1; i < depth; ++i) side = family.smaller(side);
  return std::min(side, family.most);
}

// The first layout. Its height in a page without an upper end says which page to expect; the search goes up
// from there.
void Search::start(const Family& family, Best& best) {
  const Try& how = portfolio_.front();
  const auto tried = [&](int width, int height) {
    const Outcome outcome = evaluate(how, order(how), width, height, false, 0);
    budget_.charge(outcome.work);
    if (outcome.all && outcome.width <= family.width_at(family.most) && outcome.height <= family.most &&
        (family.width > 0 || width == height || outcome.height <= width)) {
      best.any = true;
      best.width = outcome.width;
      best.height = outcome.height;
      spots_of(how, 0, best.spots);
      best.method = how.name();
    }
    return outcome;
  };
  int side = std::min(family.most, family.least + family.least / 64);
  const int open_height = std::min(family.most, round_up(std::int64_t{2} * family.least, 1) + 16);
  const Outcome open = tried(family.width_at(side), open_height);
  if (!best.any && family.width == 0 && open.all)
    side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(side) * open.height)));
  // There must be a layout to return, so this goes on beyond the end of the budget. The steps do not depend
  // on what is left of the budget, so that a larger budget finds all that a smaller one does.
  int steps = 0;
  for (int last = 0; !best.any && last < family.most; side += std::max(1, side / (++steps < 12 ? 50 : 8))) {
    last = std::min(family.full(std::clamp(side, family.least, family.most)), family.most);
    tried(family.width_at(last), last);
  }
  // For few rectangles another rule will soon do better: the end of the first one is not worth its tries.
  if (best.any) descend(family, best, how, order(how), !few());
}

// Tries smaller and smaller pages with a try that has just succeeded: first in longer and longer steps,
// then in steps of half the length each.
//   to_the_end   false: without the latter
void Search::descend(const Family& family, Best& best, const Try& how, std::span<const int> order,
                     bool to_the_end) {
  const std::uint64_t print = print_of(how, order);
  int bad = family.least - 1, jump = std::max(1, (side_of(family, best) - family.least) / 8);
  bool growing = true;
  while (budget_.open()) {
    const int good = side_of(family, best), next = family.smaller(good);
    if (next <= bad) break;
    const int middle = (good + bad) / 2;
    const int target =
        std::clamp(family.full(growing ? std::max(good - jump, middle) : middle), bad + 1, next);
    const std::uint64_t here = print_in(print, family.width_at(target), target);
    const Outcome* const before = known(here);
    const Outcome outcome =
        before ? *before : evaluate(how, order, family.width_at(target), target, false, 0);
    budget_.charge(outcome.work);
    if (!before) learn(here, outcome);
    if (outcome.all) {
      note(best);
      best.width = outcome.width;
      best.height = outcome.height;
      spots_of(how, 0, best.spots);
      jump *= 2;
    } else {
      if (!to_the_end) return;
      bad = target;
      growing = false;
    }
  }
}

// Takes over a step that succeeded.
bool Search::settle(const Family& family, Best& best, Step& step) {
  if (!step.outcome.all) return false;
  note(best);
  best.any = true;
  best.width = step.outcome.width;
  best.height = step.outcome.height;
  best.spots = std::move(step.spots);
  best.method = step.how.name();
  descend(family, best, step.how, order(step.how));
  return true;
}

// Makes the tries one after the other, each in a page depth(try) sizes below the best. With threads some are
// computed ahead; those after an improvement are discarded and made again.
//   placed   gets the share of its page that each try filled; null: not wanted
template <class Depth>
void Search::go_through(std::span<const Try> tries, const Family& family, Best& best, Depth depth_of,
                        double* placed) {
  const std::size_t batch = threads_ > 1 ? 4 * threads_ : 1;
  while (workers_.size() < threads_) workers_.push_back(std::make_unique<Worker>(set_, turned_, rotate_));
  std::vector<Step> steps(batch);
  for (std::size_t i = 0; i < tries.size();) {
    if (!budget_.open()) return;
    const std::size_t step_count = std::min(batch, tries.size() - i);
    for (std::size_t k = 0; k < step_count; ++k) {
      Step& step = steps[k];
      step.how = tries[i + k];
      int depth = depth_of(step.how);
      do {
        step.target = target(family, best, depth);
      } while (step.target < family.least && --depth > 0);
      step.print = print_in(print_of(step.how, order(step.how)), family.width_at(step.target), step.target);
      step.known = known(step.print);
    }
    parallel_chunks(step_count, threads_, 1, [&](std::size_t k, std::size_t, unsigned worker) {
      Step& step = steps[k];
      step.outcome = {};
      if (step.target < family.least) return;
      if (step.known) {
        step.outcome = *step.known;
        return;
      }
      step.outcome =
          evaluate(step.how, order(step.how), family.width_at(step.target), step.target, false, worker);
      if (step.outcome.all) spots_of(step.how, worker, step.spots);
    });
    bool better = false;
    for (std::size_t k = 0; k < step_count && !better; ++k, ++i) {
      Step& step = steps[k];
      if (step.outcome.work == 0) continue;
      if (!budget_.open()) return;
      budget_.charge(step.outcome.work);
      learn(step.print, step.outcome);
      if (placed)
        placed[i] = static_cast<double>(step.outcome.placed) /
                    (static_cast<double>(family.width_at(step.target)) * step.target);
      better = settle(family, best, step);
      if (best.any && side_of(family, best) <= family.least) return;
    }
  }
}

void Search::look(const Family& family, Best& best) {
  std::size_t looked = 0;
  for (const Try& how : portfolio_) {
    if (how.transposed || (!how.skyline && how.fit != Fit::bottom_left)) continue;
    if (looked == 4 || (best.any && !budget_.open())) return;
    const int height = best.any ? best.height - 1 : family.most;
    if (height < family.least) return;
    const Outcome outcome = evaluate(how, order(how), family.width, height, false, 0);
    budget_.charge(outcome.work);
    ++looked;
    if (!outcome.all) continue;
    best.any = true;
    best.width = outcome.width;
    best.height = outcome.height;
    spots_of(how, 0, best.spots);
    best.method = how.name();
  }
}

// Is called before `best` changes: notes it where a smaller budget would have ended with it. A search for a
// first layout does not end before it has one.
void Search::note(const Best& best) {
  if (!noted_ || (!best.any && must_find_)) return;
  while (noted_->size() < marks_.size() && budget_.would_end(marks_[noted_->size()])) noted_->push_back(best);
}

void Search::run(const Family& family, Best& best, std::span<const int> marks, std::vector<Best>& noted) {
  marks_ = marks;
  noted_ = &noted;
  must_find_ = !best.any && family.below == INT_MAX;
  go(family, best);
  noted.resize(marks.size(), best);
  noted_ = nullptr;
}

void Search::go(const Family& family, Best& best) {
  if (family.most < family.least) return;
  if (!best.any && family.below == INT_MAX) start(family, best);
  const auto finished = [&] { return target(family, best, 1) < family.least || !budget_.open(); };
  if (finished()) return;
  std::vector<Try> tries = portfolio_;
  // The first rule, which start() left before its end, comes last.
  if (few()) std::rotate(tries.begin(), tries.begin() + 1, tries.end());
  // The slower rules begin with a much smaller page, which pays for their time; they are not monotone and may
  // well succeed there.
  const auto depth = [&](const Try& how) {
    if (how.skyline || !best.any) return 1;
    return std::max(1, (side_of(family, best) - family.least) / (how.fit == Fit::contact ? 6 : 10));
  };
  std::vector<double> placed(tries.size());
  go_through(tries, family, best, depth, placed.data());
  if (finished()) return;
  std::vector<std::size_t> fullest(tries.size());
  std::iota(fullest.begin(), fullest.end(), std::size_t{0});
  std::ranges::stable_sort(fullest, std::greater(), [&](std::size_t i) { return placed[i]; });
  fullest.resize(std::min<std::size_t>(8, fullest.size()));
  std::vector<Try> again;
  for (const std::size_t i : fullest) again.push_back(tries[i]);
  // A smaller page can succeed where a larger one did not: greedy rules are not monotone.
  for (const int deeper : {2, 3})
    go_through(
        again, family, best, [deeper](const Try&) { return deeper; }, nullptr);
  // A square page of few rectangles is one search, which has time for every order and fit of MaxRects.
  if (!few() || family.width > 0) return;
  const std::vector<Try> all = every_max_rects();
  for (const int deeper : {4, 3, 2, 1})
    go_through(
        all, family, best, [deeper](const Try&) { return deeper; }, nullptr);
}

Outcome Search::fill(int width, int height, std::span<const int> members, std::size_t which,
                     std::vector<Spot>& spots) {
  const Try& how = portfolio_[which];
  const std::vector<int> offered = ordered(how.transposed ? turned_ : set_, members, how.key);
  const Outcome out = evaluate(how, offered, width, height, true, 0);
  budget_.charge(out.work);
  spots_of(how, 0, spots);
  return out;
}

bool Search::offer(std::size_t which) {
  const Try& how = portfolio_[which];
  if (!how.skyline) return false;
  offered_ = which;
  workers_[0]->skyline[how.transposed ? 1 : 0].offer(order(how), how.rule);
  return true;
}

Outcome Search::fill_next(int width, int height, std::vector<std::pair<int, Spot>>& placed) {
  const Try& how = portfolio_[offered_];
  Skyline& skyline = workers_[0]->skyline[how.transposed ? 1 : 0];
  if (how.transposed) std::swap(width, height);
  Outcome out = skyline.fill(width, height);
  if (how.transposed) std::swap(out.width, out.height);
  budget_.charge(out.work);
  placed.clear();
  for (const int i : skyline.placed()) {
    Spot spot = skyline.spots()[at(i)];
    if (how.transposed) std::swap(spot.x, spot.y);
    placed.emplace_back(i, spot);
  }
  return out;
}

}  // namespace etak::rects
