// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pack.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>

#include "app/cli/file_options.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "core/image/image.h"

namespace etak::cli {
namespace {

void add_layout_options(CLI::App& verb, PackArguments& a) {
  const std::string group = "Layout";
  verb.add_option("--page", a.page, "largest side of a page")
      ->type_name("N")
      ->check(CLI::Range(1, max_image_side))
      ->capture_default_str()
      ->group(group);
  verb.add_option("--page-form", a.page_form,
                  "mixed (powers of two up to --page, least area), pages (all --page), square, pot or free "
                  "(one page); auto: free for a scene that fits one page, else mixed")
      ->check(CLI::IsMember({"auto", "mixed", "pages", "square", "pot", "free"}))
      ->capture_default_str()
      ->group(group);
  verb.add_option("--rotate", a.rotate, "1: regions may be turned by 90 degrees")
      ->type_name("0|1")
      ->capture_default_str()
      ->group(group);
  verb.add_option("--effort", a.effort, "layouts to try; the same number gives the same layout everywhere")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str()
      ->group(group);
  verb.add_option("--max-seconds", a.max_seconds,
                  "begin no further try after this time; the layout then depends on the machine")
      ->type_name("S")
      ->check(CLI::Range(0.0, 1e6))
      ->group(group);
  verb.add_option(
          "--gutter", a.gutter,
          "texels around each region that repeat its edge; auto: from the mips, none where that would "
          "cost more than a quarter of the area (UVs are then inset)")
      ->type_name("auto|N")
      ->capture_default_str()
      ->group(group);
  verb.add_option("--mips", a.mips,
                  "levels, level 0 among them; all: down to 1 x 1; auto: all for ktx2 and dds, else 1")
      ->type_name("auto|all|N")
      ->capture_default_str()
      ->group(group);
  reads_file(verb.add_option("--previous", a.previous,
                             "layout.json of an earlier run: unchanged regions stay where they were"))
      ->type_name("FILE")
      ->group(group);
  verb.add_option("--extra-area", a.extra_area, "percent of page area that staying may cost")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str()
      ->group(group);
}

void add_leave_out_options(CLI::App& verb, PackArguments& a) {
  const std::string group = "Leaving out";
  verb.add_option("--keep", a.keep,
                  "do not leave out: unreached, equal, alpha, constant, grey, crop, islands, resolution, "
                  "textures, mips "
                  "or all; may be given again")
      ->type_name("WHAT")
      ->allow_extra_args(false)
      ->delimiter(',')
      ->group(group);
  reads_file(verb.add_option(
                 "--choice", a.choice,
                 "what etak choose found for this input (its JSON): defines of shaders, textures that may be "
                 "one number, mips that nothing reads, F0's integration, PNG level"))
      ->type_name("FILE")
      ->group(group);
  verb.add_flag("--islands", a.islands, "of a scene, keep only the islands of texels that triangles use")
      ->group(group);
  verb.add_option(
          "--max-error", a.max_error,
          "store a region at half its size, a quarter, ... while that differs by no more than so many "
          "dE2000 (and percent of alpha and of gloss) from what can be seen")
      ->type_name("DE")
      ->check(CLI::Range(0.0, 1000.0))
      ->group(group);
  verb.add_option("--texel-density", a.texel_density,
                  "of a scene: so many texels per unit of its world are enough")
      ->type_name("N")
      ->check(CLI::Range(1e-9, 1e12))
      ->group(group);
  verb.add_option(
          "--view-height", a.view_height,
          "of a scene with cameras: height of their pictures in pixels; resolution and mips that none "
          "of them can show are left out")
      ->type_name("PIXELS")
      ->check(CLI::Range(1, 1000000))
      ->group(group);
}

void add_content_options(CLI::App& verb, PackArguments& a) {
  const std::string group = "Content";
  verb.add_option("--pattern", a.pattern, "of the files in a folder")->capture_default_str()->group(group);
  verb.add_option("--gloss", a.gloss,
                  "what the gloss channel is to hold: schueler, one_minus_roughness or roughness; default as "
                  "the input")
      ->check(CLI::IsMember({"schueler", "one_minus_roughness", "roughness"}))
      ->group(group);
  verb.add_option(
          "--space-of", a.space_of,
          "ROLE=SPACE: colour space of pictures that name none: srgb, linear, power-2.2 or one of the "
          "OpenColorIO config; roles: diffuse, specular, basecolor; may be given again")
      ->type_name("ROLE=SPACE")
      ->allow_extra_args(false)
      ->group(group);
  reads_file(verb.add_option("--ocio", a.ocio,
                             "OpenColorIO config to look spaces up in (else $OCIO, else etak's own)"))
      ->type_name("FILE")
      ->group(group);
  verb.add_flag("--bleed", a.bleed, "give texels of alpha 0 the colours of their visible neighbours")
      ->group(group);
  verb.add_option("--scene", a.scene, "of a glTF: the scene that counts (default: the file's own)")
      ->check(CLI::Range(0, 1000000))
      ->group(group);
  verb.add_flag("--all-scenes", a.all_scenes, "all of its scenes count")->group(group);
  verb.add_flag("--drop-variants", a.drop_variants,
                "materials that only KHR_materials_variants uses do not count")
      ->group(group);
  verb.add_option("--gltf-form", a.gltf_form,
                  "materials of the written glTF: specular-ior (KHR_materials_specular and _ior, lossless), "
                  "specular-glossiness or metal-rough; the first is the material, more with ',' between are "
                  "added")
      ->capture_default_str()
      ->group(group);
}

void add_output_group(CLI::App& verb, PackArguments& a) {
  const std::string group = "Output";
  verb.add_option("--format", a.formats,
                  "of the textures: png, ktx2, dds, and in floats tiff, exr; with ',' between")
      ->type_name("LIST")
      ->capture_default_str()
      ->group(group);
  verb.add_option("--png-level", a.png_level, "fast, small or smallest")
      ->check(CLI::IsMember({"fast", "small", "smallest"}))
      ->default_str("fast")
      ->group(group);
  verb.add_option("--zstd", a.zstd, "Zstandard level of ktx2; 0: none")
      ->check(CLI::Range(0, 22))
      ->capture_default_str()
      ->group(group);
  verb.add_flag("--force", a.force, "replace files that are of no earlier atlas; ETAK_FORCE=1 says the same")
      ->group(group);
  verb.add_flag("-u,--update", a.update,
                "do nothing where the result of the same input and options is in place")
      ->group(group);
  verb.add_flag("--dry-run", a.dry_run, "read, lay out and report, but write nothing")->group(group);
  verb.add_option("--report", a.report, "form of the report on standard output: text, json or none")
      ->check(CLI::IsMember({"text", "json", "none"}))
      ->capture_default_str()
      ->group(group);
  verb.add_option("--page-report", a.page_report,
                  "HTML page to write: textures, layout, what was left out, findings")
      ->type_name("FILE")
      ->group(group);
  verb.add_option("--page-link", a.page_links,
                  "a link in the head of that page, relative, http or https; may be given again")
      ->type_name("TEXT=TARGET")
      ->allow_extra_args(false)
      ->group(group);
  verb.add_flag("--stats", a.stats, "with the time of each stage")->group(group);
}

void add_finding_options(CLI::App& verb, PackArguments& a) {
  const std::string group = "Findings";
  verb.add_option(
          "--fail-on", a.fail_on,
          "least severity of the validator's findings that makes the exit status 1: error (default, or "
          "what etak.toml says), warning, info or never; the atlas is written all the same")
      ->check(CLI::IsMember({"error", "warning", "info", "never"}))
      ->group(group);
  verb.add_flag("--no-validate", a.no_validate, "do not check the pages")->group(group);
  reads_file(verb.add_option("--config", a.config,
                             "configuration of the check (default: etak.toml of --output upwards)"))
      ->type_name("FILE")
      ->group(group);
  verb.add_flag("--no-config", a.no_config, "look for no etak.toml")->group(group);
}

void add_run_options(CLI::App& verb, PackArguments& a) {
  const std::string group = "Runs";
  reads_file(verb.add_option("--batch", a.batch,
                             "file of many jobs: {\"jobs\": [{\"input\", \"out\", options...}]}"))
      ->type_name("FILE")
      ->group(group);
  verb.add_option("--memory", a.memory, "most that pages may take, such as 512M or 2G")
      ->type_name("SIZE")
      ->group(group);
  verb.add_flag("--watch", a.watch, "pack again whenever an input changes, until interrupted")->group(group);
  add_follow_links(verb);
  add_thread_option(verb, a.threads);
  verb.add_flag("-q,--quiet", a.quiet, "no remarks and no progress; errors still appear");
  add_progress_option(verb, a.progress);
}

}  // namespace

void add_pack(CLI::App& app, Verb& chosen) {
  const auto arguments = std::make_shared<PackArguments>();
  CLI::App& verb = *app.add_subcommand("pack", "materials into one atlas: texture pair, layout and glTF");
  reads_file(verb.add_option("input", arguments->input,
                             "manifest or project (.json), glTF scene (.gltf, .glb), or folder of pictures"))
      ->type_name("INPUT");
  verb.add_option("-o,--output,--out", arguments->out, "folder to write; --out is its older name")
      ->type_name("DIR");
  add_layout_options(verb, *arguments);
  add_leave_out_options(verb, *arguments);
  add_content_options(verb, *arguments);
  add_output_group(verb, *arguments);
  add_finding_options(verb, *arguments);
  add_run_options(verb, *arguments);
  add_library_options(verb, arguments->library);
  add_pack_rects_options(verb, arguments->rects);
  verb.footer(
      "Texture A holds diffuse and alpha, texture B F0 and gloss, colours sRGB-encoded. All files appear "
      "together or not at all. Last come the findings of etak validate for what was written.\n"
      "Exit status: 0, or 1 when there are findings at or above --fail-on, 2 when something failed.\n"
      "Example:\n  etak pack materials.json -o atlas --page 4096");
  verb.callback([arguments, &chosen] {
    chosen = [arguments] {
      if (arguments->rects.asked) return pack_rects_command(arguments->rects);
      return pack_atlas(*arguments);
    };
  });
}

}  // namespace etak::cli
