// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtTest>

namespace etak::test {

/// A test of windows in the one program that holds all of them: to compile Qt's headers and to link its libraries
/// once for each test would take minutes.
struct GuiTest {
  const char* name;  // first argument of the program: "editor_files"
  int (*run)(int argc, char** argv);
  GuiTest* next = nullptr;

  GuiTest(const char* name_, int (*run_)(int, char**));
};

}  // namespace etak::test

/// Adds the test of class `Type` under `name`, with an application of its own.
#define ETAK_GUI_TEST(Type, name)                                                      \
  static const etak::test::GuiTest registered_##Type(name, [](int argc, char** argv) { \
    QApplication application(argc, argv);                                              \
    application.setAttribute(Qt::AA_Use96Dpi, true);                                   \
    Type test;                                                                         \
    return QTest::qExec(&test, argc, argv);                                            \
  });
