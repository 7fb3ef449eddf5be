// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "core/atlas/sources/plane.h"
#include "core/image/picture.h"
#include "core/judge/settings.h"
#include "core/project/project.h"

namespace etak::editor {

// Pictures that were dropped together. Like all reading of files, this is done by a worker.

/// One quantity of a dropped picture, and where it goes: a row of the table that is shown before anything is taken.
///   set       index of the material that the name belongs to
///   holds     what the name tells: "base colour", "roughness, G"
///   channel   where it goes; none: it is skipped
///   source    file, letters and colour space
///   green     of a normal map: which way its green points
///   fixed     it can only be skipped: a broken file, or what no channel takes
///   remark    why it is skipped, or what is to be known of it
struct DroppedRow {
  std::size_t set = 0;
  QString holds;
  std::optional<Channel> channel;
  ImageSource source;
  GreenAxis green = GreenAxis::unsaid;
  bool fixed = false;
  QString remark = {};
};

/// What becomes of dropped pictures: every file has rows or is refused.
///   sets      names of the materials: what the names of their pictures have in common
///   refused   a sentence for each path that has no row
///   decoded   pictures that were read whole and need not be read again: of sets of usual sizes all
struct DroppedPictures {
  std::vector<std::string> sets;
  std::vector<DroppedRow> rows;
  QStringList refused;
  DecodedFiles decoded = {};

  /// Whether more than one quantity came, or one that is not taken: the user then sees the table first.
  bool needs_table() const;
  /// Which of the rows of one set go to one channel: a sentence; empty where each has one of its own.
  QString doubles() const;
};

/// The name of a channel as people read it: "base color".
QString text_of(Channel channel);

/// Most materials that one drop makes.
inline constexpr std::size_t most_dropped_sets = 100;

/// Reads the names of pictures by the table of conventions that `etak validate` has, and gives each quantity the channel
/// that takes it, by the rules of `etak pack FOLDER`: a packed picture is read channel by channel, names of gloss and
/// smoothness mean 1 - roughness, and a base colour beside metalness stays one. Without metalness it is the diffuse
/// colour. A picture whose name tells nothing is the colour where its set has no other. Of two files for one channel
/// that the names do not tell apart none is taken.
///   paths   files; of a folder its pictures are taken, but none of the folders in it
DroppedPictures sort_pictures(const QStringList& paths);

/// Why a file is not a whole picture that can be read; empty: it is one. Its texels are not decoded.
///   header   where given, gets what the file says of itself
QString picture_failure(const QString& path, PictureHeader* header = nullptr);

/// The convention of a normal map that its name does not say: by its texels, as the validator tells it.
GreenAxis green_of(const std::string& path);

/// Gives the material the pictures of a set.
void take_set(const DroppedPictures& dropped, std::size_t set, ProjectMaterial& material);

/// The new materials of all sets of which something is taken.
std::vector<ProjectMaterial> materials_of(const DroppedPictures& dropped);

/// "T_Worn: diffuse, gloss; T_Bark: diffuse".
QString taken_text(const DroppedPictures& dropped);

}  // namespace etak::editor
