// SPDX-License-Identifier: Apache-2.0
// The functions of `etak eval`: compared with independent arithmetic and with printed values, and what they
// refuse.
#include "core/light/functions.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "core/base/error.h"
#include "core/base/number.h"
#include "tests/core/light/function_values.h"

using namespace etak;
using namespace etak::test::function_values;

TEST_CASE("every function of the table is there, with its inputs") {
  std::set<std::string_view> ids;
  for (const Function& each : functions()) {
    CHECK(ids.insert(each.id).second);
    CHECK(!each.source.empty());
    CHECK(!each.returns.empty());
  }
  for (const auto* id : {"f0",
                         "absorptance0",
                         "fresnel_exact",
                         "fresnel_dielectric",
                         "schlick",
                         "schueler_F",
                         "f82_hoffman",
                         "f82_tint",
                         "lazanyi",
                         "gulbrandsen_n",
                         "gulbrandsen_k",
                         "gulbrandsen_r",
                         "gulbrandsen_g",
                         "n_of_f82",
                         "k_of_f82",
                         "f0_under",
                         "f82_under",
                         "f82_mean",
                         "fresnel_mean",
                         "fresnel_max_abs_error",
                         "fresnel_cosmean_abs_error",
                         "D_ggx",
                         "D_beckmann",
                         "D_phong",
                         "D_schueler",
                         "D_sgd",
                         "uabc_norm",
                         "integral_D_ggx",
                         "integral_D_beckmann",
                         "integral_D_beckmann_printed",
                         "integral_D_phong",
                         "integral_D_schueler_over_pi",
                         "G_ct",
                         "G1_ggx",
                         "G1_beckmann_exact",
                         "G2_ggx_uncorrelated",
                         "G2_ggx_height",
                         "schueler_simplified",
                         "schueler_ksk",
                         "schueler_optimized",
                         "schueler_optimized_bounded",
                         "schueler_full",
                         "phong",
                         "blinn_phong",
                         "cook_torrance",
                         "cook_torrance_printed",
                         "ashikhmin_shirley_spec",
                         "ashikhmin_shirley_diff",
                         "oren_nayar",
                         "oren_nayar_grazing_albedo_max",
                         "hemi_diffuse",
                         "hemi_specular",
                         "hemi_specular_printed",
                         "hemi_specular_wide",
                         "hemi_reference_upper",
                         "hemi_reference_total",
                         "furnace_simplified",
                         "furnace_ksk",
                         "furnace_optimized",
                         "furnace_blinn",
                         "furnace_beckmann_ct",
                         "furnace_beckmann_ct_printed",
                         "furnace_ggx_ct",
                         "furnace_ggx_smith",
                         "furnace_ggx_smith_corr",
                         "furnace_ggx_compensated",
                         "furnace_beckmann_smith_corr",
                         "furnace_beckmann_compensated",
                         "srgb_encode",
                         "srgb_decode",
                         "srgb_u8",
                         "srgb_u8_roundtrip_mismatches",
                         "point_irradiance"}) {
    INFO(id);
    CHECK(ids.contains(id));
  }
}

