// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/options/files.h"
#include "app/cli/output/progress.h"
#include "app/cli/pack/pack.h"
#include "app/cli/verbs.h"
#include "core/image/image.h"

namespace etak::cli {
namespace {

void add_layout_options(Command verb, PackArguments& a) {
  const std::string group = "Layout";
  verb.option("--page", a.page, "largest side of a page")
      .value_name("N")
      .range(1, max_image_side)
      .show_default()
      .group(group);
  verb.option("--page-form", a.page_form,
              "mixed (powers of two up to --page, least area), pages (all --page), square, pot or free "
              "(one page); auto: free for a scene that fits one page, else mixed")
      .one_of({"auto", "mixed", "pages", "square", "pot", "free"})
      .show_default()
      .group(group);
  verb.option("--rotate", a.rotate, "1: regions may be turned by 90 degrees")
      .value_name("0|1")
      .show_default()
      .group(group);
  verb.option("--effort", a.effort, "layouts to try; the same number gives the same layout everywhere")
      .value_name("N")
      .range(1, 1000000)
      .show_default()
      .group(group);
  verb.option("--max-seconds", a.max_seconds,
              "begin no further try after this time; the layout then depends on the machine")
      .value_name("S")
      .range(0.0, 1e6)
      .group(group);
  verb.option("--gutter", a.gutter,
              "texels around each region that repeat its edge; auto: from the mips, none where that would "
              "cost more than a quarter of the area (UVs are then inset)")
      .value_name("auto|N")
      .show_default()
      .group(group);
  verb.option("--mips", a.mips,
              "levels, level 0 among them; all: down to 1 x 1; auto: all for ktx2 and dds, else 1")
      .value_name("auto|all|N")
      .show_default()
      .group(group);
  verb.option("--previous", a.previous,
              "layout.json of an earlier run: unchanged regions stay where they were")
      .reads_file()
      .value_name("FILE")
      .group(group);
  verb.option("--extra-area", a.extra_area, "percent of page area that staying may cost")
      .range(0.0, 1000.0)
      .show_default()
      .group(group);
}

void add_leave_out_options(Command verb, PackArguments& a) {
  const std::string group = "Leaving out";
  verb.option("--keep", a.keep,
              "do not leave out: unreached, equal, alpha, constant, grey, crop, islands, resolution, "
              "textures, mips "
              "or all; may be given again")
      .value_name("WHAT")
      .one_at_a_time()
      .separated_by(',')
      .group(group);
  verb.option("--choice", a.choice,
              "what etak choose found for this input (its JSON): defines of shaders, textures that may be "
              "one number, mips that nothing reads, F0's integration, PNG level")
      .reads_file()
      .value_name("FILE")
      .group(group);
  verb.flag("--islands", a.islands, "of a scene, keep only the islands of texels that triangles use")
      .group(group);
  verb.option("--max-error", a.max_error,
              "store a region at half its size, a quarter, ... while that differs by no more than so many "
              "dE2000 (and percent of alpha and of gloss) from what can be seen")
      .value_name("DE")
      .range(0.0, 1000.0)
      .group(group);
  verb.option("--texel-density", a.texel_density,
              "of a scene: so many texels per unit of its world are enough")
      .value_name("N")
      .range(1e-9, 1e12)
      .group(group);
  verb.option("--view-height", a.view_height,
              "of a scene with cameras: height of their pictures in pixels; resolution and mips that none "
              "of them can show are left out")
      .value_name("PIXELS")
      .range(1, 1000000)
      .group(group);
}

void add_content_options(Command verb, PackArguments& a) {
  const std::string group = "Content";
  verb.option("--pattern", a.pattern, "of the files in a folder").show_default().group(group);
  verb.option("--gloss", a.gloss,
              "what the gloss channel is to hold: schueler, one_minus_roughness or roughness; default as "
              "the input")
      .one_of({"schueler", "one_minus_roughness", "roughness"})
      .group(group);
  verb.option("--space-of", a.space_of,
              "ROLE=SPACE: colour space of pictures that name none: srgb, linear, power-2.2 or one of the "
              "OpenColorIO config; roles: diffuse, specular, basecolor; may be given again")
      .value_name("ROLE=SPACE")
      .one_at_a_time()
      .group(group);
  verb.option("--ocio", a.ocio, "OpenColorIO config to look spaces up in (else $OCIO, else etak's own)")
      .reads_file()
      .value_name("FILE")
      .group(group);
  verb.flag("--bleed", a.bleed, "give texels of alpha 0 the colours of their visible neighbours")
      .group(group);
  verb.option("--scene", a.scene, "of a glTF: the scene that counts (default: the file's own)")
      .range(0, 1000000)
      .group(group);
  verb.flag("--all-scenes", a.all_scenes, "all of its scenes count").group(group);
  verb.flag("--drop-variants", a.drop_variants,
            "materials that only KHR_materials_variants uses do not count")
      .group(group);
  verb.option("--gltf-form", a.gltf_form,
              "materials of the written glTF: specular-ior (KHR_materials_specular and _ior, lossless), "
              "specular-glossiness or metal-rough; the first is the material, more with ',' between are "
              "added")
      .show_default()
      .group(group);
}

void add_output_group(Command verb, PackArguments& a) {
  const std::string group = "Output";
  verb.option("--format", a.formats,
              "of the textures: png, ktx2, dds, and in floats tiff, exr; with ',' between")
      .value_name("LIST")
      .show_default()
      .group(group);
  verb.option("--png-level", a.png_level, "fast, small or smallest")
      .one_of({"fast", "small", "smallest"})
      .show_default("fast")
      .group(group);
  verb.option("--zstd", a.zstd, "Zstandard level of ktx2; 0: none").range(0, 22).show_default().group(group);
  verb.flag("--force", a.force, "replace files that are of no earlier atlas; ETAK_FORCE=1 says the same")
      .group(group);
  verb.flag("-u,--update", a.update, "do nothing where the result of the same input and options is in place")
      .group(group);
  verb.flag("--dry-run", a.dry_run, "read, lay out and report, but write nothing").group(group);
  verb.option("--report", a.report, "form of the report on standard output: text, json or none")
      .one_of({"text", "json", "none"})
      .show_default()
      .group(group);
  verb.option("--page-report", a.page_report,
              "HTML page to write: textures, layout, what was left out, findings")
      .value_name("FILE")
      .group(group);
  verb.option("--page-link", a.page_links,
              "a link in the head of that page, relative, http or https; may be given again")
      .value_name("TEXT=TARGET")
      .one_at_a_time()
      .group(group);
  verb.flag("--stats", a.stats, "with the time of each stage").group(group);
}

void add_finding_options(Command verb, PackArguments& a) {
  const std::string group = "Findings";
  verb.option("--fail-on", a.fail_on,
              "least severity of the validator's findings that makes the exit status 1: error (default, or "
              "what etak.toml says), warning, info or never; the atlas is written all the same")
      .one_of({"error", "warning", "info", "never"})
      .group(group);
  verb.flag("--no-validate", a.no_validate, "do not check the pages").group(group);
  verb.option("--config", a.config, "configuration of the check (default: etak.toml of --output upwards)")
      .reads_file()
      .value_name("FILE")
      .group(group);
  verb.flag("--no-config", a.no_config, "look for no etak.toml").group(group);
}

void add_run_options(Command verb, PackArguments& a) {
  const std::string group = "Runs";
  verb.option("--batch", a.batch, "file of many jobs: {\"jobs\": [{\"input\", \"out\", options...}]}")
      .reads_file()
      .value_name("FILE")
      .group(group);
  verb.option("--memory", a.memory, "most that pages may take, such as 512M or 2G")
      .value_name("SIZE")
      .group(group);
  verb.flag("--watch", a.watch, "pack again whenever an input changes, until interrupted").group(group);
  add_follow_links(verb);
  add_thread_option(verb, a.threads);
  verb.flag("-q,--quiet", a.quiet, "no remarks and no progress; errors still appear");
  add_progress_option(verb, a.progress);
}

}  // namespace

void add_pack(CommandLine& line) {
  const auto arguments = std::make_shared<PackArguments>();
  Command verb = line.verb("pack", "materials into one atlas: texture pair, layout and glTF");
  verb.option("input", arguments->input,
              "manifest or project (.json), glTF scene (.gltf, .glb), or folder of pictures")
      .reads_file()
      .value_name("INPUT");
  verb.option("-o,--output,--out", arguments->out, "folder to write; --out is its older name")
      .value_name("DIR");
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
  verb.runs([arguments] {
    if (arguments->rects.asked) return pack_rects_command(arguments->rects);
    return pack_atlas(*arguments);
  });
}

}  // namespace etak::cli
