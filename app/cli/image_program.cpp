// SPDX-License-Identifier: Apache-2.0
#include "app/cli/image_program.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstring>

#include "app/cli/custom_space.h"
#include "core/base/error.h"
#include "core/base/files/input.h"
#include "core/base/signals.h"

namespace etak::cli {
namespace {

char** program_arguments = nullptr;

// Folder of the running program, from the root and with '/' at its end; empty where the system does not tell.
// Never the working folder in its place: what lies there under a companion's name may be anybody's.
std::string program_folder() {
  std::array<char, PATH_MAX> path{};
  const ssize_t length = ::readlink("/proc/self/exe", path.data(), path.size());
  if (length <= 0 || path[0] != '/' || static_cast<std::size_t>(length) == path.size()) return {};
  const std::string whole(path.data(), static_cast<std::size_t>(length));
  return whole.substr(0, whole.rfind('/') + 1);
}

}  // namespace

void set_program_arguments(char** argv) {
  program_arguments = argv;
}

void become_image_program(const std::string& place, const std::string& found, const std::string& expected) {
  become_companion("etak-image", place, found, expected);
}

void become_companion(const std::string& companion, const std::string& place, const std::string& found,
                      const std::string& expected) {
  const std::string here = program_folder();
  if (here.empty())
    throw Error::at(place, companion + " is needed, and the folder of etak, where it lies, cannot be told",
                    "a readable /proc/self/exe");
  // Beside etak in a build tree, in libexec where installed.
  const std::array candidates{here + companion, here + (ETAK_LIBEXEC_FROM_BIN "/") + companion};
  for (const std::string& candidate : candidates) {
    if (::access(candidate.c_str(), X_OK) != 0) continue;
    hand_over_inputs();
    remove_temporaries();  // no destructor of this program will
    ::execv(candidate.c_str(), program_arguments);
    throw Error::at(candidate, std::string("cannot be started: ") + std::strerror(errno));
  }
  throw Error::at(place, found + " (looked for " + candidates[0] + " and " + candidates[1] + ")", expected);
}

}  // namespace etak::cli
