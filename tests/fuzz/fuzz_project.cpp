// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the reader of the editor's projects answers with an Error or with a project that is
// written and read again unchanged, and whose materials come out as a manifest or with an Error.
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/error.h"
#include "core/project/project.h"

using namespace etak;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<char> bytes(data, data + size);
  const std::string file = "folder/a.etak";
  Project project;
  try {
    project = parse_project({bytes.data(), bytes.size()}, file);
  } catch (const Error&) {
    return 0;
  }
  assert(parse_project(format_project(project, file), file) == project);
  for (const ProjectMaterial& material : project.materials) {
    assert(project.find(material.name) == &material);
    assert(single(project, material).materials.size() == 1);
  }
  return 0;
}
