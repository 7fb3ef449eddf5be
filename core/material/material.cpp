// SPDX-License-Identifier: Apache-2.0
#include "core/material/material.h"

#include <algorithm>
#include <utility>

#include "core/base/text/free_names.h"

namespace etak {
namespace {

struct FlagRow {
  std::string_view name, meaning;
};

// In the order of the enumeration.
constexpr std::array<FlagRow, flag_count> flag_rows{{
    {"extrapolated",
     "the data do not cover 400-700 nm, or less than 0.99 of one of the X, Y, Z weights; end values are held"},
    {"out-of-gamut", "a linear channel lies outside [0, 1]; it is kept in linear and clipped in 8 bit"},
    {"channel-in-zone", "one channel, but not the luminance, lies between 0.20 and 0.45"},
    {"gap", "neighbouring samples inside 400-700 nm are more than 20 nm apart"},
    {"single-sample", "the table has a single row"},
    {"unsorted", "the rows were not ascending and were sorted"},
    {"duplicate-wavelength", "rows of equal wavelength with different values were made one"},
    {"duplicate-dropped", "repeated identical rows were dropped"},
    {"negative-k", "k below zero was taken as 0"},
    {"k-assumed-0", "no k is given; 0 was taken"},
    {"k-range-short", "k is given over less of 360-830 nm than n; its end values are held"},
    {"n-not-positive", "n is zero or negative somewhere outside 360-830 nm"},
    {"formula-clamped",
     "the formula was evaluated at the end of its stated range for wavelengths outside it"},
    {"unpaired-coefficient", "the formula's last coefficient has no partner and was left out"},
    {"outside-absorption-ignored", "the small absorption of the outside medium was taken as 0"},
    {"reflectance-clamped", "tabulated reflectance up to 0.02 outside [0, 1] was taken as 0 or 1"},
    {"finer-than-grid",
     "the samples are closer than the step of the sum, which may miss what they hold: in place of the 1 nm sum they were integrated exactly; for the wider sums the automatic method finds a step"},
    {"computed", "the numbers come from theory alone; nothing was measured"},
    {"sparse", "the table has fewer than 10 samples in 400-700 nm"},
    {"doubtful",
     "its file names the numbers doubtful and says why, or the luminance of F0 is more than 0.1 off the median of at least two other datasets"},
    {"unresolved-fringes",
     "layers that are thick and coherent have fringes narrower than eight steps of the sum, which may miss them"},
}};

constexpr std::array<std::string_view, 4> origin_names{"measured", "fit", "computed", "unknown"};

}  // namespace

std::string_view name(Flag flag) {
  return flag_rows[static_cast<std::size_t>(flag)].name;
}
std::string_view meaning(Flag flag) {
  return flag_rows[static_cast<std::size_t>(flag)].meaning;
}

std::optional<Flag> flag_named(std::string_view text) {
  for (std::size_t i = 0; i < flag_count; ++i)
    if (flag_rows[i].name == text) return static_cast<Flag>(i);
  return std::nullopt;
}

std::string_view name(Origin origin) {
  return origin_names[static_cast<std::size_t>(origin)];
}

std::optional<Origin> origin_named(std::string_view text) {
  const auto found = std::find(origin_names.begin(), origin_names.end(), text);
  if (found == origin_names.end()) return std::nullopt;
  return static_cast<Origin>(found - origin_names.begin());
}

bool is_class(std::string_view text) {
  return std::find(material_classes.begin(), material_classes.end(), text) != material_classes.end();
}

std::string_view optical_kind(std::string_view material_class) {
  if (material_class == "metal" || material_class == "alloy" || material_class == "conductor")
    return "conductor";
  if (material_class == "semiconductor" || material_class == "surface") return material_class;
  return "dielectric";
}

bool gives_f0(std::string_view material_class) {
  return material_class != "surface";
}

const Dataset* Material::dataset(std::string_view dataset_id) const {
  const auto found =
      std::find_if(datasets.begin(), datasets.end(), [&](const Dataset& d) { return d.id == dataset_id; });
  return found == datasets.end() ? nullptr : &*found;
}

std::string one_line(const Citation& c) {
  std::string out;
  const auto add = [&](std::string_view separator, const std::string& text) {
    if (text.empty()) return;
    if (!out.empty()) out += separator;
    out += text;
  };
  for (std::size_t i = 0; i < c.authors.size(); ++i)
    add(i + 1 == c.authors.size() ? " and " : ", ", c.authors[i]);
  add(", ", c.title);
  add(", ", c.published_in);
  if (c.year != 0) add(" ", "(" + std::to_string(c.year) + ")");
  if (!c.doi.empty()) add(", ", "doi:" + c.doi);
  return out;
}

std::string_view without_constants(const Optics& optics) {
  return std::holds_alternative<Stack>(optics) ? "is a stack of layers" : "has reflectance data only";
}

std::string source_line(const Dataset& dataset) {
  std::string out = one_line(dataset.citation);
  if (const auto* stack = std::get_if<Stack>(&dataset.optics))
    for (const StackMedium& medium : stack->media)
      out.append(out.empty() ? "" : "; ").append(medium.id).append(": ").append(one_line(medium.citation));
  return out;
}

Material merged(std::vector<Material> materials) {
  Material out;
  FreeNames ids;
  for (Material& each : materials) {
    if (out.datasets.empty()) {
      out = std::move(each);
      for (const Dataset& dataset : out.datasets) ids.take(dataset.id);
      continue;
    }
    for (Dataset& dataset : each.datasets) {
      dataset.id = ids.free(dataset.id, [id = dataset.id](int i) { return id + "-" + std::to_string(i); });
      out.datasets.push_back(std::move(dataset));
    }
  }
  return out;
}

}  // namespace etak
