// SPDX-License-Identifier: Apache-2.0
#include "core/material/optics/optics_class.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/setting.h"
#include "core/base/text/ascii.h"
#include "core/fresnel/fresnel.h"
#include "core/material/dispersion.h"
#include "core/material/f0.h"
#include "core/material/names.h"
#include "core/spectrum/interpolate.h"

namespace etak {
namespace {

constexpr std::array<double, 1> seen_nm{550};
constexpr double metal_k = 1, opaque_k = 1e-3;

constexpr std::array<std::string_view, 23> no_metals{"H",  "He", "B",  "C",  "N",  "O",  "F",  "Ne",
                                                     "Si", "P",  "S",  "Cl", "Ar", "Ge", "As", "Se",
                                                     "Br", "Kr", "Te", "I",  "Xe", "At", "Rn"};

bool is_metal(std::string_view formula) {
  const bool element =
      formula.size() == 1 || (formula.size() == 2 && !is_upper(formula[1]) && !is_digit(formula[1]));
  return element && is_formula(formula) && std::ranges::find(no_metals, formula) == no_metals.end();
}

bool is_seen(double first_nm, double last_nm) {
  return first_nm <= seen_nm[0] && seen_nm[0] <= last_nm;
}

// The value of a table at 550 nm; none where it does not reach so far.
std::optional<double> seen_value(const Spectrum& table) {
  std::array<double, 1> out{};
  if (!is_seen(table.first_nm(), table.last_nm())) return std::nullopt;
  resample(table, Interpolation::linear, seen_nm, out);
  return out[0];
}

std::optional<double> seen_n(const OpticalConstants& optics) {
  const auto* formula = std::get_if<DispersionFormula>(&optics.n);
  if (formula == nullptr) return seen_value(std::get<Spectrum>(optics.n));
  std::array<double, 1> out{};
  if (!is_seen(formula->first_nm, formula->last_nm)) return std::nullopt;
  evaluate(*formula, seen_nm, out);
  return out[0];
}

}  // namespace

void decide_class(Material& material, std::string_view formula) {
  material.material_class = "solid";
  material.class_by = ClassBy::nobody;
  const auto* const optics = std::get_if<OpticalConstants>(&material.preferred_dataset().optics);
  const std::optional<double> n = optics == nullptr ? std::nullopt : seen_n(*optics);
  if (!n || !(*n > 0)) return;
  const std::optional<double> k = optics->k ? seen_value(*optics->k) : std::nullopt;
  const double k_or_none = k.value_or(0);
  const double f0 = f64::f0(*n, k_or_none);
  if (f0 < forbidden_zone_first ? k || *n >= 1 : k && k_or_none < opaque_k && f0 <= most_assumed_f0) {
    material.class_by = ClassBy::numbers;
  } else if (f0 >= forbidden_zone_first && k_or_none >= opaque_k) {
    material.class_by = k_or_none >= metal_k && is_metal(formula) ? ClassBy::stated : ClassBy::numbers;
    material.material_class = k_or_none < metal_k ? "semiconductor"
                              : is_metal(formula) ? "metal"
                              : k_or_none > *n    ? "conductor"
                                                  : "semiconductor";
  }
}

std::string class_remark(const Material& material) {
  if (material.class_by == ClassBy::stated) return {};
  const std::string who = "no class is stated, and n and k at 550 nm ";
  if (material.class_by == ClassBy::nobody)
    return who + "do not tell it: taken as a dielectric; " + setting("material-class") + " states another";
  const std::string_view kind = optical_kind(material.material_class);
  return who + "tell a " + std::string(kind) +
         (kind == material.material_class || kind == "dielectric" ? ""
                                                                  : ", class " + material.material_class);
}

}  // namespace etak
