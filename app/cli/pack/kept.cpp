// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pack/pack.h"

#include <array>

#include "app/cli/output/replace.h"
#include "core/base/files/output_file.h"
#include "core/base/files/output_target.h"
#include "core/base/files/read_places.h"
#include "core/exchange/data_folder.h"
#include "core/judge/settings.h"
#include "core/scene/gltf.h"
#include "core/validate/find/file_hints.h"

namespace etak::cli {

PackJobIdentity identity_of(const PackArguments& a, const ValidateConfig* config,
                            const std::string& space_config) {
  PackJobIdentity out;
  out.input = a.settings.input;
  out.output = a.settings.out;
  const auto add = [&](const std::string& name, const std::string& value) {
    out.settings += name + '=' + std::to_string(value.size()) + ':' + value + '\n';
  };
  out.settings += settings_text(a.settings);
  add("page-report", a.page_report);
  for (const std::string& link : a.page_links) add("page-link", link);
  add("checked", config == nullptr ? "no" : settings_hash(config->settings));
  if (config != nullptr) {
    add("fail-on",
        std::string(name(config->settings.fail_on)) + (a.check.fail_on == never_fails ? " never" : ""));
    add("label", relative_label(a.settings.out + "/layout.json", config->root));
    add("input-label", relative_label(a.settings.input, config->root));
  }
  for (const std::string& file : {config == nullptr ? std::string() : config->file, space_config,
                                  a.settings.choice, a.settings.previous})
    if (!file.empty()) out.files.push_back(file);
  for (const std::string& folder : a.library.all_folders())
    for (std::string& file : list_folder(folder, 1).files) out.files.push_back(std::move(file));
  if (is_gltf_file(a.settings.input)) {
    const GltfFiles files = files_of_gltf(a.settings.input);
    out.files.insert(out.files.end(), files.all.begin(), files.all.end());
  }
  return out;
}

std::optional<PackTold> atlas_from_cache(const PackArguments& a, const std::string& key) {
  std::optional<KeptAtlas> atlas = a.kept->find(key);
  if (!atlas) return std::nullopt;
  const std::string& output = a.settings.out;
  const bool in_place = PackCache::is_in_place(*atlas, output);
  // -u says of such an atlas that it is up to date.
  if (in_place && a.update) return std::nullopt;
  std::unique_ptr<OutputFolder> folder;
  if (!in_place) folder = a.kept->restored(*atlas, output, may_replace(a.force));
  if (!in_place && !folder) return std::nullopt;
  if (in_place) remove_remains(output);
  std::unique_ptr<Output> page;
  if (atlas->told.page)
    page = std::make_unique<OutputFile>(a.page_report, *atlas->told.page, true,
                                        strictest_mode(atlas->inputs) | 0200);
  const std::array<Output*, 2> outputs{folder.get(), page.get()};
  put_in_place(outputs);
  return std::move(atlas->told);
}

int with_cache(PackArguments& a, int (*work)(PackArguments&), bool again) {
  const CacheOptions options = cache_options(a.cache);
  if (options.path.empty()) return work(a);
  const bool replace = again || may_replace(a.force);
  check_cache_report(a.cache, replace);
  a.kept = std::make_shared<PackCache>(options, ETAK_VERSION, thread_count(a.threads));
  const int status = work(a);
  const CacheUse use = a.kept->folder().use();
  a.kept.reset();
  if (const auto report = cache_report(a.cache, use, replace)) report->commit();
  tell_cache(a.cache, use, shown_as(a));
  return status;
}

}  // namespace etak::cli
