// SPDX-License-Identifier: Apache-2.0
// Lobes and hemispheres among the functions of `etak eval`: compared with independent arithmetic, and with the
// numbers that etak models states.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/base/number.h"
#include "core/light/functions.h"
#include "core/light/rows.h"
#include "tests/core/light/function_values.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test::function_values;

TEST_CASE("distributions, their integrals, and geometry") {
  const double nm = 0.8, t2 = (1 - nm * nm) / (nm * nm);
  CHECK(eval("D_ggx", "alpha=0.3;nm=0.8") ==
        near_to(0.09 / (std::numbers::pi * std::pow(nm * nm * (0.09 - 1) + 1, 2))));
  CHECK(eval("D_ggx", "alpha=1e-6;nm=1") == near_to(1 / (std::numbers::pi * 1e-12)));
  CHECK(eval("D_beckmann", "m=0.3;nm=0.8") ==
        near_to(std::exp(-t2 / 0.09) / (std::numbers::pi * 0.09 * std::pow(nm, 4))));
  CHECK(eval("D_phong", "e=100;nm=0.9") == near_to(102 / (2 * std::numbers::pi) * std::pow(0.9, 100), 1e-10));
  CHECK(eval("D_phong", "e=1;nm=1e-7") == near_to(3 / (2 * std::numbers::pi) * 1e-7, 1e-10));
  CHECK(eval("D_phong", "e=4096;nm=0.9999") ==
        near_to(4098 / (2 * std::numbers::pi) * std::exp(4096 * std::log1p(-1e-4)), 1e-10));
  CHECK(eval("D_schueler", "e=16;nm=0.9") == near_to(8.5 * std::pow(0.9, 16)));
  // For p = 1/2, Gamma(1/2, alpha) has a closed form.
  const double x = t2 + 0.04;
  CHECK(eval("D_sgd", "alpha=0.2;p=0.5;nm=0.8") ==
        near_to(std::pow(0.2, -0.5) * std::exp(-x / 0.2) /
                (std::sqrt(std::numbers::pi) * std::erfc(std::sqrt(0.2)) * std::sqrt(x)) /
                (std::numbers::pi * std::pow(nm, 4))));
  CHECK(eval("uabc_norm", "a1=7;a2=1") == near_to(49 / (2 * std::numbers::pi * (8 * std::log(8.0) - 7))));
  CHECK(eval("uabc_norm", "a1=0;a2=3") == near_to(1 / std::numbers::pi));
  for (const auto* param : {"param=0.01", "param=0.3", "param=1"}) {
    CHECK(eval("integral_D_ggx", param) == near_to(1, 1e-9));
    CHECK(eval("integral_D_beckmann", param) == near_to(1, 1e-9));
    CHECK(eval("integral_D_beckmann_printed", param) == near_to(std::numbers::pi / 4, 1e-9));
  }
  for (const double e : {1.0, 8.0, 64.0, 4096.0}) {
    const std::string param = "param=" + number(e, 17);
    CHECK(eval("integral_D_phong", param) == near_to(1, 1e-9));
    CHECK(eval("integral_D_schueler_over_pi", param) == near_to((1 + e) / (2 + e), 1e-9));
  }
  CHECK(eval("G_ct", "nh=0.9;nv=0.5;nl=0.2;vh=0.7") == near_to(2 * 0.9 * 0.2 / 0.7));
  CHECK(eval("G_ct", "nh=1;nv=0.9;nl=0.9;vh=0.9") == 1);
  CHECK(eval("G_ct", "nh=0.5;nv=0;nl=0.2;vh=0.7") == 0);
  CHECK(eval("G1_ggx", "cos=0;alpha=0.3") == 0);
  const double tan2 = (1 - 0.25) / 0.25, lambda = (std::sqrt(1 + 0.09 * tan2) - 1) / 2;
  CHECK(eval("G1_ggx", "cos=0.5;alpha=0.3") == near_to(1 / (1 + lambda)));
  CHECK(eval("G2_ggx_uncorrelated", "nl=0.5;nv=0.5;alpha=0.3") == near_to(1 / ((1 + lambda) * (1 + lambda))));
  CHECK(eval("G2_ggx_height", "nl=0.5;nv=0.5;alpha=0.3") == near_to(1 / (1 + 2 * lambda)));
  const double b = 1 / (0.6 * std::sqrt(tan2));
  CHECK(eval("G1_beckmann_exact", "cos=0.5;m=0.6") ==
        near_to(1 / (1 + (std::erf(b) - 1) / 2 + std::exp(-b * b) / (2 * b * std::sqrt(std::numbers::pi)))));
  CHECK(eval("G1_beckmann_exact", "cos=1;m=0.3") == 1);
  CHECK(eval("G1_beckmann_exact", "cos=0;m=0.3") == 0);
}

