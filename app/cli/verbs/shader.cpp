// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/options/scene.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/atlas/layout_shader.h"
#include "core/atlas/variant.h"
#include "core/base/bytes/bytes_le.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/output_folder.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/text/text.h"
#include "core/glsl/glsl_text.h"
#include "core/glsl/shader_function.h"
#include "core/light/studio.h"
#include "core/pages/lists/lists.h"
#include "core/render/environment.h"
#include "core/render/ground_bounce.h"

namespace etak::cli {
namespace {

const AtlasMaterialRow& material_named(const AtlasLayout& layout, const std::string& file,
                                       const std::string& name) {
  const auto& all = layout.materials;
  std::string names;
  for (const AtlasMaterialRow& row : all) {
    if (row.name == name || (name.empty() && all.size() == 1)) return row;
    if (names.size() < 200) names += (names.empty() ? "" : ", ") + row.name;
  }
  if (name.empty())
    throw Error::at("--layout", file + " holds " + std::to_string(all.size()) + " materials",
                    "--material with one of " + names);
  throw Error::at("--material", printable(name), "one of " + names);
}

std::string color_text(const char* name, const LinearRgb& c, int digits) {
  return std::string(name) + '=' + number(c.r, digits) + ',' + number(c.g, digits) + ',' +
         number(c.b, digits);
}

// The material of --material in the layout of --layout. `name` may be empty where the layout has only one
// material. Throws Error.
LayoutShader shader_of_layout(const std::string& layout_file, const std::string& name) {
  const AtlasLayout layout = parse_layout(read_file(layout_file), layout_file);
  return layout_shader(layout, material_named(layout, layout_file, name));
}

// The material of --material in the result of `etak choose` that --choice names. `name` may be empty where
// the result has only one material. Throws Error.
MaterialVariant variant_of_choice(const std::string& choice_file, const std::string& name) {
  const ShadingVariants choices = parse_choices(read_file(choice_file), choice_file);
  const MaterialVariant* variant = choices.find(name);
  if (name.empty() && choices.materials.size() == 1) variant = &choices.materials.front();
  if (variant == nullptr)
    throw Error::at("--material", name.empty() ? "no name" : printable(name),
                    joined(choices.materials, ", ", &MaterialVariant::material));
  return *variant;
}

// The values that are the same in all texels of a material, in the form that the line has: "f0=0.04",
// "gloss=0.5", ...
std::vector<std::string> subject_of(const LayoutShader& shader) {
  std::vector<std::string> out;
  if (shader.f0) out.push_back(color_text("f0", *shader.f0, 9));
  if (shader.diffuse) out.push_back(color_text("diffuse", *shader.diffuse, 9));
  if (shader.gloss) out.push_back("gloss=" + number(*shader.gloss, 9));
  if (shader.opacity) out.push_back("opacity=" + number(*shader.opacity, 9));
  if (out.empty()) out.push_back("f0=0.04");  // everything is fetched from textures: the value is not used
  return out;
}

std::vector<std::string> subject_of(const MaterialVariant& variant) {
  const auto roughness = variant.gloss.given_roughness();
  return {color_text("f0", to_rgb(variant.f0), 17), color_text("diffuse", to_rgb(variant.diffuse), 17),
          roughness ? "roughness=" + number(*roughness, 17) : "gloss=" + number(double{variant.gloss}, 17)};
}

struct ShaderArguments {
  SceneArguments scene;
  std::string hemispheres, choice, layout, material, defines, vertex, language = "glsl";
  std::string textures;  // folder
  bool es = false, vulkan = false, function = false, mesh = false, quick = false;
  OutputArguments output;
};

// Takes subject and model from the result of `etak choose`: the material's mean texel and its chosen model.
MaterialVariant take_choice(ShaderArguments& arguments) {
  if (!arguments.scene.subject.empty() || !arguments.scene.model.empty())
    throw Error::at("--choice", "given beside a material or --model", "--material NAME of the choice");
  MaterialVariant variant = variant_of_choice(arguments.choice, arguments.material);
  arguments.scene.subject = subject_of(variant);
  arguments.scene.model = variant.model;
  return variant;
}

Scene shader_scene(ShaderArguments& arguments, SceneNotes& notes) {
  std::optional<MaterialVariant> variant;
  if (!arguments.choice.empty()) variant = take_choice(arguments);
  Scene scene = scene_of(arguments.scene, notes);
  if (variant) {
    scene.specular_values = variant->values;
    validate(scene);
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

// The BRDF alone. Throws Error for options that say how a picture is drawn.
std::string function_of(ShaderArguments& arguments, ShaderLanguage language) {
  const std::string asked = arguments.function ? "--function" : "--language " + arguments.language;
  for (const auto& [given, option] :
       {std::pair(arguments.es, "--es"), std::pair(arguments.vulkan, "--vulkan"),
        std::pair(arguments.mesh, "--mesh"), std::pair(!arguments.vertex.empty(), "--vertex"),
        std::pair(!arguments.layout.empty(), "--layout"), std::pair(!arguments.defines.empty(), "--defines"),
        std::pair(!arguments.textures.empty(), "--textures")})
    if (given)
      throw Error::at(option, "given beside " + asked + ", which writes the BRDF alone", "one of them");
  SceneNotes notes;
  const std::string text = shader_function(shader_scene(arguments, notes), language);
  return arguments.output.format == "json" ? shader_function_json(text, language, notes.remarks) : text;
}

// Red, green and blue of a picture as a PFM file whose first row is the first of the texture, at v = 0: viewers show it upside
// down.
std::string texture_bytes(const Image& picture) {
  std::string out =
      "PF\n" + std::to_string(picture.width) + ' ' + std::to_string(picture.height) + "\n-1.0\n";
  out.reserve(out.size() + picture.pixel_count() * 12);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (const float value : picture.at(x, y).first(3)) bytes_le::append_float(out, value);
  return out;
}

// The pictures that the shader of an environment samples, for --textures. Throws Error.
void write_textures(const ShaderArguments& arguments, const LightSetup& lights) {
  const std::string& name = lights.environment;
  if (find_studio(name) == nullptr)
    throw Error::at("--textures", name.empty() ? "no environment" : "an environment of a file",
                    "--env with one of etak's own: " + joined(named_studios(), ", ", &NamedStudio::name));
  const unsigned threads = thread_count(0);
  const double scale = lights.environment_scale;
  const auto prefilter = arguments.quick ? Environment::Prefilter::quick : Environment::Prefilter::full;
  const auto environment =
      lights.ground
          ? with_ground(lights, studio_above_ground(name, scale, threads, prefilter), threads, prefilter)
      : arguments.quick ? quick_studio_environment(name, scale, threads)
                        : studio_environment(name, scale, threads);
  OutputFolder folder(arguments.textures, arguments.output.force ? Replace::anything : Replace::nothing);
  folder.write("environment_levels.pfm", texture_bytes(environment->level_stack()));
  folder.write("environment_irradiance.pfm", texture_bytes(environment->irradiance_map()));
  folder.commit();
}

int run(ShaderArguments& arguments) {
  if (arguments.quick && arguments.textures.empty())
    throw Error::at("--quick", "given alone", "--textures with it");
  const auto names = shader_language_names();
  const auto language =
      static_cast<ShaderLanguage>(std::ranges::find(names, arguments.language) - names.begin());
  if (arguments.function || language != ShaderLanguage::glsl) {
    write_output(arguments.output, function_of(arguments, language));
    return exit_ok;
  }
  if (arguments.es && arguments.vulkan) throw Error::at("--es", "given beside --vulkan", "one of them");
  const GlslVersion version = arguments.es       ? GlslVersion::es_300
                              : arguments.vulkan ? GlslVersion::vulkan_450
                                                 : GlslVersion::core_330;
  const std::optional<TextureUse> textures = textures_of(arguments);
  SceneNotes notes;
  const Scene scene = shader_scene(arguments, notes);
  const bool mesh = arguments.mesh || arguments.vertex == "mesh";
  const GlslText text = mesh       ? glsl_mesh_text(scene, textures ? &*textures : nullptr, version)
                        : textures ? glsl_text(scene, *textures, version)
                                   : glsl_text(scene, version);
  if (!arguments.textures.empty()) write_textures(arguments, scene.lights);
  write_output(arguments.output, arguments.output.format == "json" ? shader_json(text, version, notes.remarks)
                                 : !arguments.vertex.empty()       ? text.vertex
                                                                   : annotated_fragment(text));
  return exit_ok;
}

}  // namespace

void add_shader(CommandLine& line) {
  const auto arguments = std::make_shared<ShaderArguments>();
  Command verb = line.verb("shader", "the shader that draws a material: what it needs and nothing else");
  add_scene_options(verb, arguments->scene);
  verb.option(
          "--hemispheres", arguments->hemispheres,
          "light of two hemispheres; FORM: auto (Schüler's corrected one for his models, else that of the model), model, corrected, wide or printed")
      .may_lack_value()
      .show_default("auto")
      .one_of({"auto", "model", "corrected", "wide", "printed"})
      .value_name("FORM");
  verb.option("--choice", arguments->choice,
              "a material of what etak choose found: its Fresnel form, masking and numbers")
      .reads_file()
      .value_name("FILE");
  verb.option("--material", arguments->material, "which of the choice or the layout").value_name("NAME");
  verb.option("--layout", arguments->layout,
              "layout.json of etak pack: values that vary come from its textures, the rest are uniforms")
      .reads_file()
      .value_name("FILE");
  verb.option("--defines", arguments->defines,
              "what is fetched from the two textures, as etak pack lists it: a file with a define a line")
      .reads_file()
      .value_name("FILE");
  verb.option(
          "--textures", arguments->textures,
          "folder for the pictures that the shader of an environment samples: a PFM file each, named as its sampler, first row at v = 0")
      .value_name("DIR");
  verb.flag("--quick", arguments->quick,
            "--textures in a hundredth of the time, with details below 6 degrees blurred");
  verb.flag("--function", arguments->function,
            "the BRDF alone, as a function of two directions, without a picture around it");
  const auto languages = shader_language_names();
  verb.option("--language", arguments->language,
              "language of the text; all but glsl hold the BRDF alone, as --function does")
      .one_of({languages.begin(), languages.end()})
      .show_default();
  verb.flag("--mesh", arguments->mesh, "for a mesh with normals instead of the studio's sphere");
  verb.flag("--es", arguments->es, "#version 300 es instead of 330 core");
  verb.flag("--vulkan", arguments->vulkan, "#version 450 with bindings and locations, for SPIR-V");
  verb.option("--vertex", arguments->vertex,
              "the vertex shader instead (JSON holds both); mesh: that of --mesh")
      .may_lack_value()
      .show_default("picture")
      .one_of({"picture", "mesh"})
      .value_name("FORM");
  add_output_options(verb, arguments->output, {"text", "json"});
  verb.footer(
      "What was left out is listed with its reason at the head of the text.\n"
      "Example:\n"
      "  etak shader gold --model schueler-full --lights 2 --es\n"
      "  etak shader copper --model ggx-f82 --language hlsl -o copper.hlsl");
  verb.runs([arguments] { return run(*arguments); });
}

}  // namespace etak::cli
