// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <string_view>

#include "core/study/error_time.h"

namespace etak::test {

/// The table of that id; the test fails where there is none.
inline const ErrorTimeTable& table(const ErrorTimeFamily& family, std::string_view id) {
  const auto found = std::ranges::find(family.tables, id, &ErrorTimeTable::id);
  REQUIRE(found != family.tables.end());
  return *found;
}

/// The family with times of a single short repeat, and its picks as they are shown then. The test fails
/// where a case times no row, a table has no front, or a pick is beaten: by whatever such times say, for
/// which way is the faster one depends on the machine.
inline ErrorTimeFamily timed(ErrorTimeFamily family) {
  for (const TimedSet& set : family.timed)
    for (const std::string& id : set.tables)
      for (const TimedCase& each : set.cases) {
        INFO(id << ": " << each.id);
        const ErrorTimeTable& in = table(family, id);
        // Of models that differ in F alone one stands for the lobe.
        CHECK((id == "lobes" || std::ranges::count(in.rows, each.id, &ErrorTimeRow::id) == 1));
      }
  TimingOptions shortest;
  shortest.repeats = 1;
  shortest.seconds_a_case = 1e-5;
  time_families({&family, 1}, shortest);
  CHECK(family.timed.empty());
  for (const ErrorTimeTable& each : family.tables) {
    INFO(each.id);
    // The few repeats may leave open which is the unbeaten one.
    CHECK(std::ranges::any_of(each.rows, [](const ErrorTimeRow& row) {
      return row.verdict == Verdict::unbeaten || row.verdict == Verdict::not_settled;
    }));
  }
  for (const ErrorTimePick& pick : family.picks) {
    INFO(pick.whom);
    const auto& rows = table(family, pick.table).rows;
    const auto row = std::ranges::find(rows, pick.row, &ErrorTimeRow::id);
    REQUIRE(row != rows.end());
    CHECK(row->time);
  }
  settle_picks(family);
  for (const ErrorTimePick& pick : family.picks) {
    INFO(pick.whom);
    const auto& rows = table(family, pick.table).rows;
    CHECK(std::ranges::find(rows, pick.row, &ErrorTimeRow::id)->verdict != Verdict::beaten);
  }
  return family;
}

}  // namespace etak::test
