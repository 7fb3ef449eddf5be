// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/calibration.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/csv.h"
#include "core/base/text/text.h"
#include "core/certainty/publications.h"

namespace etak {
namespace {

const std::vector<std::string> columns{"material", "class", "page", "preferred", "r", "g", "b", "left_out"};

// The ceil(count share)-th of the values in order. The two residuals of a material with two publications are equal, so that
// the usual correction for the size of a sample, ceil((count + 1) share), would reach too far: it covers 91 % instead of 89.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const auto at = static_cast<std::size_t>(std::ceil(double(values.size()) * share));
  return values[std::min(std::max<std::size_t>(at, 1), values.size()) - 1];
}

// The quantile for each kind of offset.
Offsets quantiles(const std::vector<Offsets>& values, double share) {
  Offsets out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    std::vector<double> each;
    for (const Offsets& value : values) each.push_back(value[i]);
    out[i] = quantile(std::move(each), share);
  }
  return out;
}

Offsets ratios(const Offsets& a, const Offsets& b) {
  Offsets out;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = a[i] / b[i];
  return out;
}

// The publications of a material but one.
std::vector<std::size_t> all_but(const PublishedMaterial& material, std::size_t publication) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < material.colours.size(); ++i)
    if (i != publication) out.push_back(i);
  return out;
}

// Student's t at 0.5 and 0.9, two-sided, for 1 to 10 degrees of freedom (Abramowitz and Stegun, table 26.10).
std::array<double, 2> student_t(std::size_t freedom) {
  constexpr std::array<std::array<double, 2>, 10> rows{{{1.000, 6.314},
                                                        {0.816, 2.920},
                                                        {0.765, 2.353},
                                                        {0.741, 2.132},
                                                        {0.727, 2.015},
                                                        {0.718, 1.943},
                                                        {0.711, 1.895},
                                                        {0.706, 1.860},
                                                        {0.703, 1.833},
                                                        {0.700, 1.812}}};
  return rows[std::min(std::max<std::size_t>(freedom, 1), rows.size()) - 1];
}

}  // namespace

std::vector<PublishedMaterial> parse_publications(std::string_view text, std::string_view file) {
  std::vector<PublishedMaterial> out;
  bool header = true;
  for (const CsvRow& row : csv_rows(text, file)) {
    if (row.fields.front().starts_with('#')) continue;
    const std::string place = std::string(file) + ":" + std::to_string(row.line);
    if (header) {
      if (row.fields != columns) throw Error::at(place, joined(row.fields), joined(columns));
      header = false;
      continue;
    }
    if (row.fields.size() != columns.size())
      throw Error::at(place, std::to_string(row.fields.size()) + " fields", std::to_string(columns.size()));
    const bool computed = row.fields[7] == "computed";
    if (!row.fields[7].empty() && !computed) continue;
    std::array<double, 3> rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (!parse_number(row.fields[4 + i], rgb[i])) throw Error::at(place, row.fields[4 + i], "a number");
    }
    if (out.empty() || out.back().name != row.fields[0]) {
      out.emplace_back().name = row.fields[0];
      std::size_t kind = 0;
      while (kind < band_class_count && name(static_cast<BandClass>(kind)) != row.fields[1]) ++kind;
      if (kind == band_class_count) throw Error::at(place, row.fields[1], "metal, semiconductor or clear");
      out.back().kind = static_cast<BandClass>(kind);
    }
    PublishedMaterial& material = out.back();
    if (row.fields[3] == "yes") material.preferred = material.colours.size();
    (computed ? material.computed : material.colours).push_back({rgb[0], rgb[1], rgb[2]});
  }
  return out;
}

std::size_t stated_of(const PublishedMaterial& material, std::span<const std::size_t> known) {
  if (material.preferred && std::find(known.begin(), known.end(), *material.preferred) != known.end())
    return *material.preferred;
  std::vector<LinearRgb> colours;
  for (const std::size_t i : known) colours.push_back(material.colours[i]);
  return known[nearest_together(colours)];
}

std::vector<Residual> residuals(std::span<const PublishedMaterial> materials) {
  std::vector<Residual> out;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const PublishedMaterial& material = materials[m];
    if (material.colours.size() < 2) continue;
    for (std::size_t i = 0; i < material.colours.size(); ++i) {
      const std::vector<std::size_t> known = all_but(material, i);
      const std::size_t stated = stated_of(material, known);
      Residual& residual = out.emplace_back();
      residual.material = m;
      residual.publication = i;
      residual.kind = material.kind;
      residual.off = offsets(material.colours[stated], material.colours[i]);
      for (const std::size_t other : known)
        if (other != stated)
          residual.others.push_back(offsets(material.colours[stated], material.colours[other]));
    }
  }
  return out;
}

