// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace etak::sys {

// The one place of what differs between systems: files and folders by open descriptors, locks, signals,
// terminals, memory and shared libraries. The sources system/posix_*.cpp hold it for Linux and other POSIX
// systems, system/windows_*.cpp for Windows, and system/memory_*.cpp, where files are a tree in memory, for WebAssembly;
// nothing else in the core and in the program `etak` calls the system.
// Where a call fails, it returns false or -1, and errno tells why. Paths and names are UTF-8 on Windows, and
// bytes elsewhere. Descriptors read and write bytes as they are and are not passed on to other programs.
// On Windows a path may hold both kinds of slashes; permissions are reduced to "read-only", and owners are
// left alone.

inline constexpr int standard_input = 0, standard_output = 1, standard_error = 2;

/// What is known of a file or folder without reading it.
struct FileInfo {
  enum class Kind { file, folder, link, pipe, socket, device };
  struct Time {
    std::int64_t seconds = 0, nanoseconds = 0;
  };
  Kind kind = Kind::device;
  std::uint64_t device = 0, number = 0;  // the same for all names of a file, different for different files
  std::uint64_t size = 0;                // bytes
  Time written, changed;                 // of the content, and of anything
  unsigned mode = 0;                     // permissions, 07777
  unsigned owner = 0, group = 0;
};

/// The facts of what is behind a path, of what is open, and of a name in an open folder. The last two may be called from
/// a handler of signals.
///   follow   a link: the facts of what it leads to; else those of the link itself
bool file_info(const std::string& path, FileInfo& out, bool follow = true);
bool file_info(int open, FileInfo& out);
bool file_info_in(int folder, const char* name, FileInfo& out, bool follow = false);

enum class Open {
  read,               // never waits for the writer of a pipe
  write,              // what exists already
  folder,             // for reading it and for naming what it holds
  unreadable_folder,  // only for naming what it holds
};
int open_file(const std::string& path, Open how);

/// Links are not followed.
enum class OpenIn {
  read,              // as Open::read
  folder,            // as Open::folder
  create,            // a new file, for writing
  create_temporary,  // a new file, for reading and writing
  lock,              // a file to be locked, made where it is missing
};
///   mode   of a new file, less the user's mask
int open_in(int folder, const std::string& name, OpenIn how, unsigned mode = 0);

/// The open folder again, with a place of its own in the list of what it holds.
int reopen_folder(int folder);
/// A second descriptor of what is open, never one of the three standard ones.
int duplicate(int open);
bool close_file(int open);

/// Returns how many bytes were read, 0 at the end, -1 on failure. read() goes on where the last one ended; read_at() and
/// write_at() leave that place as it is.
std::ptrdiff_t read(int open, void* to, std::size_t count);
std::ptrdiff_t read_at(int open, void* to, std::size_t count, std::size_t at);
/// Returns how many bytes were written, possibly fewer than `count`; -1 on failure.
std::ptrdiff_t write(int open, const void* from, std::size_t count);
std::ptrdiff_t write_at(int open, const void* from, std::size_t count, std::size_t at);

/// Sets the time at which the content of a file was written to now, by the clock of its file system.
bool touch_in(int folder, const char* name);

/// Waits until what was written is on the disk.
bool to_disk(int open);
/// Asks the system to begin with that, and does not wait.
void begin_to_disk(int open);

bool set_mode(int open, unsigned mode);
/// Gives owner and group of `like` to what is open, where that may be.
void set_owner(int open, const FileInfo& like);
/// What the user takes away from the modes of new files.
unsigned user_mask();

bool make_folder(const std::string& path);
bool make_folder_in(int folder, const std::string& name, unsigned mode);
bool remove_folder(const std::string& path);
/// The two may be called from a handler of signals. A folder must be empty.
bool remove_in(int folder, const char* name);
bool remove_folder_in(int folder, const char* name);
/// Removes the files of an open folder, not its folders; false where nothing could be removed. May be called
/// from a handler of signals.
bool remove_files_of(int folder);

/// Gives a file another name, in one step. What has the name is replaced.
bool rename_in(int from, const std::string& name, int to, const std::string& new_name);
/// rename_in(), but fails with EEXIST where the name is taken, and with EINVAL or ENOSYS where the file system
/// cannot look and rename in one step.
bool rename_new_in(int from, const std::string& name, int to, const std::string& new_name);
/// Whether the system can exchange two names in one step.
bool can_exchange();
bool exchange_in(int from, const std::string& name, int to, const std::string& other);
/// A second name for a file (a hard link).
bool link_in(int from, const std::string& name, int to, const std::string& new_name);

/// A symbolic link to a folder, only where can_exchange().
bool make_link_in(int folder, const std::string& target, const std::string& name);

/// Locks what is open against other descriptors of it, in this and in other programs, until unlock() or until
/// the descriptor is closed. Never waits: fails with EWOULDBLOCK where another one holds the lock.
bool try_lock(int open);
void unlock(int open);

