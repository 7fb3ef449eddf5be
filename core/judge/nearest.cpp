// SPDX-License-Identifier: Apache-2.0
#include "core/judge/nearest.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "core/base/hash/content_hash.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/certainty/publications.h"
#include "core/color/delta_e.h"
#include "core/judge/pixels/code_tables.h"
#include "core/material/appearance.h"
#include "core/material/f0.h"
#include "core/material/json.h"
#include "core/material/quality.h"

namespace etak {

namespace {

std::string hash_of(const MaterialLibrary& library) {
  ContentHash hash;
  std::string text;
  for (std::size_t i = 0; i < library.ids().size(); ++i) text += format_material(library.at(i));
  hash.add(text);
  return hash.hex();
}

// F0 is computed as the textures mean it: in linear sRGB, without other options.
const F0Solver& usual_solver() {
  static const F0Solver solver{F0Options{}};
  return solver;
}

KnownF0 known_f0(const Material& material, const Dataset& dataset, const F0Result& f0) {
  return {material.id,
          material.name,
          dataset.id,
          &dataset == &material.datasets[material.preferred],
          optical_kind(material.material_class) == "conductor",
          material.common,
          material.material_class == "gem",
          optical_kind(material.material_class) != "dielectric",
          std::holds_alternative<Stack>(dataset.optics),
          {f0.srgb_linear.r, f0.srgb_linear.g, f0.srgb_linear.b},
          f0.f82,
          f0.luminance,
          {}};
}

std::vector<KnownF0> f0_in(const MaterialLibrary& library) {
  std::vector<KnownF0> known;
  for (std::size_t i = 0; i < library.ids().size(); ++i) {
    const Material material = library.at(i);
    if (!gives_f0(material.material_class)) continue;
    std::map<const Dataset*, F0Result> solved;
    const auto f0_of = [&](const Dataset& dataset) {
      auto found = solved.find(&dataset);
      if (found == solved.end()) found = solved.emplace(&dataset, usual_solver().solve(dataset.optics)).first;
      return found->second;
    };
    const std::vector<std::string> reasons = doubts(material, f0_of);
    for (std::size_t d = 0; d < material.datasets.size(); ++d) {
      // A doubtful dataset excuses no texture, unless it is the preferred one, because there is none better.
      if (!reasons[d].empty() && d != material.preferred) continue;
      const Dataset& dataset = material.datasets[d];
      const F0Result f0 = f0_of(dataset);
      if (f0.refused()) continue;
      KnownF0& entry = known.emplace_back(known_f0(material, dataset, f0));
      if (entry.common && entry.preferred) entry.band = material_band(f0_of, material, dataset, f0).band;
    }
  }
  return known;
}

// The code of a linear value with a fraction, so that distances do not jump where codes are rounded.
double code_with_fraction(double linear, TextureTransfer transfer) {
  const CodeTables& tables = code_tables(transfer);
  const double clamped = std::clamp(linear, 0.0, 1.0);
  const int low =
      std::min(254, static_cast<int>(std::upper_bound(tables.decoded.begin(), tables.decoded.end(), clamped) -
                                     tables.decoded.begin()) -
                        1);
  const auto i = static_cast<std::size_t>(std::max(0, low));
  return static_cast<double>(i) + (clamped - tables.decoded[i]) / (tables.decoded[i + 1] - tables.decoded[i]);
}

Lab clipped_lab(const std::array<double, 3>& linear) {
  const auto cut = [](double channel) { return std::clamp(channel, 0.0, 1.0); };
  return to_lab(LinearRgb{cut(linear[0]), cut(linear[1]), cut(linear[2])});
}

}  // namespace

KnownMaterials::KnownMaterials(MaterialLibrary library, std::string hash)
    : library_(std::move(library)), hash_(std::move(hash)) {}

KnownMaterials::KnownMaterials(MaterialLibrary library)
    : library_(std::move(library)), hash_(hash_of(library_)) {}

const KnownMaterials& KnownMaterials::builtin() {
  static const KnownMaterials known(MaterialLibrary::builtin(), "");
  return known;
}

std::span<const KnownF0> KnownMaterials::f0() const {
  computed_.call([this] { f0_ = f0_in(library_); });
  return f0_;
}

std::vector<const KnownF0*> KnownMaterials::f0_of(std::string_view material) const {
  std::vector<const KnownF0*> found;
  if (material.empty()) return found;
  const auto match = library_.find(material);
  if (!match) return found;
  for (const KnownF0& entry : f0())
    if (entry.id == match->id) found.push_back(&entry);
  return found;
}

std::optional<KnownF0> KnownMaterials::total_of(std::string_view material) const {
  const auto match = material.empty() ? std::nullopt : library_.find(material);
  if (!match || gives_f0(match->material_class)) return std::nullopt;
  const Dataset& dataset = match->datasets[match->preferred];
  const F0Result total = solve(usual_solver(), *match, dataset);
  if (total.refused()) return std::nullopt;
  const TotalReflectance parts = divided(total.srgb_linear);
  KnownF0 out = known_f0(*match, dataset, total);
  // Pictures and factors hold no body below 0.
  const auto seen = [](double surface, double body) { return surface + std::max(body, 0.0); };
  out.linear = {seen(parts.f0.r, parts.diffuse.r), seen(parts.f0.g, parts.diffuse.g),
                seen(parts.f0.b, parts.diffuse.b)};
  return out;
}

std::optional<NamedBand> named_band(const Material& material, std::span<const KnownF0> others,
                                    const std::array<double, 3>& linear, TextureTransfer transfer,
                                    double codes) {
  constexpr double step = 0.005;  // of 8 bits
  const F0Result stated = solve(usual_solver(), material, material.preferred_dataset());
  const auto band = material_band(usual_solver(), material, material.preferred_dataset(), stated).band;
  if (!band) return std::nullopt;
  const auto is_of_another = [&](const KnownF0& other) {
    return other.preferred && other.conductor && other.id != material.id &&
           code_distance(linear, other, transfer) <= codes;
  };
  return NamedBand{*band, lies_inside(*band, stated.srgb_linear, {linear[0], linear[1], linear[2]}, step) &&
                              std::ranges::none_of(others, is_of_another)};
}

std::optional<NamedBand> KnownMaterials::band_around(std::string_view material,
                                                     const std::array<double, 3>& linear,
                                                     TextureTransfer transfer, double codes) const {
  const auto match = material.empty() ? std::nullopt : library_.find(material);
  return match ? named_band(*match, f0(), linear, transfer, codes) : std::nullopt;
}

std::string dataset_in_zone(const NamedDataset& dataset) {
  std::vector<std::string> at;
  for (const auto& [id, luminance] : dataset.others) at.push_back(number(luminance, 2) + " (" + id + ")");
  return "this dataset (" + dataset.dataset + ") lies in the zone" +
         (at.empty() ? "" : "; " + dataset.material + "'s others at " + joined(at));
}

std::optional<NamedDataset> KnownMaterials::dataset_around(std::string_view material,
                                                           const std::array<double, 3>& linear,
                                                           TextureTransfer transfer, double codes) const {
  const auto match = material.empty() ? std::nullopt : library_.find(material);
  if (!match || !gives_f0(match->material_class)) return std::nullopt;
  NamedDataset out{match->id, {}, 0, {}};
  std::optional<std::size_t> nearest;
  for (const Dataset& each : match->datasets) {
    const F0Result f0 = solve(usual_solver(), *match, each);
    if (f0.refused() || !each.doubtful.empty()) continue;
    const bool trusted = !f0.flags.has(Flag::doubtful) || &each == &match->preferred_dataset() ||
                         (each.origin == Origin::measured && !each.citation.authors.empty());
    const double distance = code_distance(linear, known_f0(*match, each, f0), transfer);
    if (trusted && distance <= codes) {
      codes = distance;
      nearest = out.others.size();
    }
    out.others.emplace_back(each.id, f0.luminance);
  }
  if (!nearest) return std::nullopt;
  const auto own = out.others.begin() + static_cast<std::ptrdiff_t>(*nearest);
  std::tie(out.dataset, out.luminance) = *own;
  out.others.erase(own);
  return out;
}

std::string KnownMaterials::could_be(const std::array<double, 3>& linear, bool metals) const {
  constexpr double least_told = 0.1;
  constexpr std::size_t most_told = 3;
  AskedColour asked{{linear[0], linear[1], linear[2]}, {}, true};
  for (const double channel : linear)
    if (!(channel >= 0 && channel <= largest_asked)) return {};
  identifies_.call(
      [this] { identifier_.emplace(library_, F0Solver(without_f82()), std::vector<std::string>{}, 1); });
  const Identified answer = identifier_->identify(asked);
  if (answer.verdict == ColourVerdict::none) return {};
  std::vector<std::string> names;
  for (const PossibleMaterial& each : answer.candidates)
    if (each.p >= least_told && names.size() < most_told &&
        !(metals && optical_kind(each.entry->material_class) != "conductor"))
      names.push_back(each.entry->id + " (p " + fixed(each.p, 2) + ")");
  return names.empty() ? "" : "could be " + joined(names, " or ");
}

const KnownMaterials& known_materials(const Settings& settings) {
  return settings.known ? *settings.known : KnownMaterials::builtin();
}

double code_distance(const std::array<double, 3>& a, const std::array<double, 3>& b,
                     TextureTransfer transfer) {
  double distance = 0;
  for (std::size_t c = 0; c < 3; ++c)
    distance =
        std::max(distance, std::abs(code_with_fraction(a[c], transfer) - code_with_fraction(b[c], transfer)));
  return distance;
}

double code_distance(const std::array<double, 3>& linear, const KnownF0& entry, TextureTransfer transfer) {
  return code_distance(linear, entry.linear, transfer);
}

double delta_e_of(const std::array<double, 3>& linear, const KnownF0& entry) {
  return delta_e2000(clipped_lab(linear), clipped_lab(entry.linear));
}

bool in_half_band(const std::array<double, 3>& linear, const KnownF0& entry) {
  constexpr std::size_t least_publications = 3;
  return entry.band && entry.band->publications >= least_publications &&
         delta_e_of(linear, entry) <= entry.band->de50;
}

const KnownF0* nearest_f0(const KnownMaterials& known, const std::array<double, 3>& linear,
                          const std::function<bool(const KnownF0&)>& wanted) {
  const KnownF0* best = nullptr;
  double least = 0;
  for (const KnownF0& entry : known.f0()) {
    if (!wanted(entry)) continue;
    const double distance = delta_e_of(linear, entry);
    if (best != nullptr && distance >= least) continue;
    best = &entry;
    least = distance;
  }
  return best;
}

std::vector<NearestMaterial> nearest_materials(const KnownMaterials& known,
                                               const std::array<double, 3>& linear, TextureTransfer transfer,
                                               std::size_t count) {
  std::vector<NearestMaterial> all;
  for (const KnownF0& entry : known.f0()) {
    const double distance = std::round(10 * code_distance(linear, entry, transfer)) / 10;
    const double delta_e = std::round(10 * delta_e_of(linear, entry)) / 10;
    // The datasets of a material follow one another; only the nearest of them is kept.
    if (!all.empty() && all.back().id == entry.id) {
      if (distance < all.back().bytes) all.back() = {entry.id, entry.dataset, distance, delta_e};
    } else {
      all.push_back({entry.id, entry.dataset, distance, delta_e});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.bytes < b.bytes; });
  if (all.size() > count) all.resize(count);
  return all;
}

Explanation explain_f0(const KnownMaterials& known, const std::array<double, 3>& linear,
                       TextureTransfer transfer) {
  constexpr double most_distance = 4;  // codes
  Explanation best;
  double grey = 0, spread_least = 255, spread_most = 0;
  for (const double c : linear) {
    grey += c / 3;
    spread_least = std::min(spread_least, code_with_fraction(c, transfer));
    spread_most = std::max(spread_most, code_with_fraction(c, transfer));
  }
  if (spread_most - spread_least > most_distance) return best;
  const CodeTables& tables = code_tables(transfer);
  best.distance = most_distance;
  const double code = code_with_fraction(grey, transfer);
  for (const KnownF0& entry : known.f0()) {
    if (!entry.preferred || entry.conductor || entry.luminance < least_dielectric_f0 ||
        entry.luminance > most_dielectric_f0)
      continue;
    const double f0 = entry.luminance, once = code_with_fraction(f0, transfer);
    const double twice = code_with_fraction(once / 255, transfer), never = 255 * f0;
    const auto consider = [&](Explanation::Cause cause, double expected) {
      const double distance = std::abs(expected - code);
      // `as_is` is considered first and wins at equal distance: a right value needs no explanation.
      if (distance < best.distance) best = {cause, f0, distance, entry.id};
    };
    consider(Explanation::Cause::as_is, once);
    if (transfer == TextureTransfer::linear) continue;
    consider(Explanation::Cause::doubled, twice);
    consider(Explanation::Cause::missing, never);
  }
  if (best.cause == Explanation::Cause::doubled) best.original = tables.decode(255 * grey);
  if (best.cause == Explanation::Cause::missing) best.original = code / 255;
  return best;
}

}  // namespace etak
