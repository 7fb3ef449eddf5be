// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/material_file.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/memory.h"
#include "core/base/text/ascii.h"
#include "core/exchange/rii/rii_page.h"
#include "core/material/json.h"
#include "core/material/limits.h"
#include "core/material/names.h"
#include "core/material/optics/optics_class.h"

namespace etak {
namespace {

constexpr std::array<std::string_view, 7> endings{"yml", "yaml", "csv", "tsv", "txt", "dat", "json"};
constexpr std::array kinds{MaterialFileKind::page,    MaterialFileKind::page,  MaterialFileKind::table,
                           MaterialFileKind::table,   MaterialFileKind::table, MaterialFileKind::table,
                           MaterialFileKind::material};
static_assert(endings.size() == kinds.size());

// The ending without its dot, in lower case; empty where there is none.
std::string ending_of(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == path.npos ? std::string() : lower_case(path.substr(dot + 1));
}

Material material_of_table(std::string_view text, const std::string& path, const TableOptions& options,
                           std::string_view id) {
  Table table = parse_table(text, path, options);
  const std::string_view stem = file_stem(path);
  Material out;
  out.id = id.empty() ? identifier(stem, '_', "table") : std::string(id);
  // A byte that is no text takes four characters.
  const bool named = id.empty() && !stem.empty() && !is_pipe_input(path);
  out.name = named ? printable(stem, most_name_bytes / 4 - 3) : out.id;
  out.preferred_reason = "the only dataset";
  Dataset& dataset = out.datasets.emplace_back();
  dataset.id = identifier(stem, '-', "table");
  dataset.optics = std::move(table.optics);
  dataset.flags = table.flags;
  dataset.citation.title = path.substr(path.rfind('/') + 1);
  decide_class(out);
  return out;
}

}  // namespace

MaterialFileKind material_file_kind(std::string_view path) {
  const auto found = std::find(endings.begin(), endings.end(), ending_of(path));
  return found == endings.end() ? MaterialFileKind::none
                                : kinds[static_cast<std::size_t>(found - endings.begin())];
}

std::span<const std::string_view> material_file_endings() {
  return endings;
}

MaterialFileKind material_content_kind(std::string_view head, std::string_view place) {
  constexpr std::string_view expected = "a page, a table or a material file";
  switch (content_kind(head)) {
    case ContentKind::gltf:
      throw Error::at(place, "holds a glTF scene", expected);
    case ContentKind::binary:
      throw Error::at(place, "holds no text", expected);
    case ContentKind::page:
      return MaterialFileKind::page;
    case ContentKind::json:
      return MaterialFileKind::material;
    case ContentKind::table:
    case ContentKind::prose:
      break;
  }
  return MaterialFileKind::table;
}

bool may_be_prose(std::string_view path) {
  const std::string ending = ending_of(path);
  return ending == "txt" || ending == "dat";
}

bool is_prose_file(std::string_view path, std::string_view head) {
  return may_be_prose(path) && content_kind(head) == ContentKind::prose;
}

Material material_of_text(std::string_view text, const std::string& path, MaterialFileKind kind,
                          const TableOptions& options, std::string_view id) {
  assert(kind != MaterialFileKind::none);
  Material out = kind == MaterialFileKind::page    ? material_from_rii_page(text, path, id)
                 : kind == MaterialFileKind::table ? material_of_table(text, path, options, id)
                                                   : parse_material(text, path);
  state(out, options);
  return out;
}

Material read_material_file(const std::string& path, MaterialFileKind kind, const TableOptions& options,
                            std::string_view id) {
  const std::string text = read_file(path);
  return with_memory_for(
      path, [&] { return mebibytes(text.size()) + " of text"; },
      [&] { return material_of_text(text, path, kind, options, id); });
}

}  // namespace etak
