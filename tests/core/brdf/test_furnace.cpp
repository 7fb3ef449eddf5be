// SPDX-License-Identifier: Apache-2.0
// The white furnace: compares directional albedo with printed numbers, with closed forms, and with the claims
// of each model.
#include <catch2/catch.hpp>
#include <cstdio>
#include <map>
#include <numbers>

#include "core/math/quadrature.h"
#include "tests/core/brdf/random_models.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr double furnace_views[] = {0, 45, 60, 75, 85, 89, 89.9};

double width_of(double e) {
  return std::sqrt(2 / (e + 2));
}

// The directional albedo by another method: over light directions, by Gauss-Legendre quadrature in many
// panels.
double albedo_over_light(const Model& model, const std::vector<double>& values, double theta_v) {
  constexpr int panels = 48;
  double sum = 0;
  const Vec3 v = direction_deg(theta_v, 0);
  for (int i = 0; i < panels; ++i)
    sum += gauss_legendre<10>(
        [&](double theta) {
          double ring = 0;
          for (int j = 0; j < panels; ++j)
            ring += gauss_legendre<10>(
                [&](double phi) {
                  const double s = std::sin(theta), c = std::cos(theta);
                  double rgb[3];
                  model.f64({s * std::cos(phi), s * std::sin(phi), c, v[0], v[1], v[2]}, values.data(), rgb);
                  return rgb[0] * c * s;
                },
                std::numbers::pi * j / panels, std::numbers::pi * (j + 1) / panels);
          return 2 * ring;
        },
        std::numbers::pi / 2 * i / panels, std::numbers::pi / 2 * (i + 1) / panels);
  return sum;
}

// The share of the light from theta_l that leaves in any direction. For models that are not reciprocal this
// differs from the directional albedo and is tested too.
double albedo_of_light(const Model& model, const std::vector<double>& values, double theta_l, double width) {
  AlbedoOptions options;
  options.lobe_width = width;
  options.error = 1e-5;
  return directional_albedo(
      [&](const Directions& d) {
        double rgb[3];
        model.f64({d.vx, d.vy, d.vz, d.lx, d.ly, d.lz}, values.data(), rgb);
        return rgb[0];
      },
      theta_l, options);
}

std::string decimals(double value, int digits) {
  char out[32];
  std::snprintf(out, sizeof out, "%.*f", digits, value);
  return out;
}

// The largest directional albedo of a white lobe, over glosses, or the widths and exponents that fit them, and views.
double largest_albedo(const char* id) {
  const Model& model = *find_model(id);
  double most = 0;
  for (double g = 0; g <= 1; g += 0.125) {
    const double e = std::exp2(12 * g);
    std::vector<double> values;
    for (const Parameter& p : model.parameters)
      values.insert(values.end(), p.color ? 3 : 1,
                    p.role == Role::gloss      ? g
                    : p.role == Role::exponent ? e
                    : p.role == Role::alpha    ? width_of(e)
                    : p.role == Role::n        ? 1.5
                    : p.role == Role::k        ? 1e6  // as good as F = 1
                                               : 1);
    for (const double theta : furnace_views)
      most = std::max(most, albedo(model, values, theta, width_of(e), 1e-6));
  }
  return most;
}

struct PrintedAlbedo {
  const char* id;
  std::vector<double> values;
  double width;
  double albedo[7];  // at `furnace_views`, with three decimals, or one above 10
};

}  // namespace

