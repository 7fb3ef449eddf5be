// SPDX-License-Identifier: Apache-2.0
// Properties that every row of the registry must have.
#include <catch2/catch.hpp>
#include <numbers>
#include <set>

#include "tests/core/brdf/random_models.h"

using namespace etak;
using namespace etak::test;

namespace {

using Rgb = std::array<double, 3>;

Rgb f64(const Model& model, const Directions& d, const std::vector<double>& values) {
  Rgb rgb;
  model.f64(d, values.data(), rgb.data());
  return rgb;
}

Directions swapped(const Directions& d) {
  return {d.vx, d.vy, d.vz, d.lx, d.ly, d.lz};
}

// Extreme values for each role, which find divisions by zero and overflows.
std::vector<std::pair<Role, double>> stresses() {
  return {{Role::gloss, 0},   {Role::gloss, 1},    {Role::f0, 0},          {Role::f0, 1.0 / 60},
          {Role::f0, 1},      {Role::f0, 1.022},   {Role::f0, -0.01},      {Role::f0, 1.5},
          {Role::f0, 100},    {Role::f0, -0.2},    {Role::f82, 0},         {Role::f82, 1},
          {Role::diffuse, 0}, {Role::diffuse, 1},  {Role::n, 1},           {Role::n, 0.01},
          {Role::n, 1.0003},  {Role::k, 0},        {Role::k, 1e3},         {Role::alpha, 1e-4},
          {Role::alpha, 1},   {Role::exponent, 1}, {Role::exponent, 4096}, {Role::exponent, 1e6}};
}

}  // namespace

TEST_CASE("the registry has every model of the sources") {
  std::set<std::string_view> ids;
  for (const Model& model : models()) {
    CHECK(ids.insert(model.id).second);
    CHECK(!model.title.empty());
    CHECK(!model.source.empty());
    CHECK(!model.files.empty());
    CHECK(!model.entry.empty());
    for (const Parameter& p : model.parameters) {
      INFO(model.id << ' ' << p.name);
      CHECK(!p.meaning.empty());
      CHECK(p.min < p.max);
      CHECK(p.min <= p.initial);
      CHECK(p.initial <= p.max);
    }
    CHECK(find_model(model.id) == &model);
  }
  for (const auto* id : {"lambert",
                         "lambert-tradeoff",
                         "oren-nayar",
                         "schueler-full",
                         "schueler-simplified",
                         "schueler-ksk",
                         "schueler-optimized",
                         "schueler-optimized-bounded",
                         "phong",
                         "blinn-phong",
                         "blinn-phong-exact",
                         "cook-torrance",
                         "cook-torrance-printed",
                         "ashikhmin-shirley",
                         "ashikhmin-shirley-specular",
                         "ashikhmin-shirley-diffuse",
                         "ggx-schlick",
                         "ggx-exact",
                         "ggx-f82",
                         "ggx-f82-tint",
                         "beckmann-smith",
                         "abc-schlick",
                         "sgd-schlick"})
    CHECK(ids.contains(id));
  CHECK(find_model(default_diffuse));
  CHECK(find_model(default_specular));
  CHECK(find_model("none") == nullptr);
  CHECK(terms().size() >= 26);
}

TEST_CASE("any three terms make a model, and the fused ones are their product") {
  Random random(11);
  for (const Term& D : terms())
    for (const Term& F : terms())
      for (const Term& V : terms()) {
        if (D.kind != TermKind::distribution || F.kind != TermKind::fresnel || V.kind != TermKind::visibility)
          continue;
        const std::string id =
            "microfacet:" + std::string(D.id) + ',' + std::string(F.id) + ',' + std::string(V.id);
        const Model* model = find_model(id);
        INFO(id);
        REQUIRE(model);
        REQUIRE(model->parameters.size() >= F.parameters.size());
        const std::vector<double> values = random_values(random, *model);
        const Directions d = random_directions(random);
        // Each term is evaluated alone, with its parameters found by name.
        const auto term = [&](const Term& t) {
          std::vector<double> own;
          for (const Parameter& p : t.parameters) {
            std::size_t at = 0;
            for (const Parameter& all : model->parameters) {
              if (all.name == p.name) break;
              at += all.color ? 3 : 1;
            }
            own.insert(own.end(), values.begin() + static_cast<std::ptrdiff_t>(at),
                       values.begin() + static_cast<std::ptrdiff_t>(at) + (p.color ? 3 : 1));
          }
          own.resize(std::max<std::size_t>(own.size(), 1));
          Rgb out;
          t.f64(d, own.data(), out.data());
          return out;
        };
        const Rgb whole = f64(*model, d, values), d_ = term(D), f = term(F), v = term(V);
        for (std::size_t c = 0; c < 3; ++c) {
          const double once = std::max(f[c], 0.0) * d_[c] * v[0];
          if (V.compensated) {
            CHECK(whole[c] >= once * (1 - 1e-12) - 1e-300);
            CHECK(whole[c] <= (once + v[1]) * (1 + 1e-12));
          } else {
            CHECK(whole[c] == Approx(once).epsilon(1e-12).margin(1e-300));
          }
        }
      }
}

