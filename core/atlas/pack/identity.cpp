// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/pack/identity.h"

#include <algorithm>
#include <vector>

#include "core/atlas/pack/gltf_pack.h"
#include "core/atlas/pack/pack.h"
#include "core/base/files/file.h"
#include "core/base/hash/content_hash.h"
#include "core/base/parallel.h"

namespace etak {

std::string settings_hash(const PackOptions& options, const PackInputs& inputs) {
  ContentHash hash;
  std::string text = options.version + '|' + inputs.settings + '|' + options.check_settings + '|';
  for (const std::string& each : options.keep) text += each + ',';
  for (const std::string& each : options.write.formats) text += each + ',';
  for (const GltfForm form : options.forms) text += std::to_string(static_cast<int>(form)) + ',';
  const auto number = [&](auto value) { text += std::to_string(value) + '|'; };
  number(static_cast<int>(inputs.gloss));
  number(options.form ? static_cast<int>(*options.form) : -1);
  number(static_cast<int>(options.write.png_level));
  number(options.write.zstd_level);
  number(options.page);
  number(int{options.rotate} + 2 * int{options.islands} + 4 * int{options.bleed});
  number(options.effort);
  number(options.max_seconds);
  number(options.gutter.value_or(-1));
  number(options.mips.value_or(-1));
  number(options.most_extra_area);
  number(options.scene.scene.value_or(-1));
  number(int{options.scene.all_scenes} + 2 * int{options.scene.variants});
  number(options.max_error.value_or(-1));
  number(options.texel_density);
  number(options.view_height);
  for (const auto& [role, space] : options.spaces) text += role + '=' + space + '|';
  hash.add(text);
  return hash.hex();
}

std::vector<std::string> input_files(const PackOptions& options, const PackInputs& inputs,
                                     const ScenePack* scene) {
  std::vector<std::string> files;
  for (const PackInput& m : inputs.materials) {
    files.insert(files.end(), m.files.begin(), m.files.end());
    if (m.normal.is_image()) files.push_back(m.normal.path);
  }
  if (scene) scene->add_files(files);
  if (!options.space_config.empty()) files.push_back(options.space_config);
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

std::string content_hash(const PackOptions& options, const PackInputs& inputs, const ScenePack* scene) {
  const std::vector<std::string> files = input_files(options, inputs, scene);
  std::vector<std::string> hashes(files.size());
  std::vector<FileBytes> memory(options.threads);
  parallel_chunks(files.size(), options.threads, 1, [&](std::size_t begin, std::size_t, unsigned worker) {
    memory[worker].load(files[begin]);
    ContentHash hash;
    hash.add(memory[worker].view());
    hashes[begin] = hash.hex();
  });
  ContentHash all;
  std::string text;
  for (const std::string& each : hashes) text += each;
  all.add(text);
  return all.hex();
}

}  // namespace etak
