// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/paths.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/image/blocks/budget.h"
#include "core/image/files/containers.h"
#include "core/pack/pack.h"

namespace etak {
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
    if (!known || twice)
      throw Error::at(setting("textures"), printable(each), "png, ktx2, dds, tiff, exr, each once");
    out.push_back(each);
  }
  return out;
}

int whole_setting(const char* of, const std::string& text, int least, int most, const char* other) {
  double value = 0;
  if (!parse_number(text, value) || value != std::floor(value) || value < least || value > most)
    throw Error::at(setting(of), printable(text),
                    std::string(other) + ", or " + std::to_string(least) + " to " + std::to_string(most));
  return static_cast<int>(value);
}

std::optional<PageForm> page_form(const std::string& text) {
  if (text == "auto") return std::nullopt;
  return text == "pages"    ? PageForm::pages
         : text == "square" ? PageForm::square
         : text == "pot"    ? PageForm::power_of_two
         : text == "free"   ? PageForm::free
         : text == "mult4"  ? PageForm::free
                            : PageForm::mixed;
}

std::optional<PngLevel> png_level(const std::string& text) {
  if (text == "auto") return std::nullopt;
  return text == "small" ? PngLevel::small : text == "smallest" ? PngLevel::smallest : PngLevel::fast;
}

// The goal as a value. Where one file holds two forms no files are weighed.
PackGoal goal(const std::string& text, bool one_form) {
  for (const PackGoal each : {PackGoal::disk, PackGoal::both, PackGoal::one_page})
    if (text == name(each)) return each;
  return text == name(PackGoal::within) && one_form ? PackGoal::within : PackGoal::gpu;
}

// Refuses settings that cannot be asked for beside one page.
void refuse_beside_one_page(const PackSettings& s) {
  const std::string beside = " beside " + setting("goal") + " one-page";
  if (s.page_form == "pages" || s.page_form == "mixed")
    throw Error::at(setting("page-form"), s.page_form + beside, "free, square, pot or mult4");
  if (s.islands)
    throw Error::at(setting("islands"), "asked for" + beside, "whole boxes, whose parts lie apart");
  if (!s.previous.empty())
    throw Error::at(setting("previous"), "asked for" + beside,
                    "a layout from scratch, whose regions are no material's");
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
      throw Error::at(setting("gltf-form"), printable(each),
                      "smallest, or specular-ior, specular-glossiness or metal-rough");
  }
  return out;
}

// ROLE=SPACE, of the roles that are colours.
std::map<std::string, std::string> spaces(const std::vector<std::string>& list) {
  std::map<std::string, std::string> out;
  for (const std::string& each : list) {
    const std::size_t at = each.find('=');
    const std::string role = each.substr(0, at);
    const bool color = role == "diffuse" || role == "specular" || role == "basecolor";
    if (at == std::string::npos || at + 1 == each.size() || !color)
      throw Error::at(setting("space-of"), printable(each), "ROLE=SPACE, of diffuse, specular or basecolor");
    if (!out.emplace(role, each.substr(at + 1)).second)
      throw Error::at(setting("space-of"), printable(each), "each role once");
  }
  return out;
}

PackLayoutOptions layout_options(const PackSettings& s) {
  PackLayoutOptions out;
  out.page = s.page;
  out.form = page_form(s.page_form);
  if (s.page_form == "mult4") out.multiple = 4;
  out.rotate = s.rotate;
  out.effort = s.effort;
  out.max_seconds = s.max_seconds;
  if (s.gutter != "auto") out.gutter = whole_setting("gutter", s.gutter, 0, 4096, "auto");
  // Two texels keep islands apart on one mip more than one texel does.
  out.viewers_gutter = 2;
  if (s.mips == "all")
    out.mips = 0;
  else if (s.mips != "auto")
    out.mips = whole_setting("mips", s.mips, 1, 15, "auto, all");
  out.previous = s.previous;
  out.most_extra_area = s.extra_area / 100;
  return out;
}

CompressOptions compress_options(const PackSettings& s, const WriteOptions& write) {
  CompressOptions out;
  if (s.compress == "none") return out;
  if (!writes_containers(write))
    throw Error::at(setting("compress"), s.compress + " without a file that can hold blocks",
                    setting("textures") + " ktx2 or dds");
  out = compress_word(s.compress);
  const auto has = [&](std::string_view format) {
    return std::ranges::find(write.formats, format) != write.formats.end();
  };
  if (out.format->code == BlockCode::astc && has("dds"))
    throw Error::at(setting("compress"), s.compress + " beside DDS files, which have no number for ASTC",
                    setting("textures") + " ktx2");
  if (!std::has_single_bit(static_cast<unsigned>(out.format->block_width)) && s.page_form != "auto" &&
      s.page_form != "free" && s.page_form != "square")
    throw Error::at(
        setting("page-form"),
        s.page_form + " beside blocks of " + std::to_string(out.format->block_width) + " texels a side",
        "auto, free or square");
  out.budget = parse_block_budget(s.block_error);
  out.effort = s.compress_effort;
  return out;
}

}  // namespace

PackOptions pack_options(const PackSettings& s) {
  PackOptions out;
  out.input.pattern = s.pattern;
  if (!s.gloss.empty()) out.input.pictures.gloss = gloss_form_named(s.gloss);
  if (s.scene >= 0) out.input.gltf.scene = s.scene;
  out.input.gltf.all_scenes = s.all_scenes;
  out.input.gltf.variants = !s.drop_variants;
  out.leave_out.keep = parse_keep(s.keep);
  out.leave_out.max_error = s.max_error;
  out.leave_out.texel_density = s.texel_density;
  out.leave_out.view_height = s.view_height;
  out.input.pictures.spaces = spaces(s.space_of);
  out.layout = layout_options(s);
  auto& variants = out.leave_out.variants;
  if (!s.choice.empty()) variants = parse_choices(read_file(s.choice), s.choice);
  out.output.write.formats = formats(s.format);
  out.output.write.png_level = png_level(s.png_level.empty() && variants ? variants->png_level : s.png_level);
  if (s.zstd > 0 && !has_zstd())
    throw Error::at(setting("zstd"), "this etak was built without Zstandard", "0");
  out.output.write.zstd_level = s.zstd;
  out.output.compress = compress_options(s, out.output.write);
  out.output.smallest_form = s.gltf_form == "smallest";
  if (!out.output.smallest_form) out.output.forms = gltf_forms(s.gltf_form);
  out.output.one_file = s.gltf_container == "glb";
  out.output.webp = s.gltf_pictures == "webp";
  out.output.goal = goal(s.goal, out.output.smallest_form || out.output.forms.size() == 1);
  if (out.output.goal == PackGoal::one_page) refuse_beside_one_page(s);
  out.leave_out.islands = out.output.goal != PackGoal::one_page && out.leave_out.leaves("islands");
  if (weighs_disk(out.output.goal) && out.output.forms.size() > 1)
    throw Error::at(setting("goal"), s.goal + " beside two forms in one file",
                    "one " + setting("gltf-form") + ", or smallest");
  out.output.bleed = s.bleed;
  return out;
}

std::size_t memory_setting(const std::string& text) {
  return text.empty() ? 0 : byte_size(text, setting("memory"));
}

std::string space_config_file(const std::string& asked) {
  if (!asked.empty()) return asked;
  const char* environment = std::getenv("OCIO");
  const std::string path = environment == nullptr ? "" : environment;
  return is_file(path) ? path : "";
}

}  // namespace etak
