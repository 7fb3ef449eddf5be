// SPDX-License-Identifier: Apache-2.0
// Compares the formula texts in float, and in vectorised loops, with those in double.
#include <catch2/catch.hpp>

#include "tests/core/brdf/random_models.h"

using namespace etak;
using namespace etak::test;

namespace {

// The error of single precision that the operations of a formula allow, relative to max(|f64|, 1e-4 of the
// peak).
double tolerance(const Model& model) {
  const auto uses = [&](std::string_view file) {
    return std::find(model.files.begin(), model.files.end(), file) != model.files.end();
  };
  const bool schueler = model.id.starts_with("schueler") && model.id != "schueler-full";
  if (schueler || uses("brdf/phong.glsl") || uses("brdf/blinn_phong.glsl") ||
      uses("brdf/ashikhmin_shirley.glsl") || uses("brdf/d_phong.glsl") || uses("brdf/d_abc.glsl") ||
      uses("brdf/d_sgd.glsl") || uses("fresnel/lazanyi.glsl"))
    if (model.id != "ashikhmin-shirley-diffuse" && model.id != "schueler-full") return 5e-4;
  if (uses("fresnel/conductor.glsl") || uses("fresnel/dielectric.glsl")) return 1e-4;
  if (model.kind == ModelKind::diffuse) return 1e-6;
  return 5e-5;
}

Directions in_floats(const Directions& d) {
  return {rounded(d.lx), rounded(d.ly), rounded(d.lz), rounded(d.vx), rounded(d.vy), rounded(d.vz)};
}

double peak(const Model& model, const std::vector<double>& values, Random& random) {
  double most = 0, rgb[3];
  const auto look = [&](const Directions& d) {
    model.f64(d, values.data(), rgb);
    for (const double each : rgb) most = std::max(most, each);
  };
  for (const double theta : {0.0, 30.0, 60.0, 80.0}) look(directions_deg(theta, theta, 180));
  for (int i = 0; i < 16; ++i) look(random_directions(random));
  return most;
}

}  // namespace

TEST_CASE(
    "float, vector lanes and their form for far lights agree with double on 20,000 random inputs of every model") {
  constexpr std::size_t per_set = 100, sets = 200;
  for (const Model& model : models()) {
    Random random(7);
    double worst_one = 0, worst_many = 0, worst_far = 0;
    for (std::size_t set = 0; set < sets; ++set) {
      std::vector<double> values = random_values(random, model);
      for (double& each : values) each = rounded(each);
      const double floor = 1e-4 * peak(model, values, random);
      std::vector<std::vector<float>> in(6, std::vector<float>(per_set)), out(3, std::vector<float>(per_set));
      std::vector<Directions> pairs;
      for (std::size_t i = 0; i < per_set; ++i) {
        const Directions d = in_floats(random_directions(random));
        pairs.push_back(d);
        const double all[6] = {d.lx, d.ly, d.lz, d.vx, d.vy, d.vz};
        for (std::size_t j = 0; j < 6; ++j) in[j][i] = rounded(all[j]);
      }
      const float* arrays[6] = {in[0].data(), in[1].data(), in[2].data(),
                                in[3].data(), in[4].data(), in[5].data()};
      float* results[3] = {out[0].data(), out[1].data(), out[2].data()};
      model.f32_batch(per_set, arrays, values.data(), results);
      for (std::size_t i = 0; i < per_set; ++i) {
        double truth[3];
        float one[3];
        model.f64(pairs[i], values.data(), truth);
        model.f32(pairs[i], values.data(), one);
        const std::array<float, 3> far = by_far_loop(model, pairs[i], values);
        for (std::size_t c = 0; c < 3; ++c) {
          const double scale = std::max(std::abs(truth[c]), floor);
          worst_one = std::max(worst_one, std::abs(one[c] - truth[c]) / scale);
          worst_many = std::max(worst_many, std::abs(out[c][i] - truth[c]) / scale);
          worst_far = std::max(worst_far, std::abs(far[c] - truth[c]) / scale);
          if (!(std::abs(one[c] - truth[c]) <= 2 * scale)) worst_one = 1e9;
        }
      }
    }
    INFO(model.id << ": float " << worst_one << ", lanes " << worst_many << ", far " << worst_far << " ("
                  << batch_instruction_set() << ")");
    CHECK(worst_one <= tolerance(model));
    CHECK(worst_many <= tolerance(model));
    CHECK(worst_far <= tolerance(model));
  }
}

