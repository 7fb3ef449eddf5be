// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <typeinfo>

// C++ exceptions for WebAssembly. Debian's libc++abi for it has the information on types (can_catch), but is built
// without exceptions: neither throw nor catch is there. The functions below have the names and the meaning of the
// Itanium C++ ABI for exceptions, level II, and clang's landing pads for WebAssembly call them. One thread only.
// A destructor returns its object there.

#if __clang_major__ > 19
// The tag of what is thrown: clang 19 defines it in every object, clang 22 leaves it to the library for unwinding.
__asm__(".globl __cpp_exception\n.tagtype __cpp_exception i32\n__cpp_exception:\n");
#endif

namespace __cxxabiv1 {
// The information on a type, in the order of libc++abi's members. Its fifth function tells whether a handler of this
// type takes an object of the type `thrown`, and moves `adjusted` to that base of it.
class __shim_type_info : public std::type_info {
 public:
  ~__shim_type_info() override;
  virtual void noop1() const;
  virtual void noop2() const;
  virtual bool can_catch(const __shim_type_info* thrown, void*& adjusted) const = 0;
};
}  // namespace __cxxabiv1

namespace {

// Stands before the object that is thrown.
struct alignas(16) Exception {
  const std::type_info* type;
  void* (*destroy)(void*);
  Exception* primary;   // of one that std::rethrow_exception() has thrown: what it stands for
  Exception* previous;  // caught before this one
  void* adjusted;       // what the handler gets
  int references;       // of std::exception_ptr and of the throw itself
  int handlers;         // negative: rethrown
};

// A landing pad fills it before it asks for the handler, and reads the selector.
struct LandingPad {
  std::uintptr_t index;
  const std::uint8_t* table;
  std::uintptr_t selector;
};

// Answers of a personality function.
enum Unwind : int { handler_found = 6, continue_unwind = 8 };

Exception* caught = nullptr;
unsigned uncaught = 0;

void* object_of(Exception* exception) {
  return exception + 1;
}
Exception* of_object(void* object) {
  return static_cast<Exception*>(object) - 1;
}
Exception* primary_of(Exception* exception) {
  return exception->primary != nullptr ? exception->primary : exception;
}

// Numbers of seven bits a byte, the lowest first (LEB128).
std::uintptr_t unsigned_number(const std::uint8_t*& at) {
  std::uintptr_t out = 0;
  for (unsigned shift = 0;; shift += 7) {
    const std::uint8_t byte = *at++;
    out |= static_cast<std::uintptr_t>(byte & 0x7f) << shift;
    if ((byte & 0x80) == 0) return out;
  }
}

std::intptr_t signed_number(const std::uint8_t*& at) {
  std::uintptr_t out = 0;
  unsigned shift = 0;
  std::uint8_t byte = 0;
  do {
    byte = *at++;
    out |= static_cast<std::uintptr_t>(byte & 0x7f) << shift;
    shift += 7;
  } while ((byte & 0x80) != 0);
  if ((byte & 0x40) != 0 && shift < 8 * sizeof out) out |= ~std::uintptr_t{0} << shift;
  return static_cast<std::intptr_t>(out);
}

[[noreturn]] void throw_again(Exception* exception) {
  ++uncaught;
  __builtin_wasm_throw(0, exception);
}

Exception* fresh(std::size_t size) {
  void* const memory = std::calloc(1, sizeof(Exception) + size);
  if (memory == nullptr) std::terminate();
  return static_cast<Exception*>(memory);
}

// The table of a function: for each landing pad its first action, then the actions, each with the number of a type and
// the way to the next one, then the types, numbered backwards. Null where the pad has no handlers.
struct Table {
  const std::uint8_t* action = nullptr;
  const std::uint8_t* types = nullptr;
};

Table table_of(const LandingPad& pad) {
  constexpr std::uint8_t none = 0xff;
  const std::uint8_t* at = pad.table;
  Table out;
  if (*at++ != none) unsigned_number(at);
  if (*at++ != none) {
    const std::uintptr_t offset = unsigned_number(at);
    out.types = at + offset;
  }
  ++at;  // how the numbers below are written
  const std::uintptr_t length = unsigned_number(at);
  const std::uint8_t* const actions = at + length;
  std::uintptr_t first = 0;
  for (std::uintptr_t i = 0; i <= pad.index && at < actions; ++i) {
    unsigned_number(at);
    first = unsigned_number(at);
  }
  if (first != 0) out.action = actions + first - 1;
  return out;
}

}  // namespace

