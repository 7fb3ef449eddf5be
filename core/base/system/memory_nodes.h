// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/system.h"

// What the sources memory_*.cpp share.
//
// Files and folders for a program without an operating system: a tree in memory, which ends with the program. There is
// one user, who may do everything, and there are neither links nor other programs. Names that a file has besides its
// first one share its bytes, as hard links do.

namespace etak::sys {
using Kind = FileInfo::Kind;

struct Node : std::enable_shared_from_this<Node> {
  Kind kind = Kind::file;
  std::uint64_t number = 0;
  unsigned mode = 0644;
  bool given = false;  // as the host put it
  int locked_by = -1;  // a descriptor
  FileInfo::Time written;
  std::weak_ptr<Node> parent;
  std::string bytes;
  std::map<std::string, std::shared_ptr<Node>, std::less<>> entries;
};
using Shared = std::shared_ptr<Node>;

struct Opened {
  Shared node;
  std::size_t at = 0;
};

FileInfo::Time now();
Shared made(Kind kind);

struct Tree {
  Shared root = made(Kind::folder);
  std::vector<Opened> open{{made(Kind::pipe)}, {made(Kind::pipe)}, {made(Kind::pipe)}};
};

Tree& tree();

/// Sets errno; returns -1 or false.
int failed(int why);
bool refused(int why);

/// What is open under that number; null where nothing is, and errno says so.
Opened* opened(int descriptor);
Shared node_of(int descriptor);
int descriptor_for(Shared node);

/// The node behind a path; null where there is none, for which errno tells why.
Shared found_at(Shared at, std::string_view path);

/// The folder that the last part of a path is a name in; no folder where there is none.
struct Place {
  Shared folder;
  std::string name;
};
Place place_of(const Shared& from, std::string_view path);

/// What has that name; null where nothing has, and errno says so.
Shared entry_of(const Place& place);
void put(const Place& place, Shared node);
int open_node(Shared node, bool folder, bool writes);

}  // namespace etak::sys
