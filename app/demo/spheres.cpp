// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <string_view>

#include "app/demo/parts.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/exchange/engine_values.h"
#include "core/image/files/png.h"
#include "core/light/studio.h"
#include "core/material/quality.h"
#include "core/render/environment.h"
#include "core/render/scene.h"
#include "core/study/choose/choose.h"
#include "core/study/sphere_looks.h"

namespace etak::demo {
namespace {

// The first rows have one of each kind.
constexpr std::array<std::string_view, 24> shown_materials{
    "gold",      "copper",   "silver",      "iron",        "titanium_nitride",  "silicon",       "diamond",
    "water",     "aluminum", "chromium",    "nickel",      "titanium",          "tungsten",      "platinum",
    "palladium", "cobalt",   "mercury",     "brass_70_30", "bronze_commercial", "stainless_316", "graphite",
    "germanium", "sapphire", "fused_silica"};

// Which materials have a sphere of a way beside the measured one.
enum class OnWall { none, all, opaque, clear };
struct ShownWay {
  std::string_view form, title;
  OnWall wall;
};
constexpr std::array<ShownWay, 6> shown_ways{{{"schueler", "Schüler", OnWall::none},
                                              {"schlick", "Schlick", OnWall::all},
                                              {"f82", "F82", OnWall::opaque},
                                              {"from_f0", "exact from F0", OnWall::clear},
                                              {"lazanyi", "Lazányi", OnWall::none},
                                              {"index", "n, k from F0 and F82", OnWall::none}}};

constexpr std::array<std::string_view, 7> shown_targets{"unreal", "unity-metallic", "blender", "filament",
                                                        "gltf",   "openpbr",        "hex"};

// A lobe narrow enough that the studio shows in the spheres.
constexpr double gloss = 0.95;
constexpr double exposure = 0.7;
constexpr int side = 144;

// The studio with a floor half as bright as its wall. In its own dark floor the lower half of a metal is
// nearly black, and gold is olive there.
Environment bright_studio(unsigned threads) {
  Studio studio = *find_studio("studio");
  studio.floor = scaled(studio.horizon, 0.55);
  return {environment_picture(studio, 1024, threads), 1, "studio", threads};
}

StartMaterial drawn(const Material& material, const std::vector<SphereLook>& looks, bool clear) {
  StartMaterial out{material.id, material.name, {}, {}};
  const auto add = [&](std::string_view title, const SphereLook& look) {
    PngOptions options;
    options.level = PngLevel::small;
    out.spheres.push_back(
        {std::string(title), png_bytes(look.picture, options), look.mean_de, look.worst_de});
  };
  add("measured", looks.front());
  for (std::size_t i = 0; i < shown_ways.size(); ++i)
    if (const OnWall wall = shown_ways[i].wall;
        wall == OnWall::all || wall == (clear ? OnWall::clear : OnWall::opaque))
      add(shown_ways[i].title, looks[i + 1]);
  const Dataset& dataset = material.preferred_dataset();
  const F0Options options;
  const ExportSurface surface = export_surface(material, dataset, options,
                                               solve(F0Solver(options), material, dataset), {}, std::nullopt);
  for (const std::string_view id : shown_targets) {
    const EngineTarget& target = *engine_target(id);
    out.values.emplace_back(target.title, copy_text(engine_values(target, surface)));
  }
  return out;
}

}  // namespace

void add_spheres(const MaterialLibrary& library, unsigned threads, StartPageData& data) {
  std::array<const FresnelForm*, shown_ways.size()> forms;
  std::ranges::transform(shown_ways, forms.begin(),
                         [](const ShownWay& way) { return fresnel_form(way.form); });
  const Environment studio = bright_studio(threads);
  std::vector<std::vector<SphereLook>> looks(shown_materials.size());
  data.materials.resize(shown_materials.size());
  parallel_chunks(shown_materials.size(), threads, 1, [&](std::size_t i, std::size_t, unsigned) {
    const auto material = library.find(shown_materials[i]);
    if (!material) throw Error::at(std::string(shown_materials[i]), "is not in the library");
    const SurfaceValues surface = surface_of(*material, material->preferred_dataset(), {}, gloss);
    looks[i] = sphere_looks(fresnel_truth(surface.optics.value(), material->id), forms, studio,
                            {gloss, exposure, side, surface.passing});
    data.materials[i] = drawn(*material, looks[i], surface.passing.has_value());
  });
  const CostTable& costs = shipped_costs();
  data.costs = costs.header;
  for (std::size_t way = 0; way < shown_ways.size(); ++way) {
    StartPoint point{std::string(shown_ways[way].title),
                     costs.of("fresnel/" + std::string(shown_ways[way].form)), 0, looks[0][way + 1].mean_de,
                     0};
    for (const auto& of_material : looks) {
      const double error = of_material[way + 1].mean_de;
      point.mean_de += error / static_cast<double>(looks.size());
      point.least_de = std::min(point.least_de, error);
      point.most_de = std::max(point.most_de, error);
    }
    data.points.push_back(point);
  }
}

}  // namespace etak::demo
