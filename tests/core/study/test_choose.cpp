// SPDX-License-Identifier: Apache-2.0
#include "core/study/choose/choose.h"
#include "core/study/choose/choose_models.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <utility>

#include "core/atlas/variant.h"
#include "core/base/error.h"
#include "core/brdf/models.h"
#include "core/color/delta_e.h"
#include "core/material/seen_stack.h"
#include "core/pages/choose_report.h"
#include "core/render/cpu_renderer.h"
#include "core/render/reference.h"
#include "tests/core/study/choose_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE(
    "silver needs no more than Schlick, coloured metals F82, semiconductors and chromium more than it") {
  CHECK(chosen("silver").fresnel->id == "schlick");
  for (const auto* id : {"gold", "copper", "aluminum"}) {
    INFO(id);
    CHECK(std::string(chosen(id).fresnel->id).starts_with("f82"));
  }
  // Fitted to n and k, or these themselves.
  const Choice chromium = chosen("chromium");
  CHECK((chromium.fresnel->id == "lazanyi" || chromium.fresnel->id == "index"));
  CHECK(chromium.fresnel_error <= 1);
  // Silicon's k is so small in the visible that n alone does.
  CHECK(chosen("silicon").fresnel->id == "from_f0");
  CHECK(chosen("germanium").fresnel->id == "index");
}

TEST_CASE("dielectrics are exact from F0 alone") {
  for (const auto* id : {"water", "glass_bk7", "diamond", "polystyrene", "halite"}) {
    INFO(id);
    CHECK(chosen(id).fresnel->id == "from_f0");
  }
}

TEST_CASE("the budget holds at every angle, in every pixel and for F0") {
  for (const auto* id : {"silver", "copper", "water"})
    for (const double budget : {0.3, 1.0, 3.0}) {
      INFO(id << " " << budget);
      const Choice choice = chosen(id, budget);
      CHECK(choice.fresnel_error <= budget);
      CHECK(choice.picture_error <= budget);
      CHECK(choice.method_error <= budget);
      CHECK(choice.chosen_ns <= choice.everything_ns * 1.15);
    }
}

TEST_CASE(
    "the renderers agree that the budget holds: every pixel of a chosen picture against the spectral one") {
  for (const auto* id : {"gold", "silver", "water", "chromium"}) {
    INFO(id);
    const auto material = MaterialLibrary::builtin().find(id);
    const Dataset& dataset = material->preferred_dataset();
    const Choice choice = chosen(id);
    Scene scene;
    scene.surface = surface_of(*material, dataset, {0, 0, 0}, 0.75);
    scene.width = scene.height = 64;
    scene.background = {0, 0, 0};
    for (const auto& [direction, intensity] :
         {std::pair{Vec3{-0.6, -0.48, -0.64}, 2.0}, {Vec3{0.6, 0, 0.8}, 1.0}}) {
      Light light;
      light.direction = direction;
      light.intensity = intensity;
      scene.lights.lights.push_back(light);
    }
    scene.specular = find_model("microfacet:ggx,exact,smith-ggx-height");
    scene.specular_values = model_values(*scene.specular, scene.surface, {});
    ReferenceOptions rays;
    rays.samples_per_side = 1;
    rays.light_samples = 0;
    const Image everything = render_reference(scene, nullptr, rays).picture;
    scene.specular = find_model(choice.model);
    scene.specular_values = choice.model_values;
    Image drawn;
    render_cpu(scene, nullptr, 1, Precision::f64, drawn);
    float most = 0;
    for (const float value : everything.values) most = std::max(most, value);
    double worst = 0;
    std::size_t judged = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        // The rim is half background in both.
        if (everything.at(x, y)[3] < 1 || std::hypot(x - 31.5, y - 31.5) > 27) continue;
        Vec3 a{}, b{};
        for (std::size_t c = 0; c < 3; ++c)
          a[c] = static_cast<double>(everything.at(x, y)[c] / most),
          b[c] = static_cast<double>(drawn.at(x, y)[c] / most);
        worst = std::max(worst, delta_e2000(to_lab(to_rgb(a)), to_lab(to_rgb(b))));
        ++judged;
      }
    CHECK(judged > 2000);
    CHECK(worst <= choice.budget);
  }
}

