// SPDX-License-Identifier: Apache-2.0
#include "core/base/json/json_text.h"
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

void write_usd(const TargetJob& j) {
  LinearRgb f0;
  if (j.metal()) {
    f0 = j.fit_f0("diffuseColor", "diffuseColor ends at 1");
    j.add("diffuseColor", f0, plain_text);
    j.add("metallic", 1);
  } else {
    const double reflected = fitted(j.one_f0("ior is one number"), 0, largest_dielectric_f0, "F0",
                                    "the index of a dielectric has to be finite", j.out.changes);
    const double ior = j.s.ior.value_or(ior_of_f0(reflected));
    f0 = grey(f64::f0(ior, 0));
    j.add("diffuseColor", j.layered_body(), plain_text);
    j.add("metallic", 0);
    j.add("ior", ior);
  }
  j.add("roughness", j.roughness());
  if (j.clear() || j.s.opacity < 1) j.add("opacity", j.clear() ? 0 : j.s.opacity);
  if (j.clear()) j.note("opacity 0 with opacityMode transparent keeps the reflection; it does not refract");
  j.note_absorption("no input takes it");
  j.schlick_edge(f0);
  j.shows_schlick(f0);
}

std::string usd_body(const ExportSurface& s, const EngineValues& values) {
  const std::string name = identifier(s.node_name());
  std::string out = "    def Material \"" + name + "\" (\n        doc = " + json(s.title()) +
                    "\n    )\n    {\n        token outputs:surface.connect = </materials/" + name +
                    "/surface.outputs:surface>\n\n        def Shader \"surface\"\n        {\n"
                    "            uniform token info:id = \"UsdPreviewSurface\"\n";
  for (const EngineField& field : values.fields)
    out += "            " + (field.values.size() == 3
                                 ? "color3f inputs:" + field.name + " = (" + field.text + ")\n"
                                 : "float inputs:" + field.name + " = " + field.text + "\n");
  return out + "            token outputs:surface\n        }\n    }\n";
}

}  // namespace

constinit const TargetRow target_usd{
    {.id = "usd",
     .title = "USD, UsdPreviewSurface",
     .version = "UsdPreviewSurface 2.6",
     .formula = "Schlick from the F0 of ior, or diffuseColor of a metal, to 1",
     .opens =
         "#usda 1.0\n(\n    defaultPrim = \"materials\"\n    metersPerUnit = 1\n    upAxis = \"Y\"\n)\n\n"
         "def Scope \"materials\"\n{\n",
     .closes = "}\n"},
    write_usd,
    usd_body};

}  // namespace etak
