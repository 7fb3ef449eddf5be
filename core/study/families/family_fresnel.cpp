// SPDX-License-Identifier: Apache-2.0
// Family b: forms of Fresnel reflectance against the spectral truth.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <variant>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/material/f0.h"
#include "core/material/library.h"
#include "core/material/quality.h"
#include "core/study/families/families.h"
#include "core/study/fresnel_forms.h"
#include "core/study/measure.h"

namespace etak {
namespace {

struct Group {
  const char* id;
  const char* title;                 // which names the classes
  const char* base;                  // the material whose numbers are timed
  std::vector<const char*> classes;  // all materials of these classes that have n and k over the visible
};

const std::vector<Group>& groups() {
  static const std::vector<Group> all{{"metals", "All metals", "silver", {"metal"}},
                                      {"semiconductors", "All semiconductors", "silicon", {"semiconductor"}},
                                      {"dielectrics",
                                       "All glasses, salts, gems, liquids and plastics",
                                       "diamond",
                                       {"glass", "salt", "gem", "liquid", "plastic"}},
                                      {"organics", "All organic materials", "cellulose", {"organic"}}};
  return all;
}

struct Subject {
  std::string id;
  bool doubtful;  // its data are named so, or computed: they are shown apart
  FresnelTruth truth;
};

// The materials of a group by their preferred datasets, the timed one first.
std::vector<Subject> subjects_of(const MaterialLibrary& library, const Group& group) {
  std::vector<Subject> out;
  for (std::size_t i = 0; i < library.ids().size(); ++i) {
    const Material material = library.at(i);
    if (std::find(group.classes.begin(), group.classes.end(), material.material_class) == group.classes.end())
      continue;
    const Dataset& dataset = material.preferred_dataset();
    const auto* optics = std::get_if<OpticalConstants>(&dataset.optics);
    if (optics == nullptr || F0Solver({}).solve(dataset.optics).refused()) continue;
    const Flags quality = quality_flags(material, dataset);
    out.push_back({material.id, quality.has(Flag::doubtful) || quality.has(Flag::computed),
                   fresnel_truth(*optics, material.id)});
  }
  const auto timed =
      std::find_if(out.begin(), out.end(), [&](const Subject& each) { return each.id == group.base; });
  if (timed == out.end()) throw Error::at(group.base, "is not in the library");
  std::rotate(out.begin(), timed, timed + 1);
  return out;
}

std::vector<TimedCase> timed_forms(const FresnelTruth& truth) {
  std::vector<TimedCase> cases;
  const auto cosines = random_floats(4096, 0, 1);
  for (const FresnelForm& form : fresnel_forms()) {
    // A form that rises above 1 without bound is not to be chosen: it stands in the table and, without a
    // time, not in the plot.
    if (!form.physical) continue;
    const auto values = form.fit(truth);
    const auto p = single_values(values[0]);
    cases.push_back({std::string(form.id), cosines->size(),
                     [&form, p, cosines, out = std::make_shared<std::vector<float>>(cosines->size())] {
                       form.many(p.data(), cosines->data(), out->data(), cosines->size());
                       keep(out->data());
                     }});
  }
  return cases;
}

// The value that `share` of the values do not exceed, on a straight line between two of them.
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  return std::lerp(values[below], values[std::min(below + 1, values.size() - 1)],
                   at - static_cast<double>(below));
}

// The errors of a form over the materials whose data are sound, and a point for each material.
ErrorTimeRow row_of(const FresnelForm& form, std::span<const Subject> subjects) {
  ErrorTimeRow row;
  row.id = form.id;
  row.title = form.title;
  std::vector<double> largest;
  double mean = 0, max_de = 0, mean_de = 0, worst = 0, doubtful = 0;
  for (const Subject& subject : subjects) {
    const FresnelError error = fresnel_error(subject.truth, form, form.fit(subject.truth));
    row.points.push_back({subject.id, error.max_abs, subject.doubtful});
    if (subject.doubtful) {
      doubtful = std::max(doubtful, error.max_abs);
      continue;
    }
    largest.push_back(error.max_abs);
    if (error.max_abs > worst) {
      worst = error.max_abs;
      row.note = "worst: " + subject.id + " at " + number(error.at_deg, 3) + "°";
    }
    mean += error.mean_abs;
    max_de = std::max(max_de, error.max_de);
    mean_de += error.mean_de;
  }
  const auto sound = static_cast<double>(largest.size());
  row.errors = {quantile(largest, 0.9), quantile(largest, 0.5), worst, mean / sound, max_de, mean_de / sound};
  if (std::any_of(subjects.begin(), subjects.end(), [](const Subject& each) { return each.doubtful; }))
    row.errors.push_back(doubtful);
  return row;
}

ErrorTimeTable table_of(const Group& group, std::span<const Subject> subjects,
                        std::vector<TimedSet>& timings) {
  ErrorTimeTable table;
  table.id = group.id;
  const auto doubtful = static_cast<std::size_t>(
      std::count_if(subjects.begin(), subjects.end(), [](const Subject& each) { return each.doubtful; }));
  table.title = std::string(group.title) + " with n and k, " + std::to_string(subjects.size() - doubtful) +
                " materials";
  if (doubtful > 0)
    table.title += " (and " + std::to_string(doubtful) + " of doubtful or computed data, apart)";
  table.metrics = {{"p90_abs", "error of F that 9 of 10 materials stay within", ""},
                   {"p50_abs", "the same, half of the materials", ""},
                   {"max_abs", "largest error of F", ""},
                   {"mean_abs", "mean over a sphere, worst channel", ""},
                   {"max_de", "largest colour difference", "ΔE2000"},
                   {"mean_de", "mean colour difference", "ΔE2000"}};
  if (doubtful > 0) table.metrics.push_back({"doubtful_max_abs", "largest error of F, doubtful data", ""});
  table.base = "schlick";
  for (const FresnelForm& form : fresnel_forms()) table.rows.push_back(row_of(form, subjects));
  timings.push_back({{table.id}, timed_forms(subjects.front().truth)});
  return table;
}

}  // namespace

