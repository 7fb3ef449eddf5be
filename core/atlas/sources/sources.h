// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/atlas/leave_out.h"
#include "core/atlas/manifest.h"
#include "core/atlas/sources/plane.h"
#include "core/image/channels.h"
#include "core/image/material_pair.h"
#include "core/material/library.h"

namespace etak {

struct MaskedSource;  // core/atlas/sources/masked.h

/// What a sampler does at the edges of a picture, by axis.
using WrapBoth = std::array<Wrap, 2>;

/// The pictures of both textures: colours, alpha and gloss; in place of F0 metalness where the first is a base colour.
struct PairPlanes {
  std::array<PlaneSource, 4> planes;
  bool metallic = false;
  int width = 1, height = 1;
};

/// A material as the packer reads it: two planes a texture that can be read in strips, or a function that
/// makes the whole pair.
struct PackInput {
  std::string name;
  int width = 1, height = 1;
  AlphaMode alpha_mode = AlphaMode::blend;
  double alpha_cutoff = 0.5;
  PlaneSource normal;                      // tangent-space normal map, or a constant for none
  std::function<Image8()> load_normals;    // the same of a scene, at the material's size, RGB; empty: none
  std::array<PlaneSource, 2> color, grey;  // by Texture
  std::function<MaterialPair(std::vector<std::string>& remarks)> convert;  // set: in place of the planes
  std::function<FloatPair()> convert_floats;                               // the same for floats.h
  std::shared_ptr<const MaskedSource> masked;                              // null: no mask
  std::shared_ptr<const PairPlanes> metallic;                              // null: not made of a base colour
  MaterialFacts facts;
  bool streamed = true;                     // every picture can be read in strips
  WrapBoth wrap{Wrap::clamp, Wrap::clamp};  // what lies beyond the picture's edges
  bool own_page = false;                    // tiles over a surface, which only a page of its own can do
  int document_index = -1;                  // in a glTF
  std::vector<std::string> files;           // all that are read

  /// The box is the whole picture.
  bool is_whole(const PixelBox& box) const { return box == PixelBox{0, 0, width, height}; }
  /// What a sampler does at the edges of a box that is stored by itself: only the whole picture can wrap.
  WrapBoth wrap_of(const PixelBox& box) const {
    return is_whole(box) ? wrap : WrapBoth{Wrap::clamp, Wrap::clamp};
  }
  bool has_normals() const { return normal.is_image() || load_normals; }
};

/// The materials to be packed, with the sources of their channels; of pictures only the headers are read.
struct PackInputs {
  GlossForm gloss = GlossForm::schueler;  // what comes out
  std::vector<PackInput> materials;
  std::vector<std::string> remarks;  // what had to be changed
  std::string settings;              // all that decides the result, except for the bytes of the files
};

/// The materials of a folder whose files are named as etak validate reads names (core/names): sets of a colour with its
/// parts, single or packed, each with its normal map and opacity. A base colour without metalness is a dielectric where
/// its convention means that. Gloss and smoothness are 1 - roughness. Sorted by name.
///   skipped   gets the paths that are no regular files, such as pipes
///   remarks   gets the sets that are left out, because something of them is missing
/// Throws Error where no set is whole.
AtlasManifest manifest_of_names(const std::string& folder, const PictureDoor& door,
                                std::vector<std::string>& skipped, std::vector<std::string>& remarks);

/// Opens a colour space that etak does not have itself. Throws Error that tells the nearest names.
using SpaceOpener = std::function<SpaceCurve(const std::string& name)>;

/// How the pictures that a manifest names are read.
///   gloss        what texture B is to hold; none: as the manifest says
///   door         to pictures other than PNG
///   open_space   for spaces other than srgb, linear and power-2.2; empty: there are no others
///   spaces       of pictures that name none, by role
///   decoded      files that need not be read again; may be filled after the inputs were made
struct PictureReading {
  std::optional<GlossForm> gloss;
  PictureDoor door;
  SpaceOpener open_space;
  std::map<std::string, std::string> spaces;
  DecodedFiles decoded = {};
};

/// Turns manifest entries into inputs: sizes from the headers, constants and library materials into codes.
///   reading   must outlive the inputs
/// Throws Error: files that are missing or of different sizes, unknown materials, spaces and channels.
PackInputs resolve_manifest(const AtlasManifest& manifest, const MaterialLibrary& library,
                            const PictureReading& reading);

/// The picture of a material's emission (three channels of at least 0, linear light; where neither `source` nor the
/// file names a space, codes are sRGB) or of its occlusion (one channel, 0 to 1), which pages have no room for.
///   material   its name, for messages
///   most       a larger picture is made smaller by means over squares of texels until no side is above this
/// Throws Error as resolve_manifest() and for texels out of range.
Image emission_floats(const ImageSource& source, const std::string& material, const PictureReading& reading,
                      int most = max_image_side);
Image occlusion_floats(const ImageSource& source, const std::string& material, const PictureReading& reading,
                       int most = max_image_side);

}  // namespace etak
