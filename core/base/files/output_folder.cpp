// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/output_folder.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"
#include "core/base/files/disk_queue.h"
#include "core/base/files/output_target.h"
#include "core/base/files/paths.h"
#include "core/base/files/temporary.h"
#include "core/base/setting.h"
#include "core/base/signals.h"
#include "core/base/system.h"

namespace etak {
namespace {

// One run at a time looks at a parent and exchanges folders in it: less than a second for a large set.
constexpr std::chrono::seconds most_wait{10};

// The layout names the textures, so it comes last.
bool is_layout(const std::string& name) {
  return name.starts_with("layout") && name.ends_with(".json");
}

// Whether the process works in the folder or below.
bool holds_working_folder(const std::string& folder) {
  const std::string here = sys::path_text(sys::working_folder());
  return here == folder || here.starts_with(folder + "/");
}

// Whether a folder is a mount, also of a folder of the same disk. A rename of "." is never done, and between two mounts
// the reason is that.
bool is_mount_point(const std::string& folder, const std::string& above) {
  sys::FileInfo inner, outer;
  if (sys::file_info(folder, inner) && sys::file_info(above, outer) && inner.device != outer.device)
    return true;
  const Descriptor from(sys::open_file(above, sys::Open::folder)),
      to(sys::open_file(folder, sys::Open::folder));
  return sys::can_exchange() && from && to && !sys::rename_in(from.get(), ".", to.get(), ".") &&
         errno == EXDEV;
}

}  // namespace

bool is_plain_file_name(std::string_view name) {
  constexpr std::string_view separators("/\0", 2);
  return !name.empty() && name != "." && name != ".." && name.find_first_of(separators) == name.npos &&
         sys::takes_file_name(name);
}

namespace {

// Folders that were made for the target to lie in. Unless they are kept, those that are empty are removed.
class MadeParents {
 public:
  MadeParents() = default;
  MadeParents(const MadeParents&) = delete;
  MadeParents& operator=(const MadeParents&) = delete;
  ~MadeParents() {
    for (; !made_.empty(); made_.pop_back()) sys::remove_folder(made_.back());
  }
  bool make(const std::filesystem::path& folder) { return make_folders(folder, &made_); }
  void keep() { made_.clear(); }

 private:
  std::vector<std::string> made_;
};

}  // namespace

struct OutputFolder::State {
  MadeParents made;         // removed after all that lies in it
  std::string path;         // as the caller wrote it, for messages
  std::string parent_path;  // without links
  std::string name;         // of the target in its parent
  Replace replace = Replace::nothing;
  bool inside = false;                // the new folder is made in the target, not beside it
  bool exchanges = true;              // else files are renamed one by one
  Descriptor parent;                  // where the new folder is made: of the target, or the target itself
  Temporary fresh;                    // the new folder; the old one, after an exchange
  std::optional<FolderLock> placing;  // from the last look on
  std::optional<Descriptor> placed;   // the target, once the set is in place
  unsigned mode = 0777;               // of new files, at most
  std::mutex lock;                    // of the two sets
  std::set<std::string> files, removed;
  DiskQueue disk;

  std::string target_path() const { return parent_path + (parent_path == "/" ? "" : "/") + name; }
  Descriptor open_target() const {
    return inside ? Descriptor(sys::reopen_folder(parent.get())) : open_folder(parent.get(), name);
  }
  int fresh_folder() const { return fresh.open().get(); }
  [[noreturn]] void fail(const char* what, const std::string& file = {}) const {
    const int why = errno;
    throw Error::at(file.empty() ? path : path + "/" + file, std::string(what) + ": " + reason_of(why));
  }

  void expect_plain(const std::string& file) const {
    if (!is_plain_file_name(file))
      throw Error::at(path, "cannot hold a file named " + printable(file), "a name without folders");
  }

