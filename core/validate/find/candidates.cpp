// SPDX-License-Identifier: Apache-2.0
#include "core/validate/find/candidates.h"

#include <filesystem>
#include <variant>

#include "core/atlas/manifest.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/files/paths.h"
#include "core/base/parallel.h"
#include "core/base/system.h"
#include "core/exchange/content_kind.h"
#include "core/validate/find/file_hints.h"
#include "core/validate/find/kind.h"

namespace etak {

namespace fs = std::filesystem;

std::vector<KindOfFile> kinds_of(const std::vector<FileCandidate>& candidates, unsigned threads) {
  std::vector<KindOfFile> out(candidates.size());
  // The kind of a .json file is told by its content. Files are opened for that, so all threads do it.
  parallel_chunks(candidates.size(), threads, 64, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      const FileCandidate& candidate = candidates[i];
      KindOfFile& found = out[i];
      found.missing = !candidate.plain && !is_there(candidate.path) && !is_pipe_input(candidate.path);
      try {
        found.kind = role_of_file(candidate.path);
        if (found.kind == FileRole::spectrum && candidate.named != Named::by_hand &&
            !looks_like_spectrum(candidate.path))
          found.kind.reset();
        if (found.kind && !candidate.searched.empty() && !candidate.plain)
          check_links(candidate.searched, candidate.path);
      } catch (const Error& error) {
        if (!found.missing) found.failure = error.what();
      }
    }
  });
  return out;
}

void add_manifest_pictures(const std::string& path, std::unordered_set<std::string>& pictures) {
  if (!path.ends_with(".json")) return;
  try {
    if (read_head(path, content_head).find("\"etak-atlas-manifest/") == std::string::npos) return;
    const auto add = [&](const std::string& picture) {
      if (!picture.empty()) pictures.insert(sys::path_text(fs::path(picture).lexically_normal()));
    };
    for (const ManifestMaterial& material : parse_manifest(read_file(path), path).materials) {
      add(material.normal);
      for (const auto* source : {&material.diffuse, &material.specular, &material.gloss, &material.roughness,
                                 &material.alpha, &material.base_color, &material.metallic})
        if (source->has_value())
          if (const auto* image = std::get_if<ImageSource>(&**source)) add(image->path);
    }
  } catch (const Error&) {
    // A broken manifest is none of the kinds that are checked; etak pack says what is wrong with it.
  }
}

}  // namespace etak
