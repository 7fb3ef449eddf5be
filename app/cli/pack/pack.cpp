// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pack/pack.h"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

#include "app/cli/output/progress.h"
#include "app/cli/output/replace.h"
#include "app/cli/pack/jobs.h"
#include "app/cli/pack/page.h"
#include "app/cli/pictures/pictures.h"
#include "app/cli/validate/request.h"
#include "core/atlas/pack/pack.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/output_target.h"
#include "core/base/memory.h"
#include "core/base/number.h"
#include "core/project/project_pack.h"
#include "core/validate/check_pack.h"
#include "core/validate/output/formats.h"

namespace etak::cli {
namespace {

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> out(1);
  for (const char c : list)
    if (c == ',')
      out.emplace_back();
    else
      out.back() += c;
  return out;
}

std::vector<std::string> formats(const std::string& list) {
  std::vector<std::string> out;
  for (const std::string& each : split(list)) {
    const bool known = std::find(page_formats.begin(), page_formats.end(), each) != page_formats.end();
    const bool twice = std::find(out.begin(), out.end(), each) != out.end();
    if (!known || twice) throw Error::at("--format", printable(each), "png, ktx2, dds, tiff, exr, each once");
    out.push_back(each);
  }
  return out;
}

int whole_option(const char* option, const std::string& text, int least, int most, const char* other) {
  double value = 0;
  if (!parse_number(text, value) || value != std::floor(value) || value < least || value > most)
    throw Error::at(option, printable(text),
                    std::string(other) + ", or " + std::to_string(least) + " to " + std::to_string(most));
  return static_cast<int>(value);
}

std::size_t memory(const std::string& text) {
  if (text.empty()) return 0;
  const char unit = text.back();
  const int shift = unit == 'K' ? 10 : unit == 'M' ? 20 : unit == 'G' ? 30 : 0;
  double value = 0;
  if (!parse_number(shift == 0 ? text : text.substr(0, text.size() - 1), value) || !(value > 0) ||
      value > 1e15)
    throw Error::at("--memory", printable(text), "a number of bytes, with K, M or G for more");
  return static_cast<std::size_t>(value * static_cast<double>(std::size_t{1} << shift));
}

std::optional<PageForm> page_form(const std::string& text) {
  if (text == "auto") return std::nullopt;
  return text == "pages"    ? PageForm::pages
         : text == "square" ? PageForm::square
         : text == "pot"    ? PageForm::power_of_two
         : text == "free"   ? PageForm::free
                            : PageForm::mixed;
}

std::vector<GltfForm> gltf_forms(const std::string& list) {
  std::vector<GltfForm> out;
  for (const std::string& each : split(list)) {
    if (each == "specular-ior")
      out.push_back(GltfForm::specular_ior);
    else if (each == "specular-glossiness")
      out.push_back(GltfForm::specular_glossiness);
    else if (each == "metal-rough")
      out.push_back(GltfForm::metal_rough);
    else
      throw Error::at("--gltf-form", printable(each), "specular-ior, specular-glossiness or metal-rough");
  }
  return out;
}

// What `etak validate` of the result would go by. Throws Error.
PackCheckOptions check_options(PackArguments& a) {
  ValidateArguments as_validate;
  as_validate.paths = {a.out + "/layout.json"};
  as_validate.config = a.config;
  as_validate.no_config = a.no_config;
  as_validate.fail_on = a.fail_on;
  PackCheckOptions out;
  out.config = validate_config(as_validate, asked_materials(a.library));
  out.never_fails = a.fail_on == never_fails;
  out.threads = thread_count(a.threads);
  out.version = ETAK_VERSION;
  return out;
}

//   check   null: the atlas was not looked at
void say(const PackArguments& a, const PackReport& report, const PackCheck* check) {
  const ValidationReport* findings = check == nullptr ? nullptr : check->report();
  OutputArguments remarks;
  remarks.quiet = a.quiet;
  if (a.report == "json")
    write_output({}, report_json(report, a.stats));
  else if (a.report == "text" && !a.quiet)
    write_output({}, report_text(report, a.stats) +
                         (findings == nullptr ? "" : validation_text(*findings, use_color({}))));
  if (a.report != "json")
    for (const std::string& each : report.remarks) remark(remarks, each);
  // Why the exit status is not 0 is told even where nothing else is.
  const bool verdict_shown = a.report == "json" || (a.report == "text" && !a.quiet);
  if (findings != nullptr && (check->failed() || check->incomplete()) && !verdict_shown)
    complain(a.out + ": " + verdict_of(*findings));
}

// Pictures of regions come and go by the megabyte. The allocator would give each back to the kernel and get
// the next as fresh small pages, whose first touches cost more than the work on them.
void keep_freed_memory() {
#ifdef __GLIBC__
  (void)::mallopt(M_MMAP_THRESHOLD, 32 << 20);
  (void)::mallopt(M_TRIM_THRESHOLD, 512 << 20);
  (void)::mallopt(M_TOP_PAD, 16 << 20);
#endif
}

}  // namespace