TEST_CASE("Fresnel functions") {
  CHECK(eval("f0", "n=1.5;k=0") == near_to(0.04));
  CHECK(eval("f0", "n=0.27;k=2.77") == near_to((0.73 * 0.73 + 2.77 * 2.77) / (1.27 * 1.27 + 2.77 * 2.77)));
  CHECK(eval("absorptance0", "n=0.2;k=1e6") == near_to(8e-13, 1e-9));
  CHECK(eval("fresnel_exact", "n=1;k=0;cos=0.3") == 0);
  CHECK(eval("fresnel_exact", "n=1;k=0;cos=0") == 0);
  CHECK(eval("fresnel_exact", "n=1.5;k=0;cos=0") == near_to(1));
  CHECK(eval("fresnel_exact", "n=1.5;k=0;cos=1e-8") == near_to(.99999994186, 1e-11));
  CHECK(eval("fresnel_exact", "n=1e-8;k=5;cos=1") == near_to(.9999999981863 + 2e-14, 1e-7));
  CHECK(eval("fresnel_dielectric", "n1=1.5;n2=1;theta_deg=45") == 1);
  CHECK(eval("fresnel_dielectric", "n1=1;n2=1.5;theta_deg=0") == near_to(0.04));
  CHECK(eval("fresnel_dielectric", "n1=1;n2=1.5;theta_deg=50") ==
        near_to(eval("fresnel_exact", "n=1.5;k=0;cos=" + number(c(50), 17))));
  CHECK(eval("fresnel_dielectric", "n1=2;n2=3;theta_deg=90") == near_to(1));
  CHECK(eval("schlick", "f0=0.04;cos=0.25") == near_to(0.04 + 0.96 * std::pow(0.75, 5)));
  CHECK(eval("schlick", "f0=1.022;cos=0") == near_to(1));
  CHECK(eval("schueler_F", "K=0.01;t=0.5") == near_to(0.01 + (0.6 - 0.01) / 16));
  CHECK(eval("schueler_F", "K=0.5;t=0") == near_to(1));
  CHECK(eval("schueler_F", "K=-0.01;t=0") == 0);
  CHECK(eval("schueler_F", "K=1.022;t=0") == near_to(1));
  CHECK(eval("schueler_F", "K=0.04;t=1.00000006") == near_to(0.04));
  const double s7 = 0.9 + 0.1 * std::pow(6.0 / 7, 5);
  const double a = (s7 - 0.85) / (1.0 / 7 * std::pow(6.0 / 7, 6));
  CHECK(eval("f82_hoffman", "f0=0.9;f82=0.85;cos=0.3") ==
        near_to(0.9 + 0.1 * std::pow(0.7, 5) - a * 0.3 * std::pow(0.7, 6)));
  CHECK(eval("f82_hoffman", "f0=0.9;f82=0.85;cos=" + number(1.0 / 7, 17)) == near_to(0.85));
  CHECK(eval("f82_tint", "f0=0.9;tint=0.8;cos=" + number(1.0 / 7, 17)) == near_to(0.8 * s7));
  CHECK(eval("lazanyi", "n=1.2;k=3;cos=0.4;a=0.3;alpha=6") ==
        near_to((0.04 + 4.8 * std::pow(0.6, 5) + 9) / (2.2 * 2.2 + 9) - 0.3 * 0.4 * std::pow(0.6, 6)));
  const double r = 0.9, g = 0.3, root = std::sqrt(r),
               n = g * (1 - r) / (1 + r) + (1 - g) * (1 + root) / (1 - root);
  CHECK(eval("gulbrandsen_n", "r=0.9;g=0.3") == near_to(n));
  CHECK(eval("gulbrandsen_k", "r=0.9;g=0.3") ==
        near_to(std::sqrt((r * (n + 1) * (n + 1) - (n - 1) * (n - 1)) / (1 - r))));
  const std::string nk = "n=" + number(n, 17) + ";k=" + number(eval("gulbrandsen_k", "r=0.9;g=0.3"), 17);
  CHECK(eval("gulbrandsen_r", nk) == near_to(0.9));
  CHECK(eval("gulbrandsen_g", nk) == near_to(0.3));
  CHECK(std::isfinite(eval("gulbrandsen_n", "r=1;g=0")));
}

TEST_CASE("errors of approximations are those of a plain loop") {
  // Schlick's approximation for glass, at every 0.25 degrees: maximum, and mean over cos^2.
  double worst = 0, mean = 0, last = 0, last_c2 = 1;
  for (int i = 0; i <= 360; ++i) {
    const double cosine = i == 360 ? 0 : c(i * 0.25), st = std::sqrt(1 - cosine * cosine) / 1.5,
                 ct = std::sqrt(1 - st * st);
    const double rs = (cosine - 1.5 * ct) / (cosine + 1.5 * ct),
                 rp = (ct - 1.5 * cosine) / (ct + 1.5 * cosine);
    const double error = std::abs(0.04 + 0.96 * std::pow(1 - cosine, 5) - (rs * rs + rp * rp) / 2);
    worst = std::max(worst, error);
    if (i > 0) mean += (last + error) / 2 * (last_c2 - cosine * cosine);
    last = error;
    last_c2 = cosine * cosine;
  }
  CHECK(eval("fresnel_max_abs_error", "model=schlick;n=1.5;k=0;step_deg=0.25") == near_to(worst, 1e-9));
  CHECK(eval("fresnel_cosmean_abs_error", "model=schlick;n=1.5;k=0;step_deg=0.25") == near_to(mean, 1e-9));
  CHECK(eval("fresnel_max_abs_error", "model=f82;n=0.27;k=2.77;step_deg=1") < 0.03);
  CHECK(eval("fresnel_max_abs_error", "model=schueler_F;n=1.5;k=0;step_deg=1") > 0.01);
  CHECK_THROWS_AS(eval("fresnel_max_abs_error", "model=none;n=1.5;k=0;step_deg=1"), Error);
}

