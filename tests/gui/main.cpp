// SPDX-License-Identifier: Apache-2.0
// etak-gui-tests NAME [OPTIONS OF QTEST]: runs one test of windows.
#include <cstdio>
#include <string_view>

#include "tests/gui/gui_test.h"

namespace etak::test {
namespace {

GuiTest*& first_test() {
  static GuiTest* first = nullptr;
  return first;
}

}  // namespace

GuiTest::GuiTest(const char* name_, int (*run_)(int, char**)) : name(name_), run(run_), next(first_test()) {
  first_test() = this;
}

}  // namespace etak::test

int main(int argc, char** argv) {
  for (const auto* test = etak::test::first_test(); test != nullptr; test = test->next)
    if (argc > 1 && std::string_view(argv[1]) == test->name) {
      argv[1] = argv[0];
      return test->run(argc - 1, argv + 1);
    }
  std::fprintf(stderr, "%s: no test is called %s\n", argv[0], argc > 1 ? argv[1] : "nothing");
  return 2;
}
