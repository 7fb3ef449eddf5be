// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/picture.h"
#include "core/validate/finding.h"
#include "core/validate/settings.h"
#include "core/validate/target.h"

namespace etak {

struct AtlasLayout;
struct Evidence;

// One target at a time: the parts that validate() (core/validate/validate.h) and PackCheck (check_pack.h) are
// made of.

/// Checks one target. Never throws for what is in the files: an unreadable one is finding ETK001, an error of
/// a rule ETK901, and the file is marked `unreadable`.
CheckedFile check(const CheckTarget& target, const PictureDoor& door, const Settings& settings,
                  unsigned threads = 1);

/// Adds evidence of a target to what is there, and what it found to `file`. May throw.
using EvidenceGatherer = std::function<void(const Settings&, Evidence&, CheckedFile& file)>;

/// Judges the evidence that is gathered under the settings that hold for the target. What goes wrong while
/// it is gathered is a finding, as of check().
CheckedFile check_by(const CheckTarget& target, const Settings& settings, const EvidenceGatherer& look);

/// Brings the findings of parts of a file into the order that judge() leaves.
void sort_findings(CheckedFile& file);

/// Adds the counts and costs of one part of a file to those of the file.
void add_sums(const CheckedFile& one, CheckedFile& file);

/// What was found of the tiles of a UDIM set, at least one, as one file: findings name their tiles.
CheckedFile joined_tiles(std::vector<CheckedFile> tiles);

/// Where the rows of a target's picture come from; called once per pass over the pixels.
using PictureOpener = std::function<std::unique_ptr<RowSource>(const TargetFile&)>;

/// The same of a pair whose pictures are at hand already: nothing is read from the files.
CheckedFile check_opened(const CheckTarget& target, const PictureOpener& open, const Settings& settings,
                         unsigned threads = 1);

/// What kind of file a path is by its ending and, for .json and what comes from a pipe, by its first bytes;
/// nullopt: none that is checked. Throws Error where those bytes cannot be read. Pictures come back as
/// specular_gloss: which role they have is for the caller's patterns to say.
std::optional<FileRole> role_of_file(const std::string& path);

/// An atlas layout: one target per page, with tiles and gutter, and last one for the materials that are on no
/// page because numbers say everything. Paths of pages are taken beside the file. Throws Error naming file
/// and JSON pointer.
std::vector<CheckTarget> targets_of_layout(const std::string& path, const std::string& label);

/// The same of a layout's text, and of one in memory; `path` is where it is, or will be.
std::vector<CheckTarget> targets_of_layout_text(const std::string& text, const std::string& path,
                                                const std::string& label);
std::vector<CheckTarget> targets_of_layout(const AtlasLayout& layout, const std::string& path,
                                           const std::string& label);

/// The pictures of a target as codes (a metal-rough set is converted first), for mask pictures and
/// thumbnails. A and B as the rules see them; empty (0 x 0) where there is none. Throws Error.
struct LoadedPictures {
  Image8 a, b, metallic;
  PicturesInMemory in_memory() const;
};
LoadedPictures load_pictures(const CheckTarget& target, const PictureDoor& door);

}  // namespace etak