TEST_CASE("transfer, lights, transparency") {
  CHECK(eval("srgb_encode", "x=0.5") == near_to(1.055 * std::pow(0.5, 1 / 2.4) - 0.055));
  CHECK(eval("srgb_decode", "y=0.04") == near_to(0.04 / 12.92));
  CHECK(eval("srgb_u8", "x=0.04") == 56);
  CHECK(eval("srgb_u8", "x=-3") == 0);
  CHECK(eval("srgb_u8", "x=1.022") == 255);
  CHECK(eval("srgb_u8_roundtrip_mismatches", "codes=256") == 0);
  CHECK(eval("srgb_u8_roundtrip_mismatches", "codes=65536") == 0);
  CHECK(eval("point_irradiance", "I=8;r=2;cos=0.5") == near_to(1));
  CHECK(eval("point_irradiance", "I=8;r=2;cos=-0.5") == 0);
  CHECK(eval("spot_share", "cos=1;inner_deg=20;outer_deg=20") == 1);
  CHECK(eval("spot_share", "cos=" + number((c(20) + c(30)) / 2, 17) + ";inner_deg=20;outer_deg=30") ==
        near_to(0.5));
  CHECK(eval("fresnel_opacity", "alpha=0.25;K=0.04;nv=1") == near_to(1 - 0.75 * 0.96));
}

TEST_CASE("every function of n and k takes n = 0, a metal without loss, in its limit") {
  for (const char* inputs : {"n=0;k=5", "n=1e-300;k=5", "n=0;k=1e-300", "n=1e-300;k=0", "n=0;k=1e6"}) {
    INFO(inputs);
    CHECK(eval("f0", inputs) == 1);
    CHECK(eval("absorptance0", inputs) <= 4e-300);
    CHECK(eval("gulbrandsen_r", inputs) == 1);
    CHECK(eval("gulbrandsen_g", inputs) == near_to(1));
    for (const char* angle : {"1", "0.9", "0.14", "1e-8", "0"}) {
      const std::string at = std::string(inputs) + ";cos=" + angle;
      INFO(at);
      CHECK(eval("fresnel_exact", at) == near_to(1));
      CHECK(eval("lazanyi", at + ";a=0;alpha=1") == near_to(1));
    }
    for (const char* model : {"schlick", "schueler_F", "f82"}) {
      const std::string at = std::string(inputs) + ";step_deg=5;model=" + model;
      CHECK(eval("fresnel_max_abs_error", at) == near_to(0, 1e-12));
      CHECK(eval("fresnel_cosmean_abs_error", at) == near_to(0, 1e-12));
    }
  }
  // For a medium that reflects everything, the lobes have F = 1.
  CHECK(eval("cook_torrance", "theta_l=10;theta_v=20;phi_v=180;n=0;k=5;m=0.3") ==
        near_to(eval("cook_torrance", "theta_l=10;theta_v=20;phi_v=180;n=1e-12;k=5;m=0.3"), 1e-9));
}