BandTable band_table(std::span<const PublishedMaterial> materials, std::span<const Residual> residuals,
                     std::optional<std::size_t> without) {
  BandTable out;
  for (const Residual& residual : residuals) {
    if (residual.material == without) continue;
    BandTable::OfClass& of = out.classes[static_cast<std::size_t>(residual.kind)];
    if (residual.publication == 0) ++of.materials;
    ++of.publications;
    for (std::size_t i = 0; i < of.mean.size(); ++i) of.mean[i] += residual.off[i];
  }
  for (BandTable::OfClass& of : out.classes)
    for (double& mean : of.mean) mean /= double(std::max<std::size_t>(of.publications, 1));
  // Scaled residuals, of one other publication and of several, by class and of all classes.
  std::array<std::array<std::vector<Offsets>, 2>, band_class_count + 1> scaled;
  for (const Residual& residual : residuals) {
    if (residual.material == without) continue;
    const Offsets value = ratios(residual.off, band_scale(out.of(residual.kind).mean, residual.others));
    scaled[static_cast<std::size_t>(residual.kind)][residual.several()].push_back(value);
    scaled.back()[residual.several()].push_back(value);
  }
  for (std::size_t kind = 0; kind < band_class_count; ++kind) {
    out.classes[kind].half_one = quantiles(scaled[kind][0], 0.5);
    out.classes[kind].half_several = quantiles(scaled[kind][1], 0.5);
  }
  out.nine_one = quantiles(scaled.back()[0], 0.9);
  out.nine_several = quantiles(scaled.back()[1], 0.9);
  std::vector<Offsets> computed;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    if (m == without || materials[m].colours.empty()) continue;
    const std::size_t stated = stated_of(materials[m], all_but(materials[m], materials[m].colours.size()));
    for (const LinearRgb& colour : materials[m].computed)
      computed.push_back(offsets(materials[m].colours[stated], colour));
  }
  out.computed = computed.size();
  out.computed_half = quantiles(computed, 0.5);
  out.computed_nine = quantiles(computed, 0.9);
  return out;
}

void BandCover::add(double off, double half, double nine) {
  ++count;
  inside50 += off <= half ? 1 : 0;
  inside90 += off <= nine ? 1 : 0;
  de50 += half;
  de90 += nine;
}

BandRules leave_one_out(std::span<const PublishedMaterial> materials) {
  BandRules out;
  const std::vector<Residual> all = residuals(materials);
  std::map<std::size_t, BandTable> tables;
  for (const Residual& residual : all) {
    const PublishedMaterial& material = materials[residual.material];
    auto table = tables.find(residual.material);
    if (table == tables.end())
      table = tables.emplace(residual.material, band_table(materials, all, residual.material)).first;
    const std::vector<std::size_t> known = all_but(material, residual.publication);
    const std::size_t stated = stated_of(material, known);
    std::vector<LinearRgb> others;
    double farthest = 0, squares = 0;
    for (const std::size_t i : known) {
      if (i == stated) continue;
      others.push_back(material.colours[i]);
      const double de = offsets(material.colours[stated], material.colours[i])[offset_de];
      farthest = std::max(farthest, de);
      squares += de * de;
    }
    const double off = residual.off[offset_de];
    const Band mine = band(residual.kind, material.colours[stated], others, table->second);
    out.conformal.add(off, mine.de50, mine.de90);
    out.by_class[static_cast<std::size_t>(residual.kind)].add(off, mine.de50, mine.de90);
    if (others.empty()) continue;
    const double deviation = std::sqrt(squares / double(others.size())), count = double(known.size());
    const auto [half, nine] = student_t(others.size());
    const double new_one = deviation * std::sqrt(1 + 1 / count);
    out.student.add(off, half * new_one, nine * new_one);
    out.range.add(off, farthest / 2, farthest);
  }
  return out;
}

CoverAt cover_at(std::span<const PublishedMaterial> materials, double nominal) {
  const std::vector<Residual> all = residuals(materials);
  CoverAt out;
  out.nominal = nominal;
  std::array<double, band_class_count> count{};
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const BandTable table = band_table(materials, all, m);
    const auto scaled = [&](const Residual& residual) {
      return residual.off[offset_de] / band_scale(table.of(residual.kind).mean, residual.others)[offset_de];
    };
    for (const Residual& mine : all) {
      if (mine.material != m) continue;
      std::vector<double> others;
      for (const Residual& each : all)
        if (each.material != m && each.several() == mine.several() &&
            (nominal >= pooled_from || each.kind == mine.kind))
          others.push_back(scaled(each));
      const double inside = scaled(mine) <= quantile(std::move(others), nominal) ? 1 : 0;
      const auto kind = static_cast<std::size_t>(mine.kind);
      count[kind] += 1;
      out.by_class[kind] += inside;
      out.all += inside;
    }
  }
  out.all /= double(all.size());
  for (std::size_t kind = 0; kind < band_class_count; ++kind)
    out.by_class[kind] /= std::max(count[kind], 1.0);
  return out;
}

}  // namespace etak
