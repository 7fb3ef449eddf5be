// SPDX-License-Identifier: Apache-2.0
#include "core/validate/check_pack.h"

#include <utility>
#include <vector>

#include "core/atlas/texels/page_pixels.h"
#include "core/image/load.h"
#include "core/validate/engine.h"
#include "core/validate/files/file_hints.h"
#include "core/validate/files/files.h"
#include "core/validate/output/formats.h"

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

PackCheck::PackCheck(const std::string& output, PackCheckOptions options)
    : options_(std::move(options)),
      path_(output + "/layout.json"),
      label_(relative_label(path_, options_.config.root)) {}

void PackCheck::attach(PackOptions& options) {
  const Settings& settings = options_.config.settings;
  // What the limit is counts too: it decides which pages are good. The usual one goes without saying.
  options.check.settings = settings_hash(settings);
  if (options_.never_fails)
    options.check.settings += "never";
  else if (settings.fail_on != Severity::error)
    options.check.settings += name(settings.fail_on);
  options.check.page = [this](const AtlasLayout& layout, int page, const PagePixels& pixels) {
    return check_page(layout, page,
                      [&](Texture texture) { return rows_of(pixels.view(texture), header_of_page()); });
  };
  options.check.written_page = [this](const AtlasLayout& layout, int page,
                                      const std::function<std::string(Texture)>& path) {
    return check_page(layout, page, [&](Texture texture) { return open_picture(path(texture), {}); });
  };
}

bool PackCheck::check_page(const AtlasLayout& layout, int page,
                           const std::function<std::unique_ptr<RowSource>(Texture)>& rows) {
  // Pages come from the first one on each time the layout has changed.
  if (page == 0) files_.clear();
  const std::vector<CheckTarget> targets = targets_of_layout(layout, path_, label_);
  const auto index = static_cast<std::size_t>(page);
  if (index >= targets.size()) return true;  // no material that is on no page
  const CheckTarget& target = targets[index];
  const auto open = [&](const TargetFile& file) {
    return rows(file.role == FileRole::diffuse_alpha ? Texture::diffuse_alpha : Texture::specular_gloss);
  };
  const CheckedFile& file = files_[target.label] =
      check_opened(target, open, options_.config.settings, options_.threads);
  return report_of_run({file}, options_.config, {}).passed || options_.never_fails;
}

const ValidationReport& PackCheck::finish(PackResult& report) {
  finished_ = true;
  std::vector<CheckedFile> files;
  for (auto& [label, file] : files_) files.push_back(std::move(file));
  report_ = report_of_run(std::move(files), options_.config, {});
  report.validation = validation_json(report_, {options_.config.settings.fail_on, options_.version});
  return report_;
}

}  // namespace etak
