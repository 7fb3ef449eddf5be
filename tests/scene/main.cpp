// SPDX-License-Identifier: Apache-2.0
// etak-demo-scene OUT MISTAKES: writes what `./dev demo` packs to OUT, and what its validator finds fault with to
// MISTAKES. Not installed.
#include <cstdio>
#include <exception>

#include "tests/scene/demo_scene.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: etak-demo-scene OUT MISTAKES\n");
    return 2;
  }
  try {
    etak::demo::write_demo_scene(argv[1], true);
    etak::demo::write_demo_mistakes(argv[2], true);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "etak-demo-scene: %s\n", e.what());
    return 1;
  }
}
