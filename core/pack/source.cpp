// SPDX-License-Identifier: Apache-2.0
#include "core/pack/source.h"

#include <algorithm>

#include "core/atlas/sources/apply_variants.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/files/paths.h"
#include "core/base/setting.h"
#include "core/pack/one_page.h"
#include "core/pack/pack.h"

namespace etak {
namespace {

PackInputs inputs_of(AtlasManifest manifest, const PackOptions& options, const MaterialLibrary& library) {
  const auto& variants = options.leave_out.variants;
  return resolve_manifest(with_methods(std::move(manifest), variants ? &*variants : nullptr), library,
                          options.input.pictures);
}

PackInputs inputs_of(const PackManifest& of, const PackOptions& options, const MaterialLibrary& library) {
  PackInputs out = inputs_of(of.manifest, options, library);
  out.remarks.insert(out.remarks.begin(), of.remarks.begin(), of.remarks.end());
  out.settings += of.settings;
  return out;
}

PackInputs inputs_of_folder(const std::string& folder, const PackOptions& options,
                            const MaterialLibrary& library) {
  std::vector<std::string> remarks;
  std::string pattern;
  PackInputs out = inputs_of(manifest_in_folder(folder, options, remarks, pattern), options, library);
  out.remarks.insert(out.remarks.end(), remarks.begin(), remarks.end());
  out.settings += pattern;
  return out;
}

PackManifest manifest_in(const std::string& path, const PackOptions& options) {
  const std::string text = read_file(path);
  if (options.input.other_manifest)
    if (auto other = options.input.other_manifest(text, path)) return *std::move(other);
  return {parse_manifest(text, path), {}, text};
}

}  // namespace

AtlasManifest manifest_in_folder(const std::string& folder, const PackOptions& options,
                                 std::vector<std::string>& remarks, std::string& pattern) {
  std::vector<std::string> skipped;
  AtlasManifest out;
  pattern = options.input.pattern.empty() && all_follow(folder, default_pattern) ? default_pattern
                                                                                 : options.input.pattern;
  if (pattern.empty())
    out = manifest_of_names(folder, options.input.pictures.door, skipped, remarks);
  else
    out = manifest_of_folder(folder, pattern, &skipped);
  std::ranges::sort(skipped);
  if (!skipped.empty()) remarks.push_back(skipped_remark(skipped));
  return out;
}

const std::vector<PackInput>& PackSource::materials() const {
  return one_page ? one_page->materials : inputs.materials;
}

PackSource read_source(const std::string& input, const PackManifest* manifest, const PackOptions& options,
                       const MaterialLibrary& library) {
  PackSource out;
  if (manifest != nullptr) {
    out.inputs = inputs_of(*manifest, options, library);
  } else if (is_folder(input)) {
    out.inputs = inputs_of_folder(input, options, library);
  } else if (is_gltf_file(input)) {
    out.scene = read_scene(input, options);
    out.inputs = out.scene->inputs;
  } else {
    out.inputs = inputs_of(manifest_in(input, options), options, library);
  }
  const PackLeaveOutOptions& less = options.leave_out;
  if (less.variants) apply_variants(*less.variants, less.keep.contains("constant"), input, out.inputs);
  if (!out.scene && (less.texel_density > 0 || less.view_height > 0))
    throw Error::at(setting(less.texel_density > 0 ? "texel-density" : "view-height"),
                    input + " says nothing of sizes in a world", "a glTF scene");
  if (out.scene && !options.input.pictures.spaces.empty())
    throw Error::at(setting("space-of"), "a glTF scene, which says what space its pictures are of",
                    "a manifest or a folder");
  return out;
}

}  // namespace etak
