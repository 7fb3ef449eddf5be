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

constinit const TargetRow target_linear{{.id = "linear",
                                         .title = "linear sRGB, not clipped",
                                         .version = "IEC 61966-2-1:1999",
                                         .unstated = one_angle},
                                        write_linear};

}  // namespace etak
