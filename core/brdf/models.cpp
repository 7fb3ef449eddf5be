// SPDX-License-Identifier: Apache-2.0
// The registry. A new model needs a text and a row in models.inc. A new combination of terms needs a row in
// `microfacet_rows`, and one in models.inc to be compiled as one vectorised loop.
#include "core/brdf/models.h"

#include <deque>
#include <mutex>

#include "core/brdf/compose.h"
#include "core/brdf/parameters.h"

namespace etak {
namespace {

namespace p = parameters;
constexpr ModelKind diffuse = ModelKind::diffuse, specular = ModelKind::specular,
                    combined = ModelKind::combined;

struct TextRow {
  std::string_view id, title, source;
  ModelKind kind;
  Claims claims;
  Few<Parameter> parameters;
  Few<std::string_view> files;
  std::string_view entry;
};

constexpr TextRow text_rows[] = {
#define ETAK_MODEL(entry, numbers, type, constant, call, ...) {__VA_ARGS__, #entry},
#define ETAK_MICROFACET(d, f, v)
#include "core/brdf/models.inc"
#undef ETAK_MODEL
#undef ETAK_MICROFACET
};

struct MicrofacetRow {
  std::string_view id, title;
  std::string_view D, F, V;
  Claims claims;
};

constexpr Claims ggx_height{true, true, "albedo below 1; 0.31 at alpha = 1, normal incidence"};
constexpr Claims compensated{true, true, "white furnace 0.99 to 1, for widths from 0.01 to 1"};
constexpr MicrofacetRow microfacet_rows[] = {
    {"ggx-schlick", "GGX, Schlick, Smith height-correlated", "ggx", "schlick", "smith-ggx-height",
     ggx_height},
    {"ggx-schlick-uncorrelated",
     "GGX, Schlick, Smith uncorrelated",
     "ggx",
     "schlick",
     "smith-ggx-uncorrelated",
     {true, true, "albedo below 1; 0.31 at alpha = 1, normal incidence"}},
    {"ggx-schlick-v-groove",
     "GGX, Schlick, V-grooves",
     "ggx",
     "schlick",
     "cook-torrance",
     {true, true, "albedo below 1; 0.375 at alpha = 1, normal incidence"}},
    {"ggx-exact", "GGX, exact Fresnel, Smith height-correlated", "ggx", "exact", "smith-ggx-height",
     ggx_height},
    {"ggx-f82", "GGX, F82, Smith height-correlated", "ggx", "f82", "smith-ggx-height", ggx_height},
    {"ggx-f82-tint", "GGX, F82-tint, Smith height-correlated", "ggx", "f82-tint", "smith-ggx-height",
     ggx_height},
    {"ggx-gulbrandsen", "GGX, Gulbrandsen, Smith height-correlated", "ggx", "gulbrandsen", "smith-ggx-height",
     ggx_height},
    {"ggx-from-f0", "GGX, exact from F0, Smith height-correlated", "ggx", "from-f0", "smith-ggx-height",
     ggx_height},
    {"ggx-spherical-gaussian", "GGX, spherical-Gaussian Schlick, Smith height-correlated", "ggx",
     "spherical-gaussian", "smith-ggx-height", ggx_height},
    {"ggx-lazanyi",
     "GGX, Lazanyi, Smith height-correlated",
     "ggx",
     "lazanyi",
     "smith-ggx-height",
     {true, true, "with fitted numbers that keep F at or below 1"}},
    {"ggx-dielectric", "GGX, two clear media, Smith height-correlated", "ggx", "dielectric",
     "smith-ggx-height", ggx_height},
    {"beckmann-smith",
     "Beckmann, exact Fresnel, Smith height-correlated",
     "beckmann",
     "exact",
     "smith-beckmann-height",
     {true, true, {}}},
    {"ggx-schlick-compensated", "GGX, Schlick, Smith and light between facets", "ggx", "schlick",
     "smith-ggx-compensated", compensated},
    {"ggx-exact-compensated", "GGX, exact Fresnel, Smith and light between facets", "ggx", "exact",
     "smith-ggx-compensated", compensated},
    {"ggx-f82-compensated", "GGX, F82, Smith and light between facets", "ggx", "f82", "smith-ggx-compensated",
     compensated},
    {"beckmann-smith-compensated", "Beckmann, exact Fresnel, Smith and light between facets", "beckmann",
     "exact", "smith-beckmann-compensated", compensated},
    {"beckmann-smith-uncorrelated",
     "Beckmann, Schlick, Smith uncorrelated",
     "beckmann",
     "schlick",
     "smith-beckmann-uncorrelated",
     {true, true, {}}},
    {"beckmann-schlick",
     "Beckmann, Schlick, V-grooves",
     "beckmann",
     "schlick",
     "cook-torrance",
     {true, true, "albedo up to 1.0000"}},
    {"phong-schlick",
     "normalised Phong lobe, Schlick, V-grooves",
     "phong",
     "schlick",
     "cook-torrance",
     {true, true, {}}},
    {"phong-implicit",
     "normalised Phong lobe, Schlick, implicit G",
     "phong",
     "schlick",
     "implicit",
     {true, true, "albedo up to 0.999"}},
    {"phong-kelemen",
     "normalised Phong lobe, Schlick, Kelemen's G",
     "phong",
     "schlick",
     "kelemen",
     {true, true, {}}},
    {"abc-schlick", "ABC, Schlick, V-grooves", "abc", "schlick", "cook-torrance", {true, true, {}}},
    {"sgd-schlick", "shifted gamma, Schlick, V-grooves", "sgd", "schlick", "cook-torrance", {true, true, {}}},
};

std::string source_of(const Model& model) {
  return "D: " + std::string(model.distribution->source) + "; F: " + std::string(model.fresnel->source) +
         "; V: " + std::string(model.visibility->source);
}

constexpr std::string_view engine_prefix = "as-";

class Registry {
 public:
  Registry() {
    for (const TextRow& row : text_rows) {
      compiled_.push_back(find_compiled(row.entry));
      Model model;
      model.id = row.id;
      model.title = row.title;
      model.source = row.source;
      model.kind = row.kind;
      model.claims = row.claims;
      model.parameters = row.parameters;
      model.files = row.files;
      model.entry = row.entry;
      model.compiled = &compiled_.back();
      (row.id.starts_with(engine_prefix) ? engines_ : rows_).push_back(model);
    }
    for (const MicrofacetRow& row : microfacet_rows) {
      ComposedModel& composed = composed_.emplace_back();
      compose(*find_term(TermKind::distribution, row.D), *find_term(TermKind::fresnel, row.F),
              *find_term(TermKind::visibility, row.V), composed);
      composed.source = source_of(composed.model);
      composed.model.id = row.id;
      composed.model.title = row.title;
      composed.model.source = composed.source;
      composed.model.claims = row.claims;
      rows_.push_back(composed.model);
    }
  }

