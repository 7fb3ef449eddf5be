// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/input.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "core/base/memory.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/system.h"

namespace etak {
namespace {

constexpr const char* what_is_read = "a regular file, a pipe, or - for standard input";

// N of "/dev/fd/N" and its other names; nothing for other paths.
std::optional<int> descriptor_of(std::string_view path) {
  if (path == "-" || path == "/dev/stdin") return sys::standard_input;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    const std::string_view digits = path.substr(folder.size());
    int number = 0;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (fault == std::errc() && end == digits.data() + digits.size() && number >= 0) return number;
  }
  return std::nullopt;
}

// A pipe whose bytes are kept.
class Pipe {
 public:
  explicit Pipe(std::string path) : path_(std::move(path)) {}

  // A new descriptor of all bytes of the pipe; Error where there are more than `most`.
  OpenedInput open(std::size_t most, double timeout) {
    const std::lock_guard guard(lock_);
    if (!fill(most, timeout)) fail_endless(most);
    return reopened();
  }

  std::string head(std::size_t count, double timeout) {
    const std::lock_guard guard(lock_);
    (void)fill(count - 1, timeout);
    std::string out(std::min(count, size_), '\0');
    if (read_all_at(memory_, out, 0) < out.size())
      throw Error::at(path_, "cannot be read: " + reason_of(errno));
    return out;
  }

 private:
  [[noreturn]] void fail_endless(std::size_t most) const {
    throw Error::at(path_, "does not end", "at most " + mebibytes(most));
  }

  // Reads until the end or until more than `wanted` bytes are there; true at the end.
  bool fill(std::size_t wanted, double timeout) {
    if (memory_ < 0) start(timeout);
    std::string buffer(std::size_t{1} << 16, '\0');
    while (!ended_ && size_ <= wanted) {
      const std::ptrdiff_t got = sys::read(source_.get(), buffer.data(), buffer.size());
      if (got < 0 && errno == EAGAIN) {  // another program has made this end non-blocking
        (void)sys::wait_for_bytes(source_.get(), -1);
        continue;
      }
      if (got < 0) throw Error::at(path_, "cannot be read: " + reason_of(errno));
      if (got == 0) {
        finish();
        break;
      }
      if (!write_all(memory_, {buffer.data(), static_cast<std::size_t>(got)}))
        throw Error::at(path_, "cannot be kept in memory: " + reason_of(errno));
      size_ += static_cast<std::size_t>(got);
    }
    return ended_ && size_ <= wanted;
  }

  void start(double timeout) {
    descriptor_ = descriptor_of(typed_input(path_)).value_or(-1);
    if (descriptor_ == sys::standard_input) {
      // Taken as it is: it may be a socket or a terminal, or a file that was read in part already.
      source_ = Descriptor(sys::duplicate(sys::standard_input));
    } else {
      source_ = Descriptor(sys::open_file(typed_input(path_), sys::Open::read));
      if (source_) wait_for_first_byte(timeout);
    }
    if (!source_) throw Error::at(path_, "cannot be opened: " + reason_of(errno));
    memory_ = sys::memory_file();
    if (memory_ < 0) throw Error::at(path_, "cannot be kept in memory: " + reason_of(errno));
  }

  void wait_for_first_byte(double timeout) {
    using Clock = std::chrono::steady_clock;
    const auto end =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeout));
    for (;;) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
      const int found = sys::wait_for_bytes(source_.get(), static_cast<int>(std::max<std::int64_t>(0, left)));
      if (found > 0) break;
      if (found < 0 && errno != EINTR) throw Error::at(path_, "cannot be read: " + reason_of(errno));
      if (Clock::now() < end) continue;
      // A writer that comes later has to wait for the next reader. Were this end still open, the writer would
      // open the pipe and leave again at once, and the next reader would wait for a writer that has gone.
      source_ = Descriptor();
      throw Error::at(path_, "nothing came from this pipe in " + number(timeout, 6) + " s",
                      "a program that writes to it, or more time by " + setting("input-timeout"));
    }
    // For the bytes behind the first one the reader waits without limit.
    sys::let_reading_wait(source_.get());
  }

  void finish() {
    ended_ = true;
    source_ = Descriptor();
    if (descriptor_ < 0) return;
    // Whoever opens this number now finds the bytes again.
    sys::put_in_place_of(memory_, descriptor_);
  }

  OpenedInput reopened() const {
    OpenedInput out{Descriptor(sys::reopen_memory_file(memory_)), size_, {}};
    if (!out.file) throw Error::at(path_, "cannot be opened: " + reason_of(errno));
    return out;
  }

  const std::string path_;
  std::mutex lock_;
  Descriptor source_;
  int memory_ = -1;      // open until the program ends
  int descriptor_ = -1;  // that the user named; -1: a named pipe
  std::size_t size_ = 0;
  bool ended_ = false;
};

