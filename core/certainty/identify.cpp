// SPDX-License-Identifier: Apache-2.0
#include "core/certainty/identify.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/text/csv.h"
#include "core/base/text/text.h"
#include "core/certainty/publications.h"
#include "core/color/delta_e.h"
#include "core/math/functions.h"

namespace etak {
namespace {

constexpr double radius_per_scale = 6;
// CIEDE2000 that two colours differ by though nobody would tell them apart: of the arithmetic, and of a step of 8 bits in
// dark colours.
constexpr double least_scale = 0.05, eight_bit_scale = 0.3;
constexpr double listed_probability = 0.9;
constexpr std::size_t least_listed = 3;

// None of a material without a band.
std::optional<Hypothesis> hypothesis(const Material& material, const F0Solver& solver) {
  const Dataset& stated = material.preferred_dataset();
  if (!why_no_band(material, stated).empty()) return std::nullopt;
  const F0Result f0 = solver.solve(stated.optics);
  const MaterialBand found = material_band(solver, material, stated, f0);
  if (!found.band) return std::nullopt;
  return Hypothesis{material.id, material.name, material.material_class, f0.srgb_linear, f0.srgb8,
                    f0.f82,      *found.band};
}

double square(double x) {
  return x * x;
}

double distance(const LinearRgb& a, const LinearRgb& b) {
  return delta_e2000(to_lab(a), to_lab(b));
}

// Logarithm of the density of a bivariate Cauchy distribution (of twice as many dimensions where F82 is a second witness),
// without its constant.
double log_density(double squares, double scale, int colours) {
  const double dimensions = 2.0 * colours;
  return -dimensions * math::log(scale) - (dimensions + 1) / 2 * math::log1p(squares / square(scale));
}

}  // namespace

std::string_view name(ColourVerdict verdict) {
  constexpr std::array<std::string_view, 3> names{"sure", "ambiguous", "none"};
  return names[static_cast<std::size_t>(verdict)];
}

void check_asked(const AskedColour& asked, std::string_view place) {
  for (const auto& colour : {std::optional(asked.f0), asked.f82}) {
    if (!colour) continue;
    for (const double channel : vec(*colour))
      if (!(channel >= 0 && channel <= largest_asked))
        throw Error::at(place, "a linear channel of " + number(channel, 6), "0 to 1.1");
  }
}

Prior parse_prior(std::string_view text, std::string_view file, const MaterialLibrary& library) {
  Prior out;
  const std::vector<CsvRow> rows = csv_rows(text, file);
  const auto place = [&](const CsvRow& row) { return std::string(file) + ":" + std::to_string(row.line); };
  if (rows.empty() || rows.front().fields != std::vector<std::string>{"id", "weight"})
    throw Error::at(rows.empty() ? std::string(file) : place(rows.front()), "no header",
                    "a CSV with the columns id,weight");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const CsvRow& row = rows[i];
    if (row.fields.size() != 2)
      throw Error::at(place(row), std::to_string(row.fields.size()) + " fields", "id,weight");
    const auto found = library.look_up(row.fields[0]);
    if (!found)
      throw Error::at(place(row), printable(row.fields[0]) + " is no material",
                      library.missing(row.fields[0]).expected);
    double weight = 0;
    if (!parse_number(row.fields[1], weight) || !(weight >= 0))
      throw Error::at(place(row), "weight " + printable(row.fields[1]), "a number of at least 0");
    out[library.ids()[found->index]] = weight;
  }
  if (out.empty()) throw Error::at(file, "names no material", "rows of id,weight");
  return out;
}

std::vector<std::vector<std::size_t>> not_told_apart(std::span<const BandOfF0> all) {
  const auto alike = [&](const BandOfF0& a, const BandOfF0& b) {
    return a.band && b.band && distance(a.stated, b.stated) <= std::min(a.band->de50, b.band->de50);
  };
  std::vector<std::vector<std::size_t>> out;
  std::vector<bool> grouped(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (grouped[i]) continue;
    std::vector<std::size_t> group{i};
    for (std::size_t j = i + 1; j < all.size(); ++j)
      if (!grouped[j] && alike(all[i], all[j])) group.push_back(j);
    if (group.size() < 2) continue;
    for (const std::size_t each : group) grouped[each] = true;
    out.push_back(std::move(group));
  }
  return out;
}