TEST_CASE("reflectance functions: std::numbers::pi f nl for Schueler and Phong, f for the others") {
  const double F = 0.2 + 0.8 * std::pow(1 - c(35), 4), D = 65 / 2.0 * std::pow(c(5), 64);
  CHECK(eval("schueler_ksk", "theta_l=30;theta_v=40;phi_v=180;K=0.2;g=0.5") ==
        near_to(D * F / (4 * c(35) * c(35)) * c(30)));
  CHECK(eval("schueler_simplified", "theta_l=30;theta_v=40;phi_v=180;K=0.2;g=0.5") ==
        near_to(D * F * std::min(1.0, 2 * c(5) * c(40) / c(35)) / (4 * c(40))));
  CHECK(eval("schueler_optimized", "theta_l=30;theta_v=40;phi_v=180;K=0.2;g=0.5") ==
        near_to(0.2 * 65 / (8 * std::pow(c(35), 3)) * std::pow(c(5), 64) * c(30)));
  CHECK(eval("schueler_full", "theta_l=30;theta_v=40;phi_v=180;n=1.5;k=0;m=0.3") ==
        near_to(std::numbers::pi * c(30) *
                eval("cook_torrance", "theta_l=30;theta_v=40;phi_v=180;n=1.5;k=0;m=0.3")));
  CHECK(eval("cook_torrance_printed", "theta_l=30;theta_v=40;phi_v=90;n=0.2;k=3;m=0.3") ==
        near_to(std::numbers::pi / 4 *
                eval("cook_torrance", "theta_l=30;theta_v=40;phi_v=90;n=0.2;k=3;m=0.3")));
  CHECK(eval("phong", "theta_l=30;theta_v=40;phi_v=180;cd=0.3;cs=0.2;m=8") ==
        near_to(0.3 * c(30) + 0.2 * std::pow(c(10), 8)));
  CHECK(eval("blinn_phong", "theta_l=30;theta_v=40;phi_v=180;cd=0.3;cs=0.2;m=8") ==
        near_to(0.3 / std::numbers::pi + 0.2 * 16 / (8 * std::numbers::pi) * std::pow(c(5), 8)));
  CHECK(eval("ashikhmin_shirley_spec", "theta_l=30;theta_v=30;phi_v=180;rs=1;nu=100;nv=10") ==
        near_to(std::sqrt(101.0 * 11) / (8 * std::numbers::pi) / (c(30) * c(30))));
  CHECK(eval("oren_nayar", "theta_l=30;theta_v=40;phi_v=0;rho=1;sigma=0.3") ==
        near_to((1 - 0.5 * 0.09 / 0.42 + 0.45 * 0.09 / 0.18 * s(40) * s(30) / c(30)) / std::numbers::pi));
  // With the viewer at azimuth 90, normal, light and viewer are not in one plane.
  const double lh = std::sqrt((1 + c(30) * c(40)) / 2), nh = (c(30) + c(40)) / (2 * lh);
  CHECK(eval("blinn_phong", "theta_l=30;theta_v=40;phi_v=90;cd=0;cs=1;m=20") ==
        near_to(28 / (8 * std::numbers::pi) * std::pow(nh, 20)));

  for (const Function& function : functions()) {
    if (!function.directions) continue;
    INFO(function.id);
    CHECK(evaluate(function, std::vector<NamedText>{{"l", "-v"}}, "") == 0);
    std::string inputs;
    for (const FunctionInput& input : function.inputs)
      inputs += std::string(input.name) + (input.name == "theta_l"   ? "=90;"
                                           : input.name == "theta_v" ? "=20;"
                                           : input.name == "rs"      ? "=0.5;"
                                                                     : "=1;");
    CHECK(eval(function.id, inputs) == 0);
    inputs.replace(inputs.find("=90"), 3, "=95");
    CHECK(eval(function.id, inputs) == 0);
    inputs.replace(inputs.find("=95"), 3, "=20");
    CHECK(eval(function.id, inputs) > 0);
    inputs.replace(inputs.find("theta_v=20"), 10, "theta_v=90");
    CHECK(eval(function.id, inputs) == 0);
  }
  CHECK(eval("oren_nayar_grazing_albedo_max", "") == near_to(1.01517878, 1e-7));
}

TEST_CASE("furnaces have the numbers of the independent integration over light directions") {
  CHECK(eval("furnace_optimized", "param=64;theta_v=89.9") == near_to(25.793016832, 1e-7));
  CHECK(eval("furnace_optimized", "param=1;theta_v=89.999999") == near_to(16.8637375779, 1e-7));
  CHECK(eval("furnace_optimized", "param=8;theta_v=89.99999") == near_to(32.8455838255, 1e-7));
  CHECK(eval("furnace_optimized", "param=4096;theta_v=89.9999") == near_to(451.982133417, 1e-7));
  CHECK(eval("furnace_optimized", "param=1;theta_v=89") == near_to(3.098007769, 1e-7));
  CHECK(eval("furnace_blinn", "param=8;theta_v=0") == near_to(16 * (1.0 / 16 + 8) / (10 * 12), 1e-8));
  CHECK(eval("furnace_ggx_smith_corr", "param=1;theta_v=0") == near_to(1 - std::log(2.0), 1e-8));
  CHECK(eval("lost_ggx", "cos=1;alpha=1") == near_to(std::log(2.0), 0.006));
  CHECK(eval("furnace_ggx_compensated", "param=1;theta_v=0") == near_to(1, 0.01));
  CHECK(eval("furnace_beckmann_smith_corr", "param=1;theta_v=0") < 0.47);
  CHECK(eval("furnace_beckmann_compensated", "param=1;theta_v=0") == near_to(1, 0.01));
  CHECK(eval("furnace_beckmann_ct_printed", "param=0.3;theta_v=60") ==
        near_to(std::numbers::pi / 4 * eval("furnace_beckmann_ct", "param=0.3;theta_v=60"), 1e-7));
}

