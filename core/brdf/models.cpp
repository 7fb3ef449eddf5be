// SPDX-License-Identifier: Apache-2.0
// The registry: a row per model. A new model is a text, a line in models.inc and a row here; a new
// combination of terms is a line in `microfacet_rows` (and one in models.inc to have it as one vectorised
// loop).
#include "core/brdf/models.h"

#include <deque>
#include <mutex>

#include "core/brdf/compose.h"
#include "core/brdf/parameters.h"

namespace etak {
namespace {

namespace p = parameters;
using Files = std::span<const std::string_view>;

constexpr Parameter lambert[] = {p::diffuse_color};
constexpr Parameter tradeoff[] = {p::diffuse_color, p::f0};
constexpr Parameter oren_nayar[] = {{"rho", "albedo", "", 0, 1, 0.5, Role::diffuse, true},
                                    {"sigma", "standard deviation of the facets' slope angle", "rad", 0,
                                     1.5707963267948966, 0.3, Role::other, false}};
constexpr Parameter phong[] = {p::diffuse_color, p::specular_color, p::m_exponent};
constexpr Parameter cook_torrance[] = {p::n, p::k, p::m_slope};
constexpr Parameter as_rd{"rd", "diffuse colour", "", 0, 1, 0.5, Role::diffuse, true};
constexpr Parameter as_rs{"rs", "specular colour", "", 0, 1, 0.04, Role::f0, true};
constexpr Parameter as_nu{"nu", "exponent along the tangent", "", 0, 1e6, 512, Role::exponent, false};
constexpr Parameter as_nv{"nv", "exponent along the bitangent", "", 0, 1e6, 512, Role::exponent, false};
constexpr Parameter as_both[] = {as_rd, as_rs, as_nu, as_nv};
constexpr Parameter as_specular[] = {as_rs, as_nu, as_nv};
constexpr Parameter as_diffuse[] = {as_rs, as_rd};
constexpr Parameter schueler[] = {p::K, p::g};
constexpr Parameter schueler_full[] = {p::n, p::k, p::g};

constexpr std::string_view lambert_files[] = {"fresnel/schlick.glsl", "brdf/geometry.glsl",
                                              "brdf/lambert.glsl"};
constexpr std::string_view oren_nayar_files[] = {"brdf/geometry.glsl", "brdf/oren_nayar.glsl"};
constexpr std::string_view phong_files[] = {"brdf/geometry.glsl", "brdf/microfacet.glsl", "brdf/phong.glsl"};
constexpr std::string_view blinn_files[] = {"brdf/geometry.glsl", "brdf/microfacet.glsl",
                                            "brdf/blinn_phong.glsl"};
constexpr std::string_view cook_torrance_files[] = {"fresnel/conductor.glsl", "brdf/geometry.glsl",
                                                    "brdf/d_beckmann.glsl", "brdf/g_cook_torrance.glsl",
                                                    "brdf/cook_torrance.glsl"};
constexpr std::string_view as_files[] = {"fresnel/schlick.glsl", "brdf/geometry.glsl", "brdf/microfacet.glsl",
                                         "brdf/lambert.glsl", "brdf/ashikhmin_shirley.glsl"};
constexpr std::string_view schueler_files[] = {
    "fresnel/conductor.glsl",    "fresnel/schueler.glsl", "brdf/geometry.glsl",
    "brdf/gloss.glsl",           "brdf/d_beckmann.glsl",  "brdf/d_phong.glsl",
    "brdf/g_cook_torrance.glsl", "brdf/g_simple.glsl",    "brdf/schueler.glsl"};

constexpr ModelKind diffuse = ModelKind::diffuse, specular = ModelKind::specular,
                    combined = ModelKind::combined;

struct TextRow {
  std::string_view id, title, source;
  ModelKind kind;
  Claims claims;
  std::span<const Parameter> parameters;
  Files files;
  std::string_view entry;
};

constexpr TextRow text_rows[] = {
    {"lambert",
     "Lambert",
     "Lambert 1760; Schueler 2009; Hoffman; TU Graz",
     diffuse,
     {true, true, "albedo cd"},
     lambert,
     lambert_files,
     "brdf_lambert"},
    {"lambert-tradeoff",
     "Lambert with what the specular part leaves",
     "Hoffman, diffuse-specular tradeoff; reciprocal form",
     diffuse,
     {true, true, {}},
     tradeoff,
     lambert_files,
     "brdf_lambert_tradeoff"},
    {"oren-nayar",
     "Oren-Nayar, qualitative",
     "Oren and Nayar 1994, eq. 30; cited by Hoffman and TU Graz",
     diffuse,
     {true, false, "albedo up to 1.0152 (sigma 0.1985, grazing)"},
     oren_nayar,
     oren_nayar_files,
     "brdf_oren_nayar"},
    {"schueler-full",
     "CookTorranceFull",
     "Schueler 2009, technique 1",
     specular,
     {true, true, "albedo up to 1.0000"},
     schueler_full,
     schueler_files,
     "brdf_schueler_full"},
    {"schueler-simplified",
     "CookTorranceSimplified",
     "Schueler 2009, technique 2, as printed",
     specular,
     {true, true, "albedo up to 0.9998; 0.34 at g = 0, normal incidence"},
     schueler,
     schueler_files,
     "brdf_schueler_simplified"},
    {"schueler-ksk",
     "KelemenSzirmayKalos",
     "Schueler 2009, technique 3, as printed",
     specular,
     {true, true, "albedo up to 0.9993; dips to 0.81 at g = 1, 89 degrees"},
     schueler,
     schueler_files,
     "brdf_schueler_ksk"},
    {"schueler-optimized",
     "Optimized, as printed",
     "Schueler 2009, technique 4, as printed",
     specular,
     {true, false, "hidden Fresnel K / lh: albedo K / cos, 2.0 at 60 degrees for K = 1"},
     schueler,
     schueler_files,
     "brdf_schueler_optimized"},
    {"schueler-optimized-bounded",
     "Optimized, bounded",
     "Schueler 2009, technique 4 with K / lh kept at or below 1",
     specular,
     {true, true, "albedo up to 0.9993"},
     schueler,
     schueler_files,
     "brdf_schueler_optimized_bounded"},
    {"phong",
     "Phong, as printed",
     "Phong 1975; TU Graz, over pi nl; specular gated by nl > 0",
     combined,
     {false, false, "not a BRDF: grows as 1 / nl (albedo 122 at m = 1, 89.9 degrees)"},
     phong,
     phong_files,
     "brdf_phong"},
    {"blinn-phong",
     "Blinn-Phong, (m + 8) / (8 pi)",
     "Blinn 1977; TU Graz",
     combined,
     {true, false, "albedo 1.075 at m = 8.8, normal incidence"},
     phong,
     blinn_files,
     "brdf_blinn_phong"},
    {"blinn-phong-exact",
     "Blinn-Phong, exact normalisation",
     "Blinn 1977; Giesen 2009",
     combined,
     {true, true, "albedo of the specular part 1 at normal incidence"},
     phong,
     blinn_files,
     "brdf_blinn_phong_exact"},
    {"cook-torrance",
     "Cook-Torrance",
     "Cook and Torrance 1981; TU Graz, with 1 / (pi m^2)",
     specular,
     {true, true, "albedo up to 1.0000"},
     cook_torrance,
     cook_torrance_files,
     "brdf_cook_torrance"},
    {"cook-torrance-printed",
     "Cook-Torrance, as printed",
     "TU Graz, with 1 / (4 m^2)",
     specular,
     {true, true, "pi / 4 too dark: albedo up to 0.7854"},
     cook_torrance,
     cook_torrance_files,
     "brdf_cook_torrance_printed"},
    {"ashikhmin-shirley",
     "Ashikhmin-Shirley",
     "Ashikhmin and Shirley 2000; cited by TU Graz",
     combined,
     {true, true, {}},
     as_both,
     as_files,
     "brdf_ashikhmin_shirley"},
    {"ashikhmin-shirley-specular",
     "Ashikhmin-Shirley, specular part",
     "Ashikhmin and Shirley 2000, eq. 4",
     specular,
     {true, true, "albedo up to 0.999"},
     as_specular,
     as_files,
     "brdf_ashikhmin_shirley_specular"},
    {"ashikhmin-shirley-diffuse",
     "Ashikhmin-Shirley, diffuse part",
     "Ashikhmin and Shirley 2000, eq. 5",
     diffuse,
     {true, true, "albedo up to 0.93 (rs = 0.04)"},
     as_diffuse,
     as_files,
     "brdf_ashikhmin_shirley_diffuse"},
};

struct MicrofacetRow {
  std::string_view id, title;
  std::string_view D, F, V;
  Claims claims;
};

constexpr Claims ggx_height{true, true, "albedo below 1; 0.31 at alpha = 1, normal incidence"};
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
      rows_.push_back(model);
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
    for (const Model& each : rows_)
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
    if (v == "smith-height" ||
        v == "smith-uncorrelated")  // of the distribution; GGX's where it has none of its own
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
    // V-grooves and Smith's G are energy-conserving for any normalised D of theirs; of other mixtures nothing
    // is claimed.
    const bool fits = V->id == "cook-torrance" || (D->id == "ggx" && V->id.starts_with("smith-ggx")) ||
                      (D->id == "beckmann" && V->id.starts_with("smith-beckmann"));
    composed.model.claims = {true, fits && D->normalised, fits ? "" : "energy of this mixture not examined"};
    return &composed.model;
  }

  std::deque<Model::Compiled> compiled_;
  std::deque<ComposedModel> composed_;
  std::vector<Model> rows_;
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