TEST_CASE("a budget in codes is kept in codes") {
  const auto gold = MaterialLibrary::builtin().find("gold");
  const ChooseSubject subject = library_subject(*gold, gold->preferred_dataset(), 0.5);
  for (const double budget : {5.0, 8.0}) {
    const Choice choice = chosen(subject, budget, ErrorUnit::codes);
    CHECK(choice.picture_error <= budget);
    CHECK(choice.fresnel_error <= budget);
    CHECK(choice.picture_error == std::floor(choice.picture_error));
  }
}

TEST_CASE("what was chosen is read back as variants") {
  const Choice choice = chosen("gold");
  const ShadingVariants variants = parse_choices(choice_json({choice}, shipped_costs()), "c");
  REQUIRE(variants.find("gold") != nullptr);
  const MaterialVariant& gold = *variants.find("gold");
  CHECK(gold.model == choice.model);
  CHECK(gold.values.size() == choice.model_values.size());
  CHECK(gold.method == choice.method);
  CHECK(variants.find("iron") == nullptr);
  CHECK_THROWS_WITH(parse_choices("{\"schema\": \"x\"}", "c"), Catch::Contains("etak-choose/2"));
}

TEST_CASE("a smaller budget never takes a cheaper form") {
  double before = 0;
  for (const double budget : {8.0, 3.0, 1.0, 0.5}) {
    const double cost = chosen("titanium", budget).chosen_ns;
    CHECK(cost >= before / 1.15);
    before = cost;
  }
}

TEST_CASE("a budget that nothing meets gives the closest, and says how close and what is exact") {
  for (const double budget : {0.0, 1e-6}) {
    const Choice choice = chosen("gold", budget);
    CHECK(!choice.met);
    CHECK(largest_error(choice) > 0.1);
    CHECK(largest_error(choice) < 1);
    for (const Candidate& each : choice.fresnel_candidates) {
      INFO(each.id);
      CHECK(!each.within);
      CHECK(each.error >= choice.fresnel_error);
    }
    const std::string remark = unmet_remark(choice);
    CHECK(remark.starts_with("gold: no form of F stays within " + std::string(budget == 0 ? "0" : "1e-06") +
                             " ΔE2000"));
    CHECK(contains(remark, "etak render gold/"));
    CHECK(remark.size() < 250);
    // What the remark names is reached when it is asked for.
    const std::size_t at = remark.find("reached is ") + 11;
    const Choice again = chosen("gold", std::stod(remark.substr(at)));
    CHECK(again.met);
    CHECK(largest_error(again) <= again.budget);
  }
  const Choice codes =
      chosen(library_subject(*MaterialLibrary::builtin().find("gold"),
                             MaterialLibrary::builtin().find("gold")->preferred_dataset(), 0.75),
             0, ErrorUnit::codes);
  CHECK(largest_error(codes) >= (codes.met ? 0 : 1));
}

TEST_CASE("no choice is within the budget because its error makes up for another's") {
  for (const char* id : {"silver", "gold", "aluminum", "nickel"})
    for (const double budget : {0.3, 0.35, 0.5, 1.0}) {
      INFO(id << " " << budget);
      const Choice choice = chosen(id, budget);
      if (!choice.met) continue;
      // What F alone spends and what the integration alone adds fit into the budget together.
      double form = 0;
      for (const Candidate& each : choice.fresnel_candidates)
        if (each.id == choice.fresnel->id) form = each.error;
      for (const Candidate& each : choice.method_candidates)
        if (each.id == choice.method) {
          CHECK(each.error >= 0.999 * choice.fresnel_error);
          CHECK(each.error <= budget);
        }
      CHECK(form + choice.method_error <= budget + 1e-9);
    }
}