// The inputs that the user named. The pipes of a process exist once, and so does this list.
//   descriptors   by "<stdin>" or "<fd N>"
//   named         named pipes, by their whole path, however it is spelled
struct Accepted {
  std::atomic<bool> any{false};  // asked for every file that is opened, so without the lock
  std::mutex lock;
  std::map<std::string, std::unique_ptr<Pipe>> descriptors;
  std::map<std::string, std::unique_ptr<Pipe>> named;
  std::set<std::string> typed;
  double timeout = 60;
};

Accepted& accepted() {
  static Accepted all;
  return all;
}

bool has_name_of_descriptor(std::string_view path) {
  return path == stdin_name || (path.starts_with("<fd ") && path.ends_with('>'));
}

// Without links, "." and ".."; empty where there is nothing.
std::string whole_path(const std::string& path) {
  return sys::path_text(sys::canonical(path));
}

// The pipe behind an accepted path; null where there is none.
Pipe* accepted_pipe(const std::string& path) {
  Accepted& all = accepted();
  if (!all.any) return nullptr;
  const std::lock_guard guard(all.lock);
  if (has_name_of_descriptor(path)) {
    const auto found = all.descriptors.find(path);
    return found == all.descriptors.end() ? nullptr : found->second.get();
  }
  if (all.named.empty()) return nullptr;
  const auto found = all.named.find(whole_path(path));
  return found == all.named.end() ? nullptr : found->second.get();
}

[[noreturn]] void refuse(const std::string& path, sys::FileInfo::Kind kind) {
  using Kind = sys::FileInfo::Kind;
  if (kind == Kind::folder) throw Error::at(path, "is a folder", "a file");
  if (kind == Kind::pipe)
    throw Error::at(path, "is a pipe, and pipes are read only where they are named on the command line",
                    "a regular file");
  throw Error::at(path, kind == Kind::socket ? "is a socket" : "is a device", what_is_read);
}

// Git LFS checks a pointer out where a large file has not been fetched: a text of less than 1024 bytes that
// begins as below (the specification of Git LFS, version 1).
void refuse_git_lfs_pointer(const std::string& path, const OpenedInput& opened) {
  constexpr std::string_view first_line = "version https://git-lfs.github.com/spec/v1\n";
  if (opened.size < first_line.size() || opened.size >= 1024) return;
  std::array<char, first_line.size()> head{};
  if (sys::read_at(opened.file.get(), head.data(), head.size(), 0) ==
          static_cast<std::ptrdiff_t>(head.size()) &&
      std::string_view(head.data(), head.size()) == first_line)
    throw Error::at(path, git_lfs_pointer, "the file, which `git lfs pull` fetches");
}

OpenedInput open_regular(const std::string& path, SeenAsFile seen = SeenAsFile::no) {
  OpenedInput out;
  sys::FileInfo info;
  if (seen == SeenAsFile::no && sys::file_info(path, info) && info.kind != sys::FileInfo::Kind::file)
    refuse(path, info.kind);
  // This call does not hang if the file has become a pipe.
  out.file = Descriptor(sys::open_file(path, sys::Open::read));
  if (!out.file) throw Error::at(path, "cannot be opened: " + reason_of(errno));
  if (!sys::file_info(out.file.get(), info)) throw Error::at(path, "cannot be read: " + reason_of(errno));
  if (info.kind != sys::FileInfo::Kind::file) refuse(path, info.kind);
  out.size = static_cast<std::size_t>(info.size);
  out.info = info;
  refuse_git_lfs_pointer(path, out);
  return out;
}

double timeout_of_inputs() {
  Accepted& all = accepted();
  const std::lock_guard guard(all.lock);
  return all.timeout;
}

}  // namespace

