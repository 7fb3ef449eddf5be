// SPDX-License-Identifier: Apache-2.0
// Every reader of etak, and what its verbs do with long lists, over four doublings: see check_growth().
#include <catch2/catch.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/atlas/layout.h"
#include "core/atlas/leave_out.h"
#include "core/atlas/manifest.h"
#include "core/atlas/variant.h"
#include "core/base/text/free_names.h"
#include "core/exchange/rii/rii_page.h"
#include "core/exchange/table.h"
#include "core/findings/baseline.h"
#include "core/findings/output/formats.h"
#include "core/findings/report.h"
#include "core/judge/rules.h"
#include "core/material/json.h"
#include "core/material/library.h"
#include "core/project/project.h"
#include "core/rects/rects.h"
#include "core/rects/text.h"
#include "core/scene/gltf.h"
#include "core/scene/texel_scale.h"
#include "core/scene/uv_use.h"
#include "core/study/choose/choose.h"
#include "tests/growth.h"

using namespace etak;
using test::check_growth;
using test::listed;

namespace {

// Number i of `count`, in micrometres, ascending.
std::string wavelength_um(std::size_t i, std::size_t count) {
  return std::to_string(0.38 + 0.4 * static_cast<double>(i) / static_cast<double>(count));
}

std::string rows_of(std::size_t count, const std::string& before, const std::string& between) {
  std::string out;
  for (std::size_t i = 0; i < count; ++i)
    out += before + wavelength_um(i, 1000000) + between + "1.5" + between + "0.1\n";
  return out;
}

std::string scene(std::size_t nodes, std::size_t meshes, std::size_t materials, std::size_t images) {
  const auto number = [](const char* head, std::size_t i, const char* tail) {
    return head + std::to_string(i) + tail;
  };
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"buffers":[{"byteLength":36,"uri":"data:;base64,)"
         R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)" +
         listed(
             "\"nodes\":[", nodes,
             [&](std::size_t i) {
               const std::string mesh = number("{\"mesh\":", i % meshes, "");
               return i + 1 < nodes ? mesh + number(",\"children\":[", i + 1, "]}") : mesh + "}";
             },
             "],") +
         listed(
             "\"meshes\":[", meshes,
             [&](std::size_t i) {
               return number(R"({"primitives":[{"attributes":{"POSITION":0},"material":)", i % materials,
                             "}]}");
             },
             "],") +
         listed(
             "\"materials\":[", materials,
             [&](std::size_t i) {
               return number(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":)", i % images, "}}}");
             },
             "],") +
         listed(
             "\"textures\":[", images, [&](std::size_t i) { return number("{\"source\":", i, "}"); }, "],") +
         listed(
             "\"images\":[", images, [&](std::size_t i) { return number("{\"uri\":\"p", i, ".png\"}"); },
             "]}");
}

ValidationReport report_with(std::size_t findings, bool one_place) {
  std::vector<CheckedFile> files(1);
  files[0].path = "crate.png";
  files[0].width = files[0].height = 4096;
  for (std::size_t i = 0; i < findings; ++i) {
    Finding finding = finding_of(*find_rule("ETK101"), Severity::warning);
    finding.file = files[0].path;
    finding.message = "F0 0.3";
    const int at = static_cast<int>(i % 4000);
    finding.box = {at, static_cast<int>(i / 4000 % 4000), 50, 50};
    if (!one_place) finding.pointer = "/materials/" + std::to_string(i);
    files[0].findings.push_back(std::move(finding));
  }
  return report_of(std::move(files), Settings{});
}

}  // namespace

TEST_CASE("tables and pages are read in time proportional to their rows") {
  const auto table = [](const std::string& text) { (void)parse_table(text, "t.csv", {}); };
  const auto page = [](const std::string& text) {
    RiiPage out;
    parse_rii_page(text, "p.yml", out);
  };
  check_growth(
      "comma", 4000, [](std::size_t n) { return "wavelength_um,n,k\n" + rows_of(n, "", ","); }, table);
  check_growth(
      "tab", 4000, [](std::size_t n) { return "wavelength_um\tn\tk\n" + rows_of(n, "", "\t"); }, table);
  const std::string head = "REFERENCES: \"a\"\nDATA:\n  - type: tabulated nk\n    data: |\n";
  check_growth(
      "page", 4000, [&](std::size_t n) { return head + rows_of(n, "        ", " "); }, page);
  check_growth(
      "references", 4000,
      [](std::size_t n) {
        std::string text = "REFERENCES: |\n";
        for (std::size_t i = 0; i < n; ++i) text += "    A. Author, <i>Journal</i> 1, 2 (2000)\n";
        return text +
               "DATA:\n  - type: tabulated nk\n    data: |\n        0.38 1.5 0.1\n        0.78 1.5 0.1\n";
      },
      [](const std::string& text) { (void)material_from_rii_page(text, "p.yml", ""); });
}

TEST_CASE("materials, manifests and projects are read in time proportional to their parts") {
  const std::string gold = format_material(*MaterialLibrary::builtin().find("gold"));
  const std::string flat = R"("diffuse":[0.5,0.5,0.5],"specular":[0.04,0.04,0.04],"gloss":0.5})";
  const auto named = [&](std::size_t i) { return "{\"name\":\"m" + std::to_string(i) + "\"," + flat; };
  check_growth(
      "manifest", 1000, [&](std::size_t n) { return listed("{\"materials\":[", n, named, "]}"); },
      [](const std::string& text) { (void)parse_manifest(text, "m.json"); });
  const auto read_project = [](const std::string& text) { (void)parse_project(text, "p.json"); };
  check_growth(
      "project", 1000,
      [&](std::size_t n) { return listed(R"({"schema":"etak-project/1","materials":[)", n, named, "]}"); },
      read_project);
  check_growth(
      "spectra", 4,
      [&](std::size_t n) {
        const auto spectrum = [&](std::size_t i) {
          std::string out = gold;
          return out.replace(out.find("\"gold\""), 6, "\"gold" + std::to_string(i) + "\"");
        };
        return listed(R"({"schema":"etak-project/1","materials":[],"spectra":[)", n, spectrum, "]}");
      },
      read_project);
  check_growth(
      "aliases", 2000,
      [&](std::size_t n) {
        std::string out = gold;
        const auto alias = [](std::size_t i) { return "\"a" + std::to_string(i) + "\""; };
        return out.replace(out.find("[\"Au\"]"), 6, listed("[", n, alias, "]"));
      },
      [](const std::string& text) { (void)parse_material(text, "gold.json"); });
}

TEST_CASE("scenes are read in time proportional to nodes, meshes, materials and images") {
  const auto read = [](const std::string& text) { (void)parse_gltf(text, "s.gltf", {}); };
  check_growth(
      "nodes", 500, [](std::size_t n) { return scene(n, 1, 1, 1); }, read);
  check_growth(
      "meshes", 500, [](std::size_t n) { return scene(n, n, 1, 1); }, read);
  check_growth(
      "materials", 500, [](std::size_t n) { return scene(1, 1, n, 1); }, read);
  check_growth(
      "images", 500, [](std::size_t n) { return scene(n, n, n, n); }, read);
}

TEST_CASE("free names are found in time proportional to their number, however many are equal") {
  const auto project = [](std::size_t n) {
    Project out;
    out.materials.resize(n);
    for (std::size_t i = 0; i < n; ++i) out.materials[i].name = "m" + std::to_string(i);
    return out;
  };
  check_growth("names", 1000, project, [](const Project& taken) {
    FreeNames names = names_of(taken);
    std::string last;
    for (std::size_t i = 0; i < taken.materials.size(); ++i) last = free_name(names, "m0");
    CHECK(last == "m0 " + std::to_string(taken.materials.size() + 1));
  });
}

TEST_CASE("layouts, choices, cost tables and rectangles are read in time proportional to their parts") {
  const auto layout = [](std::size_t n) {
    AtlasLayout out;
    out.pages.resize(n, {64, 64, {{{"a.png"}, {"b.png"}}}});
    for (std::size_t i = 0; i < n; ++i) {
      AtlasRect& rect = out.rects.emplace_back();
      rect.name = "m" + std::to_string(i);
      rect.page = static_cast<int>(i);
      rect.width = rect.height = rect.source_width = rect.source_height = 4;
      rect.crop = {0, 0, 4, 4};
      out.materials.emplace_back().name = rect.name;
      out.other_files.push_back("f" + std::to_string(i) + ".png");
    }
    return out;
  };
  check_growth("layout, written", 250, layout, [](const AtlasLayout& out) { (void)layout_json(out); });
  check_growth(
      "layout", 250, [&](std::size_t n) { return layout_json(layout(n)); },
      [](const std::string& text) { (void)parse_layout(text, "l.json"); });
  const auto choice = [](std::size_t i) {
    return "{\"material\":\"m" + std::to_string(i) +
           R"(","model":"lambert","values":[],"filter":"constant","textured":false,"codes":[0,0,0,0,0,0,0,0],)"
           R"("diffuse":[0,0,0],"f0":[0,0,0],"gloss":0.5,"defines":["A"]})";
  };
  check_growth(
      "choices", 500,
      [&](std::size_t n) {
        return listed(R"({"schema":"etak-choose/2","png_level":"fast","choices":[)", n, choice, "]}");
      },
      [](const std::string& text) {
        const ShadingVariants all = parse_choices(text, "c.json");
        std::size_t found = 0;
        for (std::size_t i = 0; i < all.materials.size(); ++i)
          found += all.find("m" + std::to_string(i)) != nullptr ? 1 : 0;
        CHECK(found == all.materials.size());
      });
  const auto cost = [](std::size_t i) { return "\"fresnel/f" + std::to_string(i) + "\":1.5"; };
  check_growth(
      "costs", 2000,
      [&](std::size_t n) { return listed(R"({"schema":"etak-costs/1","header":"","ns":{)", n, cost, "}}"); },
      [](const std::string& text) { (void)format_costs(parse_costs(text, "c.json")); });
  check_growth(
      "rectangles", 8000,
      [](std::size_t n) {
        std::string out;
        for (std::size_t i = 0; i < n; ++i) out += std::to_string(1 + i % 64) + " 7\n";
        return out;
      },
      [](const std::string& text) { (void)parse_rects(text, "r.txt"); });
}

