// SPDX-License-Identifier: Apache-2.0
#include "core/validate/check_pack.h"

#include <utility>
#include <vector>

#include "core/atlas/texels/page_pixels.h"
#include "core/findings/output/formats.h"
#include "core/findings/report.h"
#include "core/image/load.h"
#include "core/validate/files/check.h"
#include "core/validate/files/layout_targets.h"
#include "core/validate/files/scene_on_pages.h"
#include "core/validate/find/file_hints.h"
#include "core/validate/find/find_targets.h"

namespace etak {
namespace {

// The head that the page's PNG has; the other formats hold the same.
PictureHeader header_of_page() {
  PictureHeader header;
  header.format = "png";
  header.colour_space = "srgb";
  return header;
}

}  // namespace

PackCheck::~PackCheck() = default;

PackCheck::PackCheck(const std::string& output, PackCheckOptions options)
    : options_(std::move(options)),
      path_(output + "/layout.json"),
      label_(relative_label(path_, options_.config.root)) {}

void PackCheck::attach(PackOptions& options) {
  const Settings& settings = options_.config.settings;
  // The limit counts too, because it decides which pages are good. The usual one goes without saying.
  options.check.settings = settings_hash(settings);
  if (options_.never_fails)
    options.check.settings += "never";
  else if (settings.fail_on != Severity::error)
    options.check.settings += name(settings.fail_on);
  door_ = options.input.pictures.door;
  options.check.scene = [this](const PackedScene& packed) {
    const std::string& path = packed.uses->scene().path;
    scene_ =
        std::make_unique<SceneOnPages>(packed, label_, relative_label(path, options_.config.root), door_);
  };
  options.check.page = [this](const AtlasLayout& layout, int page, const PagePixels& pixels) {
    return check_page(
        layout, page, [&](Texture texture) { return rows_of(pixels.view(texture), header_of_page()); },
        &pixels);
  };
  options.check.written_page = [this](const AtlasLayout& layout, int page,
                                      const std::function<std::string(Texture)>& path) {
    return check_page(
        layout, page, [&](Texture texture) { return open_picture(path(texture), {}); }, nullptr);
  };
}

bool PackCheck::check_page(const AtlasLayout& layout, int page,
                           const std::function<std::unique_ptr<RowSource>(Texture)>& rows,
                           const PagePixels* pixels) {
  const Settings& settings = options_.config.settings;
  std::vector<CheckTarget> targets = targets_of_layout(layout, path_, label_);
  const auto index = static_cast<std::size_t>(page);
  const bool is_page = index < layout.pages.size();
  // Pages come from the first one on each time the layout has changed.
  if (page == 0) {
    files_.clear();
    if (scene_) scene_->start(layout);
  }
  std::vector<CheckedFile> found;
  if (scene_) {
    scene_->judge(page, is_page ? pixels : nullptr, settings, options_.threads);
    found.push_back(scene_->found());
  }
  // No target where no material is on no page; and those of a scene were judged. With a page come the materials whose
  // parts lie apart on it.
  for (std::size_t i = index; i < targets.size() && (is_page || !scene_); ++i) {
    CheckTarget& target = targets[i];
    const auto& parts = target.manifest.parts;
    if (parts.empty() ? i != index : scene_ || !is_page || parts.front().page != page) continue;
    if (scene_) target.manifest.scene = scene_->path();
    const auto open = [&](const TargetFile& file) {
      return rows(file.role == FileRole::diffuse_alpha ? Texture::diffuse_alpha : Texture::specular_gloss);
    };
    found.push_back(files_[target.label] = check_opened(target, open, settings, options_.threads));
  }
  return report_of_run(std::move(found), options_.config.settings, {options_.config.file}).passed ||
         options_.never_fails;
}

const ValidationReport& PackCheck::finish(PackResult& report) {
  finished_ = true;
  std::vector<CheckedFile> files;
  for (auto& [label, file] : files_) files.push_back(std::move(file));
  if (scene_) files.push_back(scene_->found());
  report_ = report_of_run(std::move(files), options_.config.settings, {options_.config.file});
  report.validation = validation_json(report_, {options_.config.settings.fail_on, options_.version});
  return report_;
}

}  // namespace etak
