// SPDX-License-Identifier: Apache-2.0
#include "core/validate/pixels/code_tables.h"
#include "core/validate/repairs/rows.h"

namespace etak {

namespace {

RepairOutcome decode_specular(const RepairBench& bench) {
  RepairPicture* b = bench.with_role({FileRole::specular_gloss, FileRole::f0_only});
  if (b == nullptr) return {"", "the F0 of the set is in no file of its own"};
  b->put_through([&](double value) { return decode_of(bench.settings.transfer, value); });
  return {"undid the second encoding of F0"};
}

}  // namespace

constinit const Repair repair_etk402{"ETK402", &decode_specular};

}  // namespace etak