// Two numbers at 89.9 degrees differ from the printed ones: .667 is the limit at 90 degrees; and 25.7 is
// inaccurate, since the integral over half vectors, with more points at the end of l h, is 25.793.
TEST_CASE("directional albedo comes out as printed") {
  const std::vector<PrintedAlbedo> table = {
      {"microfacet:schueler,schlick,cook-torrance",
       {1, 1, 1, 1},
       width_of(1),
       {.336, .419, .503, .589, .642, .662, .666}},
      {"microfacet:schueler,schlick,cook-torrance",
       {1, 1, 1, 64},
       width_of(64),
       {.985, .981, .962, .918, .941, .975, .984}},
      {"microfacet:schueler,schlick,cook-torrance",
       {1, 1, 1, 4096},
       width_of(4096),
       {1, 1, 1, 1, .994, .941, .992}},
      {"microfacet:schueler,schlick,kelemen",
       {1, 1, 1, 64},
       width_of(64),
       {.954, .937, .904, .826, .792, .879, .962}},
      {"microfacet:schueler,schlick,kelemen",
       {1, 1, 1, 4096},
       width_of(4096),
       {.999, .999, .999, .996, .964, .814, .908}},
      {"schueler-optimized", {1, 1, 1, .5}, width_of(64), {.968, 1.338, 1.791, 2.820, 5.430, 12.3, 25.8}},
      {"schueler-optimized",
       {.04, .04, .04, 1},
       width_of(4096),
       {.040, .057, .080, .154, .439, 1.338, 4.331}},
      {"schueler-optimized-bounded",
       {1, 1, 1, 1},
       width_of(4096),
       {.999, .999, .999, .996, .964, .814, .908}},
      {"blinn-phong", {0, 0, 0, 1, 1, 1, 8}, width_of(8), {1.075, .680, .465, .275, .175, .141, .134}},
      {"microfacet:beckmann,schlick,cook-torrance",
       {1, 1, 1, .3},
       .3,
       {.996, .957, .925, .927, .970, .994, .999}},
      {"microfacet:ggx,schlick,smith-height", {1, 1, 1, .5}, .5, {.688, .683, .698, .761, .872, .960, .994}},
      {"microfacet:ggx,schlick,smith-height", {1, 1, 1, 1}, 1, {.307, .377, .451, .591, .780, .929, .989}},
      {"ashikhmin-shirley-specular",
       {1, 1, 1, 512, 512},
       width_of(512),
       {.992, .961, .935, .865, .682, .539, .504}},
      {"oren-nayar", {1, 1, 1, .3}, .5, {.893, .938, .960, .984, .999, 1.004, 1.005}},
  };
  for (const PrintedAlbedo& row : table)
    for (std::size_t i = 0; i < std::size(furnace_views); ++i) {
      INFO(row.id << " at " << furnace_views[i]);
      const double digits = row.albedo[i] > 10 ? 0.06 : 6e-4;
      CHECK(albedo(*find_model(row.id), row.values, furnace_views[i], row.width) ==
            Approx(row.albedo[i]).epsilon(0).margin(digits));
    }
}

TEST_CASE("the half-vector integral equals one over light directions") {
  for (const auto& [id, values, width] :
       {std::tuple{"microfacet:ggx,schlick,smith-height", std::vector<double>{1, 1, 1, 0.4}, 0.4},
        std::tuple{"blinn-phong", std::vector<double>{0.2, 0, 0, 0.7, 0, 0, 20}, 0.3},
        std::tuple{"schueler-optimized", std::vector<double>{1, 1, 1, 0.3}, 0.4}})
    for (const double theta : {0.0, 50.0, 80.0}) {
      INFO(id << " at " << theta);
      CHECK(albedo(*find_model(id), values, theta, width, 1e-8) ==
            Approx(albedo_over_light(*find_model(id), values, theta)).epsilon(2e-6));
    }
}

TEST_CASE("closed forms at normal incidence") {
  // At normal incidence the exact Blinn-Phong has albedo 1, and the approximate one has
  // (m + 8)(2^(-m/2) + m) / ((m + 2)(m + 4)).
  for (const double m : {1.0, 8.8, 100.0, 4096.0}) {
    const std::vector<double> values{0, 0, 0, 1, 1, 1, m};
    CHECK(albedo(*find_model("blinn-phong-exact"), values, 0, width_of(m), 1e-9) == Approx(1).epsilon(1e-8));
    CHECK(albedo(*find_model("blinn-phong"), values, 0, width_of(m), 1e-9) ==
          Approx((m + 8) * (std::exp2(-m / 2) + m) / ((m + 2) * (m + 4))).epsilon(1e-8));
  }
  for (const double theta : furnace_views)
    CHECK(albedo(*find_model("lambert"), {0.6, 0, 0}, theta, 0.5, 1e-9) == Approx(0.6).epsilon(1e-8));
}

