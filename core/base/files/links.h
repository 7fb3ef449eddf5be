// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace etak {

// Scenes, manifests and archives come from others, and a symbolic link in one ("leak.png" to "../secret.png")
// would bring files into an atlas or a report that nobody named. So links that lead out of the folder of such
// a document are not followed. What the user types may be a link, and lead through links.

/// Whether links lead anywhere (--follow-links); at first they do not. To be set before anything is read.
void set_follow_links(bool follow);
bool follows_links();

/// The path of the file `name` that a document in `folder` names, or that a search of `folder` found there.
/// Whether it exists is for the reader to say.
///   folder    "": the working folder
///   name      relative to it; an absolute name comes back as it is, since it hides nothing
///   returns   folder/name
/// Throws Error that names link and target where a part of `name` is a link that leads out of `folder`, and
/// out of the folder in which the link lies (for names with ".."), unless follows_links().
std::string path_beside(const std::string& folder, const std::string& name);

/// The name of a file in a document that lies in `folder`, so that both can be moved together: relative, with "../" where
/// the file lies beside; absolute where the two have no folder in common.
///   folder   absolute; empty: the name is absolute
std::string name_from(const std::filesystem::path& folder, const std::string& file);
/// The folder of a document, as name_from() takes it.
std::filesystem::path folder_of_document(const std::string& file);

}  // namespace etak
