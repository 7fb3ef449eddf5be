// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/atlas_rect.h"
#include "core/image/picture.h"
#include "core/judge/finding.h"
#include "core/judge/settings.h"
#include "core/maps/file_role.h"

namespace etak {

/// A file of a target.
struct TargetFile {
  FileRole role = FileRole::specular_gloss;
  std::string path;      // to open
  std::string label;     // for reports: relative to the run's root
  bool guessed = false;  // the role comes from the file's name (ETK010)
  // What R, G, B and A hold, a letter for each (channel_word of names.h); empty: the usual channels of the
  // role. Of F0 and gloss "g": gloss in red, and F0 a number of each tile; "fg": a grey F0 in red and gloss in green. "+" of
  // a page: its fourth channel is red of the file behind it, which has no role of its own.
  std::string channels = {};
  GreenAxis green = GreenAxis::unsaid;            // of a normal map, by its name
  std::shared_ptr<const std::string> bytes = {};  // of the picture file, in the place of those at `path`
  friend bool operator==(const TargetFile&, const TargetFile&) = default;

  /// The file to open.
  PictureFile picture() const { return {path, bytes ? *bytes : std::string(), label}; }
};

/// A part of the picture that is judged on its own: a tile of an atlas.
///   material        the material that the tile shows, as stated: an id or name of the library, or a name of
///                   the project's own
///   surface_class   a class of ETK205 ("dry-sand"); may be empty
///   typical_gloss   the gloss that is expected of this material, for ETK303
struct CheckTile {
  std::string name, material, surface_class;
  PixelBox box;
  int page = 0;
  std::optional<double> typical_gloss;
  std::optional<int> gutter, mips;  // where they differ from the manifest's
  // For the diffuse and the specular texture: the codes of a texture that the pages do without, because it is
  // constant over the tile.
  std::array<std::optional<std::array<std::uint8_t, 4>>, 2> flat;
  std::string island_of;  // material of an atlas whose texels may lie in several tiles; empty: no atlas
  std::string layers;     // of an F0 that layers on a base make: their text; empty: a bare surface
  int own_around = 0;     // width of the frame around the tile that holds texels of the tile's own picture
  // The codes of an F0 that is constant over the tile, where its page holds gloss without it.
  std::optional<std::array<std::uint8_t, 3>> flat_f0 = {};
  friend bool operator==(const CheckTile&, const CheckTile&) = default;
};

/// What is stated about the pictures, in an atlas layout or on the command line.
struct Manifest {
  std::vector<CheckTile> tiles;  // empty: the whole picture is one
  int gutter = 0;                // texels around each tile that repeat its edge
  std::optional<int> mips;       // levels below level 0 that must stay clean (ETK504)
  std::optional<TextureTransfer> transfer;
  std::string material, surface_class;  // of the whole picture
  std::string layers;                   // of the whole target, as CheckTile::layers
  bool linear8_f0 = false;              // F0 is declared to be 8-bit linear (ETK405)
  bool transparent = false;             // alpha is transparency
  bool one_texture = false;             // the other texture was left out on purpose: its values are constant
  // The path of the scene that reads pages, where that is judged too. What the pages show is judged with it, and here what
  // their layout alone can break.
  std::string scene;
  // The page holds materials whose parts lie apart: what they show is judged material by material, and of the page what
  // its layout alone can break.
  bool layout_alone = false;
  std::vector<AtlasRect>
      parts;            // of such a material: the pictures are put together from these regions of the files
  bool packed = false;  // of a scene: its pictures are pages, whose sides their packer chose
  // The shader multiplies diffuse by 1 - max F0, as glTF's does (ETK201).
  bool specular_weighs_diffuse = false;
  friend bool operator==(const Manifest&, const Manifest&) = default;
};

/// One file, or files that belong together, to check: one CheckedFile. The tiles of a UDIM set yield one together.
struct CheckTarget {
  std::string label;  // path of the CheckedFile, relative; the first file's when empty
  std::vector<TargetFile> files;
  Manifest manifest;
  std::string udim = {};  // of a tile: the label with <UDIM> in the place of its number, equal for all tiles
  std::string tile = {};  // "1001"
  // Files of other targets that the maps of this one are held against: base colour, roughness, gloss; and the pictures that
  // its textures in blocks were made of, or blocks that were made of its own.
  std::vector<TargetFile> beside = {};
  friend bool operator==(const CheckTarget&, const CheckTarget&) = default;

  /// What findings about the whole target name: its label, else that of its first file.
  std::string own_label() const;
  /// The file with the first of these roles that some file has; null: none has one of them.
  const TargetFile* with_role(std::initializer_list<FileRole> wanted) const;
};

/// The rows of a target's pictures: null where there is none, or where no rule needs it.
struct PictureRows {
  std::unique_ptr<RowSource> a, b;      // diffuse + alpha, specular + gloss
  std::unique_ptr<RowSource> metallic;  // of a metal-rough set: metallic in each of the first three channels
};

/// The pictures of a target as codes; empty (0 x 0) where there is none.
struct Pictures {
  Image8 a, b;      // 4 channels
  Image8 metallic;  // 1 channel

  /// Their rows; the pictures must outlive them.
  PictureRows rows() const;
};

}  // namespace etak
