// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/result_text.h"

#include <utility>

#include "core/base/bytes/member_bytes.h"
#include "core/base/number.h"

namespace etak {
namespace {

void add_manifest(std::string& text, const Manifest& manifest) {
  text += std::to_string(manifest.gutter) + ' ' + std::to_string(manifest.mips.value_or(-1)) + ' ' +
          (manifest.transfer ? std::string(name(*manifest.transfer)) : "-") + ' ' +
          (manifest.linear8_f0 ? '1' : '0') + (manifest.transparent ? '1' : '0') +
          (manifest.packed ? '1' : '0') + (manifest.scene.empty() ? '0' : '1') + '\n' + manifest.material +
          '\n' + manifest.surface_class + '\n' + manifest.layers + '\n';
  for (const CheckTile& tile : manifest.tiles)
    text += tile.name + '\n' + tile.material + '\n' + tile.surface_class + '\n' + tile.layers + '\n' +
            std::to_string(tile.box.x) + ' ' + std::to_string(tile.box.y) + ' ' +
            std::to_string(tile.box.width) + ' ' + std::to_string(tile.box.height) + ' ' +
            std::to_string(tile.page) + ' ' + (tile.typical_gloss ? number(*tile.typical_gloss, 17) : "-") +
            '\n';
}

}  // namespace

std::string identity_of(const FoundTarget& found) {
  std::string text;
  text.reserve(512);
  (text += found.target.label) += '\n';
  for (const auto* files : {&found.target.files, &found.target.beside})
    for (const TargetFile& file : *files) {
      ((text += file.label) += '\n') += name(file.role);
      ((text += file.guessed ? " guessed " : " ") += file.channels) += ' ';
      (text += name(file.green)) += '\n';
    }
  add_manifest(text, found.target.manifest);
  return text;
}

std::string result_text(const CheckedFile& file) {
  MemberWriter out;
  out.member(file);
  return std::move(out.bytes);
}

std::optional<CheckedFile> read_result_text(std::string_view bytes) {
  MemberReader in(bytes);
  CheckedFile out;
  in.member(out);
  if (!in.good()) return std::nullopt;
  return out;
}

}  // namespace etak
