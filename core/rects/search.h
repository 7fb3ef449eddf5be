// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <unordered_map>
#include <utility>

#include "core/rects/limits.h"
#include "core/rects/portfolio.h"

namespace etak::rects {

/// Looks for the layout with the least side within a family. The result is that of steps taken one after the
/// other: threads only compute results before these are asked for.
class Search {
 public:
  Search(const Set& set, bool rotate, unsigned threads, Budget& budget);
  ~Search();

  /// Improves `best` (a layout of the family, or none) until it has the least side or the budget ends.
  /// Makes the tries of the portfolio, then those that filled most of their page again on still smaller pages.
  void run(const Family& family, Best& best) {
    std::vector<Best> none;
    run(family, best, {}, none);
  }

  /// Runs the search as above. `noted` becomes the layouts with which a search of each effort in `marks` would have ended;
  /// the efforts rise, and none is above that of the budget.
  void run(const Family& family, Best& best, std::span<const int> marks, std::vector<Best>& noted);

  /// Improves `best` by a few rules that build from below, in a page of the family's width without an upper
  /// end.
  void look(const Family& family, Best& best);

  /// Looks for pages that are smaller than `best`, or than the family's bound. Of the two rules that fill most of the next
  /// smaller page the order is changed, one rectangle at a time, and what fills no less is kept (a climb of hills, from one
  /// seed), within the budget.
  void climb(const Family& family, Best& best);

  /// Places as many of `members` as fit in one page, by entry `which` of the portfolio.
  Outcome fill(int width, int height, std::span<const int> members, std::size_t which,
               std::vector<Spot>& spots);
  std::size_t entries() const { return portfolio_.size(); }

  /// For pages that entry `which` fills one after the other with the whole set: offer() once, then
  /// fill_next() for every page. That gives what fill() with the remaining rectangles gives, but the time
  /// depends only on the rectangles that are placed.
  ///   placed   the rectangles of the page, by index into the set
  /// offer() returns false where the entry's rule cannot do that.
  bool offer(std::size_t which);
  Outcome fill_next(int width, int height, std::vector<std::pair<int, Spot>>& placed);

 private:
  struct Worker;
  struct Step;
  Outcome evaluate(const Try& how, std::span<const int> order, int width, int height, bool partial,
                   unsigned worker);
  void spots_of(const Try& how, unsigned worker, std::vector<Spot>& out) const;
  const std::vector<int>& order(const Try& how);
  static std::uint64_t print_in(std::uint64_t print, int width, int height);
  std::uint64_t print_of(const Try& how, std::span<const int> order) const;
  const Outcome* known(std::uint64_t print) const;
  void learn(std::uint64_t print, const Outcome& outcome);
  bool few() const { return set_.size() <= most_few; }
  int target(const Family& family, const Best& best, int depth) const;
  void start(const Family& family, Best& best);
  void descend(const Family& family, Best& best, const Try& how, std::span<const int> order,
               bool to_the_end = true);
  bool settle(const Family& family, Best& best, Step& step);
  void go(const Family& family, Best& best);
  void note(const Best& best);
  /// Entries of the portfolio, the first the one that fills most of a page.
  std::vector<std::size_t> fullest(const Family& family, int side);
  template <class Depth>
  void go_through(std::span<const Try> tries, const Family& family, Best& best, Depth depth_of,
                  double* placed);

  const Set& set_;
  Set turned_;  // width and height swapped
  bool rotate_;
  unsigned threads_;
  Budget& budget_;
  std::vector<Try> portfolio_;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::vector<int> all_;
  std::span<const int> marks_;
  std::vector<Best>* noted_ = nullptr;
  bool must_find_ = false;
  // The outcomes of tries that failed, by rule, order and page. No try is made twice, though it is charged
  // to the budget as often as it is asked for.
  std::unordered_map<std::uint64_t, Outcome> failed_;
  std::vector<int> orders_[key_count];
  std::size_t offered_ = 0;  // entry of offer()
};

}  // namespace etak::rects