TEST_CASE("energy is conserved where it is claimed, and a counter-example exists where it is not") {
  const double gloss[] = {0, 0.25, 0.5, 0.75, 1};
  for (const Model& model : models()) {
    double most = 0;
    for (const double g : gloss) {
      const double e = std::exp2(12 * g);
      std::vector<double> values;
      for (const Parameter& p : model.parameters) {
        const double value = p.role == Role::gloss      ? g
                             : p.role == Role::exponent ? e
                             : p.role == Role::alpha    ? width_of(e)
                             : p.role == Role::n        ? 1.5
                             : p.role == Role::k        ? 1e4  // as good as F = 1
                             : p.name == "n1"           ? 1
                             : p.name == "sigma"        ? 0.1985 + 0.3 * g
                             : p.name == "a1"           ? e
                             : p.name == "a2"           ? 2
                             : p.name == "p"            ? 1.5
                             : p.name == "fit_a"        ? 0
                             : p.name == "fit_alpha"    ? 5
                                                        : 1;
        for (int c = 0; c < (p.color ? 3 : 1); ++c) values.push_back(value);
      }
      // With both parts white the albedo would be 2, as intended, so the parts are tested one by one.
      const bool parts = model.kind == ModelKind::combined;
      for (int part = 0; part < (parts ? 2 : 1); ++part) {
        std::vector<double> one = values;
        if (parts) set_role(model, part == 0 ? Role::diffuse : Role::f0, 0, one);
        if (model.kind == ModelKind::diffuse) set_role(model, Role::f0, 0.04, one);
        for (const double theta : furnace_views) {
          most = std::max(most, albedo(model, one, theta, width_of(e), 1e-5));
          if (!model.claims.reciprocal)
            most = std::max(most, albedo_of_light(model, one, theta, width_of(e)));
        }
      }
    }
    INFO(model.id << ": albedo up to " << most);
    CHECK(most > 0.01);
    if (model.claims.conserves_energy)
      CHECK(most <= 1.0002);
    else
      CHECK(most > 1.005);
  }
}

TEST_CASE("light between facets brings the white furnace to within 1 % of 1") {
  for (const std::string D : {"ggx", "beckmann"}) {
    const Model &once = *find_model("microfacet:" + D + ",schlick,smith-height"),
                &all = *find_model("microfacet:" + D + ",schlick,smith-compensated");
    double darkest = 1, before = 1;
    for (const double alpha : {0.01, 0.03, 0.05, 0.085, 0.2, 0.35, 0.5, 0.7, 0.9, 1.0})
      for (const double nv : {1.0, 0.8, 0.55, 0.3, 0.15, 0.1, 0.05, 0.02}) {
        const double theta = std::acos(nv) * 180 / std::numbers::pi;
        const double whole = albedo(all, {1, 1, 1, alpha}, theta, alpha, 1e-5);
        INFO(D << " alpha " << alpha << ", nv " << nv);
        CHECK(whole > 0.99);
        CHECK(whole < 1.0002);
        darkest = std::min(darkest, whole);
        before = std::min(before, albedo(once, {1, 1, 1, alpha}, theta, alpha, 1e-5));
      }
    INFO(D << ": " << before << " before, " << darkest << " after");
    CHECK(before == Approx(D == "ggx" ? 0.307 : 0.462).margin(0.002));
  }
}

