// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/surface_check.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/base/text/text.h"
#include "core/color/srgb.h"
#include "core/exchange/color_parts.h"

namespace etak {
namespace {

constexpr double near_measured = 3;  // dE2000

std::array<double, 3> array_of(const LinearRgb& c) {
  return {c.r, c.g, c.b};
}

// A name without what programs put around it.
std::string bare_name(std::string_view name) {
  std::string text = lower_case(name);
  for (const std::string_view before : {"m_", "mat_", "mi_"})
    if (text.starts_with(before)) text.erase(0, before.size());
  for (const std::string_view behind : {"_surface", "_material", "_mat"})
    if (text.ends_with(behind)) text.resize(text.size() - behind.size());
  return text;
}

// Whether it states a coat, under which a base has another F0 than in air.
bool is_coated(const DocumentSurface& surface) {
  constexpr std::array names{"coat_weight", "coat", "clearcoat", "KHR_materials_clearcoat.clearcoatFactor"};
  return std::ranges::any_of(surface.inputs, [&](const SurfaceInput& input) {
    return std::ranges::count(names, input.name) > 0 && input.values.size() == 1 && input.values[0] > 0;
  });
}

}  // namespace

Measured nearest_measured(const KnownMaterials& known, const LinearRgb& f0, SurfaceSort sort) {
  constexpr double near = 5;
  const std::array<double, 3> linear = array_of(f0);
  const KnownF0* best = nullptr;
  if (sort == SurfaceSort::metal || sort == SurfaceSort::dielectric)
    best = nearest_f0(known, linear,
                      [&](const KnownF0& entry) { return entry.metal == (sort == SurfaceSort::metal); });
  if (best == nullptr || delta_e_of(linear, *best) > near)
    best = nearest_f0(known, linear, [](const KnownF0&) { return true; });
  return best == nullptr ? Measured{} : Measured{best, delta_e_of(linear, *best)};
}

std::optional<std::vector<const KnownF0*>> named_material(const KnownMaterials& known,
                                                          std::string_view name) {
  const std::string text = bare_name(name);
  if (!known.has(text)) return std::nullopt;
  return known.f0_of(text);
}

double distance_of(const LinearRgb& f0, const KnownF0& entry) {
  const double as_it_is = delta_e_of(array_of(f0), entry);
  if (entry.metal) return as_it_is;
  KnownF0 grey = entry;
  grey.linear = {entry.luminance, entry.luminance, entry.luminance};
  return std::min(as_it_is, delta_e_of(array_of(f0), grey));
}

bool is_what_it_is_called(const KnownMaterials& known, const DocumentSurface& surface, const LinearRgb& f0) {
  const auto entries = named_material(known, surface.name);
  if (!entries) return false;
  return entries->empty() || is_coated(surface) || std::ranges::any_of(*entries, [&](const KnownF0* entry) {
           return entry->layers || distance_of(f0, *entry) <= near_measured;
         });
}

bool is_as_measured(const KnownMaterials& known, const DocumentSurface& surface) {
  const DocumentValues values = values_of(surface);
  // The colour that a film shows is not told by the F0 of its base.
  if (!values.f0) return values.film_nm.has_value();
  if (!is_what_it_is_called(known, surface, *values.f0)) return false;
  if (values.sort == SurfaceSort::metal) return true;
  if (!values.base_color || !values.transmission) return false;
  const LinearRgb body = scaled(*values.base_color, 1 - *values.transmission);
  const auto total = known.total_of(bare_name(surface.name));
  if (!total) return largest(body) < 0.002;  // half an 8-bit code
  const double passed = 1 - largest(*values.f0);
  return delta_e_of(
             {values.f0->r + passed * body.r, values.f0->g + passed * body.g, values.f0->b + passed * body.b},
             *total) <= near_measured;
}

JudgedSurface judged_surface(const KnownMaterials& known, const DocumentSurface& surface) {
  JudgedSurface out{surface.name, surface.model, surface.place};
  const DocumentValues values = values_of(surface);
  if (!values.f0) return out;
  const Measured nearest = nearest_measured(known, *values.f0, values.sort);
  if (nearest.entry != nullptr) out.nearest = {nearest.entry->id, std::round(10 * nearest.delta_e) / 10};
  return out;
}

std::string numbers_text(const std::vector<double>& values) {
  return joined(values, " ", [](double value) { return number(value, 3); });
}

bool is_eight_bit(const ModelInput& of, const SurfaceInput& input) {
  return of.type == InputType::color && of.most <= 1 && input.values.size() == 3 && input.written.empty() &&
         *std::ranges::max_element(input.values) > 1 && std::ranges::all_of(input.values, [](double value) {
           return value >= 0 && value <= 255 && value == std::floor(value);
         });
}

std::string transfer_slip(const KnownMaterials& known, const LinearRgb& f0) {
  constexpr double near = 2, far = 3;
  const std::array<double, 3> linear = array_of(f0);
  const auto metal = [](const KnownF0& entry) { return entry.metal; };
  const KnownF0* as_it_is = nearest_f0(known, linear, metal);
  if (as_it_is == nullptr || delta_e_of(linear, *as_it_is) <= far) return {};
  struct Way {
    double (*change)(double);
    const char* what;
  };
  for (const Way& way : {Way{srgb_decode, "sRGB-encoded, where linear numbers are expected"},
                         Way{srgb_encode, "decoded from sRGB once too often"}}) {
    std::array<double, 3> other{};
    for (std::size_t c = 0; c < 3; ++c) other[c] = way.change(std::clamp(linear[c], 0.0, 1.0));
    const KnownF0* entry =
        nearest_f0(known, other, [](const KnownF0& each) { return each.conductor && each.preferred; });
    if (entry == nullptr || delta_e_of(other, *entry) > near) continue;
    return "this is " + entry->id + ", " + way.what;
  }
  return {};
}

Finding& report_surface(RuleCheck& check, const DocumentSurface& surface, const DocumentValues& values,
                        const SurfaceInput* input, const std::string& what) {
  Finding& finding = check.report();
  finding.material = surface.name;
  const std::string& place = input != nullptr ? input->place : surface.place;
  const bool pointer = place.starts_with('/');
  if (pointer) finding.pointer = place;
  finding.message = (pointer ? std::string() : place + ": ") + in_quotes(surface.name) + ", " +
                    (input != nullptr ? printable(input->name) + ": " : "") + what;
  if (input != nullptr) finding.value = printable(input->name) + " " + numbers_text(input->values);
  if (!values.f0) return finding;
  finding.linear = array_of(*values.f0);
  finding.byte = check.bytes(*finding.linear);
  finding.luminance = luminance_of(*finding.linear);
  finding.nearest =
      nearest_materials(known_materials(check.settings), *finding.linear, check.settings.transfer);
  const Measured nearest = nearest_measured(known_materials(check.settings), *values.f0, values.sort);
  if (nearest.entry != nullptr)
    finding.message += "; nearest: " + nearest.entry->id + ", " + number(nearest.delta_e, 2) + " dE off";
  return finding;
}

}  // namespace etak