TEST_CASE("hemispheres: the corrected form, the wide one and the print") {
  CHECK(eval("hemi_diffuse", "K=0.5;lower=0.2;upper=1;nz=-0.5") == near_to(0.5 * (0.2 * 0.75 + 0.25)));
  const double Fh = 0.04 + 0.96 * 0.5 * std::pow(0.4, 4);
  CHECK(eval("hemi_specular", "K=0.04;g=0.5;nv=0.6;rz=0.25;lower=0.2;upper=1") ==
        near_to(Fh * (0.2 * 0.25 + 0.75)));
  CHECK(eval("hemi_specular", "K=0.04;g=1;nv=0.6;rz=0;lower=0;upper=1") ==
        near_to((0.04 + 0.96 * std::pow(0.4, 4)) / 2));
  CHECK(eval("hemi_specular", "K=0.04;g=1;nv=0.6;rz=1e-9;lower=0;upper=1") ==
        near_to(0.04 + 0.96 * std::pow(0.4, 4)));
  const double w = 1.8 / 8;
  CHECK(eval("hemi_specular_wide", "K=0.04;g=0.5;nv=0.6;rz=0.1;lower=0.2;upper=1") ==
        near_to(Fh * (0.2 * (1 - (1 + 0.1 / w) / 2) + (1 + 0.1 / w) / 2)));
  // As printed, the weight of -1 below the horizon gives 2 lower - upper, and F(g nv) is at its largest on a
  // rough surface.
  CHECK(eval("hemi_specular_printed", "K=0.04;g=0;nv=1;rz=-1;lower=0.1;upper=1") ==
        near_to(1 * (2 * 0.1 - 1)));
  CHECK(eval("hemi_reference_total", "K=1;g=1;nv=0.5") ==
        near_to(eval("furnace_simplified", "param=4096;theta_v=60"), 1e-6));
  const double upper = eval("hemi_reference_upper", "K=0.5;g=0.5;nv=0.8;z_theta=70;z_phi=30"),
               lower = eval("hemi_reference_upper", "K=0.5;g=0.5;nv=0.8;z_theta=110;z_phi=210");
  CHECK(upper + lower == near_to(eval("hemi_reference_total", "K=0.5;g=0.5;nv=0.8"), 1e-6));
  CHECK(eval("hemi_reference_upper", "K=0.5;g=0.5;nv=0.8;z_theta=0;z_phi=0") ==
        near_to(eval("hemi_reference_total", "K=0.5;g=0.5;nv=0.8"), 1e-6));
}

TEST_CASE("each number that etak models claims of hemispheres and of the clear ball is a computed one") {
  const auto claim = [](std::string_view id) {
    return std::ranges::find(light_rows(), id, &LightRow::id)->note;
  };
  // The corrected form in a uniform field, against the integral of the lobe: the text rounds up.
  double worst = 0;
  std::string where;
  for (const char* K : {"0.04", "0.5", "0.9", "1"})
    for (const char* g : {"0.25", "0.3", "0.5", "0.75", "1"})
      for (int tenths = 1; tenths <= 10; ++tenths) {
        const std::string at = std::string("K=") + K + ";g=" + g + ";nv=" + number(tenths / 10.0, 2);
        const double off =
            std::abs(eval("hemi_specular", at + ";rz=0;lower=1;upper=1") - eval("hemi_reference_total", at));
        if (off > worst) worst = off, where = at;
      }
  CHECK(where == "K=1;g=0.25;nv=0.7");
  CHECK(worst == Approx(0.212).margin(5e-4));
  CHECK(test::contains(claim("hemispheres-specular"),
                       "error up to " + number(std::ceil(worst * 100) / 100, 2) + " for g >= 0.25"));
  // As printed F is min(60 K, 1) on a surface of gloss 0, where it should be K.
  double too_high = 0;
  for (double K = 0; K <= 1; K += 1.0 / 600) too_high = std::max(too_high, std::min(60 * K, 1.0) - K);
  const std::string at = "K=" + number(1.0 / 60, 17) + ";g=0;nv=0.5;rz=0;lower=1;upper=1";
  CHECK(eval("hemi_specular_printed", at) - eval("hemi_specular", at) == near_to(too_high));
  CHECK(test::contains(claim("hemispheres-specular-printed"),
                       "too high by up to " + number(too_high, 2) + " "));
  // A ray that is reflected twice before it leaves a ball of n = 1.5.
  const double F = std::pow(0.5 / 2.5, 2);
  CHECK(test::contains(claim("clear-ball"), "left out (" + number(100 * F * F, 1) + " % at n = 1.5)"));
}
