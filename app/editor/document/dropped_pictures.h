// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <utility>
#include <vector>

#include "core/project/project.h"

namespace etak::editor {

// Pictures that were dropped together. Like all reading of files, this is done by a worker.

/// The pictures of one material, each with the channel that its name tells.
///   name   what the names have in common: "T_Worn" of T_Worn_D.png and T_Worn_AO.png
struct DroppedSet {
  std::string name;
  std::vector<std::pair<Channel, QString>> files;
};

/// What becomes of dropped pictures: every file is in a set or is refused.
///   refused   a sentence for each file that no set has: "T_Worn_ORM.png: occlusion, roughness, metallic: not
///             taken yet"
struct DroppedPictures {
  std::vector<DroppedSet> sets;
  QStringList refused;
};

/// Most materials that one drop makes.
inline constexpr std::size_t most_dropped_sets = 100;

/// Reads the names of pictures by the table of conventions that `etak validate` has. A picture whose name tells
/// no channel is the diffuse colour, where its set has no other. Of two files for one channel none is taken, and
/// no file that is broken.
///   paths   files; of a folder its pictures are taken, but none of the folders in it
DroppedPictures sort_pictures(const QStringList& paths);

/// Why a file is not a whole picture that can be read; empty: it is one. Its texels are not decoded.
QString picture_failure(const QString& path);

/// Gives the material the pictures of the set.
void take_set(const DroppedSet& set, ProjectMaterial& material);

/// A new material with the pictures of the set.
ProjectMaterial material_of(const DroppedSet& set);

}  // namespace etak::editor
