// SPDX-License-Identifier: Apache-2.0
#include "core/pack/identity.h"

#include <algorithm>
#include <type_traits>
#include <vector>

#include "core/base/files/file.h"
#include "core/base/files/paths.h"
#include "core/base/hash/content_hash.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/pack/pack.h"

namespace etak {

std::string settings_hash(const PackOptions& options, const PackSource& source) {
  const PackInputs& inputs = source.inputs;
  const PackOutputOptions& output = options.output;
  const bool scene = source.scene != nullptr, one_page = output.goal == PackGoal::one_page;
  ContentHash hash;
  std::string text = options.run.version + '|' + inputs.settings + '|' + options.check.settings + '|';
  for (const std::string& each : options.leave_out.keep) text += each + ',';
  for (const std::string& each : options.output.write.formats) text += each + ',';
  if (const CompressOptions& blocks = output.compress; blocks.format != nullptr) {
    text += "blocks," + std::string(blocks.format->name) + (blocks.falls_back ? ",auto," : ",") +
            std::to_string(blocks.effort);
    for (const double part :
         {blocks.budget.diffuse, blocks.budget.f0, blocks.budget.gloss, blocks.budget.alpha})
      text += ',' + etak::number(part, 17);
    text += ',';
  }
  // The options of scenes change nothing of an atlas that is packed from pictures.
  if (output.smallest_form && scene) text += "smallest,";
  for (const GltfForm form : output.forms) text += std::to_string(static_cast<int>(form)) + ',';
  const auto number = [&](auto value) {
    if constexpr (std::is_floating_point_v<decltype(value)>)
      append_number(text, value, 17);
    else
      text += std::to_string(value);
    text += '|';
  };
  number(static_cast<int>(inputs.gloss));
  number(options.layout.form ? static_cast<int>(*options.layout.form) : -1);
  const auto& level = options.output.write.png_level;
  number(level ? static_cast<int>(*level) : -1);
  number(static_cast<int>(scene || one_page ? output.goal : PackGoal::gpu));
  number(options.output.write.zstd_level);
  number(options.layout.page);
  number(options.layout.multiple);
  number(int{options.layout.rotate} + 2 * int{options.leave_out.islands && scene} + 4 * int{output.bleed});
  number(options.layout.effort);
  number(options.layout.max_seconds);
  number(options.layout.gutter.value_or(
      scene && options.layout.viewers_gutter ? -1 - *options.layout.viewers_gutter : -1));
  number(options.layout.mips.value_or(-1));
  number(options.layout.most_extra_area);
  number(options.input.gltf.scene.value_or(-1));
  number(int{options.input.gltf.all_scenes} + 2 * int{options.input.gltf.variants});
  number(options.leave_out.max_error.value_or(-1));
  number(options.leave_out.texel_density);
  number(options.leave_out.view_height);
  for (const auto& [role, space] : options.input.pictures.spaces) text += role + '=' + space + '|';
  hash.add(text);
  return hash.hex();
}

std::vector<std::string> input_files(const PackOptions& options, const PackSource& source) {
  std::vector<std::string> files;
  for (const PackInput& m : source.materials()) {
    files.insert(files.end(), m.files.begin(), m.files.end());
    if (m.normal.is_image()) files.push_back(m.normal.path);
  }
  if (source.scene)
    for (const PictureFile& image : source.scene->scene.images)
      if (!image.path.empty() && is_there(image.path)) files.push_back(image.path);
  if (!options.input.space_config.empty()) files.push_back(options.input.space_config);
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

std::string content_hash(const PackOptions& options, const PackSource& source) {
  const std::vector<std::string> files = input_files(options, source);
  std::vector<std::string> hashes(files.size());
  std::vector<FileBytes> memory(options.run.threads);
  parallel_chunks(files.size(), options.run.threads, 1, [&](std::size_t begin, std::size_t, unsigned worker) {
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
