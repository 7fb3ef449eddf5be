// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: a colour space, a source and a display are found in an OpenColorIO config, or there is
// an Error. An input is the config, then the names of a space, a display and a view, each after a NUL.
// OpenColorIO itself is not instrumented; what is looked for is what it throws and etak does not expect.
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/base/error.h"
#include "core/color/ocio.h"

using namespace etak;

namespace {

// A file that is in memory alone, under a name of this process, so that nothing of it stays.
const std::string& config_file(const std::string& text) {
  static const int file = memfd_create("config.ocio", 0);
  static const std::string path = "/proc/self/fd/" + std::to_string(file);
  if (file < 0 || ftruncate(file, 0) != 0 ||
      pwrite(file, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
    std::abort();
  return path;
}

// Throws where a good config is refused as well: all others would then be refused unread.
bool good_config_opens() {
  const std::string& path = config_file(
      "ocio_profile_version: 2\nroles: {aces_interchange: a, default: a}\ndisplays: {d: [!<View> {name: v, colorspace: a}]}\n"
      "colorspaces: [!<ColorSpace> {name: a}]\n");
  return OcioConfig::open(path).space("a").name() == "a" &&
         OcioConfig::open(path).display("d", "v").view() == "v";
}

template <class Attempt>
void attempt(const Attempt& attempt) {
  try {
    attempt();
  } catch (const Error&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::array<std::string, 4> parts;
  std::string rest(reinterpret_cast<const char*>(data), size);
  for (std::string& part : parts) {
    const std::size_t end = std::min(rest.find('\0'), rest.size());
    part = rest.substr(0, end);
    rest.erase(0, std::min(end + 1, rest.size()));
  }
  const std::string &text = parts[0], &space = parts[1], &display = parts[2], &view = parts[3];
  static const bool opens = good_config_opens();
  assert(opens);
  const std::string& path = config_file(text);
  attempt([&] { (void)OcioConfig::open(path).space(space).from_xyz({0.2, 0.3, 0.4}, {0.95, 1, 1.09}); });
  attempt([&] {
    std::array<float, 6> rgb{0, 0.2F, 1, 2, -1, 1e-3F};
    OcioConfig::open(path).source(space).to_linear_srgb(rgb.data(), 2);
  });
  attempt([&] {
    std::array<float, 6> rgb{0, 0.2F, 1, 2, -1, 1e-3F};
    OcioConfig::open(path).display(display, view).apply(rgb.data(), 2);
  });
  attempt([&] {
    for (const OcioDisplayInfo& each : OcioConfig::open(path).displays()) assert(!each.name.empty());
  });
  return 0;
}
