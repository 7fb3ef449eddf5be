// SPDX-License-Identifier: Apache-2.0
#include "app/cli/render.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>

#include "app/cli/file_options.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"

namespace etak::cli {

void add_render(CLI::App& app, Verb& chosen) {
  const auto arguments = std::make_shared<RenderArguments>();
  CLI::App& verb = *app.add_subcommand("render", "a picture of a material on a sphere or quad");
  add_scene_options(verb, arguments->scene);
  verb.add_option("-o,--output", arguments->picture, "picture to write: .png (8 bit) or .exr (linear)")
      ->type_name("FILE");
  verb.add_flag("--force", arguments->stats.force, "let -o replace a file; ETAK_FORCE=1 says the same");
  verb.add_flag("--half", arguments->half, "16-bit values in .exr instead of 32-bit ones");
  verb.add_option("--device", arguments->device, "cpu, gl, or auto (cpu)")
      ->check(CLI::IsMember({"auto", "cpu", "gl"}))
      ->capture_default_str();
  verb.add_flag(
      "--reference", arguments->reference,
      "double precision, Fresnel per wavelength, supersampled; hemispheres and environment by sampling");
  verb.add_option("--spp", arguments->samples, "with --reference: points per pixel, a square number")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  verb.add_option("--light-samples", arguments->light_samples,
                  "with --reference: samples of hemispheres and environment per point")
      ->check(CLI::Range(0, 1 << 20))
      ->capture_default_str();
  verb.add_flag("--sheet", arguments->sheet, "contact sheet: eight materials under every model (no SUBJECT)");
  verb.add_option("--display", arguments->display,
                  "OpenColorIO display for the 8-bit picture, in place of --transfer");
  verb.add_option("--view", arguments->view, "OpenColorIO view of the display");
  reads_file(verb.add_option("--ocio", arguments->ocio,
                             "OpenColorIO config of --display and --view (else $OCIO, else etak's own)"))
      ->type_name("CONFIG");
  verb.add_option("--frames", arguments->frames, "draw the picture so often and state the time of a frame")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  add_thread_option(verb, arguments->threads);
  arguments->stats.format = "text";
  verb.add_option("--format", arguments->stats.format,
                  "of what is said about the picture: text (remarks) or json")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  verb.add_flag("-q,--quiet", arguments->stats.quiet, "no remarks and no progress; errors still appear");
  add_progress_option(verb, arguments->stats.progress);
  verb.footer("Example:\n  etak render gold --model ggx-f82 --gloss 0.6 -o gold.png");
  verb.callback([arguments, &chosen] { chosen = [arguments] { return draw(*arguments); }; });
}

}  // namespace etak::cli