std::vector<BandOfF0> bands_of(std::span<const NearMaterial> found, const F0Solver& solver,
                               bool axis_average) {
  std::vector<BandOfF0> out;
  for (const NearMaterial& each : found) {
    const auto& [material, result] = *each.entry;
    const Dataset& stated = material.preferred_dataset();
    out.push_back({result.srgb_linear, axis_average && !stated.axis.empty()
                                           ? std::nullopt
                                           : material_band(solver, material, stated, result).band});
  }
  return out;
}

F0Options without_f82(F0Options options) {
  options.f82 = false;
  return options;
}

Identifier::Identifier(const MaterialLibrary& library, const F0Solver& solver,
                       const std::vector<std::string>& classes, unsigned threads) {
  check_classes(classes);
  const std::size_t count = library.ids().size();
  std::vector<std::optional<Hypothesis>> found(count);
  parallel_chunks(count, threads, 8, [&](std::size_t first, std::size_t last, unsigned) {
    for (std::size_t i = first; i < last; ++i) {
      // Stacks have no band, so that none needs to be opened.
      const Material material = library.as_filed(i);
      if (classes.empty() || std::ranges::find(classes, material.material_class) != classes.end())
        found[i] = hypothesis(material, solver);
    }
  });
  for (std::optional<Hypothesis>& each : found)
    if (each) hypotheses_.push_back(std::move(*each));
}

void Identifier::replace(std::string_view id, std::optional<Material> material, const F0Solver& solver) {
  std::erase_if(hypotheses_, [&](const Hypothesis& each) { return each.id == id; });
  if (!material) return;
  if (auto made = hypothesis(*material, solver)) hypotheses_.push_back(std::move(*made));
}

Identified Identifier::identify(const AskedColour& asked, const Prior& prior) const {
  struct Weighed {
    const Hypothesis* hypothesis;
    double delta_e, weight;
  };
  std::vector<Weighed> all;
  Identified out;
  double largest = -std::numeric_limits<double>::infinity();
  bool inside = false;
  for (const Hypothesis& each : hypotheses_) {
    const double delta_e = distance(asked.f0, each.f0);
    inside = inside || lies_inside(each.band, each.f0, asked.f0);
    const auto weight = prior.find(each.id);
    if (weight != prior.end() && weight->second == 0) continue;
    double squares = square(delta_e);
    const bool second = asked.f82 && each.f82;
    if (second) squares += square(distance(*asked.f82, *each.f82));
    const double scale =
        math::hypot(each.band.de90 / radius_per_scale, asked.eight_bit ? eight_bit_scale : least_scale);
    const double value =
        log_density(squares, scale, second ? 2 : 1) + (weight != prior.end() ? math::log(weight->second) : 0);
    largest = std::max(largest, value);
    all.push_back({&each, delta_e, value});
  }
  double sum = 0;
  for (Weighed& each : all) {
    each.weight = math::exp(each.weight - largest);
    sum += each.weight;
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Weighed& a, const Weighed& b) { return a.weight > b.weight; });
  std::vector<BandOfF0> listed;
  double held = 0;
  for (const Weighed& each : all) {
    if (held >= listed_probability && listed.size() >= least_listed) break;
    const double p = each.weight / sum;
    held += p;
    const Hypothesis& entry = *each.hypothesis;
    listed.push_back({entry.f0, entry.band});
    out.candidates.push_back({&entry, p, each.delta_e, each.delta_e / entry.band.de90});
  }
  out.verdict = !inside || all.empty()                         ? ColourVerdict::none
                : out.candidates.front().p >= sure_probability ? ColourVerdict::sure
                                                               : ColourVerdict::ambiguous;
  out.groups = not_told_apart(listed);
  return out;
}

}  // namespace etak