  void find_target();
  void refuse_read_only() const;
  std::vector<std::string> strangers(int target) const;
  bool link_along(int target, const std::vector<std::string>& all) const;
  bool move_folders(const std::vector<std::string>& all);
  void exchange();
  void rename_one_by_one();
};

void OutputFolder::State::find_target() {
  namespace fs = std::filesystem;
  fs::path full = sys::absolute(path);
  if (!full.is_absolute()) throw Error::at(path, "is no folder's name");
  if (!full.has_filename()) full = full.parent_path();  // "out/"
  const auto kind = kind_at(sys::path_text(full));
  const bool there = kind.has_value();
  if (there && kind != sys::FileInfo::Kind::folder)
    throw Error::at(path, "is a file", "a folder to write to");
  const auto refuse = [&] {
    throw Error::at(path, "cannot be written: " + reason_of(errno), "a folder that can be made");
  };
  if (!there && !made.make(full.parent_path())) refuse();
  const fs::path bare = sys::canonical(there ? full : full.parent_path());
  if (bare.empty()) refuse();
  const fs::path whole = there ? bare : bare / full.filename();
  if (!there && (is_link(sys::path_text(full)) || full.filename() == "." || full.filename() == ".."))
    throw Error::at(path, "is a link that leads nowhere", "a folder to write to");
  parent_path = sys::path_text(whole.parent_path());
  name = sys::path_text(whole.filename());
  inside = there && (name.empty() || is_mount_point(sys::path_text(whole), parent_path) ||
                     !sys::may_write(parent_path));
  exchanges = !inside && !(there && (!sys::can_exchange() || holds_working_folder(sys::path_text(whole))));
  parent = Descriptor(sys::open_file(inside ? sys::path_text(whole) : parent_path, sys::Open::folder));
  if (!parent) fail("cannot be written");
}

// The parent may allow another folder to take the target's place; but a target without any permission to
// write was meant to stay as it is.
void OutputFolder::State::refuse_read_only() const {
  sys::FileInfo info;
  const Descriptor target = open_target();
  const bool there = target && sys::file_info(target.get(), info);
  if (!there || replace == Replace::anything) return;
  const bool writable = (info.mode & 0222) != 0 && sys::may_write(target_path());
  if (!writable)
    throw Error::at(path, "is read-only",
                    "a folder that may be written, or " + setting("force") + " to replace it");
}

OutputFolder::OutputFolder(const std::string& path, Replace replace) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.path = path;
  s.replace = replace;
  s.find_target();
  s.refuse_read_only();
  const Descriptor home = s.open_target();
  s.fresh = Temporary(s.parent.get(), s.inside ? "" : s.name, Temporary::Kind::folder, home.get());
  if (!s.fresh)
    throw Error::at(path, "cannot be written: " + reason_of(errno), "a folder that can be made or changed");
}

// Files that were not put in place are removed with the temporary.
OutputFolder::~OutputFolder() {
  tidy();
}

struct OutputFolder::File::Open {
  State& folder;
  std::string name;
  Descriptor file;
  std::string waiting;

  void flush() {
    if (!write_all(file.get(), waiting)) folder.fail("cannot be written", name);
    waiting.clear();
  }
};

OutputFolder::File::File(std::unique_ptr<Open> open) : open_(std::move(open)) {}

OutputFolder::File::~File() {
  if (!open_) return;
  sys::remove_in(open_->folder.fresh_folder(), open_->name.c_str());
  const std::lock_guard lock(open_->folder.lock);
  open_->folder.files.erase(open_->name);
}

void OutputFolder::File::add(std::string_view bytes) {
  constexpr std::size_t piece = std::size_t{64} << 10;
  if (open_->waiting.size() + bytes.size() > piece) open_->flush();
  if (bytes.size() < piece)
    open_->waiting.append(bytes);
  else if (!write_all(open_->file.get(), bytes))
    open_->folder.fail("cannot be written", open_->name);
}

void OutputFolder::File::patch(std::size_t at, std::string_view bytes) {
  open_->flush();
  while (!bytes.empty()) {
    const std::ptrdiff_t wrote = sys::write_at(open_->file.get(), bytes.data(), bytes.size(), at);
    if (wrote < 0) open_->folder.fail("cannot be written", open_->name);
    at += static_cast<std::size_t>(wrote);
    bytes.remove_prefix(static_cast<std::size_t>(wrote));
  }
}

