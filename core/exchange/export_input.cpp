// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/export_input.h"

#include <functional>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"
#include "core/certainty/publications.h"
#include "core/exchange/export_coat.h"
#include "core/material/names.h"
#include "core/material/quality.h"
#include "core/material/seen_stack.h"

namespace etak {
namespace {

std::string coat_note(const CoatedF0& coat) {
  const auto text = [](const LinearRgb& c) {
    return joined(vec(c), " ", [](double value) { return number(value, 4); });
  };
  return "under the coat " + coat.label + " F0 of the base is " + text(coat.under.linear) +
         ", and with it that of the whole " + text(coat.whole.linear);
}

}  // namespace

void validate(const ExportWishes& wishes, const F0Options& options) {
  if (!wishes.coat) return;
  const auto* outside = std::get_if<double>(&options.outside.index);
  if (outside == nullptr || *outside != 1)
    throw Error::at(setting("coat"), "beside " + setting("outside") + ": coats of targets are in air",
                    "one of them");
}

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
  if (std::holds_alternative<Stack>(dataset.optics))
    if (const std::string why = film_refusal(solver.options()); !why.empty()) {
      out.refusal = material.id + "/" + dataset.id + ": refused: " + why;
      return out;
    }
  const LinearRgb diffuse = wishes.diffuse.value_or(LinearRgb{0, 0, 0});
  ExportSurface& surface =
      out.surface.emplace(export_surface(material, dataset, solver.options(), result, diffuse, wishes.gloss));
  const bool averaged = wishes.axis_average && !dataset.axis.empty();
  if (const auto band = material_band(solver, material, dataset, result).band; band && !averaged)
    surface.band = words(*band);
  if (wishes.coat && surface.film) {
    out.surface.reset();
    out.refusal =
        material.id + "/" + dataset.id +
        ": refused: a coat over layers, which no target has; name it as a layer, such as 'pmma:2mm/...'";
    return out;
  }
  if (wishes.coat) {
    const std::string place = material.id + "/" + dataset.id;
    const std::string why =
        coated(*wishes.coat, solver.options(), dataset.optics, place, surface.coat.emplace());
    if (!why.empty()) {
      out.surface.reset();
      out.refusal = place + ": refused: " + why;
      return out;
    }
    surface.notes.push_back(coat_note(*surface.coat));
    if (surface.seen) {
      const SeenStack seen(coated_stack(*wishes.coat, dataset.optics), solver.options());
      surface.seen = film_truth(std::cref(seen));
    }
  }
  surface.opacity = wishes.opacity;
  surface.emission = wishes.emission;
  if (averaged) {
    surface.notes.push_back("F0 is the average over the axes of the crystal, " + dataset.id +
                            " and its others");
    surface.seen.reset();
    surface.unseen = "F0 is an average over axes";
  }
  validate(surface);
  if (!input.alias_note.empty()) surface.notes.push_back(input.alias_note);
  if (wishes.diffuse && surface.diffuse != diffuse)
    out.remark = material.id + " is no dielectric: " + setting("diffuse") + " is not used";
  return out;
}

}  // namespace etak
