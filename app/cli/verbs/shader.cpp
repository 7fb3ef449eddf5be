// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <memory>
#include <optional>

#include "app/cli/options/scene.h"
#include "app/cli/output/output.h"
#include "app/cli/shader/subject.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/number.h"
#include "core/pages/lists/lists.h"
#include "core/render/glsl/glsl_text.h"

namespace etak::cli {
namespace {

struct ShaderArguments {
  SceneArguments scene;
  std::string hemispheres, choice, layout, material, defines;
  bool es = false, vertex = false;
  OutputArguments output;
};

// The number of lights of --lights N; none where --lights names a file or is not given. Throws Error.
std::optional<int> light_count(const std::string& text) {
  double count = 0;
  if (text.empty() || !parse_number(text, count)) return std::nullopt;
  if (!(count >= 0 && count <= 64 && count == std::floor(count)))
    throw Error::at("--lights", text, "0 to 64 directional lights, or a file");
  return static_cast<int>(count);
}

// Takes subject and model from the result of `etak choose`: the material's mean texel and its chosen model.
MaterialVariant take_choice(ShaderArguments& arguments) {
  if (!arguments.scene.subject.empty() || !arguments.scene.model.empty())
    throw Error::at("--choice", "given beside a material or --model", "--material NAME of the choice");
  MaterialVariant variant = variant_of_choice(arguments.choice, arguments.material);
  arguments.scene.subject = subject_of(variant);
  arguments.scene.model = variant.model;
  return variant;
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

// The values that the shader fetches from textures; none where no texture is used. With --layout, the
// constants of the atlas's material become the subject.
std::optional<TextureUse> textures_of(ShaderArguments& arguments) {
  if (arguments.layout.empty()) {
    if (!arguments.material.empty() && arguments.choice.empty())
      throw Error::at("--material", "given alone", "--layout or --choice with it");
    if (arguments.defines.empty()) return std::nullopt;
    return texture_use(read_file(arguments.defines));
  }
  if (!arguments.scene.subject.empty() || !arguments.defines.empty() || !arguments.choice.empty())
    throw Error::at("--layout", "given beside a material, --choice or --defines", "one of them");
  const LayoutShader shader = shader_of_layout(arguments.layout, arguments.material);
  arguments.scene.subject = subject_of(shader);
  return shader.use;
}

int run(ShaderArguments& arguments) {
  const GlslVersion version = arguments.es ? GlslVersion::es_300 : GlslVersion::core_330;
  const std::optional<TextureUse> textures = textures_of(arguments);
  const Scene scene = shader_scene(arguments);
  const GlslText text = textures ? glsl_text(scene, *textures, version) : glsl_text(scene, version);
  write_output(arguments.output, arguments.output.format == "json" ? shader_json(text, version)
                                 : arguments.vertex                ? text.vertex
                                                                   : annotated_fragment(text));
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