TEST_CASE("light between facets has the colours of two and more reflections") {
  // The means of F over a diffuse hemisphere: Schlick's and F82's in closed form, the exact one by a fine sum.
  const double F0 = 0.3, F82 = 0.35, m = 1 - 1.0 / 7, n = 0.27, k = 2.77, width = 0.7;
  const double schlick = (1 + 20 * F0) / 21;
  const double dip = (F0 + (1 - F0) * std::pow(m, 5) - F82) * 7 / std::pow(m, 6);
  double exact = 0;
  for (int i = 0; i < 2000; ++i) {
    const double c = (i + 0.5) / 2000, s = std::sqrt(1 - c * c), values[6] = {n, n, n, k, k, k};
    double f[3];
    find_term(TermKind::fresnel, "exact")->f64({s, 0, c, -s, 0, c}, values, f);
    exact += 2 * c * f[0] / 2000;
  }
  struct Case {
    const char* fresnel;
    std::vector<double> values;
    double mean, tolerance;
  };
  const Directions d = directions_deg(50, 20, 140);
  double v[3];
  find_term(TermKind::visibility, "smith-ggx-compensated")->f64(d, &width, v);
  for (const Case& each : {Case{"schlick", {F0, F0, F0}, schlick, 1e-12},
                           Case{"f82", {F0, F0, F0, F82, F82, F82}, schlick - dip / 126, 1e-12},
                           Case{"exact", {n, n, n, k, k, k}, exact, 1e-4}}) {
    INFO(each.fresnel);
    std::vector<double> values = each.values;
    values.push_back(width);
    const auto of = [&](const char* masking) {
      return f64(*find_model(std::string("microfacet:ggx,") + each.fresnel + "," + masking), d, values)[0];
    };
    // F^2 L (1 - L) + F^3 L^2 (1 - L) + ... of the mean loss L leaves; L of it is what the lobe for F = 1 has.
    double light = 0, in_facets = each.mean * v[2];
    for (int i = 0; i < 200; ++i, in_facets *= each.mean * v[2]) light += in_facets * each.mean * (1 - v[2]);
    CHECK(of("smith-compensated") - of("smith-height") ==
          Approx(light / v[2] * v[1]).epsilon(each.tolerance));
  }
}

TEST_CASE("no model is negative, and none leaves finite numbers") {
  for (const Model& model : models()) {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
      const std::vector<double> values = random_values(random, model);
      for (const double each : f64(model, random_directions(random, 1e-6), values)) {
        INFO(model.id);
        REQUIRE(std::isfinite(each));
        REQUIRE(each >= 0);
      }
    }
  }
}

TEST_CASE("every model survives extreme parameters at ordinary and grazing directions") {
  const double angles[] = {0, 45, 89, 89.99, 89.999999};
  for (const Model& model : models())
    for (const auto& [role, value] : stresses()) {
      if (!has_role(model, role)) continue;
      Random random(2);
      std::vector<double> values = random_values(random, model);
      set_role(model, role, value, values);
      for (const double theta_l : angles)
        for (const double theta_v : angles)
          for (const double phi : {0.0, 90.0, 180.0, 179.9999}) {
            const Directions d = directions_deg(theta_l, theta_v, phi);
            float one[3];
            model.f32(d, values.data(), one);
            const Rgb rgb = f64(model, d, values);
            const std::array<float, 3> loop = by_loop(model, d, values), far = by_far_loop(model, d, values);
            for (std::size_t c = 0; c < 3; ++c) {
              INFO(model.id << ", role " << static_cast<int>(role) << " = " << value << ", " << theta_l << ' '
                            << theta_v << ' ' << phi);
              REQUIRE(std::isfinite(rgb[c]));
              REQUIRE(rgb[c] >= 0);
              for (const float each : {one[c], loop[c], far[c]}) {
                REQUIRE(std::isfinite(each));
                REQUIRE(each >= 0);
              }
            }
          }
    }
}

