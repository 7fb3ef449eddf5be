// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/output_tree.h"

#include <cerrno>
#include <set>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"
#include "core/base/files/disk_queue.h"
#include "core/base/files/output_folder.h"
#include "core/base/files/output_target.h"
#include "core/base/files/temporary.h"

namespace etak {

namespace {

bool is_path_below(std::string_view name) {
  for (;;) {
    const std::size_t slash = name.find('/');
    if (!is_plain_file_name(name.substr(0, slash))) return false;
    if (slash == name.npos) return true;
    name.remove_prefix(slash + 1);
  }
}

/// The last part of a path below the folder.
std::string name_in_folder(const std::string& name) {
  return name.substr(name.rfind('/') + 1);
}

/// The name, among the temporaries, of the file that number `i` replaces.
std::string old_of(std::size_t i) {
  return "old" + std::to_string(i);
}

}  // namespace

struct OutputTree::State {
  std::string path;  // as the caller wrote it, for messages
  bool overwrite = false, made = false;
  Descriptor folder;
  Temporary fresh;  // holds the files by their numbers, and the old ones while they are replaced
  std::vector<std::string> names;  // of the files, by number
  std::vector<bool> replaces;      // by number: whether there was a file in its place
  std::set<std::string> taken;
  std::vector<std::string> new_folders;  // paths below the folder, parents first
  std::set<std::string> folders{""};     // all paths of folders below it, each with a slash behind it
  DiskQueue disk;

  Descriptor folder_of(const std::string& name, bool make);
  void place_one(std::size_t i);
  void take_back(std::size_t placed);

  [[noreturn]] void fail(const char* what, const std::string& file = {}) const {
    const int why = errno;
    throw Error::at(file.empty() ? path : path + "/" + file, std::string(what) + ": " + reason_of(why));
  }
};

/// The open folder that holds the file `name`. It is reached from the handle of the tree's own folder, part by
/// part, and a link is never followed: whoever puts one there between two steps cannot lead a file elsewhere.
///   make   whether folders that are missing are made
Descriptor OutputTree::State::folder_of(const std::string& name, bool make) {
  Descriptor at(sys::duplicate(folder.get()));
  if (!at) fail("cannot be opened");
  for (std::size_t begin = 0, slash; (slash = name.find('/', begin)) != name.npos; begin = slash + 1) {
    const std::string part = name.substr(begin, slash - begin), below = name.substr(0, slash);
    if (make && sys::make_folder_in(at.get(), part, mode_of_new_folder()))
      new_folders.push_back(below);
    else if (make && errno != EEXIST)
      fail("cannot be made", below);
    Descriptor next = open_folder(at.get(), part);
    if (!next) {
      const int why = errno;
      sys::FileInfo info;
      if (sys::file_info_in(at.get(), part.c_str(), info) && info.kind != sys::FileInfo::Kind::folder)
        throw Error::at(path + "/" + below,
                        info.kind == sys::FileInfo::Kind::link ? "is a link" : "is a file", "a folder");
      errno = why;
      fail("cannot be opened", below);
    }
    at = std::move(next);
    if (make) folders.insert(below + '/');
  }
  return at;
}

OutputTree::OutputTree(const std::string& path, bool overwrite) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.path = path;
  s.overwrite = overwrite;
  s.made = sys::make_folder(path);
  if (!s.made && errno != EEXIST) s.fail("cannot be made");
  s.folder = Descriptor(sys::open_file(path, sys::Open::folder));
  if (!s.folder) s.fail("cannot be written");
  s.fresh = Temporary(s.folder.get(), "tree", Temporary::Kind::folder);
  if (s.fresh) return;
  const int why = errno;
  tidy();
  errno = why;
  s.fail("cannot be written");
}

OutputTree::~OutputTree() {
  tidy();
}

void OutputTree::write(const std::string& name, std::string_view bytes, std::optional<unsigned> mode) {
  State& s = *state_;
  if (!is_path_below(name))
    throw Error::at(s.path, "cannot hold a file named " + printable(name), "a path below the folder");
  if (!s.taken.insert(name).second) throw Error::at(s.path + "/" + name, "is written twice");
  const std::string number = std::to_string(s.names.size());
  Descriptor file(sys::open_in(s.fresh.open().get(), number, sys::OpenIn::create, mode_of_new_file()));
  if (!file || !write_all(file.get(), bytes) || (mode && !sys::set_mode(file.get(), *mode & 0777)))
    s.fail("cannot be written", name);
  s.names.push_back(name);
  s.disk.add(std::move(file), name);
}

void OutputTree::prepare() {
  State& s = *state_;
  if (const auto failure = s.disk.finish()) {
    errno = failure->second;
    s.fail("cannot be written", failure->first);
  }
  for (const std::string& name : s.names) {
    const Descriptor folder = s.folder_of(name, true);
    sys::FileInfo info;
    if (sys::file_info(folder.get(), info))
      refuse_input(info, s.path + "/" + name.substr(0, name.rfind('/') + 1));
    s.replaces.push_back(sys::file_info_in(folder.get(), name_in_folder(name).c_str(), info));
    if (!s.replaces.back()) continue;
    const std::string target = s.path + "/" + name;
    refuse_input(info, target);
    if (info.kind == sys::FileInfo::Kind::folder) throw Error::at(target, "is a folder", "a file to replace");
    if (!s.overwrite) throw exists_already(target);
  }
}

void OutputTree::State::place_one(std::size_t i) {
  const Descriptor at = folder_of(names[i], false);
  const std::string number = std::to_string(i), name = name_in_folder(names[i]);
  const int from = fresh.open().get();
  // Where there are no hard links, what is replaced cannot be put back.
  if (replaces[i]) (void)sys::link_in(at.get(), name, from, old_of(i));
  if ((replaces[i] ? sys::rename_in : rename_where_free)(from, number, at.get(), name)) return;
  if (errno == EEXIST) throw exists_already(path + "/" + names[i]);
  fail("cannot be put in place", names[i]);
}

// Undoes the first `placed` renames.
void OutputTree::State::take_back(std::size_t placed) {
  while (placed-- > 0) {
    try {
      const Descriptor at = folder_of(names[placed], false);
      const std::string name = name_in_folder(names[placed]);
      if (replaces[placed])
        sys::rename_in(fresh.open().get(), old_of(placed), at.get(), name);
      else
        sys::remove_in(at.get(), name.c_str());
    } catch (const Error&) {
      // Its folder is gone or cannot be opened: the others are put back all the same.
    }
  }
}

void OutputTree::place() {
  State& s = *state_;
  std::size_t placed = 0;
  try {
    for (; placed < s.names.size(); ++placed) s.place_one(placed);
  } catch (...) {
    s.take_back(placed);
    throw;
  }
  s.new_folders.clear();
}

void OutputTree::flush() {
  State& s = *state_;
  bool good = true;
  for (const std::string& folder : s.folders) good = names_to_disk(s.folder_of(folder, false).get()) && good;
  if (std::exchange(s.made, false))
    if (const Descriptor above = open_folder(s.folder.get(), "..")) good = names_to_disk(above.get()) && good;
  if (!good) s.fail("is in place, but its folders cannot be flushed");
}

void OutputTree::tidy() {
  State& s = *state_;
  s.fresh.remove(-1);
  for (; !s.new_folders.empty(); s.new_folders.pop_back())  // those that hold something stay
    sys::remove_folder_in(s.folder.get(), s.new_folders.back().c_str());
  if (std::exchange(s.made, false)) sys::remove_folder(s.path);
}

}  // namespace etak
