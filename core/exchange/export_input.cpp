// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/export_input.h"

#include "core/base/setting.h"
#include "core/material/names.h"
#include "core/material/quality.h"

namespace etak {

ExportAnswer export_answer(const MaterialInput& input, const TableOptions& tables, const F0Solver& solver,
                           const ExportWishes& wishes) {
  const Material material = read_material(input, tables);
  const Dataset& dataset = dataset_named(material, input.dataset, input.label());
  const F0Result result = solve_averaged(wishes.axis_average, solver, material, dataset);
  ExportAnswer out;
  out.dataset = dataset.id;
  if (result.refused()) {
    out.refusal = material.id + "/" + dataset.id + ": refused: " + result.refusal;
    return out;
  }
  if (std::holds_alternative<Stack>(dataset.optics)) {
    out.refusal = material.id + "/" + dataset.id + ": refused: a stack of layers, which no export holds yet";
    return out;
  }
  const LinearRgb diffuse = wishes.diffuse.value_or(LinearRgb{0, 0, 0});
  ExportSurface& surface =
      out.surface.emplace(export_surface(material, dataset, solver.options(), result, diffuse, wishes.gloss));
  surface.opacity = wishes.opacity;
  surface.emission = wishes.emission;
  if (wishes.axis_average && !dataset.axis.empty())
    surface.notes.push_back("F0 is the average over the axes of the crystal, " + dataset.id +
                            " and its others");
  validate(surface);
  if (!input.alias_note.empty()) surface.notes.push_back(input.alias_note);
  if (wishes.diffuse && surface.diffuse != diffuse)
    out.remark = material.id + " is no dielectric: " + setting("diffuse") + " is not used";
  return out;
}

}  // namespace etak
