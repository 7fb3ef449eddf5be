// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/output_tree.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"
#include "core/base/files/disk_queue.h"
#include "core/base/files/output_folder.h"
#include "core/base/files/output_target.h"
#include "core/base/files/temporary.h"

namespace etak {

namespace fs = std::filesystem;

namespace {

bool is_path_below(std::string_view name) {
  for (;;) {
    const std::size_t slash = name.find('/');
    if (!is_plain_file_name(name.substr(0, slash))) return false;
    if (slash == name.npos) return true;
    name.remove_prefix(slash + 1);
  }
}

}  // namespace

struct OutputTree::State {
  std::string path;  // as the caller wrote it, for messages
  bool overwrite = false, made = false;
  Descriptor folder;
  Temporary fresh;                 // holds the files by their numbers
  std::vector<std::string> names;  // of the files, by number
  std::set<std::string> taken;
  DiskQueue disk;

  [[noreturn]] void fail(const char* what, const std::string& file = {}) const {
    const int why = errno;
    throw Error::at(file.empty() ? path : path + "/" + file, std::string(what) + ": " + reason_of(why));
  }
};

OutputTree::OutputTree(const std::string& path, bool overwrite) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.path = path;
  s.overwrite = overwrite;
  s.made = ::mkdir(path.c_str(), 0777) == 0;
  if (!s.made && errno != EEXIST) s.fail("cannot be made");
  s.folder = Descriptor(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
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

void OutputTree::write(const std::string& name, std::string_view bytes) {
  State& s = *state_;
  if (!is_path_below(name))
    throw Error::at(s.path, "cannot hold a file named " + printable(name), "a path below the folder");
  if (!s.taken.insert(name).second) throw Error::at(s.path + "/" + name, "is written twice");
  const std::string number = std::to_string(s.names.size());
  Descriptor file(::openat(s.fresh.open().get(), number.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                           mode_of_new_file()));
  if (!file || !write_all(file.get(), bytes)) s.fail("cannot be written", name);
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
    const fs::path target = fs::path(s.path) / name;
    fs::path folder = s.path;
    for (const fs::path& part : fs::path(name).parent_path()) {
      folder /= part;
      std::error_code failure;
      // A link could lead out of the folder.
      if (fs::is_symlink(fs::symlink_status(folder, failure)))
        throw Error::at(folder.string(), "is a link", "a folder");
      fs::create_directory(folder, failure);
      if (failure) throw Error::at(folder.string(), "cannot be made: " + failure.message(), "a folder");
    }
    struct stat info {};
    if (::fstatat(s.folder.get(), name.c_str(), &info, AT_SYMLINK_NOFOLLOW) != 0) continue;
    if (S_ISDIR(info.st_mode)) throw Error::at(target.string(), "is a folder", "a file to replace");
    if (!s.overwrite) throw exists_already(target.string());
  }
}

void OutputTree::place() {
  State& s = *state_;
  for (std::size_t i = 0; i < s.names.size(); ++i)
    if (::renameat(s.fresh.open().get(), std::to_string(i).c_str(), s.folder.get(), s.names[i].c_str()) != 0)
      s.fail("cannot be put in place (files written before it have been)", s.names[i]);
  ::fsync(s.folder.get());
  s.made = false;
}

void OutputTree::tidy() {
  State& s = *state_;
  s.fresh.remove(-1);
  if (std::exchange(s.made, false)) ::rmdir(s.path.c_str());
}

}  // namespace etak
