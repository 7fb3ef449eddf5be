// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/files/output.h"
#include "core/base/files/output_target.h"

namespace etak {

/// Whether `name` is the name of a file in a folder and of nothing elsewhere: not empty, no '/', no NUL,
/// neither "." nor "..". The one question that decides what etak may write, replace or remove there, also
/// where the name comes from a file that a stranger made.
bool is_plain_file_name(std::string_view name);

/// A folder of files that belong together (textures and their layout): all of them appear at once or none,
/// and an old set stays whole until then, even when the process is killed.
///   How: everything is written to a new folder beside the target (temporary.h), then the two are exchanged
///   in one step (renameat2 RENAME_EXCHANGE; a plain rename when the target is not there yet). Files of the
///   target that the new set does not replace and the caller did not name to remove_old move along as they
///   are (hard links). So do folders: the new folder has links to them, which are exchanged with the folders
///   themselves directly after it has taken its place, so that a folder can be reached by its path at any
///   time; what a kill leaves of this the next set finishes. Where that cannot be, the files are renamed into the target one by
///   one, "layout*.json" last: each file is then whole at any time, but a process killed between two renames
///   leaves a mixed set, in which the layout is the old one. It cannot be where the file system has no
///   exchange or no hard links; where the target is a mount point; where its parent cannot be written (the
///   new folder is then made in the target); and where the target holds the working folder, which a shell
///   would lose.
/// A symbolic link to a folder stays, and the folder it leads to is the target.
class OutputFolder : public Output {
 public:
  /// Creates the new folder, and the parents of `path` that are not there; these are removed again where nothing is put in
  /// place. Throws Error.
  OutputFolder(const std::string& path, Replace replace);
  ~OutputFolder() override;

  /// Takes permissions beyond these away from the files that are opened from here on (strictest_mode). To be
  /// called before the first of them. Their user may write them nevertheless, to change or remove them.
  void limit_mode(unsigned most);

  /// A new file "name" (no '/'), written by calling `body` with a sink for its bytes. It goes on to the disk
  /// while others are made; commit() waits for that. Throws Error, also for a full disk; what `body` throws
  /// is passed on, and the file is removed. Different files may be written from different threads.
  void write(const std::string& name,
             const std::function<void(const std::function<void(std::string_view)>&)>& body);
  void write(const std::string& name, std::string_view bytes);

  /// A file that is written piece by piece. Unless it is closed it is removed. Lives no longer than its folder.
  class File {
   public:
    ~File();
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    void add(std::string_view bytes);
    /// Puts bytes over those from byte `at` on, which are there already.
    void patch(std::size_t at, std::string_view bytes);
    void close();

   private:
    friend class OutputFolder;
    struct Open;
    explicit File(std::unique_ptr<Open> open);
    std::unique_ptr<Open> open_;
  };
  std::unique_ptr<File> open(const std::string& name);

  /// Removes a file that was written, such as one whose bytes now lie in another.
  void take_back(const std::string& name);

  /// The path of a written file until commit(), for reading the file again.
  std::string path_until_commit(const std::string& name) const;

  /// Names of files of an earlier set in the target that are not to live on. A name that is not there, or
  /// that this set has too, does nothing. Throws Error for a name that could lead out of the target
  /// (is_plain_file_name): such names come from layouts that others have written.
  void remove_old(const std::string& name);

 private:
  void prepare() override;
  void place() override;
  void flush() override;
  void tidy() override;

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace etak
