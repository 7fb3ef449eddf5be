// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>

#include "app/demo/parts.h"
#include "core/atlas/layout.h"
#include "core/atlas/manifest.h"
#include "core/base/files/file.h"
#include "core/findings/output/formats.h"
#include "core/image/files/png.h"
#include "core/image/load.h"
#include "core/pages/finding_pictures.h"
#include "core/pages/validation_pictures.h"
#include "core/validate/validate.h"

namespace etak::demo {
namespace {

// Pictures are shown with 3 pixels for 8 texels on a side.
constexpr int shown_pixels = 3, shown_texels = 8;
constexpr std::size_t most_findings = 8;

std::string small_png(const Image8& picture, int most) {
  PngOptions options;
  options.level = PngLevel::small;
  return png_bytes(thumbnail(picture, most), options);
}

Image8 read_picture(const std::string& path) {
  return codes_of(load_picture(path, PictureDoor{}), false);
}

StartPicture start_picture(const std::string& path, std::string label) {
  const Image8 picture = read_picture(path);
  const int longest = std::max(picture.width, picture.height);
  return {small_png(picture, std::max(16, longest * shown_pixels / shown_texels)), std::move(label),
          picture.width, picture.height};
}

// The picture files of a material.
std::vector<std::string> pictures_of(const ManifestMaterial& material) {
  std::vector<std::string> out;
  for (const auto* source : {&material.diffuse, &material.specular, &material.gloss, &material.roughness,
                             &material.alpha, &material.base_color, &material.metallic})
    if (*source)
      if (const auto* image = std::get_if<ImageSource>(&**source)) out.push_back(image->path);
  return out;
}

void add_before(StartPageData& data) {
  const std::string file = "scene/manifest.json";
  std::set<std::string> shown;
  const AtlasManifest manifest = parse_manifest(read_file(file), file);
  for (const ManifestMaterial& material : manifest.materials) {
    std::uint64_t texels = 1;
    for (const std::string& path : pictures_of(material)) {
      const bool is_new = shown.insert(path).second;
      StartPicture picture = start_picture(path, std::filesystem::path(path).filename().string());
      texels = std::max(
          texels, static_cast<std::uint64_t>(picture.width) * static_cast<std::uint64_t>(picture.height));
      if (is_new) data.before.push_back(std::move(picture));
    }
    data.texels_before += 2 * texels;
  }
}

void add_after(StartPageData& data) {
  const std::string file = std::string("atlas/") + layout_file_name;
  const AtlasLayout layout = parse_layout(read_file(file), file);
  for (const AtlasPage& page : layout.pages)
    for (const auto& files : page.files) {
      if (files.empty()) continue;
      const bool first = &files == &page.files[static_cast<std::size_t>(Texture::diffuse_alpha)];
      data.after.push_back(start_picture("atlas/" + files[0], first ? "diffuse and alpha" : "F0 and gloss"));
      data.texels_after += static_cast<std::uint64_t>(page.width) * static_cast<std::uint64_t>(page.height);
    }
}

// The worst finding of each rule, the worst rules first.
void add_findings(unsigned threads, StartPageData& data) {
  ValidationRequest request;
  request.inputs.paths = {"mistakes"};
  request.run.threads = threads;
  const Settings settings = request.config.settings;
  const ValidationReport report = validate(std::move(request));
  data.verdict = verdict_of(report);
  const auto pictures =
      page_pictures(report, settings, PictureDoor{}, std::numeric_limits<std::size_t>::max(), threads);
  std::set<std::string> rules_shown;
  for (const Severity severity : {Severity::error, Severity::warning, Severity::info})
    for (std::size_t i = 0; i < report.files.size(); ++i)
      for (const Finding& finding : report.files[i].findings) {
        if (finding.severity != severity || !counts(finding) || data.findings.size() == most_findings)
          continue;
        if (!rules_shown.insert(finding.rule).second) continue;
        StartFinding& out = data.findings.emplace_back(StartFinding{finding, {}});
        if (!finding.box) continue;
        const auto& all = pictures[i].pictures;
        const auto shows = [&](const ValidationPicture& picture) {
          return std::ranges::count(picture.boxes, *finding.box) > 0;
        };
        if (const auto picture = std::ranges::find_if(all, shows); picture != all.end())
          out.picture = {picture->png, picture->label, picture->width, picture->height};
      }
}

// The first models and materials of a contact sheet.
std::string top_of_models(const std::string& file) {
  const Image8 sheet = read_picture(file);
  Image8 top(sheet.width / 2, std::min(sheet.height, sheet.width / 4), sheet.channels);
  paste(sheet, 0, 0, top);
  return small_png(top, 560);
}

}  // namespace

void add_scene(unsigned threads, StartPageData& data) {
  add_before(data);
  add_after(data);
  add_findings(threads, data);
}

void add_cards(StartPageData& data) {
  const StartCard cards[] = {
      {"f0.html", "F0 of the library",
       "Every material with spheres, spectra, datasets, their spread and sources.", ""},
      {"report/report.html", "Error against run time", "What every shortcut costs and saves, measured here.",
       ""},
      {"sources.html", "Figures of the sources",
       "What Schüler, Hoffman and TU Graz show, drawn by etak, with the commands.", ""},
      {"models-own.png", "Shading models",
       "Eight materials under each model whose lobe no other one has, and how far it is from the exact one.",
       ""},
      {"models-ggx.png", "GGX", "The same for GGX with each Fresnel and masking term.", ""},
      {"models-lobes.png", "Other lobes", "The same for Beckmann, Phong, ABC and shifted gamma.", ""},
      {"models-light.png", "Bodies and light",
       "Diffuse models, hemispheres and environment alone, and three values of gloss.", ""},
      {"atlas.html", "The atlas", "Textures, layout, what was left out and what each material needs.", ""},
      {"scene-atlas.html", "The atlas of the scene",
       "The same as glTF, with islands of the texels that triangles use.", ""},
      {"findings.html", "Findings",
       "What the validator says of the mistakes, the scene and its atlas, with places and fixes.", ""}};
  for (const StartCard& card : cards) {
    if (!std::filesystem::exists(card.target)) continue;
    data.cards.push_back(card);
    if (card.target.ends_with(".png")) data.cards.back().picture = top_of_models(card.target);
  }
}

}  // namespace etak::demo
