// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/row_runs.h"
#include "core/image/channels.h"
#include "core/image/pixels_view.h"
#include "core/scene/gltf.h"

namespace etak {

// The parts that an atlas need not hold are found here, from facts about the materials, without touching a picture.

/// The kinds of things that are left out, in the order in which they are looked for; words of the
/// setting "keep".
///   unreached   materials that the scene does not reach
///   equal       materials that find every texel they read among another material's (constant channels are
///               not read)
///   alpha       alpha of opaque materials
///   constant    channels that hold one code over the texels in use, and materials that have no others
///   grey        two of F0's three channels where they are equal in every texel in use
///   crop        texels outside of the box that the triangles use
///   islands     texels between the islands that the triangles use (only when islands are asked for)
///   resolution  detail that the content does not have, or that is never seen (only when asked for)
///   textures    one texture of regions that vary only in the other one, where a page of their own is smaller
///   mips        levels that no sampler reads, or in which no region has a texel of its own
///   files       of the pictures that scene.gltf reads beside the pages: all texels but one where they have one
///               colour, and what PNG files say beside their texels
inline constexpr std::array<std::string_view, 11> leave_out_names{
    "unreached", "equal",      "alpha",    "constant", "grey", "crop",
    "islands",   "resolution", "textures", "mips",     "files"};

/// A part of a picture to keep: its box, or of that the texels alone that triangles read.
struct PicturePart {
  PixelBox box;
  RowRuns texels = {};  // of the picture; empty: the whole box
  std::uint64_t area() const { return texels.empty() ? box.area() : count_of(texels); }
  friend bool operator==(const PicturePart&, const PicturePart&) = default;
};

/// What is known of a material. Without `learned`, its texels have not been looked at yet: it is then taken
/// to need them all.
struct MaterialFacts {
  std::string name;
  int width = 0, height = 0;
  bool reached = true;
  bool opaque = false;  // alpha plays no part
  bool learned = false;
  ChannelRange range;  // over the texels in use, alpha 255 when opaque
  std::array<std::uint64_t, 2> color_hash{}, alpha_hash{}, specular_hash{};  // of all texels
  // Decided on floats (floats.h): what channels that do not vary hold, colours in linear light.
  bool floats = false;
  std::array<double, channel_count> exact{};
  std::string source;             // materials of the same text read the same files in the same way
  PixelBox crop;                  // of the texels in use; the whole where that is not known
  std::vector<PixelBox> islands;  // empty: the crop box is the only one
  std::vector<PicturePart>
      outlines;        // the same by their texels, which may lie in each other's boxes; empty: not known
  bool tiles = false;  // the whole period is in use
  int levels = 0;      // mips that its sampler reads, level 0 among them; 0: all
  int unseen = 0;      // halvings of its picture that nobody comes near enough to see

  friend bool operator==(const MaterialFacts&, const MaterialFacts&) = default;
};

/// What becomes of a material.
struct MaterialFate {
  std::size_t owner = 0;  // index of the material whose texels it uses, often its own
  bool texels = true;     // false: constants replace all texels, or nothing draws the material
  std::array<bool, 2> varies{true, true};  // by Texture: some channel of it varies
  std::array<std::optional<std::uint8_t>, channel_count>
      constant;                   // the code of a channel that does not vary
  bool grey = false;              // F0 varies, and is one number in every texel
  std::vector<PicturePart> kept;  // of an owner: the parts of its picture to keep; may overlap
  std::size_t channels = 0;       // of an owner: how many of them vary
};

/// What one step of leave_out() took away.
struct LeaveOutLine {
  std::string what;           // of leave_out_names
  std::string detail;         // what was taken from, in words; of materials a list of all of them
  std::size_t materials = 0;  // from which the step took something
  std::uint64_t texels = 0;   // RGBA texels of the two textures
  std::uint64_t channel_texels = 0;
  std::uint64_t bytes = 0;              // uncompressed: 4 a texel
  double error = 0;                     // largest difference in codes over the texels in use
  std::vector<std::string> parts = {};  // of `detail`, where it is a list
  friend bool operator==(const LeaveOutLine&, const LeaveOutLine&) = default;
};

/// Level-0 texels of the regions alone: no gutters, no waste of pages, no mips.
///   texels           RGBA texels of both textures: what a picture file with four channels holds
///   channel_texels   single numbers of the channels that vary: what a format with fitting channels would
///                    hold
struct TexelAccount {
  std::uint64_t texels = 0, channel_texels = 0;
  friend bool operator==(const TexelAccount&, const TexelAccount&) = default;
};

/// What leave_out() may leave out, and the form of the pages that it counts with.
struct LeaveOutOptions {
  std::set<std::string> keep;  // of leave_out_names
  bool islands = false;
  bool outlines = false;  // of islands: only their own texels
  // How many mips the regions on the pages will have; boxes are made of whole texels of all of these.
  int levels = 1;             // level 0 among them; 0: down to 1 x 1
  std::optional<int> gutter;  // texels around each region; none: as its mips need

  bool leaves(std::string_view what) const { return !keep.contains(std::string(what)); }
};

/// The result of leave_out(): what becomes of each material, and what each step took away.
struct LeaveOut {
  std::vector<MaterialFate> fates;  // in the order of the facts
  std::vector<LeaveOutLine> lines;
  TexelAccount before, after;
};

/// Decides for every material what need not be stored. Of the materials that share texels, the owner is the
/// one that reads most parts of them (colour; alpha; F0 with gloss), and of several such the one of the
/// lowest index.
LeaveOut leave_out(const std::vector<MaterialFacts>& materials, const LeaveOutOptions& options);

/// Throws Error at the setting "keep" for a name that is none of leave_out_names; "all" stands for all of
/// them.
std::set<std::string> parse_keep(const std::vector<std::string>& names);

}  // namespace etak
