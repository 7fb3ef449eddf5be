// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/rects/set.h"

namespace etak::rects {

/// How the best-fit skyline chooses among the rectangles in its window. Larger score wins, ties go to the
/// earlier in the order.
struct SkylineRule {
  int window = 64;    // how many of the next rectangles of the order are looked at
  int exact = 64;     // score of a width that fills the gap
  int flush = 128;    // of a top level with a neighbour
  int ceiling = 16;   // of a top that reaches the page's end
  int sliver = 40;    // taken off where the rest of the gap is narrower than all unplaced rectangles
  int late = 0;       // taken off for each 16 places further back in the order
  int left_over = 0;  // taken off for each 1/16 of the gap left over
  int side = 0;       // of the gap where it is not flush: 0 left, 1 at the higher neighbour, 2 at the lower
};

/// Best-fit skyline: fills the lowest gap again and again with the rectangle of the order that fits it best.
/// Based on
///   E. K. Burke, G. Kendall, G. Whitwell, A new placement heuristic for the orthogonal stock-cutting
///   problem, Operations Research 52(4), 2004 (the lowest gap chooses the rectangle);
///   S. C. H. Leung, D. Zhang, K. M. Sim, A two-stage intelligent search algorithm for the two-dimensional
///   strip packing problem, EJOR 215, 2011 (scores for exact widths and level tops).
class Skyline {
 public:
  Skyline(const Set& set, bool rotate);

  /// Packs the rectangles of `order` into width x height. With `partial` those that do not fit are left out;
  /// without `partial` it stops as soon as more area is lost than the page can spare.
  Outcome pack(int width, int height, std::span<const int> order, const SkylineRule& rule, bool partial);

  /// For many pages, of which each is filled with the rectangles that the pages before it left: offer() once,
  /// then fill() for every page. fill() does what pack() with `partial` does with the rest of the order,
  /// but its time depends only on the rectangles that it places.
  ///   order   is kept by reference
  void offer(std::span<const int> order, const SkylineRule& rule);
  Outcome fill(int width, int height);

  /// What the last pack() or fill() placed, by index into the set.
  const std::vector<int>& placed() const { return placed_; }
  /// Spots by index into the set; those of rectangles left out since the last pack() or offer() have x = -1.
  const std::vector<Spot>& spots() const { return spots_; }

 private:
  struct Choice {
    int item = -1;
    int width = 0, height = 0;
  };

  Outcome fill(int width, int height, std::int64_t spare);
  void refill();
  void drop(int slot);
  Choice choose(int gap, int room, int left, int right);
  Choice widest(int gap, int room);
  int not_wider(int gap) const;
  int last_below(int entry, int room) const;
  void make_tree();
  void forget(int entry);
  void raise(int segment, int to);
  void place(int segment, int gap, int left, int right, const Choice& choice);
  void join(int segment);

  const Set& set_;
  bool rotate_;
  struct Entry {
    int width, height, item;
  };
  std::vector<Entry> by_width_;  // rising width, then height; with rotation each rectangle twice
  std::vector<int> ends_;        // by width: how many entries are not wider; empty where that takes too much
  std::vector<int> heights_;     // items by rising least possible height
  // Over by_width_, the least height below each node, made when it is first needed: node i has the children
  // 2 i and 2 i + 1, the leaves begin at leaves_. Entries placed since then are taken out when they are
  // found.
  std::vector<int> tree_;
  int leaves_ = 0;             // 0: no tree
  std::vector<char> waiting_;  // of each item
  std::size_t waiting_count_ = 0;
  std::vector<Spot> spots_;
  std::vector<int> placed_;

  std::span<const int> order_;
  SkylineRule rule_;
  std::size_t next_ = 0;  // of order_: the first not yet in the window
  int slots_ = 0;
  std::vector<int> slot_width_, slot_height_, slot_item_;  // padded to whole lanes
  std::size_t narrowest_ = 0, lowest_ = 0;                 // first waiting of by_width_, of heights_
  int least_width_ = 0, least_height_ = 0;

  int segments_ = 0;
  std::vector<int> xs_, ys_;  // segment i covers xs_[i] .. xs_[i + 1] at height ys_[i]; padded
};

}  // namespace etak::rects