TEST_CASE("what an atlas leaves out is found in time proportional to its materials") {
  // Constants alone, pictures that all differ, and pictures that all are one.
  for (const char* kind : {"constants", "pictures", "one picture"}) {
    const std::string what = kind;
    check_growth(
        kind, 1000,
        [&](std::size_t n) {
          std::vector<MaterialFacts> out(n);
          for (std::size_t i = 0; i < n; ++i) {
            MaterialFacts& m = out[i];
            m.width = m.height = 8;
            m.crop = {0, 0, 8, 8};
            m.learned = true;
            m.range.least.fill(0);
            m.range.most.fill(what == "constants" ? 0 : 255);
            m.color_hash = m.specular_hash = {what == "pictures" ? i : 1, 0};
          }
          return out;
        },
        [&](const std::vector<MaterialFacts>& materials) {
          const LeaveOut out = leave_out(materials, {});
          CHECK(out.fates.back().texels == (what != "constants"));
          CHECK((out.fates.back().owner == 0) == (what == "one picture"));
        });
  }
}

TEST_CASE("texels in use and texel scales of all materials take time in proportion to uses and materials") {
  const auto uses = [](std::size_t n) {
    GltfScene scene;
    scene.materials.resize(n);
    scene.uses.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      GltfUse& use = scene.uses[i];
      use.material = static_cast<int>(i * 7919 % n);
      use.uv[0] = {{{{0, 0}, {1, 0}, {1, 1}}}};
      use.world_area = {0.5f};
      use.world_edges = {{1, 0, 1}};
      use.world_center = {{0, 0, 0}};
      use.world_radius = {1};
    }
    return scene;
  };
  check_growth("uses", 2000, uses, [](const GltfScene& scene) {
    const MaterialUses by_material(scene);
    std::size_t touched = 0;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
      touched += texel_use(by_material, static_cast<int>(i), GltfTexture{}, 2, 2).touched > 0 ? 1 : 0;
      (void)texel_scale(by_material, static_cast<int>(i), GltfTexture{}, 2, 2, 0);
    }
    CHECK(touched > 0);
  });
}