TEST_CASE("printed claims of single models") {
  const auto K1 = [](double g) { return std::vector<double>{1, 1, 1, g}; };
  CHECK(albedo(*find_model("schueler-optimized"), K1(1), 60, width_of(4096)) == Approx(2).epsilon(0.002));
  CHECK(albedo(*find_model("schueler-optimized"), K1(1), 89.9, width_of(4096)) == Approx(108).epsilon(0.01));
  CHECK(albedo_of_light(*find_model("phong"), {0, 0, 0, 1, 1, 1, 1}, 89.9, 0.8) == Approx(122).epsilon(0.01));
  CHECK(albedo_of_light(*find_model("phong"), {0, 0, 0, 1, 1, 1, 8}, 0, 0.4) == Approx(0.2).epsilon(1e-4));
  CHECK(albedo(*find_model("cook-torrance-printed"), {1.5, 1.5, 1.5, 1e4, 1e4, 1e4, 0.05}, 0, 0.05) ==
        Approx(std::numbers::pi / 4).epsilon(1e-3));
  double worst = 0;
  for (const double K : {.04, .5, .9, 1.0})
    for (double g = 0; g <= 1; g += 0.125)
      for (const double theta : furnace_views)
        worst = std::max(worst, albedo(*find_model("schueler-optimized-bounded"), {K, K, K, g}, theta,
                                       width_of(std::exp2(12 * g)), 1e-5));
  CHECK(worst <= 0.9994);
}

TEST_CASE("each number that etak models claims of a model is a computed one") {
  const auto up_to = [](const char* id, int digits) {
    return "albedo up to " + decimals(largest_albedo(id), digits);
  };
  const auto head_on = [](const char* id, std::vector<double> values, double width, int digits) {
    return decimals(albedo(*find_model(id), values, 0, width, 1e-8), digits);
  };
  std::map<std::string_view, std::string> computed;
  for (const auto& [id, digits] :
       {std::pair("schueler-full", 4), std::pair("schueler-optimized-bounded", 4),
        std::pair("cook-torrance", 4), std::pair("beckmann-schlick", 4), std::pair("phong-implicit", 3),
        std::pair("ashikhmin-shirley-specular", 3)})
    computed[id] = up_to(id, digits);
  computed["cook-torrance-printed"] = "pi / 4 too dark: " + up_to("cook-torrance-printed", 4);
  computed["schueler-simplified"] = up_to("schueler-simplified", 4) + "; " +
                                    head_on("schueler-simplified", {1, 1, 1, 0}, 1, 2) +
                                    " at g = 0, normal incidence";
  double dip = 1, dip_view = 0;
  for (const double theta : furnace_views)
    if (const double here = albedo(*find_model("schueler-ksk"), {1, 1, 1, 1}, theta, width_of(4096), 1e-6);
        here < dip)
      dip = here, dip_view = theta;
  computed["schueler-ksk"] = up_to("schueler-ksk", 4) + "; dips to " + decimals(dip, 2) + " at g = 1, " +
                             decimals(dip_view, 0) + " degrees";
  computed["schueler-optimized"] =
      "hidden Fresnel K / lh: albedo K / cos, " +
      decimals(albedo(*find_model("schueler-optimized"), {1, 1, 1, 1}, 60, width_of(4096)), 1) +
      " at 60 degrees for K = 1";
  computed["phong"] = "not a BRDF: grows as 1 / nl (albedo " +
                      decimals(albedo_of_light(*find_model("phong"), {0, 0, 0, 1, 1, 1, 1}, 89.9, 0.8), 0) +
                      " at m = 1, 89.9 degrees)";
  double loudest = 0, at_m = 0;  // of the closed form at normal incidence
  for (double m = 0.1; m < 100; m += 0.1)
    if (const double here = (m + 8) * (std::exp2(-m / 2) + m) / ((m + 2) * (m + 4)); here > loudest)
      loudest = here, at_m = m;
  computed["blinn-phong"] =
      "albedo " + decimals(loudest, 3) + " at m = " + decimals(at_m, 1) + ", normal incidence";
  computed["blinn-phong-exact"] = "albedo of the specular part " +
                                  head_on("blinn-phong-exact", {0, 0, 0, 1, 1, 1, 8}, 0.4, 0) +
                                  " at normal incidence";
  double brightest = 0, at_sigma = 0;  // A + B / 2, Oren-Nayar's closed form for a view along the surface
  for (double sigma = 0; sigma < 1.5; sigma += 1e-4) {
    const double s2 = sigma * sigma, here = 1 - s2 / 2 / (s2 + 0.33) + 0.225 * s2 / (s2 + 0.09);
    if (here > brightest) brightest = here, at_sigma = sigma;
  }
  computed["oren-nayar"] =
      "albedo up to " + decimals(brightest, 4) + " (sigma " + decimals(at_sigma, 4) + ", grazing)";
  double diffuse = 0;
  for (const double theta : furnace_views)
    diffuse = std::max(
        diffuse, albedo(*find_model("ashikhmin-shirley-diffuse"), {.04, .04, .04, 1, 1, 1}, theta, 0.5));
  computed["ashikhmin-shirley-diffuse"] = "albedo up to " + decimals(diffuse, 2) + " (rs = 0.04)";
  // GGX at width 1, head on: 1 - ln 2 by Smith's masking, 3 / 8 by V-grooves, whatever the Fresnel term of a white metal.
  for (const Model& model : models()) {
    if (model.claims.note.find("alpha = 1") == std::string_view::npos) continue;
    const bool grooves = model.visibility->id == "cook-torrance";
    computed[model.id] = "albedo below 1; " +
                         (grooves ? decimals(0.375, 3) : decimals(1 - std::numbers::ln2, 2)) +
                         " at alpha = 1, normal incidence";
    CHECK(albedo(*find_model("microfacet:ggx,schlick," + std::string(model.visibility->id)), {1, 1, 1, 1}, 0,
                 1, 1e-6) == Approx(grooves ? 0.375 : 1 - std::numbers::ln2).margin(1e-4));
  }
  for (const Model& model : models()) {
    if (model.claims.note.find_first_of("0123456789") == std::string_view::npos) continue;
    // That of light between facets has a test of its own, and that of fitted numbers claims none.
    if (model.claims.note.starts_with("white furnace") || model.id == "ggx-lazanyi") continue;
    INFO(model.id);
    CHECK(model.claims.note == computed[model.id]);
  }
}

