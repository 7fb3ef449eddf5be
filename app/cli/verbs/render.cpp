// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/output/progress.h"
#include "app/cli/pictures/pictures.h"
#include "app/cli/pictures/render.h"
#include "app/cli/verbs.h"
#include "core/light/studio.h"
#include "core/render/engines.h"

namespace etak::cli {

void add_render(CommandLine& line) {
  const auto arguments = std::make_shared<RenderArguments>();
  arguments->scene.standard_lights = studio_lights;
  Command verb = line.verb("render", "a picture of a material on a sphere, quad or mesh");
  add_scene_options(verb, arguments->scene);
  verb.option("-o,--output", arguments->picture, "picture to write: .png (8 bit) or .exr (linear)")
      .value_name("FILE");
  verb.flag("--force", arguments->stats.force, "let -o replace a file; ETAK_FORCE=1 says the same");
  verb.option(
          "--texture", arguments->scene.texture,
          "picture of the diffuse colour and, in its fourth channel, of the opacity, laid over the object")
      .reads_file()
      .value_name("FILE");
  verb.option("--gloss-texture", arguments->scene.gloss_texture,
              "picture of F0 and, in its fourth channel, of the gloss, as etak pack writes it")
      .reads_file()
      .value_name("FILE");
  verb.option(
          "--mesh", arguments->mesh,
          "a glTF scene of triangles with normals in place of the sphere, moved and scaled to its size, or shader-ball, a shape of etak; materials of the scene are not looked at")
      .reads_file()
      .value_name("FILE");
  verb.option(
          "--sweep", arguments->sweep,
          "a row of objects, one for each value of gloss, roughness, material, model, diffuse-model, orbit, tilt, a parameter of --set, or the number of a layer (1=0nm:400nm:9): NAME=FIRST:LAST:COUNT, or NAME=VALUE,VALUE,...")
      .value_name("NAME=VALUES");
  verb.flag(
      "--transparent", arguments->transparent,
      "no background: the opacity becomes the fourth channel (.exr holds colours multiplied by it, .png does not)");
  verb.option(
          "--turntable", arguments->turntable,
          "so many pictures, of a camera that goes once around the object from --orbit on; -o FILE.png becomes FILE_01.png and so on")
      .range(1, 1000)
      .show_default();
  verb.flag("--half", arguments->half, "16-bit values in .exr instead of 32-bit ones");
  verb.option("--device", arguments->device, "cpu, gl, or auto (cpu)")
      .one_of({"auto", "cpu", "gl"})
      .show_default();
  verb.option(
          "--ambient", arguments->ambient,
          "hemispheres and environment: refined (the models themselves, by samples) or moving (the terms of a picture that moves)")
      .one_of({"refined", "moving"})
      .show_default();
  verb.flag(
      "--reference", arguments->reference,
      "double precision, Fresnel per wavelength, supersampled; hemispheres and environment by sampling");
  verb.option("--spp", arguments->samples, "with --reference: points per pixel, a square number")
      .range(1, 1024)
      .show_default();
  verb.option("--light-samples", arguments->light_samples,
              "with --reference: samples of hemispheres and environment per point")
      .range(0, 1 << 20)
      .show_default();
  verb.option(
          "--as", arguments->as,
          "model, roughness, ambient term and tone curve as this engine publishes them, and the dE2000 to the exact material")
      .one_of(engine_ids())
      .value_name("ENGINE");
  verb.flag("--sheet", arguments->sheet, "contact sheet: eight materials under every model (no SUBJECT)");
  verb.option(
          "--part", arguments->part,
          "of --sheet: models whose lobe no other has (own), those of GGX, those of other lobes, or diffuse models and light")
      .one_of({"all", "own", "ggx", "lobes", "light"})
      .show_default();
  verb.option("--display", arguments->display,
              "OpenColorIO display for the 8-bit picture, in place of --tone and --transfer");
  verb.option("--view", arguments->view, "OpenColorIO view of the display");
  verb.option("--ocio", arguments->ocio,
              "OpenColorIO config of --display and --view (else $OCIO, else etak's own)")
      .reads_file()
      .value_name("CONFIG");
  verb.option("--frames", arguments->frames, "draw the picture so often and state the time of a frame")
      .range(1, 100000)
      .show_default();
  add_thread_option(verb, arguments->threads);
  arguments->stats.format = "text";
  verb.option("--format", arguments->stats.format,
              "of what is said about the picture: text (remarks) or json")
      .one_of({"text", "json"})
      .show_default();
  verb.flag("-q,--quiet", arguments->stats.quiet, "no remarks and no progress; errors still appear");
  add_progress_option(verb, arguments->stats.progress);
  verb.footer("Example:\n  etak render gold --model ggx-f82 --gloss 0.6 -o gold.png");
  verb.runs([arguments] { return pictures("etak render").draw(*arguments); });
}

}  // namespace etak::cli