TEST_CASE("lanes take any count and leave the rest alone") {
  const Model& model = *find_model("ggx-schlick");
  const std::vector<double> values{0.04, 0.5, 0.9, 0.3};
  Random random(3);
  for (const std::size_t count : {0u, 1u, 7u, 16u, 33u}) {
    std::vector<std::vector<float>> in(6, std::vector<float>(40)), out(3, std::vector<float>(40, -1));
    for (std::size_t i = 0; i < count; ++i) {
      const Directions d = random_directions(random);
      const double all[6] = {d.lx, d.ly, d.lz, d.vx, d.vy, d.vz};
      for (std::size_t j = 0; j < 6; ++j) in[j][i] = rounded(all[j]);
    }
    const float* arrays[6] = {in[0].data(), in[1].data(), in[2].data(),
                              in[3].data(), in[4].data(), in[5].data()};
    float* results[3] = {out[0].data(), out[1].data(), out[2].data()};
    model.f32_batch(count, arrays, values.data(), results);
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < 40; ++i) CHECK((i < count ? out[c][i] >= 0 : out[c][i] == -1));
  }
}

TEST_CASE("in float no lobe passes through subnormal numbers") {
  const Model& model = *find_model("blinn-phong");
  for (const double e : {1.0, 64.0, 1024.0, 4096.0}) {
    const std::vector<double> values{0, 0, 0, 1, 1, 1, e};
    for (double theta = 0; theta < 90; theta += 0.5) {
      float rgb[3];
      model.f32(directions_deg(theta, 0, 0), values.data(), rgb);
      CHECK(rgb[0] >= 1e-30f);
    }
  }
}

TEST_CASE("a model made of any three terms evaluates in all three ways") {
  const Model* model = find_model("microfacet:sgd,gulbrandsen,smith-ggx-height");
  REQUIRE(model);
  CHECK(model == find_model("microfacet:sgd,gulbrandsen,smith-height"));
  REQUIRE(model->value_count() == 8);
  const std::vector<double> values{0.9, 0.8, 0.5, 0.2, 0.3, 0.4, 0.2, 1.5};
  const Directions d = directions_deg(30, 40, 170);
  double f64[3];
  float f32[3], many[3];
  model->f64(d, values.data(), f64);
  model->f32(d, values.data(), f32);
  const float in[6] = {rounded(d.lx), rounded(d.ly), rounded(d.lz),
                       rounded(d.vx), rounded(d.vy), rounded(d.vz)};
  const float* arrays[6] = {in, in + 1, in + 2, in + 3, in + 4, in + 5};
  float* results[3] = {many, many + 1, many + 2};
  model->f32_batch(1, arrays, values.data(), results);
  for (int c = 0; c < 3; ++c) {
    CHECK(f64[c] > 0);
    CHECK(f32[c] == Approx(f64[c]).epsilon(1e-4));
    CHECK(many[c] == Approx(f64[c]).epsilon(1e-4));
  }
  CHECK(model->text.find("f_gulbrandsen(r, g, a.lh)") != std::string_view::npos);
  CHECK(model->text.find("d_sgd_s2(alpha, p, log_norm, a.nh, a.s2)") != std::string_view::npos);
  CHECK(model->text.find("v_smith_ggx_height(a, alpha)") != std::string_view::npos);
  CHECK(find_model("microfacet:ggx,schlick") == nullptr);
  CHECK(find_model("microfacet:ggx,schlick,none") == nullptr);
}
