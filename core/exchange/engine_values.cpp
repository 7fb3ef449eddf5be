// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/engine_values.h"

#include "core/base/error.h"
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

constexpr const TargetRow* rows[] = {
#define ETAK_TARGET(name) &target_##name,
#include "core/exchange/targets/targets.inc"
#undef ETAK_TARGET
};

}  // namespace

std::span<const EngineTarget> engine_targets() {
  static const std::vector<EngineTarget> targets = [] {
    std::vector<EngineTarget> out;
    for (const TargetRow* row : rows) out.push_back(row->target);
    return out;
  }();
  return targets;
}

const EngineTarget* engine_target(std::string_view id) {
  for (const EngineTarget& target : engine_targets())
    if (target.id == id) return &target;
  return nullptr;
}

EngineValues engine_values(const EngineTarget& target, const ExportSurface& surface, Fit fit) {
  validate(surface);
  if (surface.space != RgbSpace::srgb)
    throw Error::at(surface.id, "colours in " + std::string(name(surface.space)), "linear sRGB");
  EngineValues out;
  out.target = target.id;
  const TargetJob job{surface, fit, out};
  for (const TargetRow* row : rows)
    if (row->target.id == target.id) row->write(job);
  return out;
}

std::string copy_text(const EngineValues& values) {
  if (values.fields.size() == 1) return values.fields.front().text;
  std::string out;
  for (const EngineField& field : values.fields) {
    if (values.target == "glsl")
      out += std::string("const ") + (field.values.size() == 3 ? "vec3 " : "float ") + field.name + " = " +
             field.text + ";\n";
    else
      out += field.name + ": " + field.text + '\n';
  }
  return out;
}

}  // namespace etak