ErrorTimeFamily fresnel_family(const ReportOptions&) {
  const auto library = MaterialLibrary::builtin();
  ErrorTimeFamily family;
  family.id = "fresnel";
  family.letter = "b";
  family.title = "Fresnel reflectance";
  family.reference = "F at every nanometre and angle, seen under D65, linear sRGB";
  family.grid =
      "0 to 90 degrees in steps of 0.25; preferred datasets of the library; means weighted by 2 cos";
  for (const Group& group : groups())
    family.tables.push_back(table_of(group, subjects_of(library, group), family.timed));
  enum { metals, semiconductors, dielectrics, organics };
  const auto row = [&](std::size_t table, std::string_view id) -> const ErrorTimeRow& {
    const auto& rows = family.tables[table].rows;
    return *std::find_if(rows.begin(), rows.end(), [&](const ErrorTimeRow& each) { return each.id == id; });
  };
  const auto error = [&](std::size_t table, std::string_view id, std::size_t metric) {
    return number(row(table, id).errors[metric], 2);
  };
  constexpr std::size_t largest = 2, worst = 4, mean = 5;
  family.advice =
      "Draw glasses, salts, gems, liquids and plastics with the exact form from F0 (off by at most " +
      error(dielectrics, "from_f0", largest) + ", ΔE2000 " + error(dielectrics, "from_f0", worst) +
      "; Schlick by " + error(dielectrics, "schlick", largest) + ", ΔE2000 " +
      error(dielectrics, "schlick", worst) +
      "), but not organic materials that absorb much, whose F0 does not tell their k (off by " +
      error(organics, "from_f0", largest) + "; " + row(organics, "from_f0").note +
      "), metals with F82 (ΔE2000 " + error(metals, "f82", mean) + " on the mean, Schlick " +
      error(metals, "schlick", mean) +
      ") and semiconductors and chromium with n and k from F0 and F82 (at most " +
      error(semiconductors, "index", worst) + ", F82 " + error(semiconductors, "f82", worst) +
      "), and never take n and k at three wavelengths on coloured metals (" +
      error(metals, "three_wavelengths", worst) + ").";
  family.picks = {
      {"metals", "metals", "f82", "two colours to store, hardly dearer than Schlick", "etak choose gold"},
      {"semiconductors", "semiconductors", "index", "dips that F82 has not", "etak choose silicon"},
      {"glass, water, plastics", "dielectrics", "from_f0", "exact, and F0 is all it needs",
       "etak choose glass_bk7"}};
  family.notes = {
      "The datasets are the library's own choice (tungsten and zinc, for one, not from electron-loss spectra); with Johnson and Christy for the noble and transition metals, Rakić for aluminum and Werner for tungsten and zinc "
      "Schlick's largest error is 0.2005 (chromium), F82's 0.0251.",
      "Each form gets what a renderer would: F0, F82 or n and k integrated over the spectrum, fits per channel by least squares, every angle alike. Where F0 is above 1 (gold's red in sRGB) there are no n and k: "
      "forms that need them, Lazányi's among them, miss what is above 1.",
      "The order of the times depends on the compiler's flags: the square root of the exact forms is as cheap as a few multiplications only where it is vectorised."};
  return family;
}

}  // namespace etak