TEST_CASE("findings and baselines take time in proportion to their number") {
  const auto entry = [](std::size_t i) {
    return R"({"rule":"ETK101","file":"f)" + std::to_string(i) + R"(.png"})";
  };
  check_growth(
      "reading a baseline", 1000,
      [&](std::size_t n) { return listed(R"({"schema":"etak-baseline/1","findings":[)", n, entry, "]}"); },
      [](const std::string& text) { (void)read_baseline(text, "b.json"); });
  for (const bool one_place : {false, true})
    check_growth(
        one_place ? "known defects of one name" : "known defects", 500,
        [&](std::size_t n) { return report_with(n, one_place); },
        [](const ValidationReport& report) {
          ValidationReport marked = report;
          // A stranger's baseline need not have the regions that etak writes.
          std::vector<KnownDefect> known = baseline_of(report);
          for (std::size_t i = 0; i < 20 * report.files[0].findings.size(); ++i) {
            known.push_back(known[i % known.size()]);
            known.back().region = {500, static_cast<int>(i % 1000), 900, 900};
          }
          mark_known(marked, known);
          CHECK(marked.files[0].findings[0].baseline);
        });
  const auto report = [](std::size_t n) { return report_with(n, false); };
  check_growth("text", 200, report, [](const auto& r) { (void)validation_text(r); });
  check_growth("JSON", 200, report, [](const auto& r) { (void)validation_json(r, {}); });
  check_growth("SARIF", 200, report, [](const auto& r) { (void)validation_sarif(r, {}); });
  check_growth("JUnit", 200, report, [](const auto& r) { (void)validation_junit(r, {}); });
  check_growth("CSV", 200, report, [](const auto& r) { (void)validation_csv(r); });
  check_growth("GitHub", 200, report, [](const auto& r) { (void)validation_github(r); });
}

TEST_CASE("rectangles are placed in time proportional to their number") {
  const auto sizes = [](std::size_t n) {
    std::mt19937 random(1);
    std::vector<RectSize> out;
    for (std::size_t i = 0; i < n; ++i)
      out.push_back({static_cast<int>(1 + random() % 64), static_cast<int>(1 + random() % 64)});
    return out;
  };
  const auto packed = [](PageForm form, int side) {
    return [form, side](const std::vector<RectSize>& all) {
      RectOptions options;
      options.form = form;
      options.side = side;
      options.effort = 1;
      (void)pack_rects(all, options);
    };
  };
  check_growth("strip", 1000, sizes, packed(PageForm::strip, 4096));
  check_growth("pages", 1000, sizes, packed(PageForm::pages, 1024));
  // A page costs what it takes, not what it leaves: of these there are two thousand in the end.
  check_growth("many pages", 8000, sizes, packed(PageForm::pages, 256));
  check_growth("many mixed pages", 8000, sizes, packed(PageForm::mixed, 256));
}
