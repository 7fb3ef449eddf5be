// SPDX-License-Identifier: Apache-2.0
// etak-demo-scene OUT: writes what `./dev demo` packs. Not installed.
#include <cstdio>
#include <exception>

#include "tests/scene/demo_scene.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: etak-demo-scene OUT\n");
    return 2;
  }
  try {
    etak::demo::write_demo_scene(argv[1], true);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "etak-demo-scene: %s\n", e.what());
    return 1;
  }
}