void OutputFolder::File::close() {
  open_->flush();
  sys::begin_to_disk(open_->file.get());
  open_->folder.disk.add(std::move(open_->file), open_->name);
  open_.reset();
}

void OutputFolder::limit_mode(unsigned most) {
  state_->mode = most | 0200;
}

std::string OutputFolder::path_until_commit(const std::string& name) const {
  const State& s = *state_;
  return (s.inside ? s.target_path() : s.parent_path) + "/" + s.fresh.name() + "/" + name;
}

std::unique_ptr<OutputFolder::File> OutputFolder::open(const std::string& name) {
  State& s = *state_;
  s.expect_plain(name);
  {
    const std::lock_guard lock(s.lock);
    if (!s.files.insert(name).second) throw Error::at(s.path + "/" + name, "is written twice");
  }
  // No new file is made once a signal ends the program, so that all files can be removed.
  const SignalsHeld held;
  // From here on the destructor of the file takes the name out of the set again.
  std::unique_ptr<File> out(new File(std::make_unique<File::Open>(File::Open{s, name, Descriptor(), {}})));
  out->open_->file = Descriptor(sys::open_in(s.fresh_folder(), name, sys::OpenIn::create, 0666 & s.mode));
  if (!out->open_->file) s.fail("cannot be written", name);
  return out;
}

void OutputFolder::write(const std::string& name,
                         const std::function<void(const std::function<void(std::string_view)>&)>& body) {
  const std::unique_ptr<File> file = open(name);
  body([&](std::string_view bytes) { file->add(bytes); });
  file->close();
}

void OutputFolder::write(const std::string& name, std::string_view bytes) {
  write(name, [&](const auto& sink) { sink(bytes); });
}

void OutputFolder::take_back(const std::string& name) {
  sys::remove_in(state_->fresh_folder(), name.c_str());
  const std::lock_guard lock(state_->lock);
  state_->files.erase(name);
}

void OutputFolder::remove_old(const std::string& name) {
  state_->expect_plain(name);
  const std::lock_guard lock(state_->lock);
  state_->removed.insert(name);
}

// The names in the target that are neither replaced nor removed.
std::vector<std::string> OutputFolder::State::strangers(int target) const {
  // A list that breaks off would lose what it does not name.
  errno = 0;
  std::vector<std::string> out = names_in(target);
  if (errno != 0) fail("cannot be listed");
  std::erase_if(out, [&](const std::string& entry) {
    return files.count(entry) != 0 || (removed.count(entry) != 0 && !is_folder(target, entry));
  });
  return out;
}

// Gives the files a second name in the new folder, and makes links there that lead to the folders once the target's
// own folder has the name of the new one. False where one of these cannot be.
bool OutputFolder::State::link_along(int target, const std::vector<std::string>& all) const {
  return std::ranges::all_of(all, [&](const std::string& entry) {
    return is_folder(target, entry)
               ? sys::make_link_in(fresh_folder(), "../" + fresh.name() + "/" + entry, entry)
               : sys::link_in(target, entry, fresh_folder(), entry);
  });
}

// After the exchange: puts the folders in the places of the links to them. False, and all is as it was, where one
// cannot be moved: it is a mount point, or somebody else's.
bool OutputFolder::State::move_folders(const std::vector<std::string>& all) {
  const auto exchanged = [&](const std::string& entry) {
    return sys::exchange_in(fresh_folder(), entry, placed->get(), entry);
  };
  for (auto at = all.begin(); at != all.end(); ++at) {
    if (!is_folder(fresh_folder(), *at) || exchanged(*at)) continue;
    while (at != all.begin())
      if (is_folder(placed->get(), *--at)) exchanged(*at);
    return false;
  }
  return true;
}

