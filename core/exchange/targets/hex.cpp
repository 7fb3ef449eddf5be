// SPDX-License-Identifier: Apache-2.0
#include "core/color/srgb.h"
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

void write_hex(const TargetJob& j) {
  const auto color = [&](const char* field, const LinearRgb& wanted) {
    const LinearRgb c = fitted(wanted, {j.fit, 1, j.s.space}, field, "8 bits end at 1", j.out.changes);
    const Srgb8 codes = srgb_u8(c);
    j.add(field, {double(codes.r), double(codes.g), double(codes.b)}, hex(codes));
  };
  color("F0", j.s.f0);
  if (!j.black_body()) color("diffuse", j.s.diffuse);
  j.note_no_transmission("colours alone do not say");
}

void write_srgb8(const TargetJob& j) {
  write_hex(j);
  for (EngineField& field : j.out.fields)
    field.text =
        number(field.values[0], 3) + ", " + number(field.values[1], 3) + ", " + number(field.values[2], 3);
}

}  // namespace

constinit const TargetRow target_hex{
    {.id = "hex", .title = "hex, sRGB", .version = "IEC 61966-2-1:1999", .unstated = one_angle}, write_hex};
constinit const TargetRow target_srgb8{
    {.id = "srgb8", .title = "8-bit sRGB", .version = "IEC 61966-2-1:1999", .unstated = one_angle},
    write_srgb8};

}  // namespace etak