/// Whether this user may write to, or read, what is behind the path.
bool may_write(const std::string& path);
bool may_read(const std::string& path);

/// The folder in which relative paths begin, without links; empty where it is gone.
std::filesystem::path working_folder();
/// The path from the root on, where links, "." and ".." stay. A relative path stays so where the working folder is gone.
std::filesystem::path absolute(const std::filesystem::path& path);
/// The path from the root on, without links, "." and ".."; empty where there is nothing, and errno tells why.
std::filesystem::path canonical(const std::filesystem::path& path);

/// The text of a path: with '/' between its parts on every system, else as it was made.
inline std::string path_text(const std::filesystem::path& path) {
  std::string out = path.string();
  if constexpr (std::filesystem::path::preferred_separator == '\\')
    for (char& c : out)
      if (c == '\\') c = '/';
  return out;
}

/// Whether the system takes the name for a file, and for that alone. Names that no system takes are not asked.
bool takes_file_name(std::string_view name);

/// The list of what an open folder holds, without "." and "..", in no order.
class FolderReader {
 public:
  struct Entry {
    const char* name = nullptr;          // until the next entry
    std::optional<FileInfo::Kind> kind;  // of the entry itself, where the list tells it
  };
  /// Takes the descriptor over. Where the object is false, there is no list, and the descriptor is still open.
  explicit FolderReader(int folder);
  ~FolderReader();  // closes the descriptor
  FolderReader(const FolderReader&) = delete;
  FolderReader& operator=(const FolderReader&) = delete;
  explicit operator bool() const { return list_ != nullptr; }
  int folder() const { return folder_; }
  bool next(Entry& out);

 private:
  int folder_;
  void* list_ = nullptr;
};

/// Bytes from the system's source of random numbers; false where it gives none.
bool random_bytes(void* to, std::size_t count);

/// A file in memory, or one that no other program finds and that ends with this one.
int memory_file();
/// A descriptor of that file with a place of its own, at the first byte.
int reopen_memory_file(int open);
/// Makes the number `descriptor` stand for that file, at its first byte.
void put_in_place_of(int open, int descriptor);

/// Waits for bytes to read: 1 where there are some (or the end), 0 after that many milliseconds, -1 on failure.
///   milliseconds   -1: no limit
int wait_for_bytes(int open, int milliseconds);
/// Undoes what Open::read does so that a pipe is opened without waiting: reading waits from here on.
void let_reading_wait(int open);

/// From here on a signal that asks the program to end (INT, TERM, HUP; on Windows Ctrl+C, Ctrl+Break and the
/// closing of the console) calls the handler with a number, unless the program's caller has them ignored. On
/// POSIX systems the handler runs in the middle of any thread, so it may only make system calls.
/// Growth of a file beyond a limit is an error of the call that writes, and no signal.
void on_end(void (*handler)(int number));
/// Ends the program as that signal does by itself.
[[noreturn]] void end_by(int number);
/// Waits for another thread to end the program.
[[noreturn]] void wait_for_end();

/// To be called first in main(): the arguments of the program, and the console set to UTF-8.
std::vector<std::string> start_program(int argc, char** argv);
/// The absolute path of the running program; empty where the system does not tell it.
std::string program_path();
/// A path by which the bytes of the running program can be read. Where the system allows it, they are these even
/// after another program has taken the place of its file.
std::string program_bytes();

bool is_terminal(int open);
/// The width of the terminal in columns; 0 where there is none.
unsigned terminal_columns(int open);

/// The user's folder of settings as the system says it, where it is no folder of XDG; else empty.
std::string settings_folder();
std::tm local_time(std::time_t time);

/// Memory in whole pages, of zero bytes. Null where there is none.
///   huge   that large pages are wanted
void* map_memory(std::size_t bytes, bool huge);
void unmap_memory(void* memory, std::size_t bytes);
/// Makes the allocator keep freed memory where it would give it back to the system and fetch it again.
///   largest   blocks up to so many bytes are kept, too
///   kept      bytes that are kept at most
///   ahead     bytes fetched at once; 0: as the allocator likes
void keep_freed_memory(int largest, int kept, int ahead = 0);
/// Whether the process may have so many more threads and bytes of addresses.
bool has_room(std::size_t threads, std::size_t bytes);

/// The variables of this program's environment, each as NAME=VALUE.
std::vector<std::string> environment();
/// Runs a program of the search path to its end; its messages go to standard error. False where it cannot be run.
///   words         its name and its arguments
///   environment   its variables, as environment() has them
///   out           what it wrote to standard output
///   status        its exit status; -1 where it ended in another way
bool run_program(const std::vector<std::string>& words, const std::vector<std::string>& environment,
                 std::string& out, int& status);

/// A shared library, which stays loaded. Null where it cannot be loaded; library_fault() tells why, for
/// library_symbol() too.
void* open_library(const std::string& path);
void* library_symbol(void* library, const char* name);
std::string library_fault();

}  // namespace etak::sys
