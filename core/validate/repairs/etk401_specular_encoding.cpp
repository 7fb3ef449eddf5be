// SPDX-License-Identifier: Apache-2.0
#include "core/judge/pixels/code_tables.h"
#include "core/validate/repairs/rows.h"

namespace etak {

namespace {

// Puts every value of F0 through the curve of the set's encoding, or through its inverse.
template <double (*curve)(TextureTransfer, double)>
RepairOutcome recode_specular(const RepairBench& bench, const char* done) {
  RepairPicture* b = bench.with_role({FileRole::specular_gloss, FileRole::f0_only});
  if (b == nullptr) return {"", "the F0 of the set is in no file of its own"};
  b->put_through([&](double value) { return curve(bench.settings.transfer, value); });
  return {done};
}

RepairOutcome encode_specular(const RepairBench& bench) {
  return recode_specular<&encode_of>(bench, "encoded F0, which was stored linear");
}

RepairOutcome decode_specular(const RepairBench& bench) {
  return recode_specular<&decode_of>(bench, "undid the second encoding of F0");
}

}  // namespace

constinit const Repair repair_etk401{"ETK401", &encode_specular};
constinit const Repair repair_etk402{"ETK402", &decode_specular};

}  // namespace etak
