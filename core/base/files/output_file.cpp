// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/output_file.h"

#include <cerrno>

#include "core/base/error.h"

namespace etak {

void OutputFile::fail(const char* what) const {
  const int why = errno;
  throw Error::at(path_, std::string(what) + ": " + reason_of(why));
}

OutputFile::OutputFile(const std::string& path, std::string_view bytes, bool overwrite, unsigned most_mode)
    : path_(path), overwrite_(overwrite), target_(file_target(path, overwrite)) {
  if (target_.is_device) {
    for_device_ = bytes;
    return;
  }
  folder_ = open_folder_of(target_);
  if (!folder_) fail("cannot be written");
  temporary_ = Temporary(folder_.get(), target_.name, Temporary::Kind::file);
  if (!temporary_) fail("cannot be written");
  const int file = temporary_.open().get();
  // The set-user and set-group bits of a program are not for the bytes that take its place.
  const unsigned mode = (target_.exists ? target_.mode : mode_of_new_file()) & most_mode;
  if (!write_all(file, bytes) || !sys::set_mode(file, mode) || !sys::to_disk(file)) fail("cannot be written");
}

void OutputFile::prepare() {
  if (!target_.is_device) {
    sys::FileInfo info;
    if (sys::file_info_in(folder_.get(), target_.name.c_str(), info)) refuse_input(info, path_);
    return;
  }
  Descriptor device(sys::open_file(path_, sys::Open::write));
  if (!device || !write_all(device.get(), for_device_) || !device.close()) fail("cannot be written");
}

void OutputFile::place() {
  if (target_.is_device) return;
  const auto rename = overwrite_ ? sys::rename_in : rename_where_free;
  const bool placed = rename(folder_.get(), temporary_.name(), folder_.get(), target_.name);
  if (!placed && errno == EEXIST) throw exists_already(path_);
  if (!placed || !temporary_.keep()) fail("cannot be put in place");
}

void OutputFile::flush() {
  if (!target_.is_device && !names_to_disk(folder_.get()))
    fail("is in place, but its folder cannot be flushed");
}

}  // namespace etak
