// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/export/run.h"
#include "app/cli/options/color.h"
#include "app/cli/verbs.h"

namespace etak::cli {

void add_export(CommandLine& line) {
  const auto arguments = std::make_shared<ExportArguments>();
  Command verb = line.verb("export", "materials as MaterialX, glTF or the values of an engine");
  add_input_options(verb, arguments->inputs);
  verb.option("--to", arguments->wanted,
              "mtlx (MaterialX 1.39, OpenPBR), gltf (spheres with the material), values (what to type or "
              "paste), or the values of targets, with ',' between")
      .required()
      .separated_by(',')
      .one_at_a_time()
      .words(forms_and_targets());
  verb.flag("--all", arguments->inputs.all, "every material of the library");
  add_all_datasets_option(verb, arguments->inputs);
  verb.option("--dataset", arguments->inputs.dataset, "dataset to take instead of the preferred one")
      .value_name("ID");
  add_roughness_options(verb, arguments->rough, "of the surface");
  add_color_option(verb, "--diffuse", arguments->diffuse,
                   "diffuse colour of dielectrics, linear (default black, and clear where the data say so)");
  verb.option("--opacity", arguments->opacity, "0 to 1").show_default();
  add_color_option(verb, "--emission", arguments->emission,
                   "radiance that the surface sends out by itself, linear; default black");
  verb.option("--fit", arguments->fit,
              "what becomes of a colour above 1 or below 0: clamp (each channel) or preserve-hue (the "
              "whole colour)")
      .one_of({"clamp", "preserve-hue"})
      .show_default();
  verb.option(
          "--target", arguments->targets,
          "of --to values: only these, with ',' between (hex, srgb8, linear, glsl, unreal, unity-metallic, "
          "unity-specular, blender, filament, openpbr, gltf, gltf-specular-glossiness, gulbrandsen, rgb-nk)")
      .separated_by(',')
      .value_name("TARGET,...");
  verb.option("--gltf-form", arguments->gltf_form,
              "as in pack: specular-ior (metal-rough, and dielectrics with KHR_materials_ior and _specular; "
              "metal-rough is its older name here) or specular-glossiness")
      .one_of({"specular-ior", "specular-glossiness", "metal-rough"})
      .show_default();
  add_compute_options(verb, arguments->compute);
  add_table_options(verb, arguments->tables);
  add_library_options(verb, arguments->library);
  add_output_options(verb, arguments->output,
                     {"auto", "table", "text", "csv", "json", "gltf", "glb", "mtlx"});
  add_thread_option(verb, arguments->threads);
  verb.footer(
      "--format auto is table for values, mtlx, and gltf (glb where -o ends in it); text is what to paste.\n"
      "What a target cannot hold is changed by --fit or a rule of the target and told beside the value.\n"
      "Exit status: 0 done, 1 an input named by itself was refused by the rules, 2 an input failed.\n"
      "Example:\n  etak export gold diamond --to values --target unreal,filament");
  verb.runs([arguments] { return export_materials(*arguments); });
}

}  // namespace etak::cli