// ROLE=SPACE, of the roles that are colours.
std::map<std::string, std::string> spaces(const std::vector<std::string>& list) {
  std::map<std::string, std::string> out;
  for (const std::string& each : list) {
    const std::size_t at = each.find('=');
    const std::string role = each.substr(0, at);
    const bool color = role == "diffuse" || role == "specular" || role == "basecolor";
    if (at == std::string::npos || at + 1 == each.size() || !color)
      throw Error::at("--space-of", printable(each), "ROLE=SPACE, of diffuse, specular or basecolor");
    if (!out.emplace(role, each.substr(at + 1)).second)
      throw Error::at("--space-of", printable(each), "each role once");
  }
  return out;
}

// The config that spaces are looked up in, for its bytes to count as an input.
std::string config_file(const std::string& asked) {
  if (!asked.empty()) return asked;
  const char* environment = std::getenv("OCIO");
  std::error_code failure;
  const std::string path = environment == nullptr ? "" : environment;
  return std::filesystem::is_regular_file(path, failure) ? path : "";
}

PackOptions pack_options(const PackArguments& a) {
  PackOptions out;
  out.pattern = a.pattern;
  if (!a.gloss.empty()) out.gloss = gloss_form_named(a.gloss);
  if (a.scene >= 0) out.scene.scene = a.scene;
  out.scene.all_scenes = a.all_scenes;
  out.scene.variants = !a.drop_variants;
  out.keep = parse_keep(a.keep);
  out.islands = a.islands;
  out.max_error = a.max_error;
  out.texel_density = a.texel_density;
  out.view_height = a.view_height;
  out.open_space = [config = a.ocio](const std::string& name) {
    return pictures(printable(name)).open_source(config, name);
  };
  out.spaces = spaces(a.space_of);
  out.space_config = config_file(a.ocio);
  out.page = a.page;
  out.form = page_form(a.page_form);
  out.rotate = a.rotate;
  out.effort = a.effort;
  out.max_seconds = a.max_seconds;
  if (a.gutter != "auto") out.gutter = whole_option("--gutter", a.gutter, 0, 4096, "auto");
  if (a.mips == "all")
    out.mips = 0;
  else if (a.mips != "auto")
    out.mips = whole_option("--mips", a.mips, 1, 15, "auto, all");
  out.previous = a.previous;
  out.most_extra_area = a.extra_area / 100;
  if (!a.choice.empty()) out.variants = parse_choices(read_file(a.choice), a.choice);
  out.write.formats = formats(a.formats);
  for (const std::string& format : out.write.formats)
    if (holds_floats(format)) (void)pictures("--format");  // told before the work where it is missing
  const std::string& level = a.png_level.empty() && out.variants ? out.variants->png_level : a.png_level;
  out.write.png_level = level == "small"      ? PngLevel::small
                        : level == "smallest" ? PngLevel::smallest
                                              : PngLevel::fast;
  out.write.zstd_level = a.zstd;
  out.forms = gltf_forms(a.gltf_form);
  out.bleed = a.bleed;
  out.overwrite = may_replace(a.force);
  out.update = a.update;
  out.dry_run = a.dry_run;
  out.memory = memory(a.memory);
  out.threads = thread_count(a.threads);
  out.version = ETAK_VERSION;
  out.door = picture_door();
  return out;
}

void check_page_report(const PackArguments& a) {
  if (a.page_report.empty()) return;
  std::error_code failure;
  if (!is_in_atlas_folder(a) || std::filesystem::exists(a.out, failure))
    check_file_target(a.page_report, true);
}

int pack_once(PackArguments& a) {
  if (a.input.empty())
    throw Error::at("etak pack", "nothing to pack", "a manifest, a glTF scene or a folder");
  if (a.out.empty()) throw Error::at("etak pack", "no folder to write", "-o DIR");
  PackOptions options = pack_options(a);
  check_page_report(a);
  std::optional<PackCheck> check;
  if (!a.no_validate) check.emplace(a.out, check_options(a)).attach(options);
  PackPage page(a);
  page.attach(options);
  OutputArguments shown;
  shown.quiet = a.quiet;
  shown.progress = a.progress;
  std::optional<Progress> progress(std::in_place, shown, 0, "pack");
  options.progress = [&](std::size_t done, std::size_t all) { progress->set(done, all); };
  options.beside = [&](PackReport& report, OutputFolder* folder) {
    return page.output(report, check ? &check->finish(report) : nullptr, folder);
  };
  const PackReport report = with_memory_for(
      a.input, [&] { return "its atlas " + a.out; },
      [&] {
        options.other_manifest = project_reader(a.library.get());
        return pack(a.input, a.out, options, a.library.get());
      });
  progress.reset();
  say(a, report, check ? &*check : nullptr);
  if (check && check->incomplete()) return exit_failure;
  return check && check->failed() ? exit_findings : exit_ok;
}

int pack_atlas(PackArguments& a) {
  keep_freed_memory();
  if (!a.batch.empty()) return pack_batch(a);
  if (a.watch) return pack_watch(a);
  return pack_once(a);
}

}  // namespace etak::cli
