// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/surfaces/meaning.h"

#include <algorithm>

#include "core/exchange/color_parts.h"
#include "core/fresnel/fresnel.h"

namespace etak {
namespace {

template <class Act>
LinearRgb by_channel(const Act& act) {
  return {act(std::size_t{0}), act(std::size_t{1}), act(std::size_t{2})};
}

class Reader {
 public:
  explicit Reader(const DocumentSurface& surface) : surface_(surface) {}

  const SurfaceInput* stated(Meaning meaning) const {
    for (const SurfaceInput& each : surface_.inputs)
      if (const ModelInput* input = model_input(surface_.model, each.name);
          input != nullptr && input->meaning == meaning &&
          (input->type != InputType::color || each.values.empty() || each.values.size() == 3))
        return &each;
    return nullptr;
  }

  // The number of a stated input, else the model's default, else `otherwise`; none: a picture gives it.
  std::optional<double> number(Meaning meaning, double otherwise) const {
    if (const SurfaceInput* input = stated(meaning))
      return input->values.size() == 1 ? std::optional(input->values[0]) : std::nullopt;
    const ModelInput* input = model_input(surface_.model, meaning);
    return input != nullptr && surface_.model != "values" ? input->otherwise : otherwise;
  }

  std::optional<LinearRgb> color(Meaning meaning, double otherwise) const {
    if (const SurfaceInput* input = stated(meaning)) {
      if (input->values.size() != 3) return std::nullopt;
      return LinearRgb{input->values[0], input->values[1], input->values[2]};
    }
    const ModelInput* input = model_input(surface_.model, meaning);
    const double c = input != nullptr && surface_.model != "values" ? input->otherwise : otherwise;
    return LinearRgb{c, c, c};
  }