TEST_CASE("what lies outside a domain is refused with a reason") {
  const std::pair<const char*, const char*> bad[] = {
      {"f0", "n=0;k=0"},
      {"absorptance0", "n=0;k=0"},
      {"gulbrandsen_g", "n=0;k=0"},
      {"fresnel_exact", "n=0;k=0;cos=1"},
      {"lazanyi", "n=0;k=0;cos=1;a=0;alpha=1"},
      {"fresnel_max_abs_error", "model=schlick;n=0;k=0;step_deg=1"},
      {"f0", "n=-1;k=0"},
      {"f0", "n=1.5;k=-1"},
      {"f0", "n=nan;k=0"},
      {"f0", "n=2e4;k=0"},
      {"f0", "n=1.5;k=2e6"},
      {"f0", "n=inf;k=0"},
      {"f0", "n=1.5"},
      {"f0", "n=1.5;k=0;x=1"},
      {"f0", "n=1.5;n=1.5;k=0"},
      {"fresnel_exact", "n=1.5;k=0;cos=1.5"},
      {"fresnel_exact", "n=1.5;k=0;cos=NaN"},
      {"D_ggx", "alpha=0;nm=1"},
      {"D_beckmann", "m=0;nm=1"},
      {"D_ggx", "alpha=-0.1;nm=1"},
      {"G1_ggx", "cos=1;alpha=0"},
      {"furnace_ggx_ct", "param=0;theta_v=0"},
      {"schueler_ksk", "theta_l=0;theta_v=0;phi_v=0;K=0.5;g=1.5"},
      {"schueler_ksk", "theta_l=0;theta_v=0;phi_v=0;K=0.5;g=-0.1"},
      {"schueler_ksk", "l=v"},
      {"cook_torrance", "theta_l=0;theta_v=0;phi_v=0;n=0;k=0;m=0.3"},
      {"cook_torrance", "theta_l=0;theta_v=0;phi_v=0;n=1;k=0;m=0"},
      {"point_irradiance", "I=1;r=0;cos=1"},
      {"point_irradiance", "I=-1;r=1;cos=1"},
      {"srgb_u8", "x=NaN"},
      {"srgb_u8", "x="},
      {"f82_tint", "f0=0.5;tint=1.5;cos=1"},
      {"lazanyi", "n=1;k=1;cos=1;a=0;alpha=0"},
      {"fresnel_dielectric", "n1=0;n2=1;theta_deg=0"},
      {"fresnel_dielectric", "n1=1;n2=1.5;theta_deg=91"},
      {"spot_share", "cos=1;inner_deg=30;outer_deg=20"},
      {"srgb_u8_roundtrip_mismatches", "codes=2.5"},
      {"hemi_diffuse", "K=1;lower=-1;upper=1;nz=0"}};
  for (const auto& [id, inputs] : bad) {
    INFO(id << ' ' << inputs);
    CHECK_THROWS_AS(eval(id, inputs), Error);
  }
  try {
    eval("f0", "n=0;k=0");
    FAIL("not refused");
  } catch (const Error& e) {
    CHECK(std::string(e.what()) == "test: f0 n: 0 beside k = 0; expected n above 0, or k above 0");
  }
}

TEST_CASE("the helper functions of the sources are there by themselves") {
  CHECK(eval("gloss_exponent", "g=0.5") == near_to(64));
  CHECK(eval("gloss_exponent", "g=1") == near_to(4096));
  CHECK(eval("G_implicit", "nl=0.5;nv=0.25") == near_to(0.125));
  CHECK(eval("G_implicit", "nl=-0.5;nv=0.25") == 0);
  CHECK(eval("G_kelemen", "nl=0.5;nv=0.25;vh=0.5") == near_to(0.5));
  CHECK(eval("D_abc_printed", "a1=10;a2=2;nm=0.9") == near_to(0.25));
  CHECK(eval("D_abc_printed", "a1=100;a2=2;nm=0.8") * eval("uabc_norm", "a1=100;a2=2") ==
        near_to(eval("D_abc", "a1=100;a2=2;nm=0.8")));
  CHECK(eval("R", "theta_l=30;axis=x") == near_to(-0.5));
  CHECK(eval("R", "theta_l=60;axis=z") == near_to(0.5));
  // l and v at 60 and 0 degrees: h is at 30. Of l = x and v = y, h lies between them.
  CHECK(eval("H", "theta_l=60;theta_v=0;phi_v=0;axis=z") == near_to(std::sqrt(0.75)));
  CHECK(eval("H", "theta_l=90;theta_v=90;phi_v=90;axis=x") == near_to(std::sqrt(0.5)));
  CHECK_THROWS_AS(eval("H", "theta_l=30;theta_v=150;phi_v=180;axis=z"), Error);
}
