// SPDX-License-Identifier: Apache-2.0
// The 5x5 median of 16 texels at once, by exchanges of bytes in vectors. Columns of five are sorted, then the
// rows of equal rank: columns stay sorted by that. In such a square the value at rank (i, j), counted from 0,
// has at least (i + 1)(j + 1) - 1 others that are not above it, so all with (i + 1)(j + 1) > 13 lie above the
// median or are equal to it, and as many lie below it or are equal to it. That leaves 13 values, whose median
// is found by throwing away the least and the greatest in turn.
#include <cstring>

#include "core/judge/pixels/regions.h"

namespace etak {

namespace {

using Bytes = std::uint8_t __attribute__((vector_size(16)));

inline void order(Bytes& low, Bytes& high) {
  const Bytes a = low, b = high;
  low = a < b ? a : b;
  high = a < b ? b : a;
}

inline void sort5(Bytes& a, Bytes& b, Bytes& c, Bytes& d, Bytes& e) {
  order(a, b);
  order(d, e);
  order(c, e);
  order(c, d);
  order(a, d);
  order(a, c);
  order(b, e);
  order(b, d);
  order(b, c);
}

// Moves the least of v[first..last] to v[first], and the greatest to v[last].
template <int first, int last>
inline void extremes(Bytes* v) {
  for (int i = first + 1; i <= last; ++i) order(v[first], v[i]);
  for (int i = first + 1; i < last; ++i) order(v[i], v[last]);
}

}  // namespace

void median_5x5(const std::uint8_t* const rows[5], std::uint8_t out[16]) {
  Bytes s[5][5];  // [rank in the column][column]
  for (int column = 0; column < 5; ++column) {
    for (int row = 0; row < 5; ++row) std::memcpy(&s[row][column], rows[row] + column, 16);
    sort5(s[0][column], s[1][column], s[2][column], s[3][column], s[4][column]);
  }
  for (auto& rank : s) sort5(rank[0], rank[1], rank[2], rank[3], rank[4]);
  Bytes v[13];
  int count = 0;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      if ((i + 1) * (j + 1) <= 13 && (5 - i) * (5 - j) <= 13) v[count++] = s[i][j];
  // The least and the greatest of 8 of the 13 values cannot be the median (the 7th) of all. One more value
  // takes the place of the greatest, and the same holds for those that are left.
  extremes<0, 7>(v);
  v[7] = v[8];
  extremes<1, 7>(v);
  v[7] = v[9];
  extremes<2, 7>(v);
  v[7] = v[10];
  extremes<3, 7>(v);
  v[7] = v[11];
  extremes<4, 7>(v);
  v[7] = v[12];
  extremes<5, 7>(v);
  std::memcpy(out, &v[6], 16);
}

}  // namespace etak
