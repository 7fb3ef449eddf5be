// SPDX-License-Identifier: Apache-2.0
#include "core/base/signals.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <functional>
#include <thread>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/output_folder.h"
#include "core/base/files/temporary.h"
#include "tests/support.h"

namespace etak {
namespace {

namespace fs = std::filesystem;

// Runs `act` in a process of its own, which handles signals; its status as waitpid() gives it.
//   at_first   what signals do before: nohup and a script's "&" would let the process ignore some
int status_of_child(const std::function<void()>& act, void (*at_first)(int) = SIG_DFL) {
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, at_first);
    end_by_signals();
    try {
      act();
    } catch (const Error&) {
      ::_exit(2);
    }
    ::_exit(0);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  return status;
}

bool died_of(int status, int number) {
  return WIFSIGNALED(status) && WTERMSIG(status) == number;
}

}  // namespace

TEST_CASE("a thread that holds signals twice ends when it lets the first of them go") {
  const int status = status_of_child([] {
    ::alarm(10);  // instead of waiting for ever
    const SignalsHeld outer;
    ::raise(SIGTERM);
    const SignalsHeld inner;
  });
  CHECK(died_of(status, SIGTERM));
}

TEST_CASE("a signal that ends the program takes what is half-made with it") {
  const test::TempFolder folder;
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const int status = status_of_child([&] {
      const Descriptor open(::open(folder.path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
      const Temporary file(open.get(), "a", Temporary::Kind::file);
      OutputFolder set(folder.file("set"), Replace::nothing);
      for (int i = 0; i < 300; ++i) set.write("a file of the set, number " + std::to_string(i), "1");
      ::raise(number);
      ::_exit(3);
    });
    CHECK(died_of(status, number));
    CHECK(fs::is_empty(folder.path()));
  }
}

TEST_CASE("a signal waits for what holds it, in any thread, and nothing new begins then") {
  const test::TempFolder folder;
  const int status = status_of_child([&] {
    std::thread other;
    {
      const SignalsHeld held;
      ::raise(SIGTERM);
      other = std::thread([&] {
        write_file(folder.file("too late"), "x", false);
        ::_exit(3);
      });
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      test::spit(folder.file("in time"), "x");
    }
    ::_exit(4);
  });
  CHECK(died_of(status, SIGTERM));
  CHECK(fs::exists(folder.file("in time")));
  CHECK(!fs::exists(folder.file("too late")));
}

TEST_CASE(
    "a thread that lets a signal go while another holds it does not end the program as if all was well") {
  const test::TempFolder folder;
  const int status = status_of_child([&] {
    std::atomic<bool> holds{false}, raised{false};
    std::thread other([&] {
      const SignalsHeld held;
      for (holds = true; !raised;) std::this_thread::yield();
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      test::spit(folder.file("in time"), "x");
    });
    while (!holds) std::this_thread::yield();
    {
      const SignalsHeld held;
      ::raise(SIGTERM);
      raised = true;
    }
    ::_exit(5);
  });
  CHECK(died_of(status, SIGTERM));
  CHECK(fs::exists(folder.file("in time")));
}

TEST_CASE("threads that go on writing into a folder do not keep a signal from removing it") {
  const test::TempFolder folder;
  const int status = status_of_child([&] {
    OutputFolder set(folder.file("set"), Replace::nothing);
    std::vector<std::thread> writers;
    for (int t = 0; t < 3; ++t)
      writers.emplace_back([&, t] {
        for (int i = 0;; ++i) set.write(std::to_string(t) + '-' + std::to_string(i), "x");
      });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ::kill(::getpid(), SIGINT);
    for (std::thread& writer : writers) writer.join();
  });
  CHECK(died_of(status, SIGINT));
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("a signal that was ignored from the start stays so") {
  const int status = status_of_child([] { ::raise(SIGHUP); }, SIG_IGN);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
}

TEST_CASE("a file beyond the limit of its size is an error") {
  const test::TempFolder folder;
  const int status = status_of_child([&] {
    const rlimit small{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &small);
    write_file(folder.file("a"), std::string(100000, 'x'), false);
  });
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 2);
  CHECK(fs::is_empty(folder.path()));
}

}  // namespace etak