void forget_inputs() {
  Accepted& all = accepted();
  const std::lock_guard guard(all.lock);
  all.any = false;
  all.descriptors.clear();
  all.named.clear();
  all.typed.clear();
}

std::vector<std::string> accepted_inputs() {
  Accepted& all = accepted();
  const std::lock_guard guard(all.lock);
  return {all.typed.begin(), all.typed.end()};
}

std::string accept_input(const std::string& typed) {
  Accepted& all = accepted();
  {
    const std::lock_guard guard(all.lock);
    all.typed.insert(typed);
  }
  if (const auto number = descriptor_of(typed)) {
    const std::string path =
        *number == sys::standard_input ? std::string(stdin_name) : "<fd " + std::to_string(*number) + '>';
    const std::lock_guard guard(all.lock);
    const auto [place, fresh] = all.descriptors.try_emplace(path);
    all.any = true;
    if (fresh)
      place->second = std::make_unique<Pipe>(path);
    else if (path == stdin_name)
      throw Error::at(typed, "standard input is asked for twice", "once");
    return path;
  }
  sys::FileInfo info;
  if (sys::file_info(typed, info) && info.kind == sys::FileInfo::Kind::pipe) {
    const std::lock_guard guard(all.lock);
    const auto [place, fresh] = all.named.try_emplace(whole_path(typed));
    all.any = true;
    if (fresh) place->second = std::make_unique<Pipe>(typed);
  }
  return sys::path_text(typed);
}

std::string skipped_remark(const std::vector<std::string>& skipped) {
  if (skipped.empty()) return {};
  std::string out = printable(skipped.front(), 200);
  if (skipped.size() > 1) out += " and " + std::to_string(skipped.size() - 1) + " more";
  return out + ": skipped, because pipes, sockets and devices are read only where they are named";
}

std::string typed_input(const std::string& path) {
  if (path == stdin_name) return "-";
  if (!has_name_of_descriptor(path)) return path;
  return "/dev/fd/" + path.substr(4, path.size() - 5);
}

bool is_pipe_input(const std::string& path) {
  return accepted_pipe(path) != nullptr;
}

void set_input_timeout(double seconds) {
  Accepted& all = accepted();
  const std::lock_guard guard(all.lock);
  all.timeout = seconds;
}

OpenedInput open_input(const std::string& path, std::size_t most, SeenAsFile seen) {
  if (Pipe* const pipe = accepted_pipe(path)) return pipe->open(most, timeout_of_inputs());
  OpenedInput out = open_regular(path, seen);
  if (out.size > most) throw Error::at(path, "holds " + mebibytes(out.size), "at most " + mebibytes(most));
  return out;
}

bool take_bytes(const std::string& path, sys::FileInfo& info, SeenAsFile seen,
                const std::function<void(std::string_view)>& take) {
  try {
    const OpenedInput input = open_input(path, SIZE_MAX, seen);
    info = input.info;
    // Not filled with zeros, which would take longer than the reading of a small file. One byte more than there is, so
    // that one call sees the end of a small file.
    constexpr std::size_t at_once = std::size_t{1} << 18;
    const std::size_t wanted = input.size > 0 && input.size < at_once ? input.size + 1 : at_once;
    const auto buffer = std::make_unique_for_overwrite<char[]>(wanted);
    for (std::size_t all = 0;;) {
      const std::ptrdiff_t got = sys::read(input.file.get(), buffer.get(), wanted);
      if (got < 0) return false;
      const auto count = static_cast<std::size_t>(got);
      take({buffer.get(), count});
      all += count;
      if (count == 0 || (count < wanted && input.size > 0 && all >= input.size)) return true;
    }
  } catch (const Error&) {
    return false;
  }
}

std::string read_head(const std::string& path, std::size_t count) {
  if (Pipe* const pipe = accepted_pipe(path)) return pipe->head(count, timeout_of_inputs());
  const OpenedInput opened = open_regular(path);
  std::string out(count, '\0');
  std::size_t at = 0;
  while (at < count) {
    const std::ptrdiff_t got = sys::read(opened.file.get(), out.data() + at, count - at);
    if (got < 0) throw Error::at(path, "cannot be read: " + reason_of(errno));
    if (got == 0) break;
    at += static_cast<std::size_t>(got);
  }
  out.resize(at);
  return out;
}

}  // namespace etak