TEST_CASE("every model is zero below the horizon, on it, and for l = -v") {
  for (const Model& model : models()) {
    Random random(3);
    const std::vector<double> values = random_values(random, model);
    INFO(model.id);
    for (const Directions& d :
         {directions_deg(90, 30, 180), directions_deg(30, 90, 180), directions_deg(120, 30, 0),
          directions_deg(30, 120, 0), directions_deg(90, 90, 180), directions_deg(60, 120, 180),
          Directions{0, 0, 1, 0, 0, -1}, Directions{1, 0, 0, -1, 0, 0}}) {
      CHECK(f64(model, d, values) == Rgb{0, 0, 0});
      float one[3];
      model.f32(d, values.data(), one);
      CHECK(one[0] == 0);
      CHECK(by_loop(model, d, values) == std::array<float, 3>{0, 0, 0});
      CHECK(by_far_loop(model, d, values) == std::array<float, 3>{0, 0, 0});
    }
  }
}

TEST_CASE("reciprocity holds where it is claimed and fails where it is not") {
  for (const Model& model : models()) {
    Random random(4);
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
      const std::vector<double> values = random_values(random, model);
      const Directions d = random_directions(random);
      const double there = f64(model, d, values)[0], back = f64(model, swapped(d), values)[0];
      worst = std::max(worst, std::abs(there - back) / std::max({there, back, 1e-30}));
    }
    INFO(model.id << " off by " << worst);
    if (model.claims.reciprocal)
      CHECK(worst < 1e-9);
    else
      CHECK(worst > 0.1);
  }
}

TEST_CASE("isotropic models do not change with a turn about the normal, Ashikhmin-Shirley does") {
  const double turn = 0.7;
  for (const Model& model : models()) {
    Random random(5);
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
      const std::vector<double> values = random_values(random, model);
      const Directions d = random_directions(random);
      const auto turned = [&](double x, double y) {
        return std::pair{x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn)};
      };
      const auto [lx, ly] = turned(d.lx, d.ly);
      const auto [vx, vy] = turned(d.vx, d.vy);
      const double before = f64(model, d, values)[0],
                   after = f64(model, {lx, ly, d.lz, vx, vy, d.vz}, values)[0];
      worst = std::max(worst, std::abs(before - after) / std::max({before, after, 1e-30}));
    }
    INFO(model.id);
    if (model.id == "ashikhmin-shirley" || model.id == "ashikhmin-shirley-specular")
      CHECK(worst > 0.1);
    else
      CHECK(worst < 1e-8);
  }
}

