// SPDX-License-Identifier: Apache-2.0
#include "core/validate/find/kind.h"

#include "core/base/files/input.h"
#include "core/base/files/paths.h"
#include "core/exchange/content_kind.h"
#include "core/exchange/material_file.h"
#include "core/exchange/surfaces/document.h"
#include "core/image/picture_bytes.h"
#include "core/image/picture_endings.h"

namespace etak {

namespace {

std::optional<FileRole> kind_of_json(std::string_view head) {
  const auto has = [&](std::string_view text) { return head.find(text) != std::string_view::npos; };
  if (has("\"pages\"") && (has("\"rects\"") || has("etak-atlas-layout"))) return FileRole::layout;
  if (has("\"datasets\"") || has("etak-material/")) return FileRole::material;
  return std::nullopt;
}

// The role of input from a pipe by its content, because it has no ending that could tell the role.
std::optional<FileRole> kind_of_content(std::string_view head) {
  if (is_surface_document(head)) return FileRole::surfaces;
  switch (content_kind(head)) {
    case ContentKind::gltf:
      return FileRole::scene;
    case ContentKind::json:
      return kind_of_json(head);
    case ContentKind::page:
    case ContentKind::table:
      return FileRole::spectrum;
    case ContentKind::binary:
    case ContentKind::prose:
      break;
  }
  // A picture may look like text as well: Radiance HDR begins with lines of text.
  if (!picture_format(head, "").empty()) return FileRole::specular_gloss;
  return std::nullopt;
}

// Enough to tell a form by; empty where there is no file.
std::string head_of_file(const std::string& path) {
  return is_file(path) ? read_head(path, 64) : std::string();
}

}  // namespace

std::optional<FileRole> role_of_file(const std::string& path) {
  const std::string ending = path_ending(path);
  if (ending == radiance_ending || has_picture_ending(path)) return FileRole::specular_gloss;
  if (ending == "gltf" || ending == "glb") return FileRole::scene;
  if (ending == "mtlx" || ending == "usda") return FileRole::surfaces;
  if (ending == "usd" && head_of_file(path).starts_with("#usda")) return FileRole::surfaces;
  const MaterialFileKind kind = material_file_kind(path);
  if (ending == "csv" && is_value_table(head_of_file(path))) return FileRole::surfaces;
  if (kind == MaterialFileKind::page || (kind == MaterialFileKind::table && !may_be_prose(path)))
    return FileRole::spectrum;
  const bool pipe = is_pipe_input(path);
  if (ending != "json" && !pipe) return std::nullopt;
  const std::string head = read_head(path, content_head);
  return ending == "json" ? kind_of_json(head) : kind_of_content(head);
}

}  // namespace etak
