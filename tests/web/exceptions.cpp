// SPDX-License-Identifier: Apache-2.0
// What app/web/exceptions.cpp must do: told() runs every way of throwing and catching, and returns what each handler got.
#include <charconv>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct A {
  virtual ~A() = default;
  int a = 1;
};
struct B {
  virtual ~B() = default;
  int b = 2;
};
struct C : A, B {
  int c = 3;
};

std::string text;
int alive = 0;

struct Counted {
  Counted() { ++alive; }
  Counted(const Counted&) { ++alive; }
  ~Counted() { --alive; }
};

void say(const std::string& line) {
  text += line + '\n';
}

void kept_and_thrown_again() {
  std::exception_ptr kept;
  try {
    throw Failure("one");
  } catch (...) {
    kept = std::current_exception();
  }
  for (int i = 0; i < 2; ++i) try {
      std::rethrow_exception(kept);
    } catch (const Failure& failure) {
      say(std::string("again ") + failure.what());
    }
}

void bases_and_rethrow() {
  try {
    try {
      throw C();
    } catch (const B& b) {
      say("b " + std::to_string(b.b));
      throw;
    }
  } catch (const C& c) {
    say("c " + std::to_string(c.c) + " uncaught " + std::to_string(std::uncaught_exceptions()));
  }
}

void one_within_another() {
  try {
    try {
      throw 1;
    } catch (int) {
      try {
        throw Failure("inner");
      } catch (const std::exception& inner) {
        say(inner.what());
      }
      throw;
    }
  } catch (int number) {
    say("int " + std::to_string(number));
  }
  try {
    throw "text";
  } catch (const char* thrown) {
    say(thrown);
  }
}

void destroyed_once() {
  for (int i = 0; i < 1000; ++i) try {
      const Counted here;
      throw Counted();
    } catch (const Counted&) {
      if (alive != 1) say("alive within: " + std::to_string(alive));
    }
  say("alive " + std::to_string(alive));
}

struct AtEnd {
  ~AtEnd() {
    try {
      throw Failure("in a destructor");
    } catch (const Failure& failure) {
      say(failure.what() + std::string(" uncaught ") + std::to_string(std::uncaught_exceptions()));
    }
  }
};

void while_another_is_thrown() {
  try {
    const AtEnd end;
    throw 2;
  } catch (int number) {
    say("int " + std::to_string(number));
  }
}

void no_memory() {
  std::vector<void*> blocks;
  try {
    for (int i = 0; i < 3; ++i) blocks.push_back(::operator new(0x7f000000));
  } catch (const std::bad_alloc&) {
    say("no memory");
  }
  for (void* const block : blocks) ::operator delete(block);
  try {
    (void)std::vector<int>().at(3);
  } catch (const std::out_of_range&) {
    say("out of range");
  }
}

}  // namespace

extern "C" [[clang::export_name("told")]] const char* told() {
  text.clear();
  kept_and_thrown_again();
  bases_and_rethrow();
  one_within_another();
  destroyed_once();
  while_another_is_thrown();
  no_memory();
  long caught = 0;
  for (int i = 0; i < 100000; ++i) try {
      throw Failure("x");
    } catch (const Failure&) {
      ++caught;
    }
  say(std::to_string(caught));
  return text.c_str();
}
