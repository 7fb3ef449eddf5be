// SPDX-License-Identifier: Apache-2.0
#include "core/material/catalogue.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/setting.h"
#include "core/base/text/ascii.h"
#include "core/base/text/edit_distance.h"
#include "core/base/text/text.h"
#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/material/names.h"
#include "core/material/quality.h"

namespace etak {
namespace {

bool is_one_of(const std::string& material_class, std::span<const std::string> classes) {
  return std::find(classes.begin(), classes.end(), material_class) != classes.end();
}

}  // namespace

std::vector<CatalogueEntry> catalogue(const MaterialLibrary& library, const F0Solver& solver,
                                      unsigned threads, bool axis_average) {
  std::vector<CatalogueEntry> out(library.ids().size());
  parallel_chunks(out.size(), threads, 8, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      out[i].material = library.at(i);
      const Dataset& dataset = out[i].material.preferred_dataset();
      out[i].result = solve_averaged(axis_average, solver, out[i].material, dataset);
    }
  });
  return out;
}

void check_classes(std::span<const std::string> classes) {
  for (const std::string& each : classes)
    if (std::find(material_classes.begin(), material_classes.end(), each) == material_classes.end())
      throw Error::at(
          setting("class"), printable(each),
          joined(material_classes) + did_you_mean(each, {material_classes.begin(), material_classes.end()}));
}

std::string quality_text(const CatalogueEntry& entry) {
  return quality_text(entry.material.preferred_dataset().origin, entry.result.flags);
}

bool fits(const CatalogueEntry& entry, const CatalogueFilter& filter) {
  const Material& material = entry.material;
  if (!filter.classes.empty() && !is_one_of(material.material_class, filter.classes)) return false;
  if (filter.zone && entry.result.zone != filter.zone) return false;
  const auto holds = [part = lower_case(filter.search)](std::string_view text) {
    return lower_case(text).find(part) != std::string::npos;
  };
  return holds(material.id) || holds(material.name) || holds(material.group) ||
         std::any_of(material.aliases.begin(), material.aliases.end(), holds);
}

Srgb8 codes_of(const std::array<double, 3>& values, std::string_view place) {
  std::array<std::uint8_t, 3> codes{};
  for (std::size_t i = 0; i < 3; ++i) {
    codes[i] = static_cast<std::uint8_t>(values[i] >= 0 && values[i] <= 255 ? values[i] : 0);
    if (codes[i] != values[i])
      throw Error::at(place, number(values[i], 6) + " is no 8-bit code",
                      "whole numbers 0 to 255, or " + setting("linear"));
  }
  return {codes[0], codes[1], codes[2]};
}

std::vector<NearMaterial> nearest_materials(std::span<const CatalogueEntry> entries,
                                            const std::variant<LinearRgb, Srgb8>& color,
                                            std::span<const std::string> classes, std::size_t count) {
  const auto* const linear = std::get_if<LinearRgb>(&color);
  const Lab wanted = to_lab(linear ? *linear : srgb_decode(std::get<Srgb8>(color)));
  std::vector<NearMaterial> out;
  for (const CatalogueEntry& entry : entries) {
    const std::string& its_class = entry.material.material_class;
    if (entry.result.refused() || !(classes.empty() ? gives_f0(its_class) : is_one_of(its_class, classes)))
      continue;
    const LinearRgb f0 = linear ? entry.result.srgb_linear : srgb_decode(entry.result.srgb8);
    out.push_back({&entry, delta_e2000(wanted, to_lab(f0))});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const NearMaterial& a, const NearMaterial& b) { return a.delta_e < b.delta_e; });
  out.resize(std::min(out.size(), count));
  return out;
}

NameAnswer answer_name(const MaterialLibrary& library, const F0Solver& solver, const std::string& name) {
  NameAnswer out;
  out.asked = name;
  if (auto answer = library.answer(name)) {
    out.material = std::move(answer->material);
    out.by = answer->by;
    out.note = std::move(answer->note);
    const Dataset& dataset = out.material->preferred_dataset();
    out.refusal = solver.solve(dataset.optics, dataset.flags).refusal;
    return out;
  }
  if (const Unmeasured* thing = library.unmeasured(name)) {
    out.unmeasured = true;
    out.note = thing->why;
    out.near = joined(thing->nearest);
    return out;
  }
  out.near = joined(library.suggest(name), ", ", &Suggestion::text);
  return out;
}

}  // namespace etak
