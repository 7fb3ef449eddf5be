// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/result_text.h"

#include <type_traits>
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
          '\n' + manifest.surface_class + '\n';
  for (const CheckTile& tile : manifest.tiles)
    text += tile.name + '\n' + tile.material + '\n' + tile.surface_class + '\n' + std::to_string(tile.box.x) +
            ' ' + std::to_string(tile.box.y) + ' ' + std::to_string(tile.box.width) + ' ' +
            std::to_string(tile.box.height) + ' ' + std::to_string(tile.page) + ' ' +
            (tile.typical_gloss ? number(*tile.typical_gloss, 17) : "-") + '\n';
}

// Severities are looked at when they are read, because other numbers would be none.
template <class To, class Value>
void severity_member(To& to, Value& value) {
  if constexpr (std::is_const_v<Value>)
    to.member(value);
  else
    to.member_up_to(value, Severity::error);
}

template <class Struct>
concept ResultPart = std::is_same_v<Struct, PixelBox> || std::is_same_v<Struct, NearestMaterial> ||
    std::is_same_v<Struct, FindingIsland> || std::is_same_v<Struct, Finding> ||
    std::is_same_v<Struct, CheckedFile>;

}  // namespace

template <class To, class Struct>
requires ResultPart<std::remove_const_t<Struct>>
void members(To& to, Struct& s) {
  using Type = std::remove_const_t<Struct>;
  const auto all = [&](auto&... values) { (to.member(values), ...); };
  if constexpr (std::is_same_v<Type, PixelBox>) {
    all(s.x, s.y, s.width, s.height);
  } else if constexpr (std::is_same_v<Type, NearestMaterial>) {
    all(s.id, s.dataset, s.bytes);
  } else if constexpr (std::is_same_v<Type, FindingIsland>) {
    all(s.tile, s.box, s.area_px, s.uv);
  } else if constexpr (std::is_same_v<Type, Finding>) {
    severity_member(to, s.severity);
    all(s.rule, s.slug, s.file, s.tile, s.material, s.pointer, s.box, s.uv, s.area_px, s.area_share, s.linear,
        s.byte, s.luminance, s.value, s.limit, s.nearest, s.message, s.cause, s.fix, s.source, s.islands);
  } else {
    all(s.path, s.companions, s.sha256, s.width, s.height, s.roles, s.findings, s.plateau_px, s.transition_px,
        s.counts);
  }
}

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