TEST_CASE("Oren-Nayar's albedo peaks at grazing view at 1.0152") {
  const double most = oren_nayar_grazing_albedo_max();
  CHECK(most == Approx(1.0152).margin(5e-5));
  double found = 0;
  for (double sigma = 0.15; sigma <= 0.25; sigma += 0.0125)
    for (const double theta : {80.0, 88.0, 89.99})
      found = std::max(found, albedo(*find_model("oren-nayar"), {1, 1, 1, sigma}, theta, 0.5, 1e-8));
  CHECK(found <= most + 1e-6);
  CHECK(found > most - 2e-4);
}

TEST_CASE("half spaces split the albedo, and anisotropic models need the whole turn") {
  const Model& model = *find_model("schueler-simplified");
  const double values[] = {0.5, 0.5, 0.5, 0.6};
  const auto f = [&](const Directions& d) {
    double rgb[3];
    model.f64(d, values, rgb);
    return rgb[0];
  };
  for (const double tilt : {0.0, 20.0, 70.0, 100.0, 150.0})
    for (const double turn : {0.0, 40.0, 180.0}) {
      AlbedoOptions options;
      options.lobe_width = width_of(std::exp2(7.2));
      const double whole = directional_albedo(f, 50, options);
      const Vec3 z = direction_deg(tilt, turn);
      options.half_space = z;
      const double there = directional_albedo(f, 50, options);
      options.half_space = Vec3{-z[0], -z[1], -z[2]};
      INFO("axis at " << tilt << ' ' << turn);
      CHECK(there + directional_albedo(f, 50, options) == Approx(whole).epsilon(2e-6));
      if (tilt == 0) CHECK(there == Approx(whole).epsilon(1e-6));
    }
}