extern "C" {

LandingPad __wasm_lpad_context;

int _Unwind_CallPersonality(void* thrown) {
  auto* const exception = static_cast<Exception*>(thrown);
  Exception* const whole = primary_of(exception);
  LandingPad& pad = __wasm_lpad_context;
  pad.selector = 0;
  const Table table = table_of(pad);
  for (const std::uint8_t* step = table.action; step != nullptr;) {
    const std::intptr_t type = signed_number(step);
    if (type < 0) std::terminate();  // a list of types behind a function, which went with C++17
    if (type > 0) {
      const __cxxabiv1::__shim_type_info* handler = nullptr;
      std::memcpy(&handler, table.types - type * static_cast<std::intptr_t>(sizeof handler), sizeof handler);
      void* adjusted = object_of(whole);
      if (handler == nullptr ||
          handler->can_catch(static_cast<const __cxxabiv1::__shim_type_info*>(whole->type), adjusted)) {
        exception->adjusted = adjusted;
        pad.selector = static_cast<std::uintptr_t>(type);
        return handler_found;
      }
    }
    const std::uint8_t* const from = step;
    const std::intptr_t next = signed_number(step);
    step = next == 0 ? nullptr : from + next;
  }
  return continue_unwind;
}

void* __cxa_allocate_exception(std::size_t size) noexcept {
  return object_of(fresh(size));
}

void __cxa_free_exception(void* object) noexcept {
  std::free(of_object(object));
}

void __cxa_increment_exception_refcount(void* object) noexcept {
  if (object != nullptr) ++of_object(object)->references;
}

void __cxa_decrement_exception_refcount(void* object) noexcept {
  if (object == nullptr || --of_object(object)->references != 0) return;
  Exception* const exception = of_object(object);
  if (exception->destroy != nullptr) exception->destroy(object);
  std::free(exception);
}

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
  Exception* const exception = of_object(object);
  exception->type = type;
  exception->destroy = destroy;
  exception->references = 1;
  throw_again(exception);
}

void* __cxa_get_exception_ptr(void* exception) noexcept {
  return static_cast<Exception*>(exception)->adjusted;
}

void* __cxa_begin_catch(void* thrown) noexcept {
  auto* const exception = static_cast<Exception*>(thrown);
  exception->handlers = std::abs(exception->handlers) + 1;
  if (caught != exception) {
    exception->previous = caught;
    caught = exception;
  }
  --uncaught;
  return exception->adjusted;
}

void __cxa_end_catch() {
  Exception* const exception = caught;
  if (exception == nullptr) return;
  if (exception->handlers < 0) {  // rethrown: it lives on
    if (++exception->handlers == 0) caught = exception->previous;
    return;
  }
  if (--exception->handlers != 0) return;
  caught = exception->previous;
  __cxa_decrement_exception_refcount(object_of(primary_of(exception)));
  if (exception->primary != nullptr) std::free(exception);
}

[[noreturn]] void __cxa_rethrow() {
  if (caught == nullptr) std::terminate();
  caught->handlers = -caught->handlers;
  throw_again(caught);
}

void* __cxa_current_primary_exception() noexcept {
  if (caught == nullptr) return nullptr;
  void* const object = object_of(primary_of(caught));
  __cxa_increment_exception_refcount(object);
  return object;
}

void __cxa_rethrow_primary_exception(void* object) {
  if (object == nullptr) return;
  Exception* const exception = fresh(0);
  exception->primary = of_object(object);
  exception->type = exception->primary->type;
  __cxa_increment_exception_refcount(object);
  throw_again(exception);
}

std::type_info* __cxa_current_exception_type() {
  return caught == nullptr ? nullptr : const_cast<std::type_info*>(caught->type);
}

bool __cxa_uncaught_exception() noexcept {
  return uncaught != 0;
}

unsigned __cxa_uncaught_exceptions() noexcept {
  return uncaught;
}

}  // extern "C"

// That of libc++ ends the program where there is no memory.
void* operator new(std::size_t size) {
  if (void* const memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto to = static_cast<std::size_t>(alignment);
  if (size <= SIZE_MAX - to)
    if (void* const memory = std::aligned_alloc(to, (size + to - 1) / to * to)) return memory;
  throw std::bad_alloc();
}

void* operator new[](std::size_t size) {
  return operator new(size);
}

void* operator new[](std::size_t size, std::align_val_t alignment) {
  return operator new(size, alignment);
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return std::malloc(size > 0 ? size : 1);
}

void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return std::malloc(size > 0 ? size : 1);
}
