// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/steady_file.h"

#include <algorithm>
#include <cerrno>

#include "core/base/error.h"
#include "core/base/memory.h"

namespace etak {
namespace {

constexpr std::size_t window_bytes = std::size_t{256} << 10;

std::string bytes(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " byte" : " bytes");
}

FileStamp stamp(const sys::FileInfo& info) {
  return {info.device, info.number, info.size, info.written.seconds, info.written.nanoseconds};
}

}  // namespace

FileStamp stamp_of(const std::string& path) {
  sys::FileInfo info;
  if (is_pipe_input(path) || !sys::file_info(path, info)) return {};
  return stamp(info);
}

SteadyFile::SteadyFile(const std::string& path, std::size_t most)
    : path_(path), input_(open_input(path, most)) {
  sys::FileInfo info;
  if (!sys::file_info(input_.file.get(), info)) throw Error::at(path, "cannot be read: " + reason_of(errno));
  stamp_ = stamp(info);
}

std::size_t SteadyFile::read_what_is_there(std::size_t at, char* to, std::size_t count) const noexcept {
  return read_all_at(input_.file.get(), {to, count}, at);
}

void SteadyFile::read(std::size_t at, char* to, std::size_t count) const {
  errno = 0;
  if (const std::size_t there = read_what_is_there(at, to, count); there < count) {
    const int why = errno;
    check_unchanged();
    throw Error::at(path_, why != 0 ? "cannot be read: " + reason_of(why)
                                    : "ends at byte " + std::to_string(at + there) + " of " + bytes(size()));
  }
}

std::string_view SteadyFile::view(std::size_t at, std::size_t count) {
  if (at < window_at_ || at + count > window_at_ + window_.size()) {
    const std::size_t wanted = std::min(std::max(count, window_bytes), size() - std::min(at, size()));
    window_.resize(wanted);
    window_at_ = at;
    read(at, window_.data(), wanted);
  }
  return std::string_view(window_).substr(at - window_at_, count);
}

std::string SteadyFile::all() const {
  std::string out = with_memory_for(
      path_, [&] { return "its " + mebibytes(size()); }, [&] { return std::string(size(), '\0'); });
  read(0, out.data(), out.size());
  check_unchanged();
  return out;
}

void SteadyFile::check_unchanged() const {
  sys::FileInfo now;
  if (!sys::file_info(input_.file.get(), now)) throw Error::at(path_, "cannot be read: " + reason_of(errno));
  const auto size_now = static_cast<std::size_t>(now.size);
  if (size_now != size())
    throw Error::at(path_, "changed while it was read, found " + bytes(size_now), bytes(size()));
  if (stamp(now) != stamp_) throw Error::at(path_, "changed while it was read", "a file that stays as it is");
  // Bytes that came from a pipe have no name of their own.
  if (is_pipe_input(path_)) return;
  if (const FileStamp named = stamp_of(path_); named.device != stamp_.device || named.inode != stamp_.inode)
    throw Error::at(path_, "was replaced while it was read", "a file that stays as it is");
}

}  // namespace etak