TEST_CASE("Schueler's techniques and lobes of other distributions are weighed beside GGX, F and masking") {
  // Germanium needs exact F, than which every whole model is cheaper.
  const Choice germanium = chosen("germanium");
  std::set<std::string> tried;
  for (const Candidate& each : germanium.model_candidates) {
    tried.insert(each.id);
    CHECK(each.within == (each.error <= 1));
    CHECK(each.cost_ns == shipped_costs().of("model/" + each.id));
  }
  for (const char* id : {"schueler-full", "schueler-simplified", "schueler-ksk", "schueler-optimized",
                         "schueler-optimized-bounded", "beckmann-schlick", "phong-schlick"})
    CHECK((tried.contains(id) || germanium.whole_model));
  // What costs nothing is taken as soon as its error is within the budget, and not before.
  CostTable costs = shipped_costs();
  costs.ns["model/schueler-ksk"] = 0.01;
  const auto material = MaterialLibrary::builtin().find("gold");
  const ChooseSubject gold = library_subject(*material, material->preferred_dataset(), 0.75);
  const Choice small = choose(gold, {1, ErrorUnit::delta_e}, costs);
  CHECK(!small.whole_model);
  REQUIRE(small.model_candidates.front().id == "schueler-ksk");
  const double error = small.model_candidates.front().error;
  CHECK(error > 1);
  const Choice large = choose(gold, {error + 0.01, ErrorUnit::delta_e}, costs);
  CHECK(large.whole_model);
  CHECK(large.model == "schueler-ksk");
  CHECK(large.model_values.size() == find_model(large.model)->value_count());
  CHECK(large.model_values.back() == 0.75);
  CHECK(largest_error(large) <= large.budget);
  CHECK(large.chosen_ns == Approx(0.01));
  CHECK(large.defines.front() == "ETAK_MODEL_SCHUELER_KSK");
  const ShadingVariants read = parse_choices(choice_json({large}, costs), "c");
  CHECK(read.find("gold")->model == large.model);
  CHECK(contains(choice_text({large}, costs), "schueler-ksk"));
}

TEST_CASE("the shipped costs have a row of its own for each level of PNG") {
  const auto levels = png_levels(shipped_costs());
  REQUIRE(levels.size() == 3);
  CHECK(levels[0].id == "fast");
  CHECK(levels[1].id == "small");
  CHECK(levels[2].id == "smallest");
  CHECK(levels[1].cost_ns > 2 * levels[0].cost_ns);
  CHECK(levels[2].cost_ns > 2 * levels[1].cost_ns);
}

TEST_CASE("a material without n and k is an error") {
  CHECK_THROWS_AS(chosen("brick"), Error);
}

TEST_CASE("masking terms are compared by one loop each, so that their costs differ by the terms alone") {
  double least = INFINITY, most = 0;
  for (const Term& term : terms()) {
    if (!masks_ggx(term)) continue;
    INFO(term.id);
    CHECK(find_model("microfacet:ggx,schlick," + std::string(term.id))->has_far_loop());
    const double cost = shipped_costs().of("visibility/" + std::string(term.id));
    least = std::min(least, cost);
    most = std::max(most, cost);
  }
  // Each is a whole lobe, of which masking is a part.
  CHECK(most < 2 * least);
  CHECK(shipped_costs().of("visibility/implicit") <= 1.15 * least);
}

TEST_CASE("a cost table reads back, and says what is wrong with it") {
  CHECK(parse_costs(format_costs(shipped_costs()), "c").ns.size() == shipped_costs().ns.size());
  CHECK_THROWS_WITH(parse_costs("{\"schema\": \"etak-costs/1\", \"header\": \"\", \"ns\": {\"a\": -1}}", "c"),
                    Catch::Contains("c#/ns/a"));
}

TEST_CASE("choices for many are those for each, in their order, and an error of one is thrown") {
  const MaterialLibrary library = MaterialLibrary::builtin();
  std::vector<ChooseSubject> subjects;
  std::vector<std::string> remarks;
  for (const char* id : {"gold", "water", "silicon"}) {
    const Material material = *library.find(id);
    subjects.push_back(library_subject(material, material.preferred_dataset(), Gloss(0.5), remarks));
  }
  CHECK(remarks.empty());
  std::atomic<int> told{0};
  const std::vector<Choice> all = choose_each(subjects, {}, shipped_costs(), 2, [&](unsigned) { ++told; });
  REQUIRE(all.size() == 3);
  CHECK(told == 3);
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(all[i].material == subjects[i].name);
    CHECK(choice_json({all[i]}, shipped_costs()) ==
          choice_json({choose(subjects[i], {}, shipped_costs())}, shipped_costs()));
  }
  CostTable costs = shipped_costs();
  costs.ns.erase("fresnel/f82");
  CHECK_THROWS_WITH(choose_each(subjects, {}, costs, 2), Catch::Contains("fresnel/f82"));
}

