// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

void write_linear(const TargetJob& j) {
  j.add("F0", j.s.f0, plain_text);
  if (!j.black_body()) j.add("diffuse", j.s.diffuse, plain_text);
  j.note_no_transmission("colours alone do not say");
}

}  // namespace

constinit const TargetRow target_linear{{"linear", "linear sRGB, not clipped"}, write_linear};

}  // namespace etak
