// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pack/findings.h"

#include <map>

#include "app/cli/options/options.h"
#include "app/cli/pictures/pictures.h"
#include "app/cli/validate/cache.h"
#include "app/cli/validate/plan.h"
#include "app/cli/validate/targets.h"
#include "core/validate/files/files.h"
#include "core/validate/files/open_pictures.h"
#include "core/validate/output/formats.h"

namespace etak::cli {
namespace {

ValidateArguments as_validate(const PackArguments& a) {
  ValidateArguments out;
  out.paths = {a.out + "/layout.json"};
  out.config = a.config;
  out.no_config = a.no_config;
  out.fail_on = a.fail_on;
  return out;
}

// The head that the page's PNG has; the other formats hold the same.
TextureHeader header_of_page() {
  TextureHeader header;
  header.format = "png";
  header.colour_space = "srgb";
  return header;
}

}  // namespace

struct PackFindings::Parts {
  ValidateArguments arguments;
  ValidatePlan plan;
  std::string path, label;  // of the layout
  unsigned threads = 1;
  std::map<std::string, CheckedFile> files;
  ValidationReport report;
  bool checked = false;

  explicit Parts(PackArguments& a)
      : arguments(as_validate(a)),
        plan(validate_plan(arguments, asked_materials(a.library))),
        path(arguments.paths.front()) {
    label = relative_label(path, plan.root);
    threads = thread_count(a.threads);
  }

  const Settings& settings() const { return plan.config.settings; }

  // With what [[allow]] entries accept marked.
  ValidationReport judged(std::vector<CheckedFile> checked_files) const {
    ValidationReport out = report_of(std::move(checked_files), settings());
    (void)take_out_known(out, arguments, plan);  // packing writes no baseline
    return report_of(std::move(out.files), settings());
  }

  bool check_page(const AtlasLayout& layout, int page,
                  const std::function<std::unique_ptr<RowSource>(Texture)>& rows) {
    // Pages come from the first one on each time the layout has changed.
    if (page == 0) files.clear();
    const std::vector<CheckTarget> targets = targets_of_layout_text(layout_json(layout), path, label);
    const auto index = static_cast<std::size_t>(page);
    if (index >= targets.size()) return true;  // no material that is on no page
    const CheckTarget& target = targets[index];
    const auto open = [&](const TargetFile& file) {
      return rows(file.role == FileRole::diffuse_alpha ? Texture::diffuse_alpha : Texture::specular_gloss);
    };
    const CheckedFile& file = files[target.label] = check_opened(target, open, settings(), threads);
    return judged({file}).passed || arguments.fail_on == never_fails;
  }
};

PackFindings::PackFindings(PackArguments& arguments) {
  if (!arguments.no_validate) parts_ = std::make_unique<Parts>(arguments);
}
PackFindings::~PackFindings() = default;

void PackFindings::attach(PackOptions& options) {
  if (!parts_) return;
  options.check_settings = settings_hash(parts_->settings()) + parts_->arguments.fail_on;
  options.check_page = [this](const AtlasLayout& layout, int page, const PagePixels& pixels) {
    return parts_->check_page(
        layout, page, [&](Texture texture) { return rows_of(pixels.view(texture), header_of_page()); });
  };
  options.check_written_page = [this](const AtlasLayout& layout, int page,
                                      const std::function<std::string(Texture)>& path) {
    return parts_->check_page(
        layout, page, [&](Texture texture) { return open_picture(path(texture), picture_decoder()); });
  };
}

void PackFindings::finish(PackReport& report) {
  if (!parts_) return;
  parts_->checked = true;
  std::vector<CheckedFile> files;
  for (auto& [label, file] : parts_->files) files.push_back(std::move(file));
  parts_->report = parts_->judged(std::move(files));
  parts_->report.settings_hash = settings_hash(parts_->settings());
  report.validation = validation_json(parts_->report, {parts_->settings().fail_on, ETAK_VERSION});
}

const ValidationReport* PackFindings::report() const {
  return parts_ && parts_->checked ? &parts_->report : nullptr;
}
std::string PackFindings::text(bool color) const {
  return parts_ && parts_->checked ? validation_text(parts_->report, color) : "";
}
std::string PackFindings::verdict() const {
  return parts_ && parts_->checked ? verdict_of(parts_->report) : "";
}
bool PackFindings::failed() const {
  return parts_ && parts_->checked && !parts_->report.passed && parts_->arguments.fail_on != never_fails;
}
bool PackFindings::incomplete() const {
  return parts_ && parts_->checked && parts_->report.incomplete;
}

}  // namespace etak::cli
