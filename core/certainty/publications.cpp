// SPDX-License-Identifier: Apache-2.0
#include "core/certainty/publications.h"

#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"
#include "core/material/find.h"
#include "core/material/names.h"
#include "core/material/quality.h"

namespace etak {
namespace {

constexpr double coldest_kelvin = 283, hottest_kelvin = 308;

bool same_publication(const Citation& a, const Citation& b) {
  return a.authors == b.authors && a.year == b.year && (a.doi == b.doi || a.title == b.title);
}

std::string why_no_witness(const Material& material, const Dataset& dataset, const Dataset& stated) {
  if (dataset.origin == Origin::computed) return "computed";
  if (!dataset.doubtful.empty()) return dataset.doubtful;
  if (dataset.axis != stated.axis) return "another axis";
  if (dataset.temperature_kelvin &&
      (*dataset.temperature_kelvin < coldest_kelvin || *dataset.temperature_kelvin > hottest_kelvin))
    return number(*dataset.temperature_kelvin, 4) + " K";
  if (std::holds_alternative<Stack>(dataset.optics)) return "a stack";
  if (same_publication(dataset.citation, stated.citation)) return "the same publication as " + stated.id;
  for (const Dataset& before : material.datasets) {
    if (&before == &dataset) break;
    if (&before != &stated && same_publication(before.citation, dataset.citation) &&
        why_no_witness(material, before, stated).empty())
      return "the same publication as " + before.id;
  }
  return {};
}

}  // namespace

std::string why_no_band(const Material& material, const Dataset& dataset) {
  if (!gives_f0(material.material_class))
    return "a surface: things of one name differ more than measurements of one thing";
  if (std::holds_alternative<Stack>(dataset.optics)) return "a stack: its layers have their own";
  if (material.material_class == "gas") return "a gas";
  if (!dataset.doubtful.empty()) return "doubtful: " + dataset.doubtful;
  return {};
}

std::vector<Publication> publications_beside(const Material& material, const Dataset& stated) {
  std::vector<Publication> out;
  for (const Dataset& dataset : material.datasets)
    if (dataset.id != stated.id) out.push_back({&dataset, why_no_witness(material, dataset, stated)});
  return out;
}

std::size_t nearest_together(std::span<const LinearRgb> colors) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < colors.size(); ++i) {
    double sum = 0;
    for (const LinearRgb& each : colors) sum += offsets(colors[i], each)[offset_de];
    if (sum >= least) continue;
    least = sum;
    best = i;
  }
  return best;
}

std::optional<Material> without_publication(Material material, const Dataset& dataset) {
  const Citation left_out = dataset.citation;
  const std::string was = material.preferred_dataset().id;
  std::erase_if(material.datasets,
                [&](const Dataset& each) { return same_publication(each.citation, left_out); });
  if (material.datasets.empty()) return std::nullopt;
  material.preferred = 0;
  for (std::size_t i = 0; i < material.datasets.size(); ++i)
    if (material.datasets[i].id == was) {
      material.preferred = i;
      return material;
    }
  // The other publications are compared as witnesses of each other.
  const F0Solver solver{F0Options{}};
  std::vector<std::size_t> index;
  std::vector<LinearRgb> colors;
  for (std::size_t i = 0; i < material.datasets.size(); ++i) {
    const Dataset& each = material.datasets[i];
    const F0Result result = solver.solve(each.optics);
    if (each.origin == Origin::computed || !each.doubtful.empty() || result.refused()) continue;
    index.push_back(i);
    colors.push_back(result.srgb_linear);
  }
  if (!index.empty()) material.preferred = index[nearest_together(colors)];
  material.preferred_reason = "the one that is nearest to the others, without " + dataset.id;
  return material;
}

MaterialsWithout materials_without(const MaterialLibrary& library, const std::vector<std::string>& names) {
  MaterialsWithout out;
  for (const std::string& name : names) {
    const auto found = find_material(library, name);
    if (!found || found->dataset.empty())
      throw Error::at(setting("without"), printable(name) + " names no dataset",
                      "a material and its dataset: gold/mcpeak-2015");
    const std::string& id = found->answer.material.id;
    const Dataset& dataset = dataset_named(found->answer.material, found->dataset, setting("without"));
    const auto known = out.try_emplace(id, found->answer.material).first;
    if (known->second) known->second = without_publication(std::move(*known->second), dataset);
  }
  return out;
}

void leave_out(const MaterialsWithout& without, std::shared_ptr<const Material>& material) {
  const auto found = material ? without.find(material->id) : without.end();
  if (found == without.end()) return;
  if (!found->second)
    throw Error::at(setting("without"), "leaves no dataset of " + material->id, "one of several datasets");
  material = std::make_shared<const Material>(*found->second);
}

BandClass band_class(const Material& material, const F0Result& stated) {
  const std::string_view kind = optical_kind(material.material_class);
  if (kind == "semiconductor") return BandClass::semiconductor;
  return kind == "conductor" && stated.luminance >= forbidden_zone_first ? BandClass::metal
                                                                         : BandClass::clear;
}

MaterialBand material_band(const F0Solver& solver, const Material& material, const Dataset& dataset,
                           const F0Result& stated) {
  return material_band([&](const Dataset& each) { return solver.solve(each.optics); }, material, dataset,
                       stated);
}

MaterialBand material_band(const std::function<F0Result(const Dataset&)>& f0_of, const Material& material,
                           const Dataset& dataset, const F0Result& stated) {
  MaterialBand out;
  out.reason = stated.refused() ? "refused" : why_no_band(material, dataset);
  if (!out.reason.empty()) return out;
  const BandClass kind = band_class(material, stated);
  if (dataset.origin == Origin::computed) {
    out.band = computed_band(kind, stated.srgb_linear);
    return out;
  }
  out.publications = publications_beside(material, dataset);
  std::vector<LinearRgb> others;
  for (Publication& each : out.publications) {
    if (!each.left_out.empty()) continue;
    const F0Result result = f0_of(*each.dataset);
    if (result.refused())
      each.left_out = "refused: " + result.refusal;
    else
      others.push_back(result.srgb_linear);
  }
  out.band = band(kind, stated.srgb_linear, others);
  return out;
}

}  // namespace etak
