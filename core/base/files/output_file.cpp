// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/output_file.h"

#include <cerrno>

#include "core/base/error.h"

namespace etak {

void OutputFile::fail(const char* what) const {
  const int why = errno;
  throw Error::at(path_, std::string(what) + ": " + reason_of(why));
}

OutputFile::OutputFile(const std::string& path, std::string_view bytes, bool overwrite)
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
  const unsigned mode = target_.exists ? target_.mode : mode_of_new_file();
  if (!write_all(file, bytes) || !sys::set_mode(file, mode) || !sys::to_disk(file)) fail("cannot be written");
}

void OutputFile::prepare() {
  if (!target_.is_device) return;
  Descriptor device(sys::open_file(path_, sys::Open::write));
  if (!device || !write_all(device.get(), for_device_) || !device.close()) fail("cannot be written");
}

void OutputFile::place() {
  if (target_.is_device) return;
  const auto rename = [&](auto call) {
    return call(folder_.get(), temporary_.name(), folder_.get(), target_.name);
  };
  if (overwrite_) {
    if (!rename(sys::rename_in)) fail("cannot be put in place");
  } else if (!rename(sys::rename_new_in)) {
    if (errno == EEXIST) throw exists_already(path_);
    // Some network file systems cannot check and rename in one step.
    if (errno != EINVAL && errno != ENOSYS) fail("cannot be put in place");
    (void)file_target(path_, false);
    if (!rename(sys::rename_in)) fail("cannot be put in place");
  }
  if (!temporary_.keep()) fail("cannot be put in place");
}

}  // namespace etak