TEST_CASE("a budget that is no finite number of at least 0 is refused by its name") {
  for (const double bad : {-1.0, double{NAN}, double{INFINITY}})
    CHECK_THROWS_WITH(validate(ChooseOptions{bad}), Catch::StartsWith("budget: "));
  CHECK_NOTHROW(validate(ChooseOptions{0}));
}

TEST_CASE("a material without a given gloss is compared with that of its class, which is told") {
  const Material gold = *MaterialLibrary::builtin().find("gold");
  std::vector<std::string> remarks;
  const ChooseSubject subject = library_subject(gold, gold.preferred_dataset(), std::nullopt, remarks);
  REQUIRE(remarks.size() == 1);
  CHECK(remarks[0].starts_with("gold: "));
  CHECK(subject.texel.gloss >= 0);
}

TEST_CASE("a stack is weighed as a curve, as F82 and as the films of renderers, by error and cost") {
  const Material stack = *MaterialLibrary::builtin().find("anatase:40nm/titanium");
  const ChooseSubject subject = library_subject(stack, stack.preferred_dataset(), Gloss(0.75));
  const Choice near = choose(subject, {0.1, ErrorUnit::delta_e}, shipped_costs());
  CHECK(near.met);
  CHECK(near.fresnel->id == "curve");
  CHECK(near.model == "microfacet:ggx,curve," + near.visibility);
  CHECK(near.model_values.size() == 3 * FresnelCurve::count + 1);
  // The curve that is drawn is the stack, by the exact sums.
  const SeenStack seen(std::get<Stack>(stack.preferred_dataset().optics));
  for (const double cosine : {1.0, 0.6, 0.2}) {
    FresnelCurve drawn;
    for (std::size_t i = 0; i < FresnelCurve::count; ++i)
      for (std::size_t c = 0; c < 3; ++c) drawn.colors[i][c] = near.model_values[3 * i + c];
    CHECK(difference(ErrorUnit::delta_e, drawn.at(cosine), seen(cosine)) < 0.1);
  }
  // A wider budget takes what costs less.
  const Choice far = choose(subject, {30, ErrorUnit::delta_e}, shipped_costs());
  CHECK(far.met);
  CHECK(far.chosen_ns < near.chosen_ns);
  std::vector<std::string> films;
  for (const Candidate& each : near.film_candidates) {
    films.push_back(each.id);
    CHECK(each.cost_ns == shipped_costs().of("film/" + each.id));
    CHECK(each.within == (each.error <= 0.1));
    const FilmForm& form = *film_form(each.id);
    const FilmParameters told = film_parameters(std::get<Stack>(stack.preferred_dataset().optics),
                                                FilmBase::metal, {}, std::array{&form});
    CHECK(each.error >=
          difference(ErrorUnit::delta_e, form.seen(told.forms[0].used().numbers, 0.5), seen(0.5)) - 1e-3);
  }
  std::ranges::sort(films);
  CHECK(films == std::vector<std::string>{"conductor_bsdf", "generalized_schlick_bsdf", "gltf",
                                          "openpbr-adobe-metal", "openpbr-metal"});
}

TEST_CASE("materials without layers are weighed without curves and films") {
  const Material gold = *MaterialLibrary::builtin().find("gold");
  const Choice choice = choose(library_subject(gold, gold.preferred_dataset(), Gloss(0.75)),
                               {0.001, ErrorUnit::delta_e}, shipped_costs());
  CHECK(choice.film_candidates.empty());
  for (const Candidate& each : choice.fresnel_candidates) CHECK(each.id != "curve");
}
