// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "app/cli/options/scene.h"
#include "app/cli/output/output.h"
#include "app/cli/shader/atlas.h"
#include "app/cli/verbs.h"
#include "core/atlas/variant.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json_text.h"
#include "core/base/number.h"
#include "core/base/text.h"
#include "core/render/glsl/glsl_text.h"

namespace etak::cli {
namespace {

struct ShaderArguments {
  SceneArguments scene;
  std::string hemispheres, choice, layout, material, defines;
  bool es = false, vertex = false;
  OutputArguments output;
};

// `count` directional lights spread over the half space before the object.
std::vector<Light> spread_lights(int count) {
  std::vector<Light> out;
  for (int i = 0; i < count; ++i) {
    const double z = 0.25 + 0.7 * (i + 0.5) / count, s = std::sqrt(1 - z * z);
    const double turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
    Light light;
    light.direction = {-s * std::cos(turn), -s * std::sin(turn), -z};
    out.push_back(light);
  }
  return out;
}

// --lights N; none when it names a file.
std::optional<int> light_count(const std::string& text) {
  double count = 0;
  if (text.empty() || !parse_number(text, count)) return std::nullopt;
  if (!(count >= 0 && count <= 64 && count == std::floor(count)))
    throw Error::at("--lights", text, "0 to 64 directional lights, or a file");
  return static_cast<int>(count);
}

// A material as `etak choose` found it, in place of a subject and a model: its mean texel.
MaterialVariant take_choice(ShaderArguments& arguments) {
  if (!arguments.scene.subject.empty() || !arguments.scene.model.empty())
    throw Error::at("--choice", "given beside a material or --model", "--material NAME of the choice");
  const ShadingVariants choices = parse_choices(read_file(arguments.choice), arguments.choice);
  const MaterialVariant* variant = choices.find(arguments.material);
  if (arguments.material.empty() && choices.materials.size() == 1) variant = &choices.materials.front();
  if (variant == nullptr)
    throw Error::at("--material", arguments.material.empty() ? "no name" : printable(arguments.material),
                    joined(choices.materials, ", ", &MaterialVariant::material));
  const auto colour = [](const char* name, const std::array<double, 3>& c) {
    return std::string(name) + '=' + number(c[0], 17) + ',' + number(c[1], 17) + ',' + number(c[2], 17);
  };
  arguments.scene.subject = {colour("f0", variant->f0), colour("diffuse", variant->diffuse),
                             variant->gloss.given_roughness()
                                 ? "roughness=" + number(*variant->gloss.given_roughness(), 17)
                                 : "gloss=" + number(double{variant->gloss}, 17)};
  arguments.scene.model = variant->model;
  return *variant;
}

Scene shader_scene(ShaderArguments& arguments) {
  std::optional<MaterialVariant> variant;
  if (!arguments.choice.empty()) variant = take_choice(arguments);
  const std::optional<int> count = light_count(arguments.scene.lights);
  if (count) arguments.scene.lights.clear();
  SceneNotes notes;
  Scene scene = scene_of(arguments.scene, notes);
  if (variant) {
    scene.specular_values = variant->values;
    validate(scene);
  }
  if (count) {
    scene.lights.lights = spread_lights(*count);
    scene.lights.hemispheres.reset();
  }
  if (!arguments.hemispheres.empty()) {
    if (!scene.lights.hemispheres) scene.lights.hemispheres.emplace();
    scene.lights.hemispheres->form = *hemisphere_form_named(arguments.hemispheres);
  }
  tell_held_gloss(scene, notes);
  for (const std::string& each : notes.remarks) remark(arguments.output, each);
  return scene;
}

// The shader with what is in it and what is not as comments; the first line must stay the version.
std::string text_form(const GlslText& text, bool vertex) {
  if (vertex) return text.vertex;
  const std::size_t first_line = text.fragment.find('\n') + 1;
  std::string out = text.fragment.substr(0, first_line);
  for (const bool in : {true, false})
    for (const GlslFeature& each : text.features)
      if (each.in == in)
        out += std::string(in ? "// in:       " : "// left out: ") + each.name + ": " + each.reason + '\n';
  return out + text.fragment.substr(first_line);
}

std::string json_features(const GlslText& text, bool in) {
  std::string out;
  for (const GlslFeature& each : text.features)
    if (each.in == in)
      out += std::string(out.empty() ? "" : ",") + "\n    {\"name\": " + json(each.name) +
             (in ? ", \"what\": " : ", \"reason\": ") + json(each.reason) + "}";
  return "[" + out + (out.empty() ? "]" : "\n  ]");
}

std::string json_form(const GlslText& text, GlslVersion version) {
  std::string out = "{\n  \"schema\": \"etak-shader/1\",\n  \"version\": " + json(name(version)) +
                    ",\n  \"in\": " + json_features(text, true) +
                    ",\n  \"left_out\": " + json_features(text, false) + ",\n  \"uniforms\": [";
  for (std::size_t i = 0; i < text.uniforms.size(); ++i) {
    const GlslUniform& each = text.uniforms[i];
    out += std::string(i == 0 ? "" : ",") + "\n    {\"name\": " + json(each.name) +
           ", \"type\": " + json(each.width == 1 ? "float" : "vec" + std::to_string(each.width)) +
           (each.array ? ", \"count\": " + std::to_string(each.count) : "") + ", \"values\": [";
    for (std::size_t j = 0; j < each.values.size(); ++j)
      out += (j == 0 ? "" : ", ") + number(double{each.values[j]}, 9);
    out += "]}";
  }
  return out + (text.uniforms.empty() ? "]" : "\n  ]") + ",\n  \"vertex\": " + json(text.vertex) +
         ",\n  \"fragment\": " + json(text.fragment) + "\n}\n";
}

// What is fetched from an atlas, when one is named; its constants then stand in for the material.
std::optional<TextureUse> textures_of(ShaderArguments& arguments) {
  if (arguments.layout.empty()) {
    if (!arguments.material.empty() && arguments.choice.empty())
      throw Error::at("--material", "given alone", "--layout or --choice with it");
    if (arguments.defines.empty()) return std::nullopt;
    return defined_use(arguments.defines);
  }
  if (!arguments.scene.subject.empty() || !arguments.defines.empty() || !arguments.choice.empty())
    throw Error::at("--layout", "given beside a material, --choice or --defines", "one of them");
  AtlasShader atlas = atlas_shader(arguments.layout, arguments.material);
  arguments.scene.subject = std::move(atlas.subject);
  return atlas.use;
}

int run(ShaderArguments& arguments) {
  const GlslVersion version = arguments.es ? GlslVersion::es_300 : GlslVersion::core_330;
  const std::optional<TextureUse> textures = textures_of(arguments);
  const Scene scene = shader_scene(arguments);
  const GlslText text = textures ? glsl_text(scene, *textures, version) : glsl_text(scene, version);
  write_output(arguments.output, arguments.output.format == "json" ? json_form(text, version)
                                                                   : text_form(text, arguments.vertex));
  return exit_ok;
}

}  // namespace

void add_shader(CommandLine& line) {
  const auto arguments = std::make_shared<ShaderArguments>();
  Command verb = line.verb("shader", "the GLSL that draws a material: what it needs and nothing else");
  add_scene_options(verb, arguments->scene);
  verb.find("--lights")
      ->help("number of directional lights, or a light setup; default three lights and two hemispheres")
      .value_name("N|FILE");
  verb.option("--hemispheres", arguments->hemispheres,
              "light of two hemispheres; FORM: corrected (the default), wide or printed")
      .may_lack_value()
      .show_default("corrected")
      .one_of({"corrected", "wide", "printed"})
      .value_name("FORM");
  verb.option("--choice", arguments->choice,
              "a material of what etak choose found: its Fresnel form, masking and numbers")
      .reads_file()
      .value_name("FILE");
  verb.option("--material", arguments->material, "which of the choice or the layout").value_name("NAME");
  verb.option("--layout", arguments->layout,
              "layout.json of etak pack: values that vary come from its textures, the rest are "
              "uniforms")
      .reads_file()
      .value_name("FILE");
  verb.option("--defines", arguments->defines,
              "what is fetched from the two textures, as etak pack lists it: a file with a "
              "define a line")
      .reads_file()
      .value_name("FILE");
  verb.flag("--es", arguments->es, "#version 300 es instead of 330 core");
  verb.flag("--vertex", arguments->vertex, "the vertex shader instead (JSON holds both)");
  add_output_options(verb, arguments->output, {"text", "json"});
  verb.footer(
      "What was left out is listed with its reason at the head of the text.\n"
      "Example:\n  etak shader gold --model schueler-full --lights 2 --es");
  verb.runs([arguments] { return run(*arguments); });
}

}  // namespace etak::cli
