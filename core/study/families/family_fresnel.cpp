// SPDX-License-Identifier: Apache-2.0
// Family b: forms of Fresnel reflectance against the spectral truth.
#include <algorithm>
#include <memory>
#include <string>
#include <variant>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/material/library.h"
#include "core/study/families/families.h"
#include "core/study/fresnel_forms.h"
#include "core/study/measure.h"

namespace etak {
namespace {

struct Group {
  const char* id;
  const char* title;
  std::vector<const char*> materials;  // "id" or "id/dataset" of the library
};

const std::vector<Group>& groups() {
  static const std::vector<Group> all{
      {"metals",
       "Metals",
       {"silver", "gold", "copper", "aluminum", "iron", "titanium", "chromium", "nickel", "palladium",
        "tungsten", "zinc"}},
      {"semiconductors", "Semiconductors", {"silicon", "germanium", "gallium_arsenide"}},
      {"dielectrics", "Dielectrics", {"diamond", "fused_silica", "water", "polystyrene"}}};
  return all;
}

FresnelTruth truth_of(const MaterialLibrary& library, const std::string& id) {
  const auto material = library.find(id);
  if (!material) throw Error::at(id, "is not in the library");
  const auto* optics = std::get_if<OpticalConstants>(&material->preferred_dataset().optics);
  if (optics == nullptr) throw Error::at(id, "has no n and k");
  return fresnel_truth(*optics, id);
}

std::vector<RunTime> times_of(const FresnelTruth& truth, const ReportOptions& options) {
  std::vector<TimedCase> cases;
  const auto cosines = random_floats(4096, 0, 1);
  for (const FresnelForm& form : fresnel_forms()) {
    const auto values = form.fit(truth);
    std::array<float, 4> p{};
    for (std::size_t i = 0; i < 4; ++i) p[i] = static_cast<float>(values[0][i]);
    cases.push_back({std::string(form.id), cosines->size(),
                     [&form, p, cosines, out = std::make_shared<std::vector<float>>(cosines->size())] {
                       form.many(p.data(), cosines->data(), out->data(), cosines->size());
                       keep(out->data());
                     }});
  }
  return time_cases(cases, options.timing);
}

ErrorTimeTable table_of(const MaterialLibrary& library, const Group& group, const ReportOptions& options) {
  ErrorTimeTable table;
  table.id = group.id;
  table.title = group.title;
  table.metrics = {{"max_abs", "largest error of F", ""},
                   {"mean_abs", "mean over a sphere, worst channel", ""},
                   {"max_de", "largest colour difference", "ΔE2000"},
                   {"mean_de", "mean colour difference", "ΔE2000"}};
  table.base = "schlick";
  std::vector<FresnelTruth> truths;
  for (const char* id : group.materials) truths.push_back(truth_of(library, id));
  const auto times = times_of(truths[0], options);
  for (std::size_t f = 0; f < fresnel_forms().size(); ++f) {
    const FresnelForm& form = fresnel_forms()[f];
    ErrorTimeRow row;
    row.id = form.id;
    row.title = form.title;
    row.errors = {0, 0, 0, 0};
    for (std::size_t m = 0; m < truths.size(); ++m) {
      const FresnelError error = fresnel_error(truths[m], form, form.fit(truths[m]));
      if (error.max_abs > row.errors[0])
        row.note = "worst: " + std::string(group.materials[m]) + " at " + number(error.at_deg, 3) + "°";
      row.errors[0] = std::max(row.errors[0], error.max_abs);
      row.errors[1] += error.mean_abs / static_cast<double>(truths.size());
      row.errors[2] = std::max(row.errors[2], error.max_de);
      row.errors[3] += error.mean_de / static_cast<double>(truths.size());
    }
    // A form that rises above 1 without bound is not to be chosen: it stands in the table and, without a
    // time, not in the plot.
    if (form.physical) row.time = times[f];
    table.rows.push_back(row);
  }
  mark_dominated(table);
  return table;
}

}  // namespace

ErrorTimeFamily fresnel_family(const ReportOptions& options) {
  const auto library = MaterialLibrary::builtin();
  ErrorTimeFamily family;
  family.id = "fresnel";
  family.letter = "b";
  family.title = "Fresnel reflectance";
  family.reference = "F at every nanometre and angle, seen under D65, linear sRGB";
  family.grid =
      "0 to 90 degrees in steps of 0.25; preferred datasets of the library; means weighted by 2 cos";
  for (const Group& group : groups()) family.tables.push_back(table_of(library, group, options));
  enum { metals, semiconductors, dielectrics };
  const auto error = [&](std::size_t table, std::string_view id, std::size_t metric) {
    const auto& rows = family.tables[table].rows;
    return number(
        std::find_if(rows.begin(), rows.end(), [&](const ErrorTimeRow& row) { return row.id == id; })
            ->errors[metric],
        2);
  };
  constexpr std::size_t worst = 2, mean = 3;
  family.advice =
      "Draw dielectrics with the exact form from F0, which nothing can tell from the truth (Schlick misses "
      "by up "
      "to ΔE2000 " +
      error(dielectrics, "schlick", worst) + "), metals with F82 (ΔE2000 " + error(metals, "f82", mean) +
      " on the mean, Schlick " + error(metals, "schlick", mean) +
      ") and semiconductors and chromium with n and k from F0 and F82 (at most " +
      error(semiconductors, "index", worst) + ", F82 " + error(semiconductors, "f82", worst) +
      "), and never take n and k at three wavelengths on coloured metals (" +
      error(metals, "three_wavelengths", worst) + ").";
  family.notes = {
      "The datasets are the library's own choice (tungsten and zinc, for one, not from electron-loss "
      "spectra); with "
      "Johnson and Christy for the noble and transition metals, Rakić for aluminum and Werner for tungsten "
      "and zinc "
      "Schlick's largest error is 0.2005 (chromium), F82's 0.0251.",
      "Each form gets what a renderer would: F0, F82 or n and k integrated over the spectrum, fits per "
      "channel by least squares, every angle alike. Where F0 is above 1 (gold's red in sRGB) there are no n "
      "and k: "
      "forms that need them, Lazányi's among them, miss what is above 1.",
      "The order of the times depends on the compiler's flags: the square root of the exact forms is as "
      "cheap "
      "as a few multiplications only where it is vectorised."};
  return family;
}

}  // namespace etak