void OutputFolder::State::exchange() {
  sys::FileInfo old;
  Descriptor target = open_target();
  const bool there = target && sys::file_info(target.get(), old);
  // The new folder gets mode and owner of the old one; an owner that cannot be changed stays.
  if (there) sys::set_owner(fresh_folder(), old);
  if (!sys::set_mode(fresh_folder(), there ? old.mode : mode_of_new_folder())) fail("cannot be put in place");

  if (!there) {
    if (!sys::to_disk(fresh_folder()) || !rename_where_free(parent.get(), fresh.name(), parent.get(), name))
      fail("cannot be put in place");
    (void)fresh.keep();
    placed = open_target();
    return;
  }

  // So that no other run takes the old folder for the remains of a kill, where nobody else holds this lock.
  (void)sys::try_lock(target.get());
  const std::vector<std::string> all = strangers(target.get());
  const auto exchange_names = [&] {
    return sys::exchange_in(parent.get(), fresh.name(), parent.get(), name);
  };
  if (link_along(target.get(), all) && sys::to_disk(fresh_folder()) && exchange_names()) {
    // A folder that somebody has put into the old target meanwhile is moved to the new one by tidy().
    placed = fresh.exchanged(std::move(target));
    if (move_folders(all)) return;
    if (!exchange_names()) fail("cannot be put in place");
    (void)fresh.exchanged(std::move(*placed));
    placed.reset();
  }
  for (const std::string& entry : all) sys::remove_in(fresh_folder(), entry.c_str());
  rename_one_by_one();
}

void OutputFolder::State::rename_one_by_one() {
  Descriptor target = open_target();
  if (!target) fail("cannot be put in place");
  std::vector<std::string> order(files.begin(), files.end());
  std::stable_partition(order.begin(), order.end(), [](const std::string& file) { return !is_layout(file); });
  for (const std::string& file : order)
    if (is_folder(target.get(), file)) throw Error::at(path + "/" + file, "is a folder", "a file to replace");
  for (const std::string& file : order)
    if (!sys::rename_in(fresh_folder(), file, target.get(), file))
      fail("cannot be put in place (files before it in the alphabet have been)", file);
  for (const std::string& old : removed)
    if (files.count(old) == 0) sys::remove_in(target.get(), old.c_str());
  placed = std::move(target);
}

void OutputFolder::prepare() {
  State& s = *state_;
  assert(s.fresh);
  if (const auto failure = s.disk.finish()) {
    errno = failure->second;
    s.fail("cannot be written", failure->first);
  }
  // One commit into this parent at a time, so that no file is left behind that appears between the look
  // and the exchange.
  s.placing.emplace(s.parent.get(), most_wait, s.inside ? "" : s.name, s.fresh_folder());
  if (s.placing->is_taken())
    throw Error::at(s.path, "cannot be put in place: another run of etak holds its lock");
  using Kind = sys::FileInfo::Kind;
  sys::FileInfo info;
  if (!s.inside && sys::file_info_in(s.parent.get(), s.name.c_str(), info) && info.kind != Kind::folder)
    throw Error::at(s.path, "is a file by now", "a folder to write to");
  s.refuse_read_only();
  if (const Descriptor target = s.open_target())
    for (const std::string& file : s.files) {
      if (!sys::file_info_in(target.get(), file.c_str(), info)) continue;
      if (info.kind == Kind::folder) throw Error::at(s.path + "/" + file, "is a folder", "a file to replace");
      refuse_input(info, s.path + "/" + file);
      if (s.replace == Replace::nothing) throw exists_already(s.path + "/" + file);
    }
}

void OutputFolder::place() {
  if (state_->exchanges)
    state_->exchange();
  else
    state_->rename_one_by_one();
  state_->placing.reset();
  state_->made.keep();
}

void OutputFolder::flush() {
  const State& s = *state_;
  if (!names_to_disk(s.placed->get()) || (!s.inside && !names_to_disk(s.parent.get())))
    s.fail("is in place, but its folder cannot be flushed");
}

void OutputFolder::tidy() {
  if (state_->placed) state_->fresh.remove(state_->placed->get());
}

}  // namespace etak
