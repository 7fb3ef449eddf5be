// SPDX-License-Identifier: Apache-2.0
#include "core/material/appearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "core/base/number.h"
#include "core/material/dispersion.h"
#include "core/material/f0/f0_data.h"
#include "core/material/names.h"
#include "core/math/functions.h"
#include "core/spectrum/integration.h"
#include "core/spectrum/interpolate.h"

namespace etak {
namespace {

constexpr double least_passing = 0.5, nearly_all = 0.999;
constexpr std::array<double, 4> depths_m{1, 0.1, 0.01, clear_depth_m};

const Quadrature& daylight() {
  static const Quadrature q = make_quadrature(Method::nm1, Viewing{});
  return q;
}

// Daylight through `depth_m` of a body, as X, Y, Z.
std::array<double, 3> passing(std::span<const double> k, double depth_m) {
  const Quadrature& q = daylight();
  std::vector<double> share(k.size());
  for (std::size_t i = 0; i < k.size(); ++i)
    share[i] = math::exp(-4 * std::numbers::pi * k[i] * depth_m / (q.wavelength_nm[i] * 1e-9));
  return q.integrate(share);
}

// k of a dataset on the reference grid; none where it does not reach over half of the visible weight.
std::optional<std::array<double, grid_size>> visible_k(const Dataset& dataset) {
  const auto* constants = std::get_if<OpticalConstants>(&dataset.optics);
  if (constants == nullptr || !constants->k) return std::nullopt;
  if (weight_inside(Viewing{}, constants->k->first_nm(), constants->k->last_nm())[1] < 0.5)
    return std::nullopt;
  std::array<double, grid_size> out{};
  resample_to_grid(*constants->k, out);
  return out;
}

// n_d and Abbe's number of a dataset, where its n reaches the lines that they are defined by.
void take_index(const OpticalConstants& constants, ClearBody& out) {
  constexpr std::array<double, 3> lines_nm{486.1327, 587.5618, 656.2725};  // F, d, C
  std::array<double, 3> n{};
  const auto [first_nm, last_nm] = range_of(constants);
  if (const auto* formula = std::get_if<DispersionFormula>(&constants.n))
    evaluate(*formula, lines_nm, n);
  else
    resample(std::get<Spectrum>(constants.n), Interpolation::linear, lines_nm, n);
  if (first_nm > lines_nm[1] || last_nm < lines_nm[1] || !std::isfinite(n[1])) return;
  out.n_d = n[1];
  if (first_nm <= lines_nm[0] && last_nm >= lines_nm[2] && n[0] > n[2]) out.v_d = (n[1] - 1) / (n[0] - n[2]);
}

std::string percent(double share) {
  return number(100 * share, 3) + " %";
}

// ---- roughness by class and group

struct ClassRow {
  std::string_view material_class;
  double value;
  bool is_gloss;  // else perceptual roughness
};
// Metals keep the gloss that etak has always drawn them with. Polished and liquid things are smooth; what is
// met as parts, grains and stones lies between; everyday surfaces are close to the largest roughness, but for the
// groups below.
constexpr std::array<ClassRow, material_classes.size()> class_rows{{
    {"metal", 0.75, true},
    {"alloy", 0.75, true},
    {"conductor", 0.75, true},
    {"semiconductor", 0.75, true},
    {"gem", 0, false},
    {"mineral", 0.3, false},
    {"crystal", 0.3, false},
    {"salt", 0.3, false},
    {"glass", 0, false},
    {"plastic", 0.3, false},
    {"organic", 0.3, false},
    {"liquid", 0, false},
    {"solid", 0.3, false},
    {"gas", 0, false},
    {"surface", 0.9, false},
}};
constexpr bool in_order_of_classes() {
  for (std::size_t i = 0; i < class_rows.size(); ++i)
    if (class_rows[i].material_class != material_classes[i]) return false;
  return true;
}
static_assert(in_order_of_classes(), "every class has its roughness");

struct GroupRow {
  std::string_view group;
  double roughness;
};
// Groups of class "surface" that are met smoother than the class: oil is a liquid, moulded plastic and glazed or
// waxed things have a sheen, skin, fruits and leather a broad highlight, sawn wood and broken stone a trace of one.
// What is not here is matt, as fabric, paper, soil, powder, pigment, snow and what houses and roads are built of.
constexpr auto group_rows = std::to_array<GroupRow>({{"oil", 0.1},
                                                     {"plastic", 0.3},
                                                     {"household", 0.3},
                                                     {"paint", 0.35},
                                                     {"hair", 0.4},
                                                     {"skin", 0.45},
                                                     {"leather", 0.5},
                                                     {"food", 0.5},
                                                     {"rubber", 0.6},
                                                     {"wood", 0.6},
                                                     {"plant", 0.6},
                                                     {"metal", 0.6},
                                                     {"stone", 0.7}});

// The clarity of the body below the layers.
Clarity clarity_of_base(const Stack& stack, RgbSpace space) {
  Clarity out;
  if (!stack.is_open()) return out;
  const StackMedium& base = stack.media[stack.base];
  out.clear = base.body.has_value();
  out.reason = "as its base " + base.id + "/" + base.dataset + (out.clear ? " is" : " is not clear");
  if (!out.clear) return out;
  out.body = *base.body;
  const Xyz white = to_xyz(daylight().white());
  const Mat3 from_srgb = inverse(xyz_to_rgb(RgbSpace::srgb, white, white));
  if (space != RgbSpace::srgb)
    out.body.color = to_rgb(xyz_to_rgb(space, white, white) * (from_srgb * vec(out.body.color)));
  return out;
}

}  // namespace

Clarity clarity(const Material& material, const Dataset& dataset, RgbSpace space) {
  Clarity out;
  const std::string_view kind = optical_kind(material.material_class);
  if (kind != "dielectric") {
    out.reason = kind == "surface" ? "the data are the total reflectance of a body"
                                   : "a " + std::string(kind) + " is not seen through";
    return out;
  }
  const auto* constants = std::get_if<OpticalConstants>(&dataset.optics);
  if (constants == nullptr) {
    if (const auto* stack = std::get_if<Stack>(&dataset.optics)) return clarity_of_base(*stack, space);
    out.reason = "the data are reflectance: what the body absorbs is not known";
    return out;
  }
  out.reason = material.body.empty() ? alias_note(material.bodies, dataset.id) : material.body;
  if (!out.reason.empty()) return out;
  std::optional<std::array<double, grid_size>> k = visible_k(dataset);
  double through = k ? passing(*k, clear_depth_m)[1] : 0;
  if (k && through < least_passing) {
    out.reason = percent(through) + " of daylight passes 1 mm by its k";
    return out;
  }
  out.clear = true;
  take_index(*constants, out.body);
  std::string whose = "its k";
  if (k) out.k_of = &dataset;
  if (!k) {
    // Over 1 m clear bodies differ visibly in their absorption.
    double most = -1;
    for (const Dataset& other : material.datasets)
      if (const auto found = visible_k(other)) {
        if (passing(*found, clear_depth_m)[1] < least_passing) continue;
        if (const double far = passing(*found, 1)[1]; far > most) {
          most = far;
          k = found;
          whose = "k of " + other.id;
          out.k_of = &other;
        }
      }
    if (!k) {
      out.reason = "a dielectric without data of what it absorbs of visible light";
      return out;
    }
    through = passing(*k, clear_depth_m)[1];
  }
  out.reason = percent(through) + " of daylight passes 1 mm by " + whose;
  const double depth = *std::find_if(depths_m.begin(), depths_m.end(), [&](double each) {
    return each == clear_depth_m || passing(*k, each)[1] >= least_passing;
  });
  const std::array<double, 3> xyz = passing(*k, depth);
  if (depth == depths_m.front() && xyz[1] > nearly_all) return out;
  const Xyz white = to_xyz(daylight().white());
  out.body.depth_m = depth;
  out.body.color = to_rgb(xyz_to_rgb(space, white, white) * xyz);
  return out;
}

std::optional<ClearBody> clear_body(const Material& material, const Dataset& dataset, RgbSpace space) {
  const Clarity found = clarity(material, dataset, space);
  return found.clear ? std::optional(found.body) : std::nullopt;
}

std::string clear_body_text(const ClearBody& body) {
  std::string out;
  if (body.n_d) out = "n_d " + number(*body.n_d, 5);
  if (body.v_d) out += ", V_d " + number(*body.v_d, 4);
  if (!out.empty()) out += "; ";
  if (body.depth_m == 0) return out + "no colour over 1 m is known";
  const LinearRgb& c = body.color;
  return out + "linear " + number(c.r, 4) + " " + number(c.g, 4) + " " + number(c.b, 4) + " through " +
         number(body.depth_m, 3) + " m";
}

std::string black_body_remark(const Clarity& body) {
  return "the body is taken as black: " + body.reason + "; light scattered inside is in no n and k";
}

bool is_clear_body(const Material& material, const Dataset& dataset, const LinearRgb& diffuse) {
  return diffuse == LinearRgb{} && clarity(material, dataset).clear;
}

DefaultGloss default_gloss(const Material& material, bool clear_body) {
  constexpr const char* convention = ", a convention, no measurement";
  if (clear_body) return {Gloss::of_roughness(0), std::string("the default of clear bodies") + convention};
  const auto group = std::ranges::find(group_rows, material.group, &GroupRow::group);
  if (material.material_class == "surface" && group != group_rows.end())
    return {Gloss::of_roughness(group->roughness),
            "the default of class surface, group " + material.group + convention};
  const auto row = std::find_if(class_rows.begin(), class_rows.end(), [&](const ClassRow& each) {
    return each.material_class == material.material_class;
  });
  const ClassRow& found = row == class_rows.end() ? class_rows.front() : *row;
  return {found.is_gloss ? Gloss(found.value) : Gloss::of_roughness(found.value),
          "the default of class " + std::string(found.material_class) + convention};
}

std::string default_gloss_remark(const DefaultGloss& standard) {
  return roughness_text(standard.gloss) + ": " + standard.reason;
}

std::string total_reflectance_remark(const TotalReflectance& parts) {
  const double f0 = parts.f0.g;
  const bool less = f0 > 0 && std::min({parts.diffuse.r, parts.diffuse.g, parts.diffuse.b}) <= 0;
  return "the data are the total reflectance of a body: F0 " + number(f0, 3) +
         (f0 < assumed_f0
              ? ", lowered from an assumed " + number(assumed_f0, 3) + " to the mean of its channels,"
              : ", which is assumed,") +
         " is taken off the diffuse colour, so that both add up to what was measured at normal incidence" +
         (less ? "; a channel that has less than F0 keeps F0, and its diffuse colour is black" : "");
}

TotalReflectance divided(const LinearRgb& total, const LinearRgb& wanted) {
  const double of_wanted = wanted.r + wanted.g + wanted.b, of_total = total.r + total.g + total.b;
  const double share = of_total < of_wanted ? std::max(of_total / of_wanted, 0.0) : 1;
  TotalReflectance out;
  out.lowered = share < 1;
  out.f0 = {share * wanted.r, share * wanted.g, share * wanted.b};
  const auto rest = [](double whole, double part) { return std::max(whole - part, std::min(whole, 0.0)); };
  out.diffuse = {rest(total.r, out.f0.r), rest(total.g, out.f0.g), rest(total.b, out.f0.b)};
  return out;
}

}  // namespace etak
