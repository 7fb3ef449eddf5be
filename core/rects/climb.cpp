// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>

#include "core/base/random.h"
#include "core/rects/index.h"
#include "core/rects/search.h"

namespace etak::rects {
namespace {

// Takes one entry to another place of the order, at most a quarter of its length away.
void shift_one(std::vector<int>& order, SplitMix& numbers) {
  const int count = static_cast<int>(order.size()), reach = count / 4;
  const int from = static_cast<int>(numbers.uniform() * count);
  const int to =
      std::clamp(from - reach + static_cast<int>(numbers.uniform() * (2 * reach + 2)), 0, count - 1);
  const auto at = [&](int i) { return order.begin() + i; };
  if (from < to)
    std::rotate(at(from), at(from + 1), at(to + 1));
  else
    std::rotate(at(to), at(from), at(from + 1));
}

}  // namespace

std::vector<std::size_t> Search::fullest(const Family& family, int side) {
  std::vector<std::int64_t> placed;
  std::vector<std::size_t> out;
  for (const Try& how : portfolio_) {
    if (!budget_.open()) break;
    const Outcome outcome = evaluate(how, order(how), family.width_at(side), side, true, 0);
    budget_.charge(outcome.work);
    out.push_back(placed.size());
    placed.push_back(outcome.placed);
  }
  std::ranges::stable_sort(out, std::greater(), [&](std::size_t i) { return placed[i]; });
  return out;
}

void Search::climb(const Family& family, Best& best) {
  constexpr std::size_t ways = 2;
  constexpr int steps = 200;
  int side = target(family, best, 1);
  if (side < family.least || set_.items.empty()) return;
  SplitMix numbers(1);
  std::vector<std::size_t> which = fullest(family, side);
  which.resize(std::min(ways, which.size()));
  for (const std::size_t way : which) {
    const Try& how = portfolio_[way];
    std::vector<int> now = order(how);
    std::int64_t placed = -1;
    for (int step = 0; step < steps && side >= family.least && budget_.open(); ++step) {
      std::vector<int> next = now;
      if (step > 0) shift_one(next, numbers);
      const Outcome outcome = evaluate(how, next, family.width_at(side), side, true, 0);
      budget_.charge(outcome.work);
      if (!outcome.all && outcome.placed < placed) continue;
      placed = outcome.placed;
      now = std::move(next);
      if (!outcome.all) continue;
      best.any = true;
      best.width = outcome.width;
      best.height = outcome.height;
      spots_of(how, 0, best.spots);
      best.method = how.name() + ", shifted";
      side = target(family, best, 1);
      placed = -1;
    }
  }
}

}  // namespace etak::rects
