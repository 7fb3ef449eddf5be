// SPDX-License-Identifier: Apache-2.0
#include "core/validate/pixels/code_tables.h"
#include "core/validate/repairs/rows.h"

namespace etak {

namespace {

RepairOutcome encode_specular(const RepairBench& bench) {
  RepairPicture* b = bench.with_role({FileRole::specular_gloss, FileRole::f0_only});
  if (b == nullptr) return {"", "the F0 of the set is in no file of its own"};
  b->put_through([&](double value) { return encode_of(bench.settings.transfer, value); });
  return {"encoded F0, which was stored linear"};
}

}  // namespace

constinit const Repair repair_etk401{"ETK401", &encode_specular};

}  // namespace etak
