// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/picture.h"
#include "core/judge/finding.h"
#include "core/judge/settings.h"
#include "core/judge/target.h"

namespace etak {

struct AtlasLayout;
struct Evidence;

// Checks of one target: the parts that validate() (core/validate/validate.h) and PackCheck (check_pack.h) are
// made of.

/// Checks one target. Never throws for what is in the files: an unreadable one is finding ETK001, an error of
/// a rule ETK901, and the file is marked `unreadable`.
CheckedFile check(const CheckTarget& target, const PictureDoor& door, const Settings& settings,
                  unsigned threads = 1);

/// Adds evidence of a target to what is there, and what was found meanwhile to `file`. May throw.
using EvidenceGatherer = std::function<void(const Settings&, Evidence&, CheckedFile& file)>;

/// Gathers the evidence under the settings for the target and judges it. An error of `look` becomes a
/// finding, as in check().
CheckedFile check_by(const CheckTarget& target, const Settings& settings, const EvidenceGatherer& look);

/// Puts findings into the order in which judge() leaves them.
void sort_findings(CheckedFile& file);

/// Adds the counts and costs of one part of a file to those of the file.
void add_sums(const CheckedFile& one, CheckedFile& file);

/// Joins the results of the tiles of a UDIM set, at least one, to one result, whose findings name their
/// tiles.
CheckedFile joined_tiles(std::vector<CheckedFile> tiles);

/// Opens a picture of a target; called once for each pass over the pixels.
using PictureOpener = std::function<std::unique_ptr<RowSource>(const TargetFile&)>;

/// Opens a picture of a target: the file at its path, or its bytes, which then must outlive the source.
/// Throws Error.
std::unique_ptr<RowSource> open_target_file(const TargetFile& file, const PictureDoor& door);

/// Checks a pair whose pictures `open` gives, as check() does: no file of the target is read.
CheckedFile check_opened(const CheckTarget& target, const PictureOpener& open, const Settings& settings,
                         unsigned threads = 1);

/// The kind of a file by its ending and, for .json and input from a pipe, by its first bytes; nullopt: a kind
/// that is not checked. Throws Error where those bytes cannot be read. Every picture is specular_gloss here;
/// the caller finds its role by its name.
std::optional<FileRole> role_of_file(const std::string& path);

/// An atlas layout: one target per page, with tiles and gutter, and last one for the materials that are on no
/// page because constants replace their texels. Paths of pages are relative to the folder of the file. Throws
/// Error naming file and JSON pointer.
std::vector<CheckTarget> targets_of_layout(const std::string& path, const std::string& label);

/// The same of the text of a layout, and of a layout in memory; `path` is where its file is, or will be.
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