  std::span<const Model> rows() const { return rows_; }

  const Model* find(std::string_view id) {
    for (const Model& each : id.starts_with(engine_prefix) ? engines_ : rows_)
      if (each.id == id) return &each;
    constexpr std::string_view prefix = "microfacet:";
    if (!id.starts_with(prefix)) return nullptr;
    return find_terms(id.substr(prefix.size()));
  }

 private:
  const Model* find_terms(std::string_view terms) {
    const auto first = terms.find(','), second = terms.find(',', first + 1);
    if (first == terms.npos || second == terms.npos) return nullptr;
    const std::string_view d = terms.substr(0, first), f = terms.substr(first + 1, second - first - 1);
    std::string v(terms.substr(second + 1));
    // Smith's term of the distribution; that of GGX for distributions without one of their own.
    if (v == "smith-height" || v == "smith-uncorrelated" || v == "smith-compensated")
      v = (d.starts_with("beckmann") ? "smith-beckmann" : "smith-ggx") + v.substr(5);
    const Term* D = find_term(TermKind::distribution, d);
    const Term* F = find_term(TermKind::fresnel, f);
    const Term* V = find_term(TermKind::visibility, v);
    if (!D || !F || !V) return nullptr;
    for (const Model& each : rows_)
      if (each.distribution == D && each.fresnel == F && each.visibility == V) return &each;
    const std::lock_guard lock(composed_lock_);
    for (const ComposedModel& each : composed_)
      if (each.model.distribution == D && each.model.fresnel == F && each.model.visibility == V)
        return &each.model;
    ComposedModel& composed = composed_.emplace_back();
    compose(*D, *F, *V, composed);
    composed.id = "microfacet:" + std::string(D->id) + ',' + std::string(F->id) + ',' + std::string(V->id);
    composed.title = std::string(D->title) + " / " + std::string(F->title) + " / " + std::string(V->title);
    composed.source = source_of(composed.model);
    composed.model.id = composed.id;
    composed.model.title = composed.title;
    composed.model.source = composed.source;
    // V-grooves conserve energy with any normalised D, and Smith's G with the D that it was derived for. For
    // other mixtures nothing is claimed.
    const bool fits = V->id == "cook-torrance" || (D->id == "ggx" && V->id.starts_with("smith-ggx")) ||
                      (D->id == "beckmann" && V->id.starts_with("smith-beckmann"));
    composed.model.claims = {true, fits && D->normalised, fits ? "" : "energy of this mixture not examined"};
    return &composed.model;
  }

  std::deque<Model::Compiled> compiled_;
  std::deque<ComposedModel> composed_;
  std::vector<Model> rows_, engines_;
  std::mutex composed_lock_;
};

Registry& registry() {
  static Registry registry;
  return registry;
}

}  // namespace

std::string_view name(ModelKind kind) {
  return kind == diffuse ? "diffuse" : kind == specular ? "specular" : "both";
}
std::span<const Model> models() {
  return registry().rows();
}
const Model* find_model(std::string_view id) {
  return registry().find(id);
}

}  // namespace etak
