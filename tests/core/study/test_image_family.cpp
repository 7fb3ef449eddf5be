// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "core/brdf/models.h"
#include "core/render/cpu_renderer.h"
#include "core/render/reference.h"
#include "core/study/families/families.h"
#include "core/study/sphere_pictures.h"
#include "tests/core/material/library_support.h"
#include "tests/core/study/table.h"
#include "tests/support.h"

using namespace etak;

namespace {

Image rendered(const Scene& scene) {
  Image picture;
  render_cpu(scene, nullptr, 1, Precision::f64, picture);
  return picture;
}

ReportOptions quickest() {
  ReportOptions options;
  options.threads = 2;
  return options;
}

double image_error(const ErrorTimeTable& table, std::string_view row, std::size_t metric = 0) {
  const auto found = std::find_if(table.rows.begin(), table.rows.end(),
                                  [&](const ErrorTimeRow& each) { return each.id == row; });
  REQUIRE(found != table.rows.end());
  return found->errors[metric];
}

void require_whole(const ErrorTimeFamily& family) {
  CHECK(!family.title.empty());
  CHECK(!family.reference.empty());
  CHECK(!family.grid.empty());
  CHECK(!family.advice.empty());
  for (const ErrorTimeTable& each : family.tables) {
    std::set<std::string> ids;
    for (const ErrorTimeRow& row : each.rows) {
      INFO(each.id << ", " << row.id);
      CHECK(ids.insert(row.id).second);
      CHECK(row.errors.size() == each.metrics.size());
      for (const double value : row.errors) CHECK(std::isfinite(value));
      if (row.time) CHECK(row.time->median_ns > 0);
    }
    CHECK(ids.count(each.base) == 1);
  }
}

}  // namespace

