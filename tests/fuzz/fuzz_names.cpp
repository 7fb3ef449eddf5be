// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: a picture's name is read, or is not known; and a list of names (--files-from) gives the same names
// at once and one by one. The first byte picks the reader.
#include <sys/mman.h>
#include <unistd.h>

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "app/cli/inputs/inputs.h"
#include "core/base/error.h"
#include "core/names/names.h"

using namespace etak;

namespace {

void read_name(std::string_view name) {
  static const OwnName own[] = {{"shine", FileRole::gloss, ""}, {"orm2", FileRole::other, "orm"}};
  static const NameReader reader(own), plain({});
  for (const NameReader* each : {&reader, &plain})
    if (const auto parsed = each->read(name)) {
      assert(parsed->set.size() <= name.size());
      for (const char letter : parsed->channels) (void)channel_word(letter);
    }
  const std::size_t cut = name.find('/');
  if (cut == name.npos) return;
  if (const auto parsed = plain.read_in_folder(name.substr(0, cut), name.substr(cut + 1)))
    assert(parsed->set.size() <= name.size() && !parsed->sure);
}

// The list lies in a file that is in memory alone.
void read_list(std::string_view text) {
  static const int file = memfd_create("list", 0);
  static const std::string path = "/proc/self/fd/" + std::to_string(file);
  if (file < 0 || ftruncate(file, 0) != 0 ||
      pwrite(file, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
    std::abort();
  cli::ListedNames list(path), again(path);
  const std::vector<std::string> all = list.take();
  assert(all.size() <= list.count());
  for (const std::string& name : all) {
    assert(!name.empty() && text.find(name) != text.npos);
    assert(again.take(1) == std::vector<std::string>{name});
  }
  assert(again.take(1).empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::vector<char> bytes(data + 1, data + size);
  const std::string_view text(bytes.data(), bytes.size());
  try {
    (data[0] & 1) == 0 ? read_name(text) : read_list(text);
  } catch (const Error&) {
  }
  return 0;
}