 private:
  const DocumentSurface& surface_;
};

LinearRgb product(const LinearRgb& a, const LinearRgb& b) {
  return {a.r * b.r, a.g * b.g, a.b * b.b};
}

void take_index(const LinearRgb& n, const LinearRgb& k, DocumentValues& out) {
  const auto a = vec(n), b = vec(k);
  const auto in_range = [](double x) { return x >= 0 && x <= 1000; };
  if (!std::ranges::all_of(a, in_range) || !std::ranges::all_of(b, in_range)) return;
  out.f0 = by_channel([&](std::size_t c) { return f64::f0(a[c], b[c]); });
  out.f82 = by_channel([&](std::size_t c) { return f64::fresnel_exact(a[c], b[c], f82_cosine); });
}

// The edge of a metal: by its tint, or by Gulbrandsen's edge colour.
void take_edge(const Reader& reader, DocumentValues& out) {
  const auto tint = reader.stated(Meaning::tint), edge = reader.stated(Meaning::edge_color);
  out.edge_from = tint != nullptr ? tint : edge;
  if (out.edge_from == nullptr || out.edge_from->values.size() != 3 || !out.f0) return;
  const std::vector<double>& stated = out.edge_from->values;
  const auto f0 = vec(*out.f0);
  out.f82 = by_channel([&](std::size_t c) {
    if (tint != nullptr) return f64::f_schlick(f0[c], f82_cosine) * stated[c];
    return f64::f_gulbrandsen(std::clamp(f0[c], 0.0, 0.999), std::clamp(stated[c], 0.0, 1.0), f82_cosine);
  });
}

void take_metal(const Reader& reader, DocumentValues& out) {
  out.f0_from = reader.stated(Meaning::base_color);
  const auto weight = reader.number(Meaning::base_weight, 1);
  if (out.f0_from == nullptr || !out.base_color || !weight) return;
  out.f0 = scaled(*out.base_color, *weight);
  take_edge(reader, out);
}

void take_dielectric(const Reader& reader, DocumentValues& out) {
  const auto weight = reader.number(Meaning::specular_weight, 1);
  std::optional<LinearRgb> factor = LinearRgb{1, 1, 1};
  for (const Meaning meaning : {Meaning::tint, Meaning::edge_color, Meaning::specular_color}) {
    const auto color = reader.color(meaning, 1);
    factor = color && factor ? std::optional(product(*factor, *color)) : std::nullopt;
    if (const auto input = reader.stated(meaning)) out.f0_from = input;
  }
  if (const auto input = reader.stated(Meaning::specular_weight)) out.f0_from = input;
  if (const auto input = reader.stated(Meaning::ior)) out.f0_from = input;
  if (out.f0_from == nullptr || !weight || !factor || !out.ior || *out.ior < 0) return;
  const double of_ior = *out.ior == 0 ? 1 : f64::f0(*out.ior, 0);
  const LinearRgb scaled_f0 = scaled(*factor, of_ior * *weight);
  out.f0 = LinearRgb{std::min(scaled_f0.r, 1.0), std::min(scaled_f0.g, 1.0), std::min(scaled_f0.b, 1.0)};
}

// Where the metalness is not known, neither is F0; an edge of zero metalness is none.
void take_by_metalness(const Reader& reader, DocumentValues& out) {
  out.metal_from = reader.stated(Meaning::metalness);
  if (!out.metalness) return;
  out.sort = *out.metalness >= 0.9   ? SurfaceSort::metal
             : *out.metalness <= 0.1 ? SurfaceSort::dielectric
                                     : SurfaceSort::between;
  if (out.sort == SurfaceSort::metal) take_metal(reader, out);
  if (out.sort == SurfaceSort::dielectric) take_dielectric(reader, out);
}

// Whether a film that is not known in full lies on the surface.
bool take_film(const Reader& reader, DocumentValues& out) {
  for (const auto& [meaning, unit] : {std::pair(Meaning::film_nm, 1.0), std::pair(Meaning::film_um, 1000.0)})
    if (const SurfaceInput* input = reader.stated(meaning)) {
      out.film_from = input;
      if (!input->values.empty()) out.film_nm = input->values[0] * unit;
    }
  const SurfaceInput* weight = reader.stated(Meaning::film_weight);
  if (weight != nullptr) return weight->values.empty() || weight->values[0] > 0;
  return out.film_from != nullptr && (!out.film_nm || *out.film_nm > 0) &&
         reader.number(Meaning::film_weight, 1).value_or(1) > 0;
}

}  // namespace

DocumentValues values_of(const DocumentSurface& surface) {
  const Reader reader(surface);
  DocumentValues out;
  const bool film = take_film(reader, out);
  if (reader.stated(Meaning::roughness) != nullptr) out.roughness = reader.number(Meaning::roughness, 1);
  if (reader.stated(Meaning::diffuse) != nullptr) out.diffuse = reader.color(Meaning::diffuse, 0);
  if (reader.stated(Meaning::base_color) != nullptr) out.base_color = reader.color(Meaning::base_color, 1);
  out.ior = reader.number(Meaning::ior, 1.5);
  out.transmission = reader.number(Meaning::transmission, 0);
  const SurfaceInput *n = reader.stated(Meaning::n), *k = reader.stated(Meaning::k);
  const SurfaceInput* f0 = reader.stated(Meaning::f0);
  const bool f0_counts =
      model_input(surface.model, Meaning::takes_f0) == nullptr || reader.number(Meaning::takes_f0, 0) == 1;
  if (n != nullptr && k != nullptr && !out.base_color) {
    out.sort = SurfaceSort::either;
    out.f0_from = n;
    if (n->values.size() == 3 && k->values.size() == 3)
      take_index(*reader.color(Meaning::n, 1), *reader.color(Meaning::k, 0), out);
  } else if (f0 != nullptr && f0_counts && (!f0->values.empty() || !out.base_color)) {
    out.f0_from = f0;
    out.f0 = reader.color(Meaning::f0, 0);
    if (const SurfaceInput* f82 = reader.stated(Meaning::f82); f82 != nullptr && f82->values.size() == 3) {
      out.edge_from = f82;
      out.f82 = reader.color(Meaning::f82, 0);
    } else {
      take_edge(reader, out);
    }
  } else {
    const bool of_metals =
        reader.stated(Meaning::edge_color) != nullptr || reader.stated(Meaning::tint) != nullptr;
    out.metalness = reader.number(Meaning::metalness, of_metals ? 1 : 0);
    take_by_metalness(reader, out);
  }
  if (film) out.f0 = out.f82 = std::nullopt;
  return out;
}

}  // namespace etak