TEST_CASE("parameters come back in the printed formulas: values at one pair of directions by hand") {
  // l is at 30 degrees and v at 40 degrees on opposite sides, so h is at 5 degrees towards v, and
  // l.h = cos 35.
  const Directions d = directions_deg(30, 40, 180);
  const auto c = [](double deg) { return std::cos(deg * std::numbers::pi / 180); };
  const double nl = c(30), nv = c(40), nh = c(5), lh = c(35), g = 0.5, e = 64, K = 0.2;
  const double F = K + (1 - K) * std::pow(1 - lh, 4);
  const double G = std::min({1.0, 2 * nh * nv / lh, 2 * nh * nl / lh});
  const double D = (1 + e) / 2 * std::pow(nh, e);
  const std::vector<double> Kg{K, K, K, g};
  CHECK(std::numbers::pi * nl * f64(*find_model("schueler-simplified"), d, Kg)[0] ==
        Approx(D * F * G / (4 * nv)).epsilon(1e-12));
  CHECK(std::numbers::pi * nl * f64(*find_model("schueler-ksk"), d, Kg)[0] ==
        Approx(D * F / (4 * lh * lh) * nl).epsilon(1e-12));
  CHECK(std::numbers::pi * nl * f64(*find_model("schueler-optimized"), d, Kg)[0] ==
        Approx(K * (1 + e) / (8 * lh * lh * lh) * std::pow(nh, e) * nl).epsilon(1e-12));
  CHECK(f64(*find_model("schueler-optimized-bounded"), d, Kg)[0] ==
        Approx(std::min(K / lh, 1.0) / (lh * lh) * (1 + e) / 8 * std::pow(nh, e) / std::numbers::pi)
            .epsilon(1e-12));

  const double m = 0.3, tan2 = std::pow(std::tan(5 * std::numbers::pi / 180), 2);
  const double beckmann = std::exp(-tan2 / (m * m)) / (std::numbers::pi * m * m * std::pow(nh, 4));
  const std::vector<double> glass{1.5, 1.5, 1.5, 0, 0, 0, m};
  // Two clear media at 35 degrees, sin_t = sin 35 / 1.5.
  const double st = std::sin(35 * std::numbers::pi / 180) / 1.5, ct = std::sqrt(1 - st * st);
  const double rs = (lh - 1.5 * ct) / (lh + 1.5 * ct), rp = (ct - 1.5 * lh) / (ct + 1.5 * lh),
               R = (rs * rs + rp * rp) / 2;
  CHECK(f64(*find_model("cook-torrance"), d, glass)[0] ==
        Approx(beckmann * R * G / (4 * nl * nv)).epsilon(1e-12));
  CHECK(f64(*find_model("cook-torrance-printed"), d, glass)[0] ==
        Approx(beckmann * R * G / (4 * nl * nv) * std::numbers::pi / 4).epsilon(1e-12));

  const std::vector<double> phong{0.3, 0.3, 0.3, 0.2, 0.2, 0.2, 8};
  CHECK(std::numbers::pi * nl * f64(*find_model("phong"), d, phong)[0] ==
        Approx(0.3 * nl + 0.2 * std::pow(c(10), 8)).epsilon(1e-12));
  CHECK(f64(*find_model("blinn-phong"), d, phong)[0] ==
        Approx(0.3 / std::numbers::pi + 16 / (8 * std::numbers::pi) * 0.2 * std::pow(nh, 8)).epsilon(1e-12));

  const double a2 = 0.09, t = nh * nh * (a2 - 1) + 1;
  const double V = 0.5 / (nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2));
  const double S = 0.04 + 0.96 * std::pow(1 - lh, 5);
  CHECK(f64(*find_model("ggx-schlick"), d, {0.04, 0.04, 0.04, 0.3})[0] ==
        Approx(a2 / (std::numbers::pi * t * t) * V * S).epsilon(1e-12));

  const double s2 = 0.09, A = 1 - 0.5 * s2 / (s2 + 0.33);  // at opposite azimuths there is no B part
  CHECK(f64(*find_model("oren-nayar"), d, {0.8, 0.8, 0.8, 0.3})[0] ==
        Approx(0.8 / std::numbers::pi * A).epsilon(1e-12));
  // At equal azimuths, B is multiplied by the sine of the larger angle and the tangent of the smaller one.
  const double B = 0.45 * s2 / (s2 + 0.09);
  const double near = std::sin(40 * std::numbers::pi / 180) * std::tan(30 * std::numbers::pi / 180);
  CHECK(f64(*find_model("oren-nayar"), directions_deg(30, 40, 0), {0.8, 0.8, 0.8, 0.3})[0] ==
        Approx(0.8 / std::numbers::pi * (A + B * near)).epsilon(1e-12));

  // For Ashikhmin-Shirley with h in the plane of the tangent, only nu matters.
  const double as =
      std::sqrt(101.0 * 11) / (8 * std::numbers::pi) * std::pow(nh, 100) * S / (lh * std::max(nl, nv));
  CHECK(f64(*find_model("ashikhmin-shirley-specular"), d, {0.04, 0.04, 0.04, 100, 10})[0] ==
        Approx(as).epsilon(1e-12));
  const double ad = 28 * 0.5 / (23 * std::numbers::pi) * (1 - 0.04) * (1 - std::pow(1 - nl / 2, 5)) *
                    (1 - std::pow(1 - nv / 2, 5));
  CHECK(f64(*find_model("ashikhmin-shirley-diffuse"), d, {0.04, 0.04, 0.04, 0.5, 0.5, 0.5})[0] ==
        Approx(ad).epsilon(1e-12));
}

TEST_CASE("Ashikhmin-Shirley at the mirror direction takes the exponent 0") {
  const double value =
      f64(*find_model("ashikhmin-shirley-specular"), directions_deg(20, 20, 180), {1, 1, 1, 100, 10})[0];
  const double c = std::cos(20 * std::numbers::pi / 180);
  CHECK(value == Approx(std::sqrt(101.0 * 11) / (8 * std::numbers::pi) / (c * c)).epsilon(1e-12));
}

TEST_CASE("a lobe of exponent 4096 keeps its digits beside the peak in float") {
  const Model& model = *find_model("blinn-phong");
  const std::vector<double> values{0, 0, 0, 1, 1, 1, 4096};
  for (const double degrees : {0.01, 0.1, 0.5, 1.0, 2.0}) {
    const Directions d = directions_deg(0, 2 * degrees, 0);
    float one[3];
    model.f32(d, values.data(), one);
    CHECK(one[0] == Approx(f64(model, d, values)[0]).epsilon(2e-5));
    CHECK(f64(model, d, values)[0] ==
          Approx(4104 / (8 * std::numbers::pi) * std::pow(std::cos(degrees * std::numbers::pi / 180), 4096))
              .epsilon(1e-10));
  }
}