TEST_CASE("one colour of F per light gives the spectral reference's picture, for any model and threads") {
  constexpr int side = 40;
  constexpr double gloss = 0.4;
  const std::vector<bool> judged = sphere_pixels(side);
  const std::vector<const Model*> models{find_model("schueler-full"), find_model("ggx-f82"),
                                         find_model("beckmann-smith"), find_model("schueler-optimized"),
                                         find_model("phong")};
  const SphereTruth truth(models, gloss, side, 2, 1), again(models, gloss, side, 2, 3);
  for (const char* id : {"copper", "glass_bk7", "polystyrene"})
    for (const Model* model : models) {
      const SphereMaterial material = sphere_material(
          test::library(), id, id == std::string("polystyrene") ? Vec3{0.3, 0.2, 0.1} : Vec3{});
      // A reference with a body of its own has no lobe to take F from.
      if (model->kind == ModelKind::combined && material.surface.diffuse != Vec3{}) continue;
      const Scene scene = sphere_scene(*model, material, gloss, side);
      ReferenceOptions options;
      options.samples_per_side = 2;
      options.light_samples = 0;
      const Image slow = render_reference(scene, nullptr, options).picture;
      const Image quick = truth.picture(*model, material);
      CHECK(quick == again.picture(*model, material));
      const double scale = brightest(slow, judged);
      double worst = 0;
      for (std::size_t i = 0; i < slow.pixel_count(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
          worst = std::max(worst, std::abs(double(slow.values[4 * i + c]) - double(quick.values[3 * i + c])));
      INFO(id << ", " << model->id);
      CHECK(worst < 1e-6 * scale);
    }
}

TEST_CASE("models that differ in F alone share a lobe, others do not") {
  const auto lobe = [](std::string_view id) { return &lobe_model(*find_model(id)); };
  CHECK(lobe("ggx-f82") == lobe("ggx-schlick"));
  CHECK(lobe("ggx-dielectric") == lobe("ggx-lazanyi"));
  CHECK(lobe("schueler-optimized") == lobe("schueler-optimized-bounded"));
  CHECK(lobe("ggx-schlick") != lobe("ggx-schlick-v-groove"));
  CHECK(lobe("schueler-full") != lobe("schueler-ksk"));
}

TEST_CASE("errors of a picture are those of its codes and colours") {
  // Three judged pixels, the fourth is not looked at.
  const std::vector<bool> judged{true, true, true, false};
  Image a(4, 1, 3), b(4, 1, 3);
  a.values = {1, 1, 1, 0, 0, 0, 0.2f, 0.2f, 0.2f, 0, 0, 0};
  b.values = {1, 1, 1, 0, 0, 0, 0.4f, 0.2f, 0.2f, 9, 9, 9};
  const PictureErrors same = picture_errors(seen(a, 1, judged), seen(a, 1, judged), judged);
  CHECK(same.rms_codes() == 0);
  CHECK(same.mean_de() == 0);
  CHECK(same.mean_flip() == 0);
  const PictureErrors errors = picture_errors(seen(a, 1, judged), seen(b, 1, judged), judged);
  CHECK(errors.pixels == 3);
  // 0.2 is code 124, 0.4 code 170: 46 codes in one of nine numbers.
  CHECK(errors.rms_codes() == Approx(46 / 3.0));
  CHECK(errors.psnr_db() == Approx(20 * std::log10(255 / (46 / 3.0))));
  const double de = delta_e2000(to_lab(LinearRgb{double(0.2f), double(0.2f), double(0.2f)}),
                                to_lab(LinearRgb{double(0.4f), double(0.2f), double(0.2f)}));
  CHECK(errors.worst_de == Approx(de));
  CHECK(errors.mean_de() == Approx(de / 3));
  CHECK(errors.mean_flip() > 0);
  PictureErrors both = same;
  both.add(errors);
  CHECK(both.pixels == 6);
  CHECK(both.rms_codes() == Approx(46 / 3.0 / std::sqrt(2.0)));
  // Twice as bright clips at white.
  CHECK(picture_errors(seen(a, 2, {true, false, false, false}), seen(a, 1, {true, false, false, false}),
                       {true, false, false, false})
            .rms_codes() == 0);
}

TEST_CASE("the judged pixels are covered whole by the renderer and by the reference's rays") {
  const SphereMaterial material = sphere_material(test::library(), "glass_bk7", {0.2, 0.2, 0.2});
  const Scene scene = sphere_scene(*find_model("ggx-schlick"), material, 0.5, 50);
  ReferenceOptions options;
  options.light_samples = 0;
  const Image reference = render_reference(scene, nullptr, options).picture, quick = rendered(scene);
  const std::vector<bool> judged = sphere_pixels(50);
  for (std::size_t i = 0; i < judged.size(); ++i)
    if (judged[i]) {
      REQUIRE(reference.values[4 * i + 3] == 1);
      REQUIRE(quick.values[4 * i + 3] == 1);
    }
  const auto count = std::count(judged.begin(), judged.end(), true);
  CHECK(double(count) == Approx(3.14159 * std::pow(50 / 2.2 - 1, 2)).epsilon(0.03));
}

TEST_CASE("exact Fresnel in a renderer's pictures is as near as one ray per pixel can be") {
  constexpr int side = 64;
  const std::vector<bool> judged = sphere_pixels(side);
  const Model &exact = *find_model("ggx-from-f0"), &schlick = *find_model("ggx-schlick");
  const SphereTruth truth({&exact}, 0.5, side, 4, 2);
  const SphereMaterial material = sphere_material(test::library(), "glass_bk7", {0, 0, 0});
  const Image reference = truth.picture(exact, material);
  const double exposure = 1 / brightest(reference, judged);
  const SeenPicture right = seen(reference, exposure, judged);
  const auto errors = [&](const Model& model) {
    return picture_errors(right, seen(rendered(sphere_scene(model, material, 0.5, side)), exposure, judged),
                          judged);
  };
  CHECK(errors(exact).rms_codes() < 1);
  CHECK(errors(schlick).rms_codes() > 2 * errors(exact).rms_codes());
  CHECK(errors(schlick).mean_flip() > 2 * errors(exact).mean_flip());
}

TEST_CASE("the image family has every specular model of one reflection, and tells forms and lobes apart") {
  const ErrorTimeFamily family = image_family(quickest());
  require_whole(family);
  const ErrorTimeTable &metals = test::table(family, "metals"),
                       &dielectrics = test::table(family, "dielectrics"),
                       &lobes = test::table(family, "lobes");
  // Pictures are compared with the spectral one of the same lobe, which has one reflection.
  for (const Model& model : models())
    if (model.kind != ModelKind::diffuse && !model.compensated()) {
      CHECK(image_error(metals, model.id) > 0);
      CHECK(image_error(dielectrics, model.id) > 0);
    }
  CHECK(image_error(metals, "ggx-f82") < image_error(metals, "ggx-schlick"));
  CHECK(image_error(dielectrics, "ggx-from-f0") < image_error(dielectrics, "ggx-schlick"));
  // F82 pins 82 degrees and loses Brewster's dip: not for dielectrics.
  CHECK(image_error(dielectrics, "ggx-f82") > image_error(dielectrics, "ggx-schlick"));
  CHECK(image_error(metals, "schueler-optimized") > image_error(metals, "schueler-optimized-bounded"));
  CHECK(image_error(lobes, "ggx-schlick") > image_error(lobes, "beckmann-schlick"));
  CHECK(image_error(lobes, "cook-torrance") == Approx(image_error(lobes, "schueler-full")).epsilon(1e-3));
  // No model of exact F is nearer than what rays alone change, but for lobes wider than Full's.
  CHECK(image_error(dielectrics, "schueler-full") < 1.2 * image_error(dielectrics, "one_ray"));
}

TEST_CASE("a sphere's pictures are compared with others of the same lobe only") {
  const ErrorTimeFamily family = test::timed(image_family(quickest()));
  for (const char* id : {"metals", "dielectrics"}) {
    const ErrorTimeTable& table = test::table(family, id);
    const auto row = [&](std::string_view model) -> const ErrorTimeRow& {
      return *std::find_if(table.rows.begin(), table.rows.end(),
                           [&](const ErrorTimeRow& each) { return each.id == model; });
    };
    INFO(id);
    // Its lobe is that of no other model, so that it is unbeaten by nobody.
    CHECK(row("phong").verdict == Verdict::alone);
    CHECK(row("ggx-f82").truth == row("ggx-schlick").truth);
    CHECK(row("ggx-f82").truth != row("schueler-full").truth);
  }
  for (const ErrorTimeRow& row : test::table(family, "lobes").rows) CHECK(row.truth.empty());
}

TEST_CASE("the packer family: more effort packs closer, a higher level never writes more") {
  const ErrorTimeFamily family = test::timed(packer_family(quickest()));
  require_whole(family);
  const auto falls = [](const ErrorTimeTable& each, double slack) {
    for (std::size_t i = 1; i < each.rows.size(); ++i)
      CHECK(each.rows[i].errors[0] <= each.rows[i - 1].errors[0] + slack);
  };
  // No promise of the packer for a single set.
  falls(test::table(family, "effort"), 0.5);
  falls(test::table(family, "png"), 0);
  CHECK(image_error(test::table(family, "effort"), "effort_300") <
        image_error(test::table(family, "effort"), "effort_1") / 4);
  for (const ErrorTimeRow& row : test::table(family, "effort").rows)
    for (const double lost : row.errors) CHECK((lost >= 0 && lost < 60));
  CHECK(image_error(test::table(family, "png"), "smallest") == 1);
  CHECK(image_error(test::table(family, "png"), "fast") < 2);
}
